//! The examples of the page about grading, done as it says.

use crate::program::{Ran, editor_in};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const PAGE: &str = include_str!("../../docs/grading.md");

/// The blocks of the page in a language, in their order.
fn blocks(language: &str) -> Vec<&'static str> {
    let start = format!("```{language}\n");
    let all = PAGE.split(&*start).skip(1);
    all.map(|rest| rest.split_once("```").expect("an end").0)
        .collect()
}

/// A folder with the pose of the page and one of its files of tests.
fn folder(tests: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("walk.json"), blocks("json")[1]).unwrap();
    fs::write(folder.path().join("tests.json"), tests).unwrap();
    folder
}

/// Runs a line of the page, and checks that it succeeds.
#[track_caller]
fn run(folder: &Path, line: &str) -> Ran {
    let words: Vec<&str> = line.split_whitespace().collect();
    let ran = match &words[..] {
        ["mkdir", "-p", folders @ ..] => {
            for name in folders {
                fs::create_dir_all(folder.join(name)).unwrap();
            }
            return Ran {
                code: Some(0),
                out: String::new(),
                err: String::new(),
            };
        }
        ["./editor", arguments @ ..] => editor_in(folder, arguments),
        _ => panic!("{line} is no line that is known"),
    };
    assert_eq!(ran.code, Some(0), "{line}: {}", ran.err);
    ran
}

/// The files of a character of our own under the name that the page has.
fn model(folder: &Path) {
    let characters = format!("{}/assets/characters", env!("CARGO_MANIFEST_DIR"));
    for extension in ["obj", "skel", "attach"] {
        let from = format!("{characters}/adult.{extension}");
        fs::copy(from, folder.join(format!("Model1.{extension}"))).unwrap();
    }
}

#[test]
fn the_program_prints_the_example_of_everything_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let ran = editor_in(folder.path(), &["grade", "--example"]);
    assert_eq!(
        (ran.code, &*ran.out, &*ran.err),
        (Some(0), blocks("json")[2], "")
    );
}

fn report(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("report/grade.json")).unwrap()).unwrap()
}

#[test]
fn the_first_example_gives_the_rows_that_stand_below_it() {
    let folder = folder(blocks("json")[0]);
    let mut printed = String::new();
    for line in blocks("sh")[0].lines() {
        printed += &run(folder.path(), line).out;
    }
    let told = PAGE.split("```\n\n```\n").nth(1).expect("what is printed");
    assert_eq!(printed, told.split_once("```").unwrap().0);
}

#[test]
fn the_example_with_everything_grades_a_folder_that_is_made_by_hand() {
    let folder = folder(blocks("json")[2]);
    let folder = folder.path();
    model(folder);
    run(folder, "mkdir -p submissions/Chen");
    let chen = "submissions/Chen";
    run(
        folder,
        &format!("./editor export Model1.obj --pose walk.json -o {chen}/walk.obj"),
    );
    let picture = format!(
        "./editor render Model1.obj --pose walk.json --camera 80,10,1.5,0.5,0.5,0.5 --size 800x600 -o {chen}/front.png"
    );
    run(folder, &picture);
    let ran = run(
        folder,
        "./editor grade submissions --tests tests.json -o report",
    );
    let report = report(folder);
    for test in report["submissions"][0]["tests"].as_array().unwrap() {
        assert_eq!(test["outcome"], "right", "{}", ran.out);
    }
}

#[cfg(unix)]
#[test]
fn with_the_example_of_a_command_files_in_the_folder_are_told_not_to_be_read() {
    let folder = folder(blocks("json")[3]);
    let folder = folder.path();
    model(folder);
    run(folder, "mkdir -p submissions/Chen submissions/Dube");
    run(
        folder,
        "./editor export Model1.obj --pose walk.json -o submissions/Chen/walk.obj",
    );
    let ran = run(
        folder,
        "./editor grade submissions --tests tests.json -o report",
    );
    let (table, reasons) = ran.out.split_once("missing: ").expect("reasons");
    assert_eq!(table.lines().count(), 3);
    let expected = "there is no program ./build/pose (Dube)\nmissing: there is no program ./build/pose; \
                    the walk.obj that is there is not read, since the tests have a command (Chen)\n";
    assert_eq!(reasons, expected);
}
