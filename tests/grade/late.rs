//! Programs that are one pose late, or have one pose for all tests.

use crate::diagnose::figures::obj;
use crate::diagnose::student::with;
use crate::grade::support::{Class, result};
use crate::program::editor_in;
use glam::Vec3;
use serde_json::json;

/// Writes the mesh `places` for the test number `test`.
fn write_mesh(class: &Class, student: &str, test: usize, places: &[Vec3]) {
    let (name, figure) = &class.tests[test];
    let text = obj(places, figure, |number| number.to_string());
    class.write(&format!("class/{student}/{name}.obj"), text);
}

#[test]
fn meshes_that_are_all_one_pose_late_are_named_in_whatever_order_a_program_has_made_them() {
    let class = Class::new(&["robot", "robot", "robot", "dog"]);
    let right = with(&[]);
    let zyx = with(&["euler-zyx"]);
    let orders = [("ann", [0, 1, 2]), ("bob", [2, 1, 0]), ("cid", [2, 0, 1])];
    for (student, order) in orders {
        class.submit(student, &right, |number| number.to_string());
        let mut late = class.tests[0].1.positions.clone();
        for test in order {
            write_mesh(&class, student, test, &late);
            late = right.skin(&class.tests[test].1);
        }
    }
    // Of dan's, one is missing and all have a mistake besides; eve's first one is right, as drawn twice.
    write_mesh(&class, "dan", 1, &zyx.skin(&class.tests[0].1));
    write_mesh(&class, "dan", 2, &zyx.skin(&class.tests[1].1));
    for (test, of) in [(0, 0), (1, 0), (2, 1)] {
        write_mesh(&class, "eve", test, &right.skin(&class.tests[of].1));
    }
    let report = class.graded();
    for (student, test, what) in [
        ("ann", "robot-1", "the mesh at rest, before the first one"),
        ("ann", "robot-2", "the result of robot-1"),
        ("ann", "robot-3", "the result of robot-2"),
        ("bob", "robot-3", "the mesh at rest, before the first one"),
        ("bob", "robot-1", "the result of robot-2"),
        ("eve", "robot-2", "the result of robot-1"),
        ("eve", "robot-3", "the result of robot-2"),
    ] {
        let found = result(&report, student, test);
        assert_eq!(found["outcome"], "explained", "{found}");
        assert_eq!(found["causes"], json!([["pose-late"]]), "{found}");
        assert_eq!(
            found["points"],
            json!({"3.2": 4.0, "3.4": 3.0, "4.2": 10.0})
        );
        let text = found["text"].as_str().unwrap();
        let told = format!("pose-late: the mesh is that of the pose before ({what})\n  section");
        assert!(text.starts_with(&told), "{text}");
        assert!(text.contains("\n  look at  the order in which"), "{text}");
    }
    for test in ["robot-2", "robot-3"] {
        let found = result(&report, "dan", test);
        let both = json!([["pose-late", "euler-zyx"]]);
        assert_eq!(found["causes"], both, "{found}");
    }
    assert_eq!(result(&report, "eve", "robot-1")["outcome"], "right");
    assert_eq!(result(&report, "ann", "dog-4")["outcome"], "right");
    // An order by neither place nor name is that of no program.
    assert_eq!(
        result(&report, "cid", "robot-1")["hint"],
        "the result of robot-3"
    );
}

