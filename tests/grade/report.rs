//! What an instructor gets: rows, a table, and a page that needs nothing else.

use crate::diagnose::figures::{Figure, obj, turned};
use crate::diagnose::student::{Student, with};
use crate::grade::support::{Class, result};
use crate::program::editor_in;
use editor_core::character::skinning::skin_positions;
use editor_core::math::Euler;
use glam::{EulerRot, Mat3, Mat4, Quat, Vec3};
use serde_json::{Value, json};
use std::path::Path;

fn class() -> Class {
    let class = Class::new(&["robot", "dog"]);
    for (name, ids) in [
        ("Ada & <Bob>", &[][..]),
        ("eve", &["euler-zyx"]),
        ("kim, lee", &["euler-zyx"]),
    ] {
        class.submit(name, &with(ids), |number| number.to_string());
    }
    class.write(
        "class/zoe/robot-1.obj",
        "v 1 2 <script>alert(1)</script>\u{1b}[0m\nf 1 1 1\n",
    );
    let mut tests = class.tests_file();
    tests["title"] = "Assignment <1> & more".into();
    tests["rubric"] = json!({
        "sections": {"artifact": {"title": "Artifact", "points": 10}, "extra credit": {"points": 5, "extra": true}},
        "given": {"eve": {"artifact": 9.5, "extra credit": 2}},
    });
    class.set_tests(&tests);
    class
}

