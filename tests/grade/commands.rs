//! Programs of submissions that are run, and what they must not do to others.

use crate::diagnose::figures::obj;
use crate::diagnose::student::RIGHT;
use crate::grade::support::{Class, result};
use serde_json::json;
use std::fs;
use std::os::unix::fs::PermissionsExt;

/// A class whose submissions are programs, each with the lines of a shell script.
fn class(programs: &[(&str, &str)]) -> Class {
    let class = Class::new(&["robot"]);
    let figure = &class.tests[0].1;
    class.write(
        "right.obj",
        obj(&RIGHT.skin(figure), figure, |number| number.to_string()),
    );
    for file in ["man.obj", "man.skel", "man.attach"] {
        let extension = file.split('.').nth(1).unwrap();
        let asset = format!(
            "{}/assets/characters/robot.{extension}",
            env!("CARGO_MANIFEST_DIR")
        );
        class.write(file, fs::read(asset).unwrap());
    }
    let mut tests = class.tests_file();
    tests["tests"][0]["character"] = "man.obj".into();
    tests["command"] = json!({
        "run": ["./pose", "{character}", "{pose}", "{output}", "{test}"],
        "seconds": 6,
        "memory": 200,
    });
    class.set_tests(&tests);
    for (name, lines) in programs {
        let path = format!("class/{name}/pose");
        class.write(&path, format!("#!/bin/sh\n{lines}\n"));
        let executable = fs::Permissions::from_mode(0o755);
        fs::set_permissions(class.path().join(path), executable).unwrap();
    }
    class
}

#[test]
fn a_program_that_hangs_crashes_or_eats_memory_harms_no_other() {
    let class = class(&[
        (
            "ada",
            "test -f \"$1\" && test -f \"$2\" && test \"$4\" = robot-1 && cp ../../right.obj \"$3\"",
        ),
        ("bob", "sleep 1000 & echo $! > child; wait"),
        ("cem", "kill -SEGV $$"),
        ("dan", "head -c 3000m /dev/zero | tail"),
        ("eve", "echo 'no such joint' >&2; echo > \"$3\"; exit 3"),
        ("fay", "exit 0"),
        ("gus", "yes >&2 & yes; "),
        ("ida", "printf 'v 1 2' > \"$3\""),
        (
            "joe",
            "cp ../../right.obj \"$3\"; exec > /dev/null; sleep 1000 &",
        ),
    ]);
    class.write("class/hal/readme.txt", "no program");
    class.write("class/kim/pose", "#!/bin/sh\n");
    let report = class.graded();
    for (name, outcome, text) in [
        ("ada", "right", "right: "),
        ("bob", "failed", "the command did not end within 6 s"),
        ("cem", "failed", "the command crashed with SIGSEGV"),
        (
            "dan",
            "failed",
            "the command took more than 200 MiB of memory",
        ),
        (
            "eve",
            "failed",
            "the command ended with exit code 3:\nno such joint",
        ),
        (
            "fay",
            "missing",
            "the command ended without writing its file",
        ),
        ("gus", "failed", "the command did not end within 6 s"),
        ("hal", "missing", "there is no program ./pose"),
        ("ida", "unreadable", "robot-1.obj:1:6: "),
        ("joe", "right", "right: "),
        (
            "kim",
            "failed",
            "./pose cannot be started: it is not executable (chmod +x)",
        ),
    ] {
        let found = result(&report, name, "robot-1");
        assert_eq!(found["outcome"], outcome, "{name}: {found}");
        assert!(
            found["text"].as_str().unwrap().starts_with(text),
            "{name}: {found}"
        );
    }
    // What a program started ends with it, and is then gone or waits to be collected.
    let child = String::from_utf8(class.read("class/bob/child")).unwrap();
    let status = fs::read_to_string(format!("/proc/{}/stat", child.trim())).unwrap_or_default();
    assert!(status.is_empty() || status.contains(") Z "), "{status}");
}

#[test]
fn a_program_is_run_again_only_if_something_of_its_folder_has_changed() {
    let class = class(&[("ada", "echo run >> ../../runs; cp ../../right.obj \"$3\"")]);
    let runs = || class.read("runs").len() / "run\n".len();
    class.graded();
    class.graded();
    assert_eq!(runs(), 1);
    class.write("class/ada/src/main.cpp", "// changed");
    class.graded();
    assert_eq!(runs(), 2);
}