#[test]
fn a_picture_of_a_mesh_of_a_late_program_is_late_as_well() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let mut tests = class.tests_file();
    for (test, name) in [(0, "front"), (2, "last")] {
        let mut picture = tests["tests"][test].clone();
        picture["name"] = name.into();
        picture["kind"] = "picture".into();
        picture["size"] = json!([400, 300]);
        tests["tests"].as_array_mut().unwrap().push(picture);
    }
    class.set_tests(&tests);
    let right = with(&[]);
    let rest = class.tests[0].1.positions.clone();
    write_mesh(&class, "ann", 0, &rest);
    write_mesh(&class, "ann", 1, &right.skin(&class.tests[0].1));
    write_mesh(&class, "ann", 2, &right.skin(&class.tests[1].1));
    // Nothing is posed at all.
    (0..3).for_each(|test| write_mesh(&class, "bob", test, &rest));
    for student in ["ann", "bob"] {
        for files in [["robot-1.obj", "front.png"], ["robot-3.obj", "last.png"]] {
            let [mesh, picture] = files.map(|it| format!("class/{student}/{it}"));
            let words = ["render", &mesh, "--size", "400x300", "-o", &picture];
            let ran = editor_in(class.path(), &words);
            assert_eq!(ran.code, Some(0), "{}", ran.err);
        }
    }
    let report = class.graded();
    for (student, cause) in [("ann", "pose-late"), ("bob", "pose-not-applied")] {
        for test in ["robot-1", "front", "robot-3", "last"] {
            let found = result(&report, student, test);
            assert_eq!(
                found["causes"][0],
                json!([cause]),
                "{student} {test}: {found}"
            );
        }
    }
}

#[test]
fn meshes_that_are_not_all_late_are_each_what_they_are_alone() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    let rest = class.tests[0].1.positions.clone();
    // The last one is right.
    class.submit("ann", &right, |number| number.to_string());
    write_mesh(&class, "ann", 0, &rest);
    write_mesh(&class, "ann", 1, &right.skin(&class.tests[0].1));
    // A single mesh may have a wrong name.
    write_mesh(&class, "bob", 1, &right.skin(&class.tests[0].1));
    // Nothing is posed at all.
    (0..3).for_each(|test| write_mesh(&class, "cid", test, &rest));
    let report = class.graded();
    for student in ["ann", "bob"] {
        let found = result(&report, student, "robot-2");
        assert_eq!(found["hint"], "the result of robot-1", "{found}");
    }
    for (student, test) in [("ann", "robot-1"), ("cid", "robot-1"), ("cid", "robot-3")] {
        let found = result(&report, student, test);
        assert_eq!(found["causes"][0], json!(["pose-not-applied"]), "{found}");
    }
}

#[test]
fn late_meshes_of_simple_poses_are_late_though_a_mistake_in_angles_gives_some_of_them() {
    let mut class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    for (test, by) in [20.0, 40.0, 60.0].into_iter().enumerate() {
        let joints = class.tests[test].1.degrees.len();
        let degrees = (0..joints).map(|joint| Vec3::X * if joint == 1 { by } else { 0.0 });
        class.set_pose(test, degrees.collect());
    }
    let mut late = class.tests[0].1.positions.clone();
    for test in 0..3 {
        write_mesh(&class, "ann", test, &late);
        late = right.skin(&class.tests[test].1);
    }
    let report = class.graded();
    for test in ["robot-1", "robot-2", "robot-3"] {
        let found = result(&report, "ann", test);
        assert_eq!(found["causes"], json!([["pose-late"]]), "{found}");
    }
}

#[test]
fn meshes_that_are_all_of_one_test_are_said_to_be_and_count_as_of_another_pose() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    for (student, of) in [("ann", 0), ("bob", 2)] {
        for test in 0..3 {
            write_mesh(&class, student, test, &right.skin(&class.tests[of].1));
        }
    }
    let report = class.graded();
    for (student, test, of) in [("ann", "robot-3", 1), ("bob", "robot-1", 3)] {
        let found = result(&report, student, test);
        let hint = format!("the result of robot-{of}, as in all tests");
        assert_eq!(found["hint"], hint, "{found}");
        assert_eq!(found["points"]["4.2"], 0.0, "{found}");
        let text = found["text"].as_str().unwrap();
        let told = format!(
            "another test: this is the result of robot-{of}, as all meshes of this character are, so that "
        );
        assert!(text.starts_with(&told), "{text}");
    }
    assert_eq!(result(&report, "bob", "robot-3")["outcome"], "right");
}
