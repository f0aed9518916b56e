//! Help, and wrong usage.

use crate::program::{editor_in, folder};

#[test]
fn help_and_version_are_results() {
    let folder = folder();
    for arguments in [
        &["--help"][..],
        &["check", "--help"],
        &["export", "--help"],
        &["--version"],
    ] {
        let ran = editor_in(folder.path(), arguments);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{arguments:?}");
        assert!(!ran.out.is_empty());
    }
    let help = editor_in(folder.path(), &["--help"]).out;
    assert!(help.contains("check") && help.contains("export"), "{help}");
}

#[test]
fn help_lists_the_verdicts_of_a_diagnosis_and_shows_a_command_that_makes_files() {
    let folder = folder();
    let help = |command: &str| {
        let help = editor_in(folder.path(), &[command, "--help"]).out;
        help.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let diagnose = help("diagnose");
    for word in [
        "right, triangles (",
        "explained (",
        "other-pose (",
        "and unexplained",
        "verdict is null",
    ] {
        assert!(diagnose.contains(word), "{word}: {diagnose}");
    }
    let grade = help("grade");
    let command = r#"{"run": ["./build/pose", "{character}", "{pose}", "{output}"], "seconds": 60, "memory": 1024}"#;
    for told in [command, "(pose-not-applied, other-pose)", "nearest number"] {
        assert!(grade.contains(told), "{told}: {grade}");
    }
}

#[test]
fn wrong_usage_ends_with_2_and_prints_no_result() {
    let folder = folder();
    for arguments in [
        &["check"][..],
        &["check", "--frobnicate", "man.obj"],
        &["export", "man.obj"],
        &["export", "-o", "out.obj"],
        &["export", "man.obj", "-o", "out.stl"],
        &["render", "man.obj", "-o", "out.bmp"],
        &["render", "man.obj", "-o", "out"],
        &["compare", "man.png", "man.png", "-o", "out.obj"],
    ] {
        let ran = editor_in(folder.path(), arguments);
        assert_eq!((ran.code, &*ran.out), (Some(2), ""), "{arguments:?}");
        assert!(ran.err.starts_with("error: "), "{}", ran.err);
    }
}

#[test]
fn a_misspelled_command_is_told_with_the_one_that_was_meant_whatever_follows() {
    let folder = folder();
    for (arguments, told) in [
        (
            &["rendr", "man.obj", "-o", "a.png"][..],
            "rendr; did you mean render?",
        ),
        (
            &["diagnos", "a.obj", "--character", "man.obj"],
            "diagnos; did you mean diagnose?",
        ),
        (&["chek", "man.obj"], "chek; did you mean check?"),
        (&["rendr", "--help"], "rendr; did you mean render?"),
        (&["frobnicate", "-o", "a.png"], "frobnicate"),
    ] {
        let ran = editor_in(folder.path(), arguments);
        let told = format!("error: there is neither a command nor a file called {told}\n");
        assert_eq!((ran.code, &*ran.out), (Some(2), ""));
        assert!(ran.err.starts_with(&told), "{}", ran.err);
    }
    let ran = editor_in(folder.path(), &["render", "man.obj", "--frobnicate"]);
    assert!(ran.err.contains("--frobnicate"), "{}", ran.err);
}

#[test]
fn a_character_that_the_program_brings_is_no_unknown_command() {
    for (word, code) in [("builtin:robot", 1), ("robot", 2)] {
        let status = std::process::Command::new(env!("CARGO_BIN_EXE_editor"))
            .arg(word)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stderr(std::process::Stdio::null())
            .status()
            .unwrap();
        // Without a display a window is a failure, and not wrong usage.
        assert_eq!(status.code(), Some(code), "{word}");
    }
}

#[test]
fn the_help_of_what_reads_files_names_every_kind_of_them() {
    let folder = folder();
    for command in ["check", "export", "render"] {
        let help = editor_in(folder.path(), &[command, "--help"]).out;
        let words = help.split_whitespace().collect::<Vec<_>>().join(" ");
        let kinds = "Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), \
                     shapes (.obj, .dae), curves (.swp)";
        assert!(words.contains(kinds), "{help}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_said_on_standard_error_changes_no_exit_code() {
    let folder = folder();
    for (code, line) in [
        (1, "check bad.obj"),
        (1, "export builtin:nobody -o out.obj"),
        (2, "export man.obj -o out.stl"),
        (0, "export man.obj -o out.obj"),
        (1, "compare bad.obj man.obj"),
    ] {
        let full = std::fs::File::create("/dev/full").unwrap();
        let status = std::process::Command::new(env!("CARGO_BIN_EXE_editor"))
            .args(line.split(' '))
            .current_dir(folder.path())
            .stdout(std::process::Stdio::null())
            .stderr(full)
            .status()
            .unwrap();
        assert_eq!(status.code(), Some(code), "{line}");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_editor"))
        .args(["check", "builtin:showcase"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

#[test]
fn a_folder_that_is_missing_is_told_before_any_work_and_made_for_a_report_alone() {
    let folder = folder();
    let path = folder.path();
    // What is read is wrong as well, and would be told first.
    for (line, output) in [
        ("render bad.obj -o none/out.png", "none/out.png"),
        (
            "render bad.obj --turntable 4 -o none/%02d.png",
            "none/%02d.png",
        ),
        ("export bad.obj -o none/out.obj", "none/out.obj"),
        ("export bad.obj -o none/out.skel", "none/out.skel"),
        ("submit --picture bad.obj -o none/out.zip", "none/out.zip"),
    ] {
        let ran = editor_in(path, &line.split(' ').collect::<Vec<_>>());
        let told = format!("error: {output}: there is no folder none\n");
        assert_eq!((ran.code, &*ran.err), (Some(1), &*told), "{line}");
    }
    let ran = editor_in(path, &["export", "bad.obj", "-o", "."]);
    assert!(
        ran.err.contains("expected a file to write, found a folder"),
        "{}",
        ran.err
    );
    assert!(!path.join("none").exists());
    let tests = r#"{"tests": [{"name": "bent", "character": "man.obj", "pose": "bend.json", "points": {"4.2": 1}}]}"#;
    std::fs::write(path.join("tests.json"), tests).unwrap();
    std::fs::create_dir_all(path.join("class/Ada")).unwrap();
    let line = "export man.obj --pose bend.json -o class/Ada/bent.obj";
    editor_in(path, &line.split(' ').collect::<Vec<_>>());
    let line = "grade class --tests tests.json -o none/report";
    let ran = editor_in(path, &line.split(' ').collect::<Vec<_>>());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(path.join("none/report/grade.html").is_file());
}