#[test]
fn every_submission_has_a_row_on_the_terminal_and_the_same_mistake_is_one_line() {
    let class = class();
    let ran = class.run("class --tests tests.json -o report");
    let expected = "\
submission   points  3.2  3.4   4.2    artifact  extra credit  result
Ada & <Bob>  40/40 (10 wait)  8/8  12/12  20/20  -/10      none          right
eve          45.5/50  8/8  6/12  20/20  9.5/10    2/5           euler-zyx
kim, lee     34/40 (10 wait)  8/8  6/12  20/20  -/10      none          euler-zyx
zoe          0/40 (10 wait)    0/8  0/12  0/20   -/10      none          unreadable (robot-1); missing (dog-2)
wait: points that are still to be given by hand, by \"given\" in the rubric, in sections with -
euler-zyx in 2 submissions: eve, kim, lee
missing: there is no dog-2.obj (zoe)
unreadable: robot-1.obj:1:7: expected a number for z, found “<script>alert(1)</script>\\u{1b}[0m” (zoe)
";
    let squeezed = |text: &str| {
        text.lines()
            .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
            .collect::<Vec<_>>()
    };
    assert_eq!(squeezed(&ran.out), squeezed(expected));
    assert_eq!(ran.code, Some(0));
    assert!(
        ran.err.ends_with("the report is in report/grade.html\n"),
        "{}",
        ran.err
    );
}

#[test]
fn what_is_asked_about_a_mesh_at_the_origin_is_not_shortened_on_the_terminal() {
    let class = Class::new(&["robot"]);
    let figure = &class.tests[0].1;
    let origin = vec![Vec3::ZERO; figure.positions.len()];
    let number: fn(f32) -> String = |number| number.to_string();
    class.write("class/gus/robot-1.obj", obj(&origin, figure, number));
    let ran = class.run("class --tests tests.json -o report");
    let question = "blank: all vertices are at the origin: are the joints' matrices filled, and the inverse bind \
                    matrices? New ones are 0, and so are weights below 1 that are read as whole numbers (gus)\n";
    assert!(ran.out.ends_with(question), "{}", ran.out);
}

#[test]
fn files_of_which_nothing_is_known_are_named_to_be_looked_at_by_hand() {
    let class = Class::new(&["robot", "robot"]);
    let right = with(&[]);
    let bent = |number: usize, off: usize| {
        let (test, figure) = &class.tests[number];
        let mut places = right.skin(figure);
        let bent = places.iter_mut().take(off);
        bent.for_each(|at| *at += Vec3::new(1.0, 2.0, 3.0) * at.x);
        let text = obj(&places, figure, |number| number.to_string());
        (format!("{test}.obj"), text)
    };
    for (student, files) in [
        ("ann", &[(0, 300)][..]),
        ("bob", &[(0, 300), (1, 200)]),
        ("cem", &[(1, 1)]),
    ] {
        class.submit(student, &right, |number| number.to_string());
        for (number, off) in files {
            let (name, text) = bent(*number, *off);
            class.write(&format!("class/{student}/{name}"), text);
        }
    }
    let ran = class.run("class --tests tests.json -o report");
    let told = "\nunexplained: to be looked at by hand (ann: robot-1; bob)\n";
    assert!(ran.out.ends_with(told), "{}", ran.out);
    assert!(ran.out.contains("all but 1 vertex"), "{}", ran.out);
}

#[test]
fn the_exact_result_of_another_pose_is_told_and_shows_none_of_the_sections() {
    let class = Class::new(&["robot"]);
    class.submit("bob", &with(&[]), |number| number.to_string());
    class.write(
        "robot-1.json",
        r#"{"joints": {"Left elbow": [10, 20, 30]}}"#,
    );
    let ran = class.run("class --tests tests.json -o report");
    assert!(ran.out.contains("other-pose"), "{}", ran.out);
    let report = class.graded();
    let bob = result(&report, "bob", "robot-1");
    assert_eq!(bob["outcome"], "other-pose");
    assert_eq!(bob["points"], json!({"3.2": 0.0, "3.4": 0.0, "4.2": 0.0}));
    let text = bob["text"].as_str().unwrap();
    assert!(
        text.contains("of a pose that is not the given one"),
        "{text}"
    );
    let table = String::from_utf8(class.read("report/grade.csv")).unwrap();
    assert!(table.contains("other-pose"), "{table}");
}

/// Writes what gives `degrees` instead of those of the first test, exactly.
fn submit_in(class: &Class, name: &str, degrees: impl Fn(usize) -> Vec3) {
    let (test, figure) = &class.tests[0];
    let theirs = Figure::builtin(figure.name.trim_start_matches("builtin:"), degrees);
    let text = obj(&with(&[]).skin(&theirs), figure, |number| {
        number.to_string()
    });
    class.write(&format!("class/{name}/{test}.obj"), text);
}

#[test]
fn another_pose_counts_as_a_slip_in_joints_only_if_more_than_half_of_it_is_as_asked() {
    let class = Class::new(&["adult"]);
    let asked = class.tests[0].1.degrees.clone();
    let other = turned(77);
    let all = asked.len();
    let at_rest_from = |count: usize| {
        let asked = &asked;
        move |joint: usize| {
            if joint < count {
                asked[joint]
            } else {
                Vec3::ZERO
            }
        }
    };
    submit_in(&class, "quarter", at_rest_from(all / 4));
    submit_in(&class, "most", at_rest_from(all * 3 / 4));
    submit_in(&class, "one", at_rest_from(4));
    submit_in(&class, "other", other);
    submit_in(&class, "whole degrees", |joint| {
        asked[joint] + Vec3::splat(0.5)
    });
    let report = class.graded();
    let turned_by = |&asked: &Vec3| {
        let [before, after] = [asked, asked + Vec3::splat(0.5)]
            .map(|degrees| Quat::from_mat3(&Euler::from_degrees(degrees).to_mat3()));
        before.angle_between(after).to_degrees()
    };
    let most = asked.iter().map(turned_by).fold(0.0, f32::max);
    let all_by_little = format!("{all} of {all} joints turned otherwise, by up to {most:.1}°");
    for (name, points, hint) in [
        ("one", [0.0; 3], None),
        ("quarter", [0.0; 3], None),
        ("other", [0.0; 3], None),
        ("most", [4.0, 3.0, 10.0], Some("right but for 5 joints")),
        ("whole degrees", [4.0, 3.0, 10.0], Some(&*all_by_little)),
    ] {
        let found = result(&report, name, "adult-1");
        assert_eq!(found["outcome"], "other-pose", "{name}: {found}");
        let [a, b, c] = points;
        let points = json!({"3.2": a, "3.4": b, "4.2": c});
        assert_eq!(found["points"], points, "{name}: {found}");
        assert_eq!(found["hint"].as_str(), hint, "{name}: {found}");
    }
}

#[test]
fn a_joint_that_is_not_turned_in_a_file_with_two_digits_counts_as_that_and_as_too_few_digits() {
    let class = Class::new(&["adult"]);
    let (test, figure) = &class.tests[0];
    let knee = 10;
    let posed = Figure::builtin("adult", |joint| figure.degrees[joint]).without(knee);
    let text = obj(&with(&[]).skin(&posed), figure, |number| {
        format!("{number:.2}")
    });
    class.write(&format!("class/ann/{test}.obj"), text);
    let report = class.graded();
    let found = result(&report, "ann", "adult-1");
    assert_eq!(found["hint"], "right but for 1 joint", "{found}");
    let points = json!({"3.2": 4.0, "3.4": 3.0, "4.2": 9.0});
    assert_eq!(found["points"], points, "{found}");
    let why = json!([
        "right-but-for-joints leaves 50 % of 3.4",
        "right-but-for-digits leaves 90 % of 4.2"
    ]);
    assert_eq!(found["why"], why, "{found}");
}

#[test]
fn the_pose_of_another_character_s_test_is_told_and_shows_none_of_the_sections() {
    let mut class = Class::new(&["adult", "dog"]);
    // Both have joints of these names.
    let turned = |at: usize, by: [Vec3; 2], among: usize| {
        let mut degrees = vec![Vec3::ZERO; among];
        degrees[0] = by[0];
        degrees[at] = by[1];
        degrees
    };
    let by = [Vec3::new(0.0, 40.0, 10.0), Vec3::new(20.0, 0.0, 15.0)];
    let of_dog = turned(2, by, class.tests[1].1.degrees.len());
    class.set_pose(1, of_dog);
    let of_adult = turned(1, by, class.tests[0].1.degrees.len());
    submit_in(&class, "bob", |joint| of_adult[joint]);
    let report = class.graded();
    let bob = result(&report, "bob", "adult-1");
    assert_eq!(bob["hint"], "the pose of dog-2", "{bob}");
    assert_eq!(bob["points"], json!({"3.2": 0.0, "3.4": 0.0, "4.2": 0.0}));
}

#[test]
fn files_that_are_swapped_between_tests_are_said_to_be_and_told_anew_when_tests_change() {
    let mut class = Class::new(&["robot", "robot"]);
    class.submit("bob", &with(&[]), |number| number.to_string());
    let [one, two] = ["robot-1", "robot-2"].map(|test| format!("class/bob/{test}.obj"));
    let (first, second) = (class.read(&one), class.read(&two));
    class.write(&one, second);
    class.write(&two, first);
    let ran = class.run("class --tests tests.json -o report");
    for told in [
        "other-pose: the result of robot-2 (robot-1)",
        "other-pose: the result of robot-1 (robot-2)",
    ] {
        assert!(ran.out.contains(told), "{}", ran.out);
    }
    let report = class.graded();
    let bob = result(&report, "bob", "robot-1");
    let text = bob["text"].as_str().unwrap();
    let told = "another test: this is exactly the result of robot-2, so that the file may have the wrong name";
    assert_eq!(text, told);
    // Without the other test it is that of some other pose.
    let mut tests = class.tests_file();
    tests["tests"].as_array_mut().unwrap().pop();
    class.tests.pop();
    class.set_tests(&tests);
    let report = class.graded();
    let bob = result(&report, "bob", "robot-1");
    assert_eq!(
        (&bob["outcome"], &bob["hint"]),
        (&json!("other-pose"), &json!(null))
    );
}

#[test]
fn a_file_of_another_test_with_a_mistake_besides_is_said_to_be_that() {
    let class = Class::new(&["robot", "robot", "dog"]);
    for (student, ids) in [("ann", "euler-zyx"), ("bob", "no-inverse-bind")] {
        class.submit(student, &with(&[ids]), |number| number.to_string());
        let first = class.read(&format!("class/{student}/robot-1.obj"));
        class.write(&format!("class/{student}/robot-2.obj"), first);
    }
    let report = class.graded();
    for (student, ids) in [("ann", "euler-zyx"), ("bob", "no-inverse-bind")] {
        let found = result(&report, student, "robot-2");
        let of_first = format!("the result of robot-1, with {ids}");
        assert_eq!(
            (&found["outcome"], &found["hint"]),
            (&json!("other-pose"), &json!(of_first)),
            "{found}"
        );
        let text = found["text"].as_str().unwrap();
        assert!(
            text.starts_with(&format!("another test: this is {of_first}, so that ")),
            "{text}"
        );
        let right = result(&report, student, "robot-1");
        assert_eq!(right["causes"], json!([[ids]]), "{right}");
    }
}

#[test]
fn the_result_of_another_test_is_told_before_a_joint_that_is_not_turned_beside_a_mistake() {
    let mut class = Class::new(&["adult", "adult"]);
    let joints = class.tests[0].1.degrees.len();
    let pose = |turned: &[(usize, Vec3)]| {
        let mut degrees = vec![Vec3::ZERO; joints];
        turned.iter().for_each(|&(joint, by)| degrees[joint] = by);
        degrees
    };
    let (leg, knee, shoulder) = (9, 10, 16);
    let as_asked = (leg, Vec3::new(0.0, 30.0, 10.0));
    let asked = [as_asked, (knee, Vec3::Z * 20.0), (shoulder, Vec3::X * 40.0)];
    let other = [as_asked, (shoulder, Vec3::X * -40.0)];
    class.set_pose(0, pose(&asked));
    let of_other = pose(&other);
    submit_in(&class, "ann", |joint| of_other[joint]);
    let both = json!([["sign-flipped-x", "joint-not-turned"]]);
    let found = result(&class.graded(), "ann", "adult-1").clone();
    assert_eq!(found["causes"], both, "{found}");
    let points = json!({"3.2": 4.0, "3.4": 1.5, "4.2": 10.0});
    assert_eq!(found["points"], points, "{found}");
    // Once there is a test with that pose, it is found anew.
    class.set_pose(1, of_other.clone());
    let found = result(&class.graded(), "ann", "adult-1").clone();
    assert_eq!(found["hint"], "the result of adult-2", "{found}");
}

#[test]
fn results_that_are_skinned_instead_of_the_mesh_at_rest_are_named_with_their_tests() {
    let mut class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    class.submit("ann", &right, |number| number.to_string());
    class.submit("bob", &right, |number| number.to_string());
    // Ann's program begins anew at the third test, Bob's never.
    let rest = class.tests[0].1.positions.clone();
    let mut last = rest.clone();
    for place in 0..3 {
        let (test, figure) = &mut class.tests[place];
        figure.positions = last;
        last = right.skin(figure);
        let text = obj(&last, figure, |number| number.to_string());
        let students = if place < 2 {
            &["ann", "bob"][..]
        } else {
            &["bob"]
        };
        let paths = students
            .iter()
            .map(|name| format!("class/{name}/{test}.obj"));
        let paths: Vec<String> = paths.collect();
        paths.iter().for_each(|path| class.write(path, &text));
    }
    let report = class.graded();
    for (student, test, how) in [
        ("ann", "robot-2", "that of robot-1"),
        ("bob", "robot-2", "that of robot-1"),
        (
            "bob",
            "robot-3",
            "that of robot-1, robot-2 one upon the other",
        ),
    ] {
        let found = result(&report, student, test);
        assert_eq!(found["causes"], json!([["last-result-skinned"]]));
        assert_eq!(found["points"], json!({"3.2": 4.0, "3.4": 6.0, "4.2": 5.0}));
        let text = found["text"].as_str().unwrap();
        let told = format!("instead of the mesh at rest ({how})\n");
        assert!(text.contains(&told), "{text}");
    }
    for (student, test) in [("ann", "robot-1"), ("ann", "robot-3"), ("bob", "robot-1")] {
        assert_eq!(result(&report, student, test)["outcome"], "right");
    }
    // It is found anew where that test is not there any more.
    let mut tests = class.tests_file();
    tests["tests"].as_array_mut().unwrap().remove(0);
    class.set_tests(&tests);
    let report = class.graded();
    assert_eq!(result(&report, "ann", "robot-2")["outcome"], "unexplained");
}

#[test]
fn sums_that_go_on_from_test_to_test_are_named_with_their_tests() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    class.submit("ann", &right, |number| number.to_string());
    class.submit("bob", &right, |number| number.to_string());
    let mut sums = [
        vec![Vec3::ZERO; class.tests[0].1.positions.len()],
        class.tests[0].1.positions.clone(),
    ];
    for (test, figure) in &class.tests {
        for (sum, name) in sums.iter_mut().zip(["ann", "bob"]) {
            for (sum, place) in sum.iter_mut().zip(right.skin(figure)) {
                *sum += place;
            }
            let text = obj(sum, figure, |number| number.to_string());
            class.write(&format!("class/{name}/{test}.obj"), text);
        }
    }
    let report = class.graded();
    for (student, test, how) in [
        ("ann", "robot-2", "from the result of robot-1"),
        (
            "ann",
            "robot-3",
            "from the result of robot-1, robot-2 together",
        ),
        (
            "bob",
            "robot-2",
            "from the mesh at rest and the result of robot-1",
        ),
    ] {
        let found = result(&report, student, test);
        assert_eq!(found["causes"], json!([["sum-not-reset"]]));
        let text = found["text"].as_str().unwrap();
        let told = format!("so that it goes on from what it was ({how})\n");
        assert!(text.contains(&told), "{text}");
    }
    assert_eq!(result(&report, "ann", "robot-1")["outcome"], "right");
    let first = result(&report, "bob", "robot-1");
    let both = json!([["sum-not-reset"], ["sum-begun-at-rest"]]);
    assert_eq!(first["causes"], both);
}

