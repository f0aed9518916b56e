//! The program as its users run it: arguments in, files, text and an exit code out.

mod check;
mod doctor;
mod export;
mod manual;
#[cfg(unix)]
mod memory;
mod pipes;
mod render;
pub mod submit;
mod usage;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a run of the program did.
pub struct Ran {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Runs `editor` with `arguments` in `folder`.
pub fn editor_in(folder: &Path, arguments: &[&str]) -> Ran {
    let output = Command::new(env!("CARGO_BIN_EXE_editor"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs `editor` with `arguments` in `folder`, and `input` on its standard input. Returns what it did, but for its
/// standard output, which need not be text.
pub fn editor_with(folder: &Path, arguments: &[&str], input: &[u8]) -> (Ran, Vec<u8>) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_editor"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    // A command that fails before it reads closes the pipe.
    let _ = pipe.write_all(input);
    drop(pipe);
    let output = child.wait_with_output().unwrap();
    let ran = Ran {
        code: output.status.code(),
        out: String::new(),
        err: String::from_utf8(output.stderr).unwrap(),
    };
    (ran, output.stdout)
}

/// A folder with a small character, a shape, and a scene of both.
pub fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("man.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\n"),
        ("man.skel", "0 0 0 -1 # Root\n0 1 0 0 # Tip\n"),
        ("man.attach", "1\n0.25\n1\n"),
        ("box.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"),
        ("bad.obj", "v 0 0 0\nf 1 1 2\n"),
        ("bend.json", "{\"joints\": {\"Tip\": [0, 0, 90]}}"),
        (
            "a.scene",
            "{\"format\": \"editor-scene\", \"version\": 1, \"shapes\": [{\"source\": \"man.obj\"},
            {\"source\": \"box.obj\", \"position\": [0, 0, 2]}]}",
        ),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// The names of the files in `folder`, sorted.
pub fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<PathBuf> = entries.map(|e| e.unwrap().file_name().into()).collect();
    names.sort();
    names
}
