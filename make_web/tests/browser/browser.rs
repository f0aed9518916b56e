//! A browser that shows the page, and a hand that uses it.

use super::picture::{Part, assert_not_blank};
use super::web_driver::WebDriver;
use base64::Engine as _;
use image::RgbImage;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// One browser at a time: several would take too long each for what the tests wait for.
static ONE: Mutex<()> = Mutex::new(());

/// Time after which something will not happen any more.
const PATIENCE: Duration = Duration::from_secs(90);

/// Width and height of the page in points, where a test says nothing else.
pub const SIZE: (u32, u32) = (1280, 800);

/// The middle of the view in pages of [`SIZE`], clear of bars and of the first help.
pub const VIEW: Part = (200, 80, 900, 640);

/// Keys of WebDriver.
pub const CTRL: &str = "\u{e009}";
pub const ESC: &str = "\u{e00c}";
pub const ENTER: &str = "\u{e007}";
pub const F12: &str = "\u{e03c}";

/// A browser with the page.
pub struct Browser {
    driver: WebDriver,
    downloads: TempDir,
    address: String,
    _one: MutexGuard<'static, ()>,
}

impl Browser {
    /// Opens the page in a new browser of [`SIZE`], and waits until it shows the program.
    pub fn open() -> Self {
        Self::with_size(SIZE, 1.0)
    }

    /// The same in another size, with so many pixels a point.
    pub fn with_size(size: (u32, u32), scale: f32) -> Self {
        let one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/web-test");
        let server = make_web::Server::new(&folder, 0).expect("run `make test-web`");
        let address = server.address();
        thread::spawn(move || make_web::serve(&server));
        let downloads = TempDir::new().unwrap();
        let browser = Self {
            driver: WebDriver::start(downloads.path(), scale),
            downloads,
            address,
            _one: one,
        };
        let (width, height) = size;
        let metrics = json!({"cmd": "Emulation.setDeviceMetricsOverride", "params":
            {"width": width, "height": height, "deviceScaleFactor": 0, "mobile": false}});
        browser.driver.post("/goog/cdp/execute", &metrics);
        browser.go("");
        browser
    }

    /// Opens the page with `query` behind its address, in place of what is there.
    pub fn go(&self, query: &str) {
        let url = format!("{}{query}", self.address);
        self.driver.post("/url", &json!({"url": url}));
        self.wait_for_program();
    }

    /// Waits until the page shows the program.
    pub fn wait_for_program(&self) {
        self.wait("the program is there", || {
            self.script("return document.getElementById('note').hidden") == true
        });
    }

    /// Runs the body of a function of JavaScript, and returns what it returns.
    pub fn script(&self, script: &str) -> Value {
        self.driver.script(script)
    }

    /// Waits until something is so.
    pub fn wait(&self, what: &str, is_so: impl Fn() -> bool) {
        let begun = Instant::now();
        while !is_so() {
            assert!(begun.elapsed() < PATIENCE, "waited in vain until {what}");
            thread::sleep(Duration::from_millis(100));
        }
    }

    /// The page, once it stands still.
    pub fn picture(&self) -> RgbImage {
        let begun = Instant::now();
        let mut before = self.screenshot();
        loop {
            thread::sleep(Duration::from_millis(400));
            let now = self.screenshot();
            if now == before {
                return now;
            }
            assert!(begun.elapsed() < PATIENCE, "the page never stands still");
            before = now;
        }
    }

    fn screenshot(&self) -> RgbImage {
        let coded = self.driver.get("/screenshot");
        let coded = coded.as_str().unwrap();
        let bytes = base64::engine::general_purpose::STANDARD.decode(coded);
        image::load_from_memory(&bytes.unwrap())
            .unwrap()
            .into_rgb8()
    }

    /// Clicks at a place, in points.
    pub fn click(&self, x: u32, y: u32) {
        self.drag((x, y), (x, y));
    }

    /// Drags from one place to another, in points, with the left button.
    pub fn drag(&self, from: (u32, u32), to: (u32, u32)) {
        let step =
            |(x, y): (u32, u32)| json!({"type": "pointerMove", "duration": 60, "x": x, "y": y});
        // Frames between, in which the program sees each of the steps.
        let rest = json!({"type": "pause", "duration": 250});
        let between = (u32::midpoint(from.0, to.0), u32::midpoint(from.1, to.1));
        let actions = json!([
            step(from), rest, {"type": "pointerDown", "button": 0}, rest,
            step(between), rest, step(to), rest, {"type": "pointerUp", "button": 0}, rest,
        ]);
        let pointer = json!({"pointerType": "mouse"});
        self.driver.post(
            "/actions",
            &json!({"actions": [
                {"type": "pointer", "id": "mouse", "parameters": pointer, "actions": actions}
            ]}),
        );
    }

    /// Presses `keys` together.
    pub fn press(&self, keys: &[&str]) {
        let down = keys
            .iter()
            .map(|key| json!({"type": "keyDown", "value": key}));
        let rest = [json!({"type": "pause", "duration": 250})];
        let up = keys.iter().rev();
        let up = up.map(|key| json!({"type": "keyUp", "value": key}));
        let actions: Vec<Value> = down.chain(rest.clone()).chain(up).chain(rest).collect();
        self.driver.post(
            "/actions",
            &json!({"actions": [{"type": "key", "id": "keyboard", "actions": actions}]}),
        );
    }

    /// Chooses files where the page has asked for some.
    pub fn choose(&self, files: &[PathBuf]) {
        let chooser = json!({"using": "css selector", "value": "#chooser"});
        let found = self.driver.post("/element", &chooser);
        let id = found.as_object().unwrap().values().next().unwrap();
        let files: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        let path = format!("/element/{}/value", id.as_str().unwrap());
        self.driver.post(&path, &json!({"text": files.join("\n")}));
    }

    /// A file that the page has handed over, once it is whole.
    pub fn downloaded(&self, name: &str) -> Vec<u8> {
        let path = self.downloads.path().join(name);
        self.wait("the file is downloaded", || path.is_file());
        std::fs::read(path).unwrap()
    }

    /// Ends the test: nothing may have gone wrong on the page.
    pub fn finish(self) {
        if self.script("return innerWidth") == SIZE.0 {
            assert_not_blank(&self.picture(), VIEW);
        }
        let log = self.driver.post("/se/log", &json!({"type": "browser"}));
        let is_bad = |entry: &&Value| entry["level"] == "SEVERE" || entry["level"] == "WARNING";
        let bad: Vec<&Value> = log.as_array().unwrap().iter().filter(is_bad).collect();
        assert!(bad.is_empty(), "the browser complains: {bad:#?}");
    }
}