#[test]
fn b_of_the_pose_of_another_test_is_named_with_that_test() {
    let class = Class::new(&["robot", "robot"]);
    class.submit("ann", &with(&[]), |number| number.to_string());
    let [(_, first), (_, second)] = &class.tests[..] else {
        panic!("two tests")
    };
    let skeleton = first.character.skeleton();
    let b = skeleton.update_current_joint_to_world_transforms(&first.pose());
    let rest = &first.positions;
    for (test, figure) in &class.tests {
        let t = skeleton.update_current_joint_to_world_transforms(&figure.pose());
        let palette: Vec<Mat4> = t.iter().zip(&b).map(|(t, b)| *t * b.inverse()).collect();
        let mut skinned = rest.clone();
        skin_positions(&palette, second.character.attachments(), rest, &mut skinned);
        let text = obj(&skinned, figure, |number| number.to_string());
        class.write(&format!("class/ann/{test}.obj"), text);
    }
    let report = class.graded();
    let found = result(&report, "ann", "robot-2");
    assert_eq!(found["causes"], json!([["bind-of-other-pose"]]));
    assert_eq!(found["points"], json!({"3.2": 4.0, "3.4": 6.0, "4.2": 5.0}));
    let text = found["text"].as_str().unwrap();
    assert!(
        text.contains("than the bind pose (that of robot-1)"),
        "{text}"
    );
    let first = result(&report, "ann", "robot-1");
    assert_eq!(first["causes"], json!([["pose-not-applied"]]));
    let text = first["text"].as_str().unwrap();
    assert!(text.contains("which would make B of the pose"), "{text}");
}

