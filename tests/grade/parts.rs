//! Runs that resume where another one stopped, and parts that are joined.

use crate::diagnose::student::{RIGHT, with};
use crate::grade::support::Class;
use std::fs;

fn class() -> Class {
    let class = Class::new(&["robot"]);
    for (name, ids) in [
        ("ada", &[][..]),
        ("bob", &["euler-zyx"]),
        ("cem", &["no-inverse-bind", "euler-xzy"]),
        ("dan", &["parent-order"]),
        ("eve", &["euler-zyx"]),
    ] {
        class.submit(name, &with(ids), |number| number.to_string());
    }
    class.write("class/fay/notes.txt", "no file");
    class
}

#[track_caller]
fn run(class: &Class, line: &str) -> String {
    let ran = class.run(line);
    assert_eq!(ran.code, Some(0), "{line}: {}", ran.err);
    ran.err
}

#[test]
fn parts_that_are_joined_give_the_report_of_one_run_byte_for_byte() {
    let class = class();
    run(&class, "class --tests tests.json -o whole");
    for part in 1..=4 {
        run(
            &class,
            &format!("class --tests tests.json --part {part}/4 -o part-{part}"),
        );
    }
    run(&class, "--merge part-3 part-1 part-4 part-2 -o joined");
    class.assert_same("whole", "joined");
    // A part that comes twice changes nothing.
    run(
        &class,
        "--merge part-1 part-1 part-2 part-3 part-4 -o joined",
    );
    class.assert_same("whole", "joined");
}

#[test]
fn parts_are_not_joined_into_one_of_them() {
    let class = class();
    for part in 1..=2 {
        run(
            &class,
            &format!("class --tests tests.json --part {part}/2 -o part-{part}"),
        );
    }
    let before = class.read("part-1/grade.json");
    for output in ["part-1", "part-2", "part-2/../part-1/"] {
        let ran = class.run(&format!("--merge part-1 part-2 -o {output}"));
        let told = format!(
            "error: {output}: expected another folder for the report than those of parts\n"
        );
        assert_eq!((ran.code, ran.err), (Some(1), told));
    }
    assert_eq!(class.read("part-1/grade.json"), before);
}

#[test]
fn a_part_replaces_no_report_of_the_class_and_none_of_another_part() {
    let class = class();
    run(&class, "class --tests tests.json -o whole");
    run(&class, "class --tests tests.json --part 1/2 -o part");
    let before = class.read("whole/grade.json");
    for (output, found) in [("whole", "a whole class"), ("part", "part 1/2")] {
        let ran = class.run(&format!("class --tests tests.json --part 2/2 -o {output}"));
        let told = format!(
            "error: {output}: expected a folder for the report of part 2/2, found that of {found}\n"
        );
        assert_eq!(ran.code, Some(1));
        assert!(ran.err.ends_with(&told), "{}", ran.err);
    }
    assert_eq!(class.read("whole/grade.json"), before);
    run(&class, "class --tests tests.json --part 1/2 -o part");
}

#[test]
fn the_page_of_a_submission_that_is_gone_goes_too() {
    let class = class();
    run(&class, "class --tests tests.json -o report");
    fs::write(class.path().join("report/pages/mine.html"), "").unwrap();
    fs::rename(
        class.path().join("class/ada"),
        class.path().join("class/zoe"),
    )
    .unwrap();
    run(&class, "class --tests tests.json -o report");
    let there = |name: &str| {
        class
            .path()
            .join(format!("report/pages/{name}.html"))
            .exists()
    };
    assert!(!there("ada") && there("zoe") && there("bob") && there("mine"));
}

#[test]
fn submissions_are_in_the_order_in_which_people_count_in_joined_reports_too() {
    let class = Class::new(&["robot"]);
    for name in ["S10", "S2", "S1", "s3", "S2b", "S02"] {
        class.write(&format!("class/{name}/notes.txt"), "no file");
    }
    run(&class, "class --tests tests.json -o whole");
    let csv = String::from_utf8(class.read("whole/grade.csv")).unwrap();
    let names: Vec<&str> = csv
        .lines()
        .skip(1)
        .map(|line| &line[..line.find(',').unwrap()])
        .collect();
    assert_eq!(names, ["S1", "S02", "S2", "S2b", "s3", "S10"]);
    for part in 1..=2 {
        run(
            &class,
            &format!("class --tests tests.json --part {part}/2 -o part-{part}"),
        );
    }
    run(&class, "--merge part-1 part-2 -o joined");
    class.assert_same("whole", "joined");
}

#[test]
fn jobs_that_write_into_one_folder_at_once_take_no_file_of_another_for_abandoned() {
    let folder = tempfile::tempdir().unwrap();
    std::thread::scope(|threads| {
        for writer in 0..8 {
            let path = folder.path().join(format!("{writer}.json"));
            threads.spawn(move || {
                for round in 0..40 {
                    let bytes = format!("{writer} {round}");
                    editor_core::disk::write_whole(&path, bytes.as_bytes()).unwrap();
                }
            });
        }
    });
    let left = std::fs::read_dir(folder.path()).unwrap();
    assert_eq!(left.count(), 8);
}