#[test]
fn a_program_that_failed_is_run_again_since_what_it_lacked_may_be_there_by_now() {
    let lines =
        "test -f ../../module || { echo 'no module' >&2; exit 1; }; cp ../../right.obj \"$3\"";
    let class = class(&[
        ("ada", lines),
        (
            "bob",
            "test -f ../../module && cp ../../right.obj \"$3\"; exit 0",
        ),
    ]);
    class.write("class/cem/pose", "#!/bin/sh\ncp ../../right.obj \"$3\"\n");
    let report = class.graded();
    for (name, outcome) in [("ada", "failed"), ("bob", "missing"), ("cem", "failed")] {
        assert_eq!(
            result(&report, name, "robot-1")["outcome"],
            outcome,
            "{name}"
        );
    }
    class.write("module", "");
    let executable = fs::Permissions::from_mode(0o755);
    fs::set_permissions(class.path().join("class/cem/pose"), executable).unwrap();
    let report = class.graded();
    for name in ["ada", "bob", "cem"] {
        assert_eq!(
            result(&report, name, "robot-1")["outcome"],
            "right",
            "{name}"
        );
    }
}

#[test]
fn of_several_tests_none_is_run_again_for_what_a_later_one_leaves_in_the_folder() {
    let lines = "echo run >> ../../runs; date +%N > \"left-$4\"; cp ../../right.obj \"$3\"";
    let class = class(&[("ada", lines)]);
    let mut tests = class.tests_file();
    let mut second = tests["tests"][0].clone();
    second["name"] = "again".into();
    tests["tests"].as_array_mut().unwrap().push(second);
    class.set_tests(&tests);
    let runs = || class.read("runs").len() / "run\n".len();
    class.graded();
    class.graded();
    assert_eq!(runs(), 2);
    class.write("class/ada/src/main.cpp", "// changed");
    class.graded();
    assert_eq!(runs(), 4);
}

/// Sends a signal to a process.
fn signal(name: &str, process: u32) {
    let sent = std::process::Command::new("kill")
        .args(["-s", name, &process.to_string()])
        .status();
    assert!(sent.unwrap().success());
}

#[test]
fn asked_to_end_it_ends_what_it_started_and_asked_twice_it_ends_at_once() {
    let class = class(&[("ada", "echo $$ > child; exec sleep 5")]);
    let started = || {
        let child = class.path().join("class/ada/child");
        let _ = fs::remove_file(&child);
        let grade = std::process::Command::new(env!("CARGO_BIN_EXE_editor"))
            .args(["grade", "class", "--tests", "tests.json", "-o", "report"])
            .current_dir(class.path())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        while !fs::read_to_string(&child)
            .unwrap_or_default()
            .ends_with('\n')
        {
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        grade
    };
    let mut once = started();
    signal("INT", once.id());
    assert_eq!(once.wait().unwrap().code(), Some(1));
    let assert_ended = || {
        let child = String::from_utf8(class.read("class/ada/child")).unwrap();
        let status = || fs::read_to_string(format!("/proc/{}/stat", child.trim()));
        let has_ended = || status().map_or(true, |status| status.contains(") Z "));
        // The system takes its time with what was killed, but far less than the child would.
        let mut looks = (0..200).map(|_| std::thread::sleep(std::time::Duration::from_millis(5)));
        assert!(looks.any(|()| has_ended()), "{:?}", status());
    };
    assert_ended();

    // Both come while it stands still, so that it has no time to end after the first.
    let mut twice = started();
    for name in ["STOP", "INT", "TERM", "CONT"] {
        signal(name, twice.id());
    }
    let code = twice.wait().unwrap().code();
    assert!([Some(128 + 2), Some(128 + 15)].contains(&code), "{code:?}");
    assert_ended();
}

#[test]
fn a_program_is_run_again_if_a_huge_file_or_a_link_in_its_folder_has_changed() {
    let class = class(&[("ada", "echo run >> ../../runs; cp ../../right.obj \"$3\"")]);
    let runs = || class.read("runs").len() / "run\n".len();
    let huge = class.path().join("class/ada/huge");
    let resize = |mib: u64| fs::File::create(&huge).unwrap().set_len(mib << 20).unwrap();
    resize(65);
    class.graded();
    class.graded();
    assert_eq!(runs(), 1);
    resize(66);
    class.graded();
    assert_eq!(runs(), 2);
    let link = class.path().join("class/ada/link");
    std::os::unix::fs::symlink("nowhere", &link).unwrap();
    class.graded();
    assert_eq!(runs(), 3);
    fs::remove_file(&link).unwrap();
    std::os::unix::fs::symlink("elsewhere", &link).unwrap();
    class.graded();
    assert_eq!(runs(), 4);
}

#[test]
fn a_program_that_knows_the_character_itself_is_run_for_one_that_is_built_in() {
    let class = class(&[("ada", "cp ../../right.obj \"$1\"")]);
    let mut tests = class.tests_file();
    tests["tests"][0]["character"] = "builtin:robot".into();
    tests["command"]["run"] = json!(["./pose", "{output}"]);
    class.set_tests(&tests);
    let report = class.graded();
    assert_eq!(result(&report, "ada", "robot-1")["outcome"], "right");
}
