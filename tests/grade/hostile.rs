//! Submissions and parts that are made to mislead the grader.

use crate::diagnose::student::{RIGHT, with};
use crate::grade::support::{Class, result};
use serde_json::Value;
use std::fs;

fn class() -> Class {
    let class = Class::new(&["robot"]);
    class.submit("ada", &RIGHT, |number| number.to_string());
    class.submit("bob", &with(&["euler-zyx"]), |number| number.to_string());
    class
}

fn json(class: &Class, path: &str) -> Value {
    serde_json::from_slice(&class.read(path)).unwrap()
}

#[test]
fn the_picture_of_a_mesh_does_not_depend_on_the_faces_of_the_submission() {
    let class = class();
    let text = String::from_utf8(class.read("class/bob/robot-1.obj")).unwrap();
    let faces = "f 1 2 3\n".repeat(1000);
    class.write("class/cem/robot-1.obj", text + &faces);
    class.graded();
    let picture = |name: &str| {
        let kept = json(&class, &format!("report/kept/submissions/{name}.json"));
        let picture = kept["robot-1"]["graded"]["picture"].as_str();
        picture.unwrap().to_owned()
    };
    assert!(picture("cem") == picture("bob"));
}

#[cfg(unix)]
#[test]
fn a_link_to_the_file_of_another_submission_is_unreadable() {
    let class = class();
    fs::create_dir(class.path().join("class/cem")).unwrap();
    std::os::unix::fs::symlink(
        "../ada/robot-1.obj",
        class.path().join("class/cem/robot-1.obj"),
    )
    .unwrap();
    let report = class.graded();
    let found = result(&report, "cem", "robot-1");
    assert_eq!(found["outcome"], "unreadable");
    assert_eq!(
        found["text"],
        "robot-1.obj: expected a file, found a symbolic link"
    );
}

#[test]
fn a_part_cannot_name_files_outside_of_its_folder_nor_put_markup_into_the_page() {
    let class = class();
    let ran = class.run("class --tests tests.json -o part");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let run = json(&class, "part/kept/run.json");
    for name in ["../../ada", "/ada", "..", "", "a/b"] {
        let mut run = run.clone();
        run["submissions"] = vec![name].into();
        class.write("part/kept/run.json", run.to_string());
        let ran = class.run("--merge part -o joined");
        let told = format!("error: part: expected the name of a folder, found “{name}”\n");
        assert_eq!((ran.code, ran.err), (Some(1), told));
        assert!(!class.path().join("joined").exists());
    }
    let mut run = run.clone();
    run["pictures"]["robot-1"] = "\"/><b>bold</b>".into();
    class.write("part/kept/run.json", run.to_string());
    assert_eq!(class.run("--merge part -o joined").code, Some(0));
    let page = String::from_utf8(class.read("joined/grade.html")).unwrap();
    assert!(!page.contains("<b>"));
}

#[test]
fn names_that_spreadsheets_would_run_are_texts_in_the_table() {
    let class = class();
    class.submit("=1+1", &RIGHT, |number| number.to_string());
    class.graded();
    let table = String::from_utf8(class.read("report/grade.csv")).unwrap();
    assert!(table.contains("\r\n'=1+1,"), "{table}");
}

#[test]
fn only_the_folder_of_a_finished_report_is_left_out_and_that_is_reported() {
    let class = class();
    class.write("class/bob/kept/submissions/readme.txt", "");
    let ran = class.run("class --tests tests.json -o class/report");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let report = json(&class, "class/report/grade.json");
    result(&report, "bob", "robot-1");
    let ran = class.run("class --tests tests.json -o class/report");
    let told = "warning: class/report: left out, since it is a report\n";
    assert!(ran.err.starts_with(told), "{}", ran.err);
}

#[test]
fn a_report_does_not_come_into_the_folder_of_the_submissions_or_into_one_of_them() {
    let class = class();
    for (output, found) in [
        ("class", "that of the submissions"),
        ("class/../class", "that of the submissions"),
        ("class/bob", "a submission"),
    ] {
        let ran = class.run(&format!("class --tests tests.json -o {output}"));
        let told = format!("error: {output}: expected a folder for the report, found {found}\n");
        assert_eq!((ran.code, &*ran.err), (Some(1), &*told));
    }
    assert!(!class.path().join("class/kept").exists());
    assert!(!class.path().join("class/bob/kept").exists());
}

#[test]
#[cfg(unix)]
fn a_submission_that_is_a_link_to_another_one_is_left_out_and_that_is_reported() {
    let class = class();
    std::os::unix::fs::symlink("bob", class.path().join("class/copy")).unwrap();
    let ran = class.run("class --tests tests.json -o report");
    let told = "warning: class/copy: left out, since it is a symbolic link\n";
    assert!(
        ran.code == Some(0) && ran.err.starts_with(told),
        "{}",
        ran.err
    );
    let report = json(&class, "report/grade.json");
    let submissions = report["submissions"].as_array().unwrap();
    assert!(submissions.iter().all(|one| one["name"] != "copy"));
}
