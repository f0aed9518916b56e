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
pub const VIEW: Part = (200, 80, 900, 600);

/// Keys of WebDriver.
pub const CTRL: &str = "\u{e009}";
pub const SHIFT: &str = "\u{e008}";
pub const ESC: &str = "\u{e00c}";
pub const ENTER: &str = "\u{e007}";
pub const DELETE: &str = "\u{e017}";
pub const RIGHT: &str = "\u{e014}";
pub const F3: &str = "\u{e033}";
pub const F6: &str = "\u{e036}";
pub const F7: &str = "\u{e037}";
pub const F8: &str = "\u{e038}";
pub const F10: &str = "\u{e03a}";
pub const F12: &str = "\u{e03c}";

/// A browser with the page.
pub struct Browser {
    driver: WebDriver,
    downloads: TempDir,
    address: String,
    _one: MutexGuard<'static, ()>,
}

/// The page that `make test-web` has built.
pub fn page_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/web-test")
}

impl Browser {
    /// Opens the page in a new browser of [`SIZE`], and waits until it shows the program.
    pub fn open() -> Self {
        Self::with_size(SIZE, 1.0)
    }

    /// The same in another size, with so many pixels a point.
    pub fn with_size(size: (u32, u32), scale: f32) -> Self {
        let server = make_web::Server::new(&page_folder(), 0).expect("run `make test-web`");
        let address = server.address();
        thread::spawn(move || make_web::serve(&server));
        Self::at(address, size, scale)
    }

    /// The same with the page at `address`, whoever serves it.
    pub fn at(address: String, size: (u32, u32), scale: f32) -> Self {
        let one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
        let downloads = TempDir::new().unwrap();
        let browser = Self {
            driver: WebDriver::start(downloads.path(), scale),
            downloads,
            address,
            _one: one,
        };
        browser.resize(size, 0.0);
        browser.go("");
        browser
    }

    /// Gives the page another size, in points, with so many pixels a point; with as many as the browser
    /// has at 0.
    pub fn resize(&self, (width, height): (u32, u32), scale: f32) {
        let metrics =
            json!({"width": width, "height": height, "deviceScaleFactor": scale, "mobile": false});
        self.devtools("Emulation.setDeviceMetricsOverride", &metrics);
    }

    /// Opens the page with `query` behind its address, in place of what is there.
    pub fn go(&self, query: &str) {
        let url = format!("{}{query}", self.address);
        self.driver.post("/url", &json!({"url": url}));
        self.wait_for_program();
    }

    /// Opens the page again, as it is now.
    pub fn reload(&self) {
        self.driver.post("/refresh", &json!({}));
        self.wait_for_program();
    }

    /// Opens another page of the same site.
    pub fn go_elsewhere(&self, name: &str) {
        let url = format!("{}{name}", self.address);
        self.driver.post("/url", &json!({"url": url}));
    }

    /// Opens another tab, and goes on there.
    pub fn open_tab(&self) {
        let opened = self.driver.post("/window/new", &json!({"type": "tab"}));
        self.use_tab(opened["handle"].as_str().unwrap());
        self.go("");
    }

    /// The tab that is used now.
    pub fn tab(&self) -> String {
        self.driver.get("/window").as_str().unwrap().to_owned()
    }

    /// Goes on in another tab.
    pub fn use_tab(&self, tab: &str) {
        self.driver.post("/window", &json!({"handle": tab}));
    }

    /// Zooms pages as the menu of the browser does, by its settings.
    pub fn zoom(&self, factor: f32) {
        let page = self.tab();
        let opened = self.driver.post("/window/new", &json!({"type": "tab"}));
        self.use_tab(opened["handle"].as_str().unwrap());
        let settings = json!({"url": "chrome://settings/appearance"});
        self.driver.post("/url", &settings);
        self.script(&format!("chrome.settingsPrivate.setDefaultZoom({factor})"));
        self.use_tab(&page);
    }

    /// Carries out a command of Chromium's DevTools.
    pub fn devtools(&self, command: &str, parameters: &Value) {
        let body = json!({"cmd": command, "params": parameters});
        self.driver.post("/goog/cdp/execute", &body);
    }

    /// Runs the command with this name, by the search for commands.
    pub fn command(&self, name: &str) {
        self.press(&[CTRL, SHIFT, "p"]);
        for letter in name.chars() {
            self.press_for(&[&letter.to_string()], 40);
        }
        self.press(&[ENTER]);
    }

    /// Waits until the page shows the program.
    pub fn wait_for_program(&self) {
        self.wait("the program is there", || {
            let shown = "return performance.getEntriesByName('editor-shown').length > 0";
            self.script(shown) == true
        });
    }

    /// Runs the body of a function of JavaScript, and returns what it returns.
    pub fn script(&self, script: &str) -> Value {
        self.driver.script(script)
    }

    /// The title, which names what is open.
    pub fn title(&self) -> String {
        let title = self.script("return document.title");
        title.as_str().unwrap().to_owned()
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
        let rest = json!({"type": "pause", "duration": 250});
        // Longer ones are no clicks.
        let short = json!({"type": "pause", "duration": 60});
        let actions = json!([
            {"type": "pointerMove", "duration": 60, "x": x, "y": y}, rest,
            {"type": "pointerDown", "button": 0}, short, {"type": "pointerUp", "button": 0}, rest,
        ]);
        self.act("mouse", &actions);
    }

    /// Moves the pointer to a place, in points.
    pub fn point(&self, (x, y): (u32, u32)) {
        let rest = json!({"type": "pause", "duration": 250});
        let actions = json!([{"type": "pointerMove", "duration": 60, "x": x, "y": y}, rest]);
        self.act("mouse", &actions);
    }

