//! The real window against that of an earlier version of the program, which is built beside this one: a
//! user drags a bone, and both are looked at from outside.

use crate::desktop::{Desktop, Program};
use crate::frames::{SCENE, scene};
use crate::report::Report;
use crate::window::Window;
use egui::Key;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The version with which the work on frames began.
const EARLIER: &str = "f712158";

/// Where its window, 1280 pixels wide and 800 high, shows the left elbow's bone of `builtin:adult`.
const EARLIER_BONE: (f32, f32) = (592.0, 372.0);

const ROUNDS: usize = 3;

/// Steps of a drag, and the time between them: enough for a frame each on two cores, and too little for
/// a picture at rest.
const STEPS: usize = 60;
const STEP: Duration = Duration::from_millis(90);

pub fn run(report: &mut Report) {
    for (what, file) in [
        (
            "Dragging a bone of builtin:adult in the window against f712158",
            "builtin:adult",
        ),
        (
            "Dragging a bone of builtin:adult against f712158, both in the Course look",
            SCENE,
        ),
    ] {
        report.ratio(what, 1.0 / 3.0, || {
            let earlier = Dragged {
                binary: build_earlier(),
                file,
                bone: EARLIER_BONE,
            };
            let now = Dragged {
                binary: PathBuf::from(env!("CARGO_BIN_EXE_editor")),
                file,
                bone: bone(file),
            };
            let mut least = (f64::INFINITY, f64::INFINITY);
            for _ in 0..ROUNDS {
                least.0 = least.0.min(now.cost());
                least.1 = least.1.min(earlier.cost());
            }
            least
        });
    }
}

/// A program whose window a user drags in.
struct Dragged {
    binary: PathBuf,
    /// The file that it opens.
    file: &'static str,
    /// Where the bone is in the window.
    bone: (f32, f32),
}

impl Dragged {
    /// CPU time of a step of a drag in a window that has just opened, in milliseconds.
    fn cost(&self) -> f64 {
        let home = tempfile::tempdir().expect("a folder");
        std::fs::write(home.path().join(SCENE), scene(1, "course")).expect("a scene");
        let desktop = Desktop::of_size(1280, 800);
        let program = Program::start_at(&self.binary, &desktop, home.path(), &[self.file]);
        program.resize(1280, 800);
        program.keys(&["b"]);
        let before = program.settled_picture();
        program.point(self.bone);
        program.press("1");
        let started = program.processor_time();
        let mut next = Instant::now();
        for step in 0..STEPS {
            let angle = step as f32 * 0.3;
            let (x, y) = self.bone;
            program.point((x + 40.0 * angle.sin(), y + 30.0 * angle.cos()));
            next += STEP;
            std::thread::sleep(next.saturating_duration_since(Instant::now()));
        }
        let ticks = program.processor_time() - started;
        program.release("1");
        assert!(
            program.settled_picture() != before,
            "a bone was dragged in {}",
            self.binary.display()
        );
        ticks as f64 * 10.0 / STEPS as f64
    }
}

/// Where the bone is in this version's window.
fn bone(file: &str) -> (f32, f32) {
    let mut window = Window::start(file, &scene(1, "course"));
    window.key(Key::B);
    let end = window.end_of_bone("Left elbow");
    (end.x, end.y)
}

/// Builds the earlier version from the history, if that has not been done, and returns its program.
pub fn build_earlier() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = root.join("target/bench").join(EARLIER);
    let program = folder.join("target/release/editor");
    if program.exists() {
        return program;
    }
    std::fs::create_dir_all(&folder).expect("a folder below target");
    let mut archive = Command::new("git")
        .current_dir(root)
        .args(["archive", EARLIER])
        .stdout(Stdio::piped())
        .spawn()
        .expect("git runs");
    let sources = archive.stdout.take().expect("the sources");
    let unpacked = Command::new("tar")
        .arg("-x")
        .current_dir(&folder)
        .stdin(sources)
        .status();
    assert!(
        archive.wait().is_ok_and(|status| status.success())
            && unpacked.is_ok_and(|status| status.success()),
        "the history of the project has {EARLIER}"
    );
    let built = Command::new(env!("CARGO"))
        .current_dir(&folder)
        .env_remove("CARGO_TARGET_DIR")
        .args(["build", "--release", "--locked", "--bin", "editor"])
        .status();
    assert!(
        built.is_ok_and(|status| status.success()),
        "{EARLIER} is built"
    );
    program
}
