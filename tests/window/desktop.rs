//! A screen without a monitor, the program in it, and hands: Xvfb and xdotool.

use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The program that is tested.
const PROGRAM: &str = env!("CARGO_BIN_EXE_editor");

/// How long something may take before it is taken to hang. A busy machine needs a part of it.
const PATIENCE: Duration = Duration::from_secs(120);

/// One desktop at a time: servers that start together may take each other's display number, and
/// programs that draw in software together are slow.
static TURN: Mutex<()> = Mutex::new(());

/// A running Xvfb.
pub struct Desktop {
    _turn: MutexGuard<'static, ()>,
    server: Child,
    pub display: String,
}

impl Desktop {
    /// Starts one on a display number of its own choosing.
    pub fn start() -> Self {
        Self::of_size(1400, 900)
    }

    /// Starts one with so many pixels.
    pub fn of_size(width: u32, height: u32) -> Self {
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let mut server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-screen",
                "0",
                &format!("{width}x{height}x24"),
                "-noreset",
                "-nolisten",
                "tcp",
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb starts (package xvfb)");
        let stdout = server.stdout.take().expect("its standard output");
        let mut number = String::new();
        BufReader::new(stdout)
            .read_line(&mut number)
            .expect("the display's number");
        Self {
            _turn: turn,
            server,
            display: format!(":{}", number.trim()),
        }
    }

    /// Runs xdotool and returns what it prints.
    pub fn xdotool(&self, arguments: &[&str]) -> String {
        let output = Command::new("xdotool")
            .args(arguments)
            .env("DISPLAY", &self.display)
            .output()
            .expect("xdotool runs (package xdotool)");
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }
}

impl Drop for Desktop {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// The program, running in a desktop.
pub struct Program<'a> {
    desktop: &'a Desktop,
    child: Child,
    pub window: String,
}

impl<'a> Program<'a> {
    /// Starts it with `home` as the user's folder and waits for its window.
    pub fn start(desktop: &'a Desktop, home: &Path, arguments: &[&str]) -> Self {
        Self::start_at(Path::new(PROGRAM), desktop, home, arguments)
    }

    /// Does so with the program at a path.
    pub fn start_at(program: &Path, desktop: &'a Desktop, home: &Path, arguments: &[&str]) -> Self {
        let child = command_at(program, home)
            .args(arguments)
            .env("DISPLAY", &desktop.display)
            .spawn()
            .expect("the program starts");
        let mut program = Self {
            desktop,
            child,
            window: String::new(),
        };
        program.window = program.wait_for("its window", |program| {
            let pid = program.child.id().to_string();
            let found = desktop.xdotool(&["search", "--onlyvisible", "--pid", &pid]);
            found.lines().next().map(str::to_owned)
        });
        // Without a window manager nothing gives a window the keyboard.
        desktop.xdotool(&["windowmove", &program.window, "0", "0"]);
        desktop.xdotool(&["windowfocus", &program.window]);
        program.wait_for("its first picture", |program| {
            let dump = program.grab();
            let pixels = dump
                .len()
                .checked_sub(100_000)
                .map(|start| &dump[start..])?;
            let first = pixels.get(..4)?;
            pixels
                .chunks_exact(4)
                .any(|pixel| pixel != first)
                .then_some(())
        });
        program
    }

    /// Makes the window so many pixels large.
    pub fn resize(&self, width: u32, height: u32) {
        let (width, height) = (width.to_string(), height.to_string());
        self.desktop
            .xdotool(&["windowsize", &self.window, &width, &height]);
        pause();
    }

    pub fn title(&self) -> String {
        self.desktop.xdotool(&["getwindowname", &self.window])
    }

    /// Presses and releases keys, named as X names them.
    pub fn keys(&self, keys: &[&str]) {
        for key in keys {
            self.desktop.xdotool(&["key", key]);
            pause();
        }
    }

    /// Types text as it stands.
    pub fn write(&self, text: &str) {
        self.desktop.xdotool(&["type", "--delay", "40", text]);
        pause();
    }

    /// Drags with button `button` in steps, as a hand does.
    pub fn drag(&self, button: &str, from: (f32, f32), to: (f32, f32)) {
        const STEPS: i32 = 10;
        self.point(from);
        self.press(button);
        for step in 1..=STEPS {
            let along = step as f32 / STEPS as f32;
            self.point((
                from.0 + (to.0 - from.0) * along,
                from.1 + (to.1 - from.1) * along,
            ));
        }
        self.release(button);
    }

    /// Presses a button and holds it.
    pub fn press(&self, button: &str) {
        self.desktop.xdotool(&["mousedown", button]);
        pause();
    }

    pub fn release(&self, button: &str) {
        self.desktop.xdotool(&["mouseup", button]);
        pause();
    }

    /// Clicks with the first button.
    pub fn click(&self, place: (f32, f32)) {
        self.point(place);
        self.desktop.xdotool(&["click", "1"]);
        pause();
    }

    /// Moves the pointer there.
    pub fn point(&self, (x, y): (f32, f32)) {
        let (x, y) = (x.round().to_string(), y.round().to_string());
        self.desktop.xdotool(&["mousemove", &x, &y]);
        std::thread::sleep(Duration::from_millis(30));
    }