#[test]
fn angles_that_are_left_of_other_tests_are_named_with_these() {
    let mut class = Class::new(&["robot", "robot", "robot"]);
    let of_test = |place: usize| class.tests[place].1.degrees.clone();
    let [first, mut second, third] = [0, 1, 2].map(of_test);
    for degrees in second.iter_mut().step_by(2) {
        *degrees = Vec3::ZERO;
    }
    class.set_pose(1, second.clone());
    let right = with(&[]);
    let names = ["bob", "cid", "dan"];
    for name in names {
        class.submit(name, &right, |number| number.to_string());
    }
    let write = |student: &str, test: usize, degrees: Vec<Vec3>| {
        let posed = Figure::builtin("robot", |joint| degrees[joint]);
        let (test, figure) = &class.tests[test];
        let text = obj(&right.skin(&posed), figure, |number| number.to_string());
        class.write(&format!("class/{student}/{test}.obj"), text);
    };
    let joints = 0..first.len();
    let left = joints.clone().map(|joint| match second[joint] {
        Vec3::ZERO => first[joint],
        own => own,
    });
    write("bob", 1, left.collect());
    let sums = joints
        .clone()
        .map(|joint| first[joint] + second[joint] + third[joint]);
    write("cid", 2, sums.collect());
    let turned_on = joints.map(|joint| {
        let [before, own] = [first[joint], second[joint]].map(Euler::from_degrees);
        Euler::nearest(before.to_mat3() * own.to_mat3(), own).degrees()
    });
    write("dan", 1, turned_on.collect());
    let report = class.graded();
    for (student, test, how) in [
        (
            "bob",
            "robot-2",
            "those of robot-1, where the test has none",
        ),
        (
            "cid",
            "robot-3",
            "those of robot-1, robot-2 together, to which its own are added",
        ),
        (
            "dan",
            "robot-2",
            "those of robot-1, from which joints turn on",
        ),
    ] {
        let found = result(&report, student, test);
        assert_eq!(found["causes"], json!([["angles-kept"]]), "{found}");
        let text = found["text"].as_str().unwrap();
        assert!(text.contains(&format!("({how})")), "{text}");
    }
    for student in names {
        assert_eq!(result(&report, student, "robot-1")["outcome"], "right");
    }
}

#[test]
fn what_is_kept_of_other_tests_is_named_in_whatever_order_a_program_has_made_them() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let right = with(&[]);
    let figure = |test: usize| &class.tests[test].1;
    let name = |test: usize| class.tests[test].0.clone();
    let orders = [("ann", [0, 1, 2]), ("bob", [2, 1, 0]), ("cid", [2, 0, 1])];
    for (student, order) in orders {
        class.submit(student, &right, |number| number.to_string());
        let mut sums = vec![Vec3::ZERO; figure(0).degrees.len()];
        for test in order {
            for (sum, own) in sums.iter_mut().zip(&figure(test).degrees) {
                *sum += *own;
            }
            let summed = Figure::builtin("robot", |joint| sums[joint]);
            let text = obj(&right.skin(&summed), figure(test), |number| {
                number.to_string()
            });
            class.write(&format!("class/{student}/{}.obj", name(test)), text);
        }
    }
    let report = class.graded();
    for (student, [first, second, third]) in orders {
        let cause = |test: usize| result(&report, student, &name(test))["causes"].clone();
        assert_eq!(result(&report, student, &name(first))["outcome"], "right");
        assert_eq!(cause(second), json!([["angles-kept"]]), "{student}");
        // An order by neither place nor name is that of no program.
        let named = cause(third) == json!([["angles-kept"]]);
        assert_eq!(named, student != "cid", "{student}");
    }
}

#[test]
fn tests_have_the_same_character_whichever_of_its_files_they_name() {
    let class = Class::new(&["robot", "robot"]);
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/characters");
    for extension in ["obj", "skel", "attach"] {
        let file = format!("robot.{extension}");
        class.write(&file, std::fs::read(assets.join(&file)).unwrap());
    }
    let mut tests = class.tests_file();
    tests["tests"][0]["character"] = json!("robot.obj");
    tests["tests"][1]["character"] = json!("robot.skel");
    class.set_tests(&tests);
    let right = with(&[]);
    class.submit("ann", &right, |number| number.to_string());
    let [(_, before), (name, own)] = &class.tests[..] else {
        panic!("two tests");
    };
    let summed = Figure::builtin("robot", |joint| before.degrees[joint] + own.degrees[joint]);
    let text = obj(&right.skin(&summed), own, |number| number.to_string());
    class.write(&format!("class/ann/{name}.obj"), text);
    let report = class.graded();
    let found = result(&report, "ann", name);
    assert_eq!(found["causes"], json!([["angles-kept"]]), "{found}");
}