    /// Drags from one place to another, in points, with the left button.
    pub fn drag(&self, from: (u32, u32), to: (u32, u32)) {
        self.drag_with("mouse", from, to);
    }

    /// The same with the tip of a pen.
    pub fn drag_pen(&self, from: (u32, u32), to: (u32, u32)) {
        self.drag_with("pen", from, to);
    }

    fn drag_with(&self, kind: &str, from: (u32, u32), to: (u32, u32)) {
        let step =
            |(x, y): (u32, u32)| json!({"type": "pointerMove", "duration": 60, "x": x, "y": y});
        // Frames between, in which the program sees each of the steps.
        let rest = json!({"type": "pause", "duration": 250});
        let between = (u32::midpoint(from.0, to.0), u32::midpoint(from.1, to.1));
        let actions = json!([
            step(from), rest, {"type": "pointerDown", "button": 0}, rest,
            step(between), rest, step(to), rest, {"type": "pointerUp", "button": 0}, rest,
        ]);
        self.act(kind, &actions);
    }

    /// Has one pointer of a kind do something.
    fn act(&self, kind: &str, actions: &Value) {
        let pointer = json!({"pointerType": kind});
        self.driver.post(
            "/actions",
            &json!({"actions": [
                {"type": "pointer", "id": kind, "parameters": pointer, "actions": actions}
            ]}),
        );
    }

    /// Moves fingers from one place to another each, in points, all at the same time.
    pub fn touch(&self, fingers: &[[(u32, u32); 2]]) {
        let moved = |(x, y): (u32, u32), time: u32| json!({"type": "pointerMove", "duration": time, "x": x, "y": y});
        let rest = json!({"type": "pause", "duration": 250});
        let parameters = json!({"pointerType": "touch"});
        let fingers = fingers.iter().enumerate();
        let fingers = fingers.map(|(number, &[from, to])| {
            let between = (u32::midpoint(from.0, to.0), u32::midpoint(from.1, to.1));
            // A finger that rests for long means something else.
            let actions = json!([
                moved(from, 0), {"type": "pointerDown", "button": 0}, moved(between, 30),
                moved(to, 30), rest, {"type": "pointerUp", "button": 0}, rest,
            ]);

            let id = format!("finger {number}");
            json!({"type": "pointer", "id": id, "parameters": parameters, "actions": actions})
        });
        let fingers: Vec<Value> = fingers.collect();
        self.driver.post("/actions", &json!({"actions": fingers}));
    }

    /// Rests a finger at a place, in points, for longer than a tap.
    pub fn hold(&self, x: u32, y: u32) {
        let rest = json!({"type": "pause", "duration": 250});
        let actions = json!([
            {"type": "pointerMove", "duration": 0, "x": x, "y": y},
            {"type": "pointerDown", "button": 0}, {"type": "pause", "duration": 1500},
            {"type": "pointerUp", "button": 0}, rest,
        ]);
        self.act("touch", &actions);
    }

    /// Moves two fingers on a touchpad apart, or together if negative, with the pointer at a place: for
    /// the page, a wheel with a key that nobody presses.
    pub fn pinch(&self, (x, y): (u32, u32), apart: i32) {
        const CTRL_KEY: u32 = 2;
        let there = json!({"type": "mouseMoved", "x": x, "y": y});
        self.devtools("Input.dispatchMouseEvent", &there);
        let event = json!({
            "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": -apart,
            "modifiers": CTRL_KEY,
        });
        self.devtools("Input.dispatchMouseEvent", &event);
    }

    /// Turns the wheel at a place, down if `by` is above 0.
    pub fn wheel(&self, (x, y): (u32, u32), by: i32) {
        let event = json!({"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by});
        self.devtools("Input.dispatchMouseEvent", &event);
        std::thread::sleep(Duration::from_millis(500));
    }

    /// Presses `keys` together.
    pub fn press(&self, keys: &[&str]) {
        self.press_for(keys, 250);
    }

    /// The same for so many milliseconds, with as many after it.
    fn press_for(&self, keys: &[&str], time: u32) {
        let down = keys
            .iter()
            .map(|key| json!({"type": "keyDown", "value": key}));
        let rest = [json!({"type": "pause", "duration": time})];
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

    /// Drops files and folders in the middle of the view.
    pub fn drop_files(&self, files: &[PathBuf]) {
        let data = json!({"items": [], "files": files, "dragOperationsMask": 1});
        for kind in ["dragEnter", "dragOver", "drop"] {
            let event = json!({"type": kind, "x": 500, "y": 300, "data": data});
            self.devtools("Input.dispatchDragEvent", &event);
        }
    }

    /// The folder of files that the page has handed over.
    pub fn downloads(&self) -> &Path {
        self.downloads.path()
    }

    /// A file that the page has handed over, once it is whole.
    pub fn downloaded(&self, name: &str) -> Vec<u8> {
        let path = self.downloads.path().join(name);
        self.wait("the file is downloaded", || path.is_file());
        std::fs::read(path).unwrap()
    }

    /// Ends the test: nothing may have gone wrong on the page.
    pub fn finish(self) {
        if self.script("return innerWidth") == SIZE.0
            && self.script("return document.getElementById('editor') !== null") == true
        {
            assert_not_blank(&self.picture(), VIEW);
        }
        let log = self.driver.post("/se/log", &json!({"type": "browser"}));
        let is_bad = |entry: &&Value| entry["level"] == "SEVERE" || entry["level"] == "WARNING";
        let bad: Vec<&Value> = log.as_array().unwrap().iter().filter(is_bad).collect();
        assert!(bad.is_empty(), "the browser complains: {bad:#?}");
    }
}
