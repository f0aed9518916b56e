//! The program as a whole, looked at from outside: its start, its size, and its memory at rest.

use crate::desktop::{Desktop, Program};
use crate::earlier::build_earlier;
use crate::report::Report;
use std::path::Path;
use std::process::Command;

const PROGRAM: &str = env!("CARGO_BIN_EXE_editor");
const ROUNDS: usize = 3;
/// What is opened.
const FILE: &str = "builtin:showcase";

pub fn run(report: &mut Report) {
    report.ratio(
        "From the start to the first picture of builtin:showcase, against f712158",
        0.5,
        || {
            let earlier = build_earlier();
            let rounds = (0..ROUNDS).map(|_| [start(Path::new(PROGRAM)), start(&earlier)]);
            let least = rounds.reduce(|least, round| [0, 1].map(|at| least[at].min(round[at])));
            least.expect("rounds").into()
        },
    );
    report.ratio_in("MB", "The program's file against 18 MB", 1.0, || {
        let file = std::fs::metadata(PROGRAM).expect("the program's file");
        (file.len() as f64 / 1e6, 18.0)
    });
    if report.is_wanted(PARTS) {
        parts()
            .into_iter()
            .for_each(|part| report.tell(PARTS, part));
    }
    let what = "Memory at rest with builtin:showcase, the driver's included, against 120 MB";
    report.ratio_in("MB", what, 1.0, || {
        let home = tempfile::tempdir().expect("a folder");
        let desktop = Desktop::of_size(1280, 800);
        let program = Program::start(&desktop, home.path(), &[FILE]);
        program.resize(1280, 800);
        program.settled_picture();
        (
            memory(&desktop.xdotool(&["getwindowpid", &program.window])),
            120.0,
        )
    });
}

const PARTS: &str = "The program's file by part";
/// Parts of the file that are told, in megabytes.
const LARGE: f64 = 0.3;

/// The large parts of the program's file, as binutils tell them.
fn parts() -> Vec<String> {
    let output = Command::new("size").args(["-A", PROGRAM]).output();
    let text = output.map(|output| output.stdout).unwrap_or_default();
    let text = String::from_utf8_lossy(&text);
    let parts = text.lines().filter_map(|line| {
        let mut words = line.split_whitespace();
        let (name, size) = (words.next()?, words.next()?.parse::<f64>().ok()?);
        let is_part = name.starts_with('.') && size / 1e6 >= LARGE;
        is_part.then(|| (name.to_owned(), size / 1e6))
    });
    let mut parts: Vec<(String, f64)> = parts.collect();
    parts.sort_by(|one, other| other.1.total_cmp(&one.1));
    let parts = parts
        .into_iter()
        .map(|(name, size)| format!("`{name}`: {size:.1} MB"));
    parts.collect()
}

/// Milliseconds of the processor from the start of a program to a picture that stands still. The driver
/// keeps compiled shaders of both from one start to the next, as it does for a user.
fn start(program: &Path) -> f64 {
    let home = tempfile::tempdir().expect("a folder");
    let desktop = Desktop::of_size(1280, 800);
    let program = Program::start_at(program, &desktop, home.path(), &[FILE]);
    program.settled_picture();
    program.processor_time() as f64 * 10.0
}

/// Memory of a process that is there now, in megabytes, shared code included.
fn memory(process: &str) -> f64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status"));
    let status = status.expect("the program's state");
    let size = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let size = size.and_then(|size| size.trim().strip_suffix(" kB"));
    let kib: f64 = size.and_then(|kib| kib.parse().ok()).expect("a size");
    kib * 1024.0 / 1e6
}