#[test]
fn what_is_kept_of_other_tests_is_named_beside_the_mistake_that_all_of_them_show() {
    let class = Class::new(&["robot", "robot", "robot"]);
    let shifted = with(&["weights-shifted"]);
    let zyx = with(&["euler-zyx"]);
    class.submit("ann", &shifted, |number| number.to_string());
    class.submit("bob", &zyx, |number| number.to_string());
    class.submit("cid", &shifted, |number| number.to_string());
    class.submit("dan", &zyx, |number| number.to_string());
    let write = |student: &str, test: usize, places: &[Vec3]| {
        let (test, figure) = &class.tests[test];
        let text = obj(places, figure, |number| number.to_string());
        class.write(&format!("class/{student}/{test}.obj"), text);
    };
    let figure = |test: usize| &class.tests[test].1;
    let mut again = Figure::builtin("robot", |joint| figure(1).degrees[joint]);
    again.positions = shifted.skin(figure(0));
    write("ann", 1, &shifted.skin(&again));
    let sum: Vec<Vec3> = (zyx.skin(figure(0)).iter().zip(zyx.skin(figure(1))))
        .map(|(before, own)| *before + own)
        .collect();
    write("bob", 1, &sum);
    let degrees = |joint: usize| (0..3).map(|test| figure(test).degrees[joint]).sum();
    write("cid", 2, &shifted.skin(&Figure::builtin("robot", degrees)));
    // Its rotations, each Rz · Ry · Rx, are multiplied onto those of the test before.
    let turned_on = |joint: usize| {
        let [before, own] = [0, 1].map(|test| {
            let [x, y, z] = figure(test).degrees[joint].to_array().map(f32::to_radians);
            Mat3::from_euler(EulerRot::ZYX, z, y, x)
        });
        let (z, y, x) = (before * own).to_euler(EulerRot::ZYX);
        Vec3::new(x, y, z) * (180.0 / std::f32::consts::PI)
    };
    write("dan", 1, &zyx.skin(&Figure::builtin("robot", turned_on)));
    let report = class.graded();
    for (student, test, ids) in [
        ("dan", "robot-2", ["angles-kept", "euler-zyx"]),
        ("ann", "robot-2", ["last-result-skinned", "weights-shifted"]),
        ("bob", "robot-2", ["sum-not-reset", "euler-zyx"]),
        ("cid", "robot-3", ["angles-kept", "weights-shifted"]),
    ] {
        let found = result(&report, student, test);
        assert_eq!(found["causes"], json!([ids]), "{found}");
    }
    let told = result(&report, "ann", "robot-1")["causes"].clone();
    assert_eq!(told, json!([["weights-shifted"]]));
}

#[test]
fn the_table_for_a_gradebook_has_a_line_for_each_submission() {
    let class = class();
    class.graded();
    let csv = String::from_utf8(class.read("report/grade.csv")).unwrap();
    let expected =
        "submission,points,possible,not graded,3.2 Skeleton,3.4 Sliders,4.2 SSD,Artifact,extra credit,result\r
Ada & <Bob>,40,50,10,8,12,20,,,right\r
eve,45.5,50,0,8,6,20,9.5,2,\"euler-zyx (robot-1, dog-2)\"\r
\"kim, lee\",34,50,10,8,6,20,,,\"euler-zyx (robot-1, dog-2)\"\r
zoe,0,50,10,0,0,0,,,unreadable (robot-1); missing (dog-2)\r
";
    assert_eq!(csv, expected);
}

#[test]
fn a_name_that_a_spreadsheet_would_run_has_an_apostrophe_in_the_table_alone_as_help_says() {
    let class = Class::new(&["robot"]);
    class.submit("-Chen", &with(&[]), |number| number.to_string());
    let report = class.graded();
    assert_eq!(report["submissions"][0]["name"], "-Chen");
    let csv = String::from_utf8(class.read("report/grade.csv")).unwrap();
    assert!(csv.contains("\n'-Chen,20,"), "{csv}");
    let help = class.run("--help").out;
    let words: Vec<&str> = help.split_whitespace().collect();
    let told = "have an apostrophe before them";
    assert!(words.join(" ").contains(told), "{help}");
}

#[test]
fn the_page_is_well_formed_and_asks_for_nothing_from_outside() {
    let class = class();
    class.graded();
    let page = String::from_utf8(class.read("report/grade.html")).unwrap();
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..roxmltree::ParsingOptions::default()
    };
    let document = roxmltree::Document::parse_with_options(&page, options).unwrap();
    let mut pictures = 0;
    for node in document.descendants() {
        let name = node.tag_name().name();
        assert!(
            !["script", "link", "iframe", "object", "embed", "base"].contains(&name),
            "{name}"
        );
        for attribute in node.attributes() {
            assert!(!attribute.name().starts_with("on"), "{attribute:?}");
            if ["src", "href", "srcset", "data", "action"].contains(&attribute.name()) {
                let target = attribute.value();
                let is_inside =
                    target.starts_with('#') || target.starts_with("data:image/png;base64,iVBOR");
                assert!(is_inside, "{target}");
                pictures += usize::from(target.starts_with("data:"));
            }
        }
    }
    // Two exact ones, and what two submissions give for two tests.
    assert_eq!(pictures, 6);
    for address in ["http:", "https:", "url(", "@import"] {
        assert!(!page.contains(address), "{address}");
    }
    let ids: Vec<&str> = document
        .descendants()
        .filter_map(|node| node.attribute("id"))
        .collect();
    let links = document
        .descendants()
        .filter_map(|node| node.attribute("href")?.strip_prefix('#'));
    for link in links {
        assert!(ids.contains(&link), "{link}");
    }
    let text: String = document
        .descendants()
        .filter(|node| node.is_text())
        .filter_map(|node| node.text())
        .collect();
    // The artifact is still to be graded for all but one, which is no loss for the others.
    for told in [
        "Of what is graded so far the mean is 69 %, the median 88 %.",
        "34 of 40, 10 more not graded yet",
        "45.5 of 50",
        "Assignment <1> & more",
        "Ada & <Bob>",
        "euler-zyx",
        "<script>alert(1)</script>",
        "setJointTransform",
    ] {
        assert!(text.contains(told), "{told}");
    }
}

