//! Meshes that nothing explains count by how near they are.

use crate::diagnose::figures::obj;
use crate::diagnose::student::{Student, with};
use crate::grade::support::{Class, result};
use editor_core::math::Aabb;
use glam::Vec3;
use serde_json::json;

/// A direction for each vertex, as if by chance.
fn direction(vertex: usize) -> Vec3 {
    let part = |by: f32| (vertex as f32 * by).sin() * 1000.0;
    let [x, y, z] = [12.9898, 78.233, 37.719].map(|by| part(by).fract() * 2.0);
    Vec3::new(x, y, z).normalize_or(Vec3::X)
}

#[test]
fn a_mesh_whose_vertices_are_all_off_has_the_more_points_the_nearer_they_are() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    let right = with(&[]).skin(figure);
    let size = Aabb::from_points(right.iter().copied()).size().length();
    let errors = [
        ("ann", 0.0002),
        ("bob", 0.0009),
        ("cem", 0.0012),
        ("dan", 0.003),
        ("eve", 0.02),
    ];
    for (student, error) in errors {
        let off = |(vertex, at): (usize, &Vec3)| *at + direction(vertex) * error * size;
        let places: Vec<Vec3> = right.iter().enumerate().map(off).collect();
        let text = obj(&places, figure, |number| number.to_string());
        class.write(&format!("class/{student}/{test}.obj"), text);
    }
    let report = class.graded();
    for student in ["ann", "bob"] {
        let found = result(&report, student, test);
        assert_eq!(found["outcome"], "unexplained", "{found}");
        let points = json!({"3.2": 4.0, "3.4": 6.0, "4.2": 9.0});
        assert_eq!(found["points"], points, "{found}");
        let why = json!(["right-but-for-little leaves 90 % of 4.2"]);
        assert_eq!(found["why"], why);
    }
    let ann = result(&report, "ann", test);
    let hint = "within 0.020 % of the size everywhere";
    assert_eq!(ann["hint"], hint);
    let text = ann["text"].as_str().unwrap();
    assert!(
        text.starts_with(&format!("nearly right: {hint}\n")),
        "{text}"
    );
    // What is right is counted as before.
    assert_eq!(ann["agrees"], 0.0);
    let near = |student: &str| result(&report, student, test)["near"].as_f64().unwrap();
    for (student, expected) in [("ann", 0.85), ("cem", 0.46), ("dan", 0.26), ("eve", 0.0)] {
        assert!((near(student) - expected).abs() < 0.01, "{}", near(student));
    }
    let points = |student: &str| {
        let points = result(&report, student, test)["points"]["4.2"].clone();
        points.as_f64().unwrap()
    };
    // From what is right but for little, with the logarithm of the largest distance, to half of what vertices count for.
    for (student, error) in [("cem", 0.0012_f64), ("dan", 0.003), ("eve", 0.01)] {
        let (little, half) = (9.0, 5.0 * near(student));
        let expected = little + (half - little) * (error / 0.001).log10();
        assert!((points(student) - expected).abs() < 0.01, "{student}");
    }
    let dan = result(&report, "dan", test)["why"][0].as_str().unwrap();
    let told = "what no known mistake explains leaves 53.";
    assert!(dan.starts_with(told), "{dan}");
    let near =
        "so near is it to the exact result: no vertex is farther off than 0.300 % of the size";
    assert!(dan.ends_with(near), "{dan}");
}

#[test]
fn of_a_mesh_with_one_vertex_more_it_is_known_how_much_of_it_is_right() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    let right = obj(&with(&[]).skin(figure), figure, |number| number.to_string());
    let lines: Vec<&str> = right.lines().collect();
    let vertices = figure.positions.len();
    let repeated = [&lines[..vertices], &lines[vertices - 1..]].concat();
    class.write(&format!("class/ann/{test}.obj"), repeated.join("\n"));
    let report = class.graded();
    let found = result(&report, "ann", test);
    assert_eq!(found["causes"], json!([["vertex-too-many"]]), "{found}");
    assert_eq!(
        (&found["agrees"], &found["near"]),
        (&json!(1.0), &json!(1.0))
    );
}

#[test]
fn a_loop_that_ends_early_costs_as_much_beside_another_mistake_by_the_share_that_it_comes_to() {
    let class = Class::new(&["adult"]);
    let (test, figure) = &class.tests[0];
    let zyx = with(&["euler-zyx"]).skin(figure);
    let all = zyx.len();
    let ends = [0.5, 0.95, 0.985].map(|share| (share * all as f64) as usize);
    for end in ends {
        let mut places = zyx.clone();
        places[end..].copy_from_slice(&figure.positions[end..]);
        let text = obj(&places, figure, |number| number.to_string());
        class.write(&format!("class/to {end}/{test}.obj"), text);
    }
    let report = class.graded();
    for end in ends {
        let found = result(&report, &format!("to {end}"), test);
        let causes = json!([["euler-zyx", "vertices-not-reached"]]);
        assert_eq!(found["causes"], causes, "{found}");
        let reached = end as f64 / all as f64;
        let expected = 5.0 + 4.0 * ((reached - 0.9) / 0.09).clamp(0.0, 1.0);
        let points = found["points"]["4.2"].as_f64().unwrap();
        assert!((points - expected).abs() < 0.01, "{points} {expected}");
        assert_eq!(found["points"]["3.4"], 3.0);
    }
}

#[test]
#[expect(clippy::approx_constant, reason = "students write π so")]
fn what_nobody_sees_beside_a_mistake_costs_as_little_as_alone() {
    let class = Class::new(&["robot"]);
    let test = &class.tests[0].0;
    for (student, ids) in [("ann", &[][..]), ("bob", &["no-inverse-bind"])] {
        let coarse = Student {
            to_radians: |degrees| degrees * 3.14 / 180.0,
            ..with(ids)
        };
        class.submit(student, &coarse, |number| number.to_string());
    }
    let report = class.graded();
    let why = |student: &str| result(&report, student, test)["why"].clone();
    let told = "angles-scaled leaves 90 % of 3.4, so little";
    assert_eq!(why("ann"), json!([format!("{told} is the mesh off")]));
    assert_eq!(
        why("bob"),
        json!([
            "no-inverse-bind leaves 50 % of 4.2",
            format!("{told} would it move by itself")
        ])
    );
    let points = &result(&report, "bob", test)["points"];
    assert_eq!(*points, json!({"3.2": 4.0, "3.4": 5.4, "4.2": 5.0}));
}

#[test]
fn vertices_in_another_order_cost_as_much_as_any_mistake_since_they_are_not_where_they_belong() {
    let class = Class::new(&["robot"]);
    let (test, figure) = &class.tests[0];
    let mut places = with(&[]).skin(figure);
    places.reverse();
    let text = obj(&places, figure, |number| number.to_string());
    class.write(&format!("class/ann/{test}.obj"), text);
    let report = class.graded();
    let found = result(&report, "ann", test);
    assert_eq!(found["causes"], json!([["vertices-renumbered"]]), "{found}");
    let why =
        json!(["vertices-renumbered leaves 50 % of 4.2, since the test has no points for 4.1"]);
    assert_eq!(found["why"], why);
}
