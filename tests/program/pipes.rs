//! `-` for standard input and standard output.

use crate::program::{editor_in, editor_with, files_in, folder};
use serde_json::Value;
use std::path::Path;

/// What a command that must succeed writes on standard output, with nothing else said.
#[track_caller]
fn piped(folder: &Path, line: &str, input: &[u8]) -> Vec<u8> {
    let (ran, out) = editor_with(folder, &line.split(' ').collect::<Vec<_>>(), input);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{line}");
    out
}

#[test]
fn a_mesh_goes_through_pipes_from_export_to_a_picture_that_is_the_one_of_files() {
    let folder = folder();
    let path = folder.path();
    let mesh = piped(path, "export box.obj -o -", b"");
    piped(path, "export box.obj -o out.obj", b"");
    assert_eq!(mesh, std::fs::read(path.join("out.obj")).unwrap());
    let picture = piped(path, "render - --size 80x60 --fit -o -", &mesh);
    assert!(picture.starts_with(b"\x89PNG"));
    piped(path, "render out.obj --size 80x60 --fit -o out.png", b"");
    assert_eq!(picture, std::fs::read(path.join("out.png")).unwrap());
    let turn = piped(path, "render - --size 20x20 --turntable 4 -o -", &mesh);
    assert!(turn.starts_with(b"GIF89a"));
    let left: Vec<_> = files_in(path)
        .into_iter()
        .filter(|it| it.to_string_lossy().starts_with('-'))
        .collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn pictures_meshes_and_poses_come_through_standard_input() {
    let folder = folder();
    let path = folder.path();
    let picture = piped(path, "render box.obj --size 80x60 -o -", b"");
    piped(path, "render box.obj --size 80x60 -o out.png", b"");
    let told = piped(path, "compare out.png - --json", &picture);
    let report: Value = serde_json::from_slice(&told).unwrap();
    assert_eq!(
        (&report["passed"], &report["b"]),
        (&true.into(), &"-".into())
    );

    let pose = std::fs::read(path.join("bend.json")).unwrap();
    let (ran, posed) = editor_with(
        path,
        &["export", "man.obj", "--pose", "-", "-o", "-"],
        &pose,
    );
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let by_name = editor_in(
        path,
        &["export", "man.obj", "--pose", "bend.json", "-o", "out.obj"],
    );
    assert_eq!(
        (by_name.code, &by_name.err),
        (Some(0), &ran.err),
        "warnings are on standard error"
    );
    assert_eq!(posed, std::fs::read(path.join("out.obj")).unwrap());
    let line = [
        "diagnose",
        "-",
        "--character",
        "man.obj",
        "--pose",
        "bend.json",
    ];
    let (ran, right) = editor_with(path, &line, &posed);
    assert_eq!((ran.code, right.starts_with(b"right")), (Some(0), true));
}

#[test]
fn what_is_wrong_with_standard_input_is_told_with_its_line() {
    let (ran, out) = editor_with(folder().path(), &["check", "-"], b"v 0 0 0\nf 1 1 2\n");
    let told = "error: -.obj:2:7: expected a vertex from 1 to 1, found 2\n";
    assert_eq!((ran.code, &*ran.err, out.len()), (Some(1), told, 0));
    for command in ["check", "render"] {
        let line = [command, "-", "-o", "a.png"];
        let line = &line[..if command == "check" { 2 } else { 4 }];
        let (ran, _) = editor_with(folder().path(), line, b"");
        let told = "error: -: expected a file on standard input, found nothing\n";
        assert_eq!((ran.code, &*ran.err), (Some(1), told));
    }
}

#[test]
fn a_pipe_that_has_another_use_already_is_wrong_usage() {
    for (line, told) in [
        (
            "compare - -",
            "expected - once, found it twice: standard input is one file",
        ),
        (
            "compare box.obj box.obj -o -",
            "expected the name of a file to write, found -: standard output has the result",
        ),
        (
            "export box.obj --materials -o -",
            "expected one file for standard output, found 2: give -o a name",
        ),
    ] {
        let (ran, out) = editor_with(
            folder().path(),
            &line.split(' ').collect::<Vec<_>>(),
            b"v 0 0 0\n",
        );
        assert_eq!((ran.code, out.len()), (Some(2), 0), "{line}: {}", ran.err);
        assert!(
            ran.err.starts_with(&format!("error: {told}\n")),
            "{line}: {}",
            ran.err
        );
    }
}