#[test]
fn on_paper_all_results_are_open_nothing_scrolls_and_no_picture_is_cut() {
    let class = class();
    class.graded();
    let page = String::from_utf8(class.read("report/grade.html")).unwrap();
    let (_, print) = page
        .split_once("@media print {")
        .expect("a style for paper");
    let (print, _) = print.split_once("</style>").unwrap();
    for rule in [
        "details::details-content { content-visibility: visible; block-size: auto;",
        ".wide { overflow: visible;",
        "figure, .test, tr, .legend { break-inside: avoid; }",
    ] {
        assert!(print.contains(rule), "{rule}");
    }
}

#[test]
fn lines_of_a_diagnosis_that_do_not_fit_go_on_below_their_words() {
    let class = class();
    class.graded();
    let page = String::from_utf8(class.read("report/grade.html")).unwrap();
    for line in [
        "<pre><span>euler-zyx: the rotation is",
        "<span class=\"told\">  look at  setJointTransform: the order",
        "<span class=\"told\">  shown by ",
    ] {
        assert!(page.contains(line), "{line}");
    }
}

#[test]
fn a_mesh_that_one_mistake_gives_but_for_a_few_vertices_has_its_name_in_the_table() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    let mut theirs = with(&["weights-shifted"]).skin(figure);
    theirs[7].x += 1.0;
    let text = obj(&theirs, figure, |number| number.to_string());
    class.write(&format!("class/eve/{test}.obj"), text);
    let ran = class.run("class --tests tests.json -o report");
    let told = "nearly weights-shifted";
    assert!(ran.out.contains(told), "{}", ran.out);
    let csv = String::from_utf8(class.read("report/grade.csv")).unwrap();
    assert!(csv.contains(told), "{csv}");
    let report = class.graded();
    assert_eq!(
        result(&report, "eve", test)["hint"],
        "nearly weights-shifted"
    );
}

#[test]
fn a_mesh_that_is_right_but_for_its_size_place_or_axes_says_so_in_the_table() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    let right = with(&[]).skin(figure);
    let written = |name: &str, change: fn(Vec3) -> Vec3| {
        let theirs: Vec<Vec3> = right.iter().copied().map(change).collect();
        let text = obj(&theirs, figure, |number| number.to_string());
        class.write(&format!("class/{name}/{test}.obj"), text);
    };
    written("ann", |at| at * 100.0);
    written("bob", |at| at + Vec3::new(3.0, 0.0, 4.0));
    written("cem", |at| Vec3::new(at.x, -at.z, at.y));
    let ran = class.run("class --tests tests.json -o report");
    for told in [
        "nearly right: the exact result, 100 times as large",
        "nearly right: the exact result, moved by 5",
        "nearly right: the exact result with the axes x, -z, y",
    ] {
        assert!(ran.out.contains(told), "{}", ran.out);
    }
}

#[test]
fn a_mesh_that_is_right_but_for_few_vertices_says_for_how_many() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    for (name, off) in [("ann", 1), ("bob", 5)] {
        let mut theirs = with(&[]).skin(figure);
        theirs.iter_mut().take(off).for_each(|at| at.x += 1.0);
        let text = obj(&theirs, figure, |number| number.to_string());
        class.write(&format!("class/{name}/{test}.obj"), text);
    }
    // Where these are many, the table says what is wrong with them.
    let right = obj(&with(&[]).skin(figure), figure, |number| number.to_string());
    let none = right
        .lines()
        .enumerate()
        .map(|(at, line)| match line.strip_prefix("v ") {
            Some(_) if at < 300 => "v nan nan nan".to_owned(),
            _ => line.to_owned(),
        });
    let none = none.collect::<Vec<_>>().join("\n");
    class.write(&format!("class/cem/{test}.obj"), &none);
    let report = class.graded();
    let hint = |name| &result(&report, name, test)["hint"];
    assert_eq!(*hint("ann"), "all but 1 vertex");
    assert_eq!(*hint("bob"), "all but 5 vertices");
    let ran = class.run("class --tests tests.json -o report");
    let none = none.matches("v nan").count();
    let told = format!("unexplained: {none} vertices are no numbers (nan or infinite)");
    assert!(ran.out.contains(&told), "{}", ran.out);
}

#[test]
fn a_mistake_that_counts_against_another_section_than_its_own_says_which() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&["euler-zyx"]), |number| number.to_string());
    let mut tests = class.tests_file();
    tests["tests"][0]["points"] = json!({"3.2": 4, "4.2": 10});
    class.set_tests(&tests);
    let ran = class.run("class --tests tests.json -o report");
    let told = "euler-zyx counts against 3.2, since the test has no points for 3.4";
    assert!(
        ran.out.contains(&format!("\n{told} (robot-1)\n")),
        "{}",
        ran.out
    );
    let report = class.graded();
    let eve = result(&report, "eve", "robot-1");
    assert_eq!(eve["points"], json!({"3.2": 2.0, "4.2": 10.0}));
    assert_eq!(eve["elsewhere"], json!([told]));
    let page = String::from_utf8(class.read("report/grade.html")).unwrap();
    let why = "euler-zyx leaves 50 % of 3.2, since the test has no points for 3.4";
    assert_eq!(eve["why"], json!([why]));
    assert!(page.contains(why));
}