    /// What is on the screen now, once it stands still and nothing waits for the processor to
    /// change it.
    pub fn picture(&self) -> Vec<u8> {
        let mut last = None;
        let since = Instant::now();
        loop {
            let now = self.grab();
            if last.as_ref() == Some(&now) || since.elapsed() > PATIENCE {
                return now;
            }
            last = self.sleeps().then_some(now);
            std::thread::sleep(Duration::from_millis(200));
            last = last.filter(|_| self.sleeps());
        }
    }

    /// Whether all threads of the program and of its screen wait for something to happen, none
    /// for the processor.
    fn sleeps(&self) -> bool {
        [self.child.id(), self.desktop.server.id()]
            .into_iter()
            .all(|process| {
                let threads = std::fs::read_dir(format!("/proc/{process}/task"));
                threads.into_iter().flatten().flatten().all(|thread| {
                    let stat = std::fs::read_to_string(thread.path().join("stat"));
                    // The name, in parentheses, may hold blanks; the state follows it.
                    let stat = stat.unwrap_or_default();
                    let state = stat.rsplit(')').next().unwrap_or_default().trim_start();
                    !state.starts_with(['R', 'D'])
                })
            })
    }

    /// The same once it stands still for long, so that every key and click is surely in it.
    pub fn settled_picture(&self) -> Vec<u8> {
        let since = Instant::now();
        let mut last = self.picture();
        loop {
            std::thread::sleep(Duration::from_secs(2));
            let now = self.picture();
            if now == last || since.elapsed() > PATIENCE {
                return now;
            }
            last = now;
        }
    }

    /// Colors of the pixels in `dump`, row by row from the upper left.
    pub fn colors(dump: &[u8], width: u32, height: u32) -> Vec<[u8; 3]> {
        let bytes = 4 * width as usize * height as usize;
        let start = dump.len().checked_sub(bytes).expect("a whole dump");
        let (pixels, _) = dump[start..].as_chunks::<4>();
        pixels.iter().map(|&[b, g, r, _]| [r, g, b]).collect()
    }

    /// The window's pixels, by way of a dump of the screen.
    fn grab(&self) -> Vec<u8> {
        let output = Command::new("xwd")
            .args(["-silent", "-id", &self.window])
            .env("DISPLAY", &self.desktop.display)
            .output()
            .expect("xwd runs (package x11-apps)");
        output.stdout
    }

    /// Waits until `look` sees something.
    pub fn wait_for<T>(&mut self, what: &str, look: impl Fn(&Self) -> Option<T>) -> T {
        let since = Instant::now();
        loop {
            if let Some(seen) = look(self) {
                return seen;
            }
            if let Some(status) = self.child.try_wait().expect("the program's state") {
                panic!(
                    "the program ended ({status}) before {what} was seen: {}",
                    self.stderr()
                );
            }
            assert!(since.elapsed() < PATIENCE, "{what} was not seen");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Asks the program to end, as the system does when it shuts down, and waits for it. Unsaved
    /// work is kept and no question asked.
    pub fn terminate(self) -> (ExitStatus, String) {
        let pid = self.child.id().to_string();
        let sent = Command::new("kill").args(["-TERM", &pid]).status();
        assert!(sent.expect("kill runs").success());
        self.end()
    }

    /// Ends the program as the system does to one that does not answer.
    pub fn kill(mut self) {
        self.child.kill().expect("it was killed");
        self.child.wait().expect("it ended");
    }

    /// Waits for the program's end.
    pub fn end(mut self) -> (ExitStatus, String) {
        let since = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().expect("the program's state") {
                let told = self.stderr();
                return (status, told);
            }
            assert!(since.elapsed() < PATIENCE, "the program does not end");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn stderr(&mut self) -> String {
        let mut told = String::new();
        if let Some(mut stderr) = self.child.stderr.take() {
            let _ = stderr.read_to_string(&mut told);
        }
        told
    }

    /// What the program has used of the processor so far, in hundredths of a second.
    pub fn processor_time(&self) -> u64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id()))
            .expect("the program's state");
        // The name, in parentheses, may hold blanks; user and system time are fields 14 and 15.
        let after_name = stat.rsplit(')').next().expect("fields after the name");
        let fields: Vec<&str> = after_name.split_whitespace().collect();
        let field = |number: usize| {
            fields[number - 3]
                .parse::<u64>()
                .expect("a number of ticks")
        };
        field(14) + field(15)
    }
}

impl Drop for Program<'_> {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The folder of the user's session, made if need be.
pub fn session_folder(home: &Path) -> PathBuf {
    let folder = home.join("session");
    std::fs::create_dir_all(&folder).expect("the session's folder");
    folder
}

/// The program with nothing of this machine's user in its surroundings.
pub fn command(home: &Path) -> Command {
    command_at(Path::new(PROGRAM), home)
}

fn command_at(program: &Path, home: &Path) -> Command {
    let mut command = Command::new(program);
    command
        .current_dir(home)
        .env("HOME", home)
        .env("XDG_RUNTIME_DIR", home.join("session"))
        .env_remove("XDG_CONFIG_HOME")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("DISPLAY")
        .env("LIBGL_ALWAYS_SOFTWARE", "1")
        .stdin(Stdio::null())
        .stderr(Stdio::piped());
    command
}

fn pause() {
    std::thread::sleep(Duration::from_millis(120));
}