#[test]
fn reports_are_the_same_whatever_the_number_of_jobs() {
    let class = class();
    run(&class, "class --tests tests.json -o one --jobs 1");
    run(&class, "class --tests tests.json -o many --jobs 7");
    class.assert_same("one", "many");
}

#[test]
fn what_is_graded_is_not_graded_again_unless_it_has_changed() {
    let class = class();
    let graded = |line: &str| {
        let told = run(&class, line);
        let told = told
            .lines()
            .find(|line| line.starts_with("graded "))
            .unwrap();
        let (_, rest) = told.split_once(" in ").unwrap();
        let (_, rest) = rest.split_once(" s").unwrap();
        rest.trim_start_matches(", ").to_owned()
    };
    let line = "class --tests tests.json -o report";
    assert_eq!(graded(line), "");
    let first = class.read("report/grade.html");
    assert_eq!(graded(line), "6 of them before");
    assert_eq!(class.read("report/grade.html"), first);
    // As a run leaves it that was cut off.
    fs::remove_file(class.path().join("report/kept/submissions/bob.json")).unwrap();
    class.write("report/kept/submissions/cem.json", "{\"robot-1\": ");
    fs::remove_file(class.path().join("report/kept/run.json")).unwrap();
    assert_eq!(graded(line), "4 of them before");
    assert_eq!(class.read("report/grade.html"), first);
    class.submit("bob", &RIGHT, |number| number.to_string());
    assert_eq!(graded(line), "5 of them before");
    assert_ne!(class.read("report/grade.html"), first);
    // Other points need no file to be graded anew, and another pose all of them.
    let mut tests = class.tests_file();
    tests["tests"][0]["points"]["4.2"] = 30.into();
    class.set_tests(&tests);
    assert_eq!(graded(line), "6 of them before");
    class.write("robot-1.json", "{\"joints\": {\"1\": [10, 20, 30]}}");
    // The one without a file is still without one, but by another test.
    assert_eq!(graded(line), "");
}

#[test]
fn what_another_build_of_the_program_graded_is_graded_anew() {
    let class = class();
    let line = "class --tests tests.json -o report";
    run(&class, line);
    let kept = "report/kept/submissions/bob.json";
    let mut results: serde_json::Value = serde_json::from_slice(&class.read(kept)).unwrap();
    let key = results["robot-1"]["key"].as_str().unwrap().to_owned();
    // The key begins with the size of the program.
    let program = fs::metadata(env!("CARGO_BIN_EXE_editor")).unwrap().len();
    let rest = key
        .strip_prefix(&program.to_string())
        .expect("the program's size");
    results["robot-1"]["key"] = format!("{}{rest}", program + 1).into();
    class.write(kept, results.to_string());
    assert!(run(&class, line).contains("5 of them before"));
    assert!(run(&class, line).contains("6 of them before"));
}

#[test]
fn parts_of_other_tests_or_with_other_results_do_not_fit() {
    let class = class();
    run(&class, "class --tests tests.json --part 1/2 -o a");
    run(&class, "class --tests tests.json --part 1/4 -o f");
    run(&class, "class --tests tests.json --part 4/4 -o g");
    run(&class, "class --tests tests.json -o b");
    class.submit("bob", &RIGHT, |number| number.to_string());
    run(&class, "class --tests tests.json -o c");
    let mut tests = class.tests_file();
    tests["title"] = "Another".into();
    class.set_tests(&tests);
    run(&class, "class --tests tests.json --part 2/2 -o d");
    for (line, told) in [
        (
            "--merge a d -o e",
            "error: d: expected the same tests as in a, found others\n",
        ),
        (
            "--merge b c -o e",
            "error: c: expected the same results for bob as in b, found others\n",
        ),
        (
            "--merge a -o e",
            "error: a: expected the reports of all 2 parts, found none of part 2/2\n",
        ),
        (
            "--merge f g -o e",
            "error: f: expected the reports of all 4 parts, found none of part 2/4, 3/4\n",
        ),
        (
            "--merge a f -o e",
            "error: f: expected one of 2 parts as in a, found part 1 of 4\n",
        ),
    ] {
        let ran = class.run(line);
        assert_eq!((ran.code, &*ran.err), (Some(1), told));
        assert!(!class.path().join("e").exists());
    }
    let mut run: serde_json::Value =
        serde_json::from_slice(&class.read("f/kept/run.json")).unwrap();
    run["part"]["count"] = u64::MAX.into();
    class.write("f/kept/run.json", run.to_string());
    let ran = class.run("--merge f -o e");
    let told = format!(", 9/{} and more\n", u64::MAX);
    assert!(
        ran.code == Some(1) && ran.err.ends_with(&told),
        "{}",
        ran.err
    );
}