#[test]
fn triangles_that_are_wrong_cost_as_much_where_a_vertex_is_off_as_well() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&[]), |number| number.to_string());
    let file = "class/eve/robot-1.obj";
    let text = String::from_utf8(class.read(file)).unwrap();
    let mut is_first = true;
    let lines = text.lines().map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        match &words[..] {
            ["v", _, y, z] if std::mem::take(&mut is_first) => format!("v 9 {y} {z}"),
            ["f", a, b, c] => format!("f {a} {c} {b}"),
            _ => line.to_owned(),
        }
    });
    let text: Vec<String> = lines.collect();
    class.write(file, text.join("\n"));
    let mut tests = class.tests_file();
    tests["tests"][0]["points"] = json!({"4.1": 4, "4.2": 10});
    class.set_tests(&tests);
    assert_eq!(
        class.run("class --tests tests.json -o report").code,
        Some(0)
    );
    let report = class.graded();
    let eve = result(&report, "eve", "robot-1");
    assert_eq!(eve["points"], json!({"4.1": 3.6, "4.2": 9.0}));
    let why = [
        "right-but-for-few leaves 90 % of 4.2",
        "triangles-turned leaves 90 % of 4.1",
    ];
    assert_eq!(eve["why"], json!(why));
}

#[test]
fn each_section_says_its_points_and_whether_they_are_scaled_or_given_by_hand() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&["no-inverse-bind"]), |number| {
        number.to_string()
    });
    let mut tests = class.tests_file();
    tests["tests"][0]["points"] = json!({"3.4": 4, "4.2": 10});
    tests["rubric"] = json!({"sections": {"4.2": {"points": 40}}, "given": {"eve": {"3.4": 3}}});
    class.set_tests(&tests);
    assert_eq!(
        class.run("class --tests tests.json -o report").code,
        Some(0)
    );
    let report = class.graded();
    let notes = [
        "3.4 Sliders: 3 of 4, given by hand",
        "4.2 SSD: 20 of 40, for 5 of 10 in the tests",
    ];
    assert_eq!(report["submissions"][0]["notes"], json!(notes));
    let page = String::from_utf8(class.read("report/grade.html")).unwrap();
    assert!(notes.iter().all(|note| page.contains(note)));
}

#[test]
fn points_that_are_given_to_nobody_are_told() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&[]), |number| number.to_string());
    let mut tests = class.tests_file();
    tests["rubric"] =
        json!({"given": {"EVE": {"4.2": 1}, "eva": {"4.2": 9}, "eve": {"4.3": 1, "4.2": 5}}});
    class.set_tests(&tests);
    let ran = class.run("class --tests tests.json -o report");
    assert_eq!(ran.code, Some(0));
    let warnings: Vec<&str> = ran
        .err
        .lines()
        .filter(|line| line.contains("given"))
        .collect();
    assert_eq!(
        warnings,
        [
            "warning: tests.json: points are given to EVE, but there is no such submission, but eve: the names differ in capitals",
            "warning: tests.json: points are given to eva, but there is no such submission",
            "warning: tests.json: eve is given points for 4.3, which is no section",
        ]
    );
}

#[test]
fn a_section_of_the_rubric_in_which_nobody_gets_points_is_told() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&[]), |number| number.to_string());
    let mut tests = class.tests_file();
    tests["rubric"] = json!({
        "sections": {"4.2": {"points": 40}, "42": {"points": 5}, "artifact": {"points": 10}},
        "given": {"eve": {"artifact": 9}},
    });
    class.set_tests(&tests);
    let ran = class.run("class --tests tests.json -o report");
    assert_eq!(ran.code, Some(0));
    let mut told = ran.err.lines().filter(|line| line.contains("tests.json"));
    let warning = "warning: tests.json: no test has points for 42, and nobody is given any by hand";
    assert_eq!((told.next(), told.next()), (Some(warning), None));
}

#[test]
fn a_section_of_a_test_that_is_misspelled_is_told() {
    let class = Class::new(&["robot", "dog"]);
    class.submit("eve", &with(&[]), |number| number.to_string());
    let mut tests = class.tests_file();
    tests["tests"][0]["points"] = json!({"3,4": 6, "4.2": 10});
    class.set_tests(&tests);
    let ran = class.run("class --tests tests.json -o report");
    let warning = "warning: tests.json: tests have points for 3,4, which is a section of its own beside 3.4\n";
    assert_eq!(ran.code, Some(0));
    assert!(ran.err.contains(warning), "{}", ran.err);
    assert!(!ran.err.contains("beside 4.2"), "{}", ran.err);
}

#[test]
fn a_section_that_no_mistake_belongs_to_is_told() {
    let class = Class::new(&["robot"]);
    class.submit("eve", &with(&[]), |number| number.to_string());
    let mut tests = class.tests_file();
    tests["tests"][0]["points"] = json!({"3.1": 4, "3.2": 4, "3.4": 6, "4.2": 10});
    class.set_tests(&tests);
    let ran = class.run("class --tests tests.json -o report");
    let warning = "warning: tests.json: no mistake costs points of 3.1, which are lost only with all others of a test\n";
    assert_eq!(ran.code, Some(0));
    assert!(ran.err.contains(warning), "{}", ran.err);
    assert_eq!(
        ran.err.matches("no mistake costs").count(),
        1,
        "{}",
        ran.err
    );
}

#[test]
fn each_submission_has_a_page_of_its_own_that_names_no_other() {
    let class = class();
    class.graded();
    let page = String::from_utf8(class.read("report/pages/eve.html")).unwrap();
    assert!(page.contains("<h3>eve</h3>") && page.contains("euler-zyx: "));
    assert!(!page.contains("kim, lee") && !page.contains("&lt;Bob"));
    let names = ["Ada-Bob.html", "kim-lee.html", "zoe.html"];
    for name in names {
        assert!(
            !class.read(&format!("report/pages/{name}")).is_empty(),
            "{name}"
        );
    }
    // The report says which is whose.
    let report: serde_json::Value =
        serde_json::from_slice(&class.read("report/grade.json")).unwrap();
    for submission in report["submissions"].as_array().unwrap() {
        let (name, path) = (&submission["name"], submission["page"].as_str().unwrap());
        let page = String::from_utf8(class.read(&format!("report/{path}"))).unwrap();
        let name = name.as_str().unwrap();
        let shown = name.replace('&', "&amp;");
        let shown = shown.replace('<', "&lt;").replace('>', "&gt;");
        assert!(
            page.contains(&format!("<h3>{shown}</h3>")),
            "{path}: {name}"
        );
    }
}

#[test]
fn pictures_that_are_swapped_between_tests_are_said_to_be_and_what_is_no_number_counts_as_wrong() {
    let class = Class::new(&["robot", "adult"]);
    let mut tests = class.tests_file();
    for test in tests["tests"].as_array_mut().unwrap() {
        test["kind"] = "picture".into();
        test["size"] = json!([400, 300]);
    }
    class.set_tests(&tests);
    for (index, (test, figure)) in class.tests.iter().enumerate() {
        let text = obj(&with(&[]).skin(figure), figure, |number| number.to_string());
        class.write("right.obj", text);
        let (other, _) = &class.tests[1 - index];
        class.write("class/eve/about.txt", "");
        let output = format!("class/eve/{other}.png");
        let words = ["render", "right.obj", "--size", "400x300", "-o", &output];
        let ran = editor_in(class.path(), &words);
        assert_eq!(ran.code, Some(0), "{test}: {}", ran.err);
    }
    let report = class.graded();
    for (index, (test, _)) in class.tests.iter().enumerate() {
        let (other, _) = &class.tests[1 - index];
        let found = result(&report, "eve", test);
        assert_eq!(found["outcome"], "other-pose", "{found}");
        assert_eq!(found["hint"], format!("the result of {other}"));
    }
}

/// A class whose test of a mesh has one of a picture of that, called `side`, beside it.
fn class_with_picture() -> Class {
    let class = Class::new(&["adult"]);
    let mut tests = class.tests_file();
    let mut picture = tests["tests"][0].clone();
    picture["name"] = "side".into();
    picture["kind"] = "picture".into();
    picture["camera"] = json!([80, 10, 3]);
    picture["size"] = json!([400, 300]);
    tests["tests"].as_array_mut().unwrap().push(picture);
    class.set_tests(&tests);
    class
}

/// Hands in a mesh, and its own picture.
fn hand_in_with_picture(class: &Class, name: &str, text: &str) {
    let [mesh, picture] = ["adult-1.obj", "side.png"].map(|it| format!("class/{name}/{it}"));
    class.write(&mesh, text);
    let words = [
        "render", &mesh, "--camera", "80,10,3", "--size", "400x300", "-o", &picture,
    ];
    let ran = editor_in(class.path(), &words);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn a_picture_that_only_shows_the_mesh_of_its_submission_counts_as_that_and_follows_it() {
    let class = class_with_picture();
    let figure = &class.tests[0].1;
    // No picture tells which joints have each other's weights.
    let exchanged = Student {
        joint_of_column: |column| match column + 1 {
            13 => 14,
            14 => 13,
            joint => joint,
        },
        ..with(&[])
    };
    let text = obj(&exchanged.skin(figure), figure, |number| number.to_string());
    for name in ["ann", "bob"] {
        hand_in_with_picture(&class, name, &text);
    }
    // Another mesh is none that this picture shows.
    class.submit("bob", &with(&["no-inverse-bind"]), |number| {
        number.to_string()
    });
    let told = |report: &Value, name: &str| {
        let found = result(report, name, "side");
        let text = found["text"].as_str().unwrap().to_owned();
        (found["outcome"].clone(), text)
    };
    let report = class.graded();
    let (outcome, text) = told(&report, "ann");
    let shows = "it shows adult-1.obj of the submission:\nweights-exchanged: ";
    assert!(outcome == "explained" && text.starts_with(shows), "{text}");
    // What is right of it is of the picture, and not of the mesh.
    let [picture, mesh] = ["side", "adult-1"].map(|test| result(&report, "ann", test));
    let off = picture["error"].as_f64().unwrap();
    assert!(off > 0.001, "{picture}");
    assert!((picture["agrees"].as_f64().unwrap() - (1.0 - off)).abs() < 1e-6);
    assert_ne!(picture["agrees"], mesh["agrees"], "{picture}");
    let (outcome, text) = told(&report, "bob");
    assert!(
        outcome == "unexplained" && !text.contains("it shows"),
        "{text}"
    );
    // Handed in anew, the mesh is the one.
    class.write("class/bob/adult-1.obj", class.read("class/ann/adult-1.obj"));
    let (outcome, text) = told(&class.graded(), "bob");
    assert!(outcome == "explained" && text.starts_with(shows), "{text}");
}

#[test]
fn a_picture_shows_the_mesh_of_its_submission_though_a_part_of_that_lies_behind_the_camera() {
    let class = class_with_picture();
    let figure = &class.tests[0].1;
    let right = with(&[]).skin(figure);
    // A few vertices in one place, before the camera and behind it.
    for (name, at) in [
        ("ann", Vec3::new(1.0, 1.0, 2.0)),
        ("bob", Vec3::new(1.0, 1.5, 6.0)),
    ] {
        let mut places = right.clone();
        places[100..130].fill(at);
        let text = obj(&places, figure, |number| number.to_string());
        hand_in_with_picture(&class, name, &text);
    }
    let report = class.graded();
    for name in ["ann", "bob"] {
        let found = result(&report, name, "side");
        let text = found["text"].as_str().unwrap();
        let shows =
            "it shows adult-1.obj of the submission:\nnearly right: all but 30 of its vertices";
        assert!(text.starts_with(shows), "{name}: {text}");
    }
}
