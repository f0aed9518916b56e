//! A class of eighty: thirty with mistakes, by themselves and two at once, and fifty that are right.

use crate::diagnose::figures::{Format, obj};
use crate::diagnose::student::{RIGHT, Student, with};
use crate::grade::support::{Class, result};
use glam::Vec3;
use serde_json::{Value, json};

/// What thirty students do wrong.
const BROKEN: [&[&str]; 30] = [
    &["weights-shifted"],
    &["no-inverse-bind"],
    &["inverse-bind-only"],
    &["bind-not-inverted"],
    &["factors-swapped"],
    &["parent-missing"],
    &["parent-order"],
    &["euler-xzy"],
    &["euler-yxz"],
    &["euler-yzx"],
    &["euler-zxy"],
    &["euler-zyx"],
    &["degrees-as-radians"],
    &["rotation-transposed"],
    &["rotation-before-translation"],
    &["translation-missing"],
    &["pose-not-applied"],
    &["strongest-joint-only"],
    &["one-axis-ignored-x"],
    &["one-axis-ignored-y"],
    &["sign-flipped-y"],
    &["sign-flipped-z"],
    &["weights-shifted", "euler-zyx"],
    &["euler-xzy", "parent-missing"],
    &["parent-order", "degrees-as-radians"],
    &["no-inverse-bind", "euler-yxz"],
    &["strongest-joint-only", "rotation-transposed"],
    &["weights-shifted", "sign-flipped-x"],
    &["bind-not-inverted", "euler-zxy"],
    &["joints-by-depth", "euler-yzx"],
];

const FORMATS: [Format; 5] = [
    |number| format!("{number:.4}"),
    |number| format!("{number:.6}"),
    |number| format!("{number:.9}"),
    |number| number.to_string(),
    |number| format!("{number:.5e}"),
];

/// Weights that count, each with the index of its joint.
type Weights = Vec<(usize, f32)>;

/// The right program with other orders of its sums.
fn right_programs() -> [Student; 5] {
    let with_weights = |weights: fn(Weights) -> Weights| Student { weights, ..RIGHT };
    [
        RIGHT,
        with_weights(|mut weights| {
            weights.reverse();
            weights
        }),
        with_weights(|mut weights| {
            weights.sort_by(|a, b| a.1.total_cmp(&b.1));
            weights
        }),
        with_weights(|mut weights| {
            weights.sort_by(|a, b| b.1.total_cmp(&a.1));
            weights
        }),
        Student {
            product: |t, b| (b * t.inverse()).inverse(),
            ..RIGHT
        },
    ]
}

/// Whether two meshes are one but for rounding to four digits.
fn is_same(a: &[Vec3], b: &[Vec3]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.distance(*b) < 1e-4)
}

#[test]
fn each_of_thirty_wrong_solutions_is_told_its_mistakes_and_each_of_fifty_right_ones_none() {
    let class = Class::new(&["adult", "robot", "dog"]);
    for (index, ids) in BROKEN.iter().enumerate() {
        class.submit(&ids.join("+"), &with(ids), FORMATS[index % 2]);
    }
    for (at, student) in right_programs().iter().enumerate() {
        for (how, format) in FORMATS.into_iter().enumerate() {
            class.submit(&format!("right-{at}{how}"), student, format);
            let text = class.read(&format!("class/right-{at}{how}/{}.obj", class.tests[0].0));
            class.submit(&format!("right-{at}{how}-crlf"), student, format);
            let text = String::from_utf8(text).unwrap().replace('\n', "\r\n");
            class.write(
                &format!("class/right-{at}{how}-crlf/{}.obj", class.tests[0].0),
                text,
            );
        }
    }
    let report = class.graded();
    let submissions = report["submissions"].as_array().unwrap();
    assert_eq!(submissions.len(), 80);
    for submission in submissions {
        let name = submission["name"].as_str().unwrap();
        if name.starts_with("right-") {
            assert_eq!(submission["points"], 60.0, "{name}: {submission}");
            for test in submission["tests"].as_array().unwrap() {
                assert_eq!(
                    (&test["outcome"], &test["causes"]),
                    (&json!("right"), &json!([])),
                    "{name}"
                );
            }
        }
    }
    for ids in BROKEN {
        assert_told(&class, &report, ids);
    }
}

/// Checks that the mistakes `ids` are told wherever they make a difference, which they do in a test.
#[track_caller]
fn assert_told(class: &Class, report: &Value, ids: &[&str]) {
    let mut is_told = false;
    for (test, figure) in &class.tests {
        let found = result(report, &ids.join("+"), test);
        let theirs = with(ids).skin(figure);
        let mut expected = ids.to_vec();
        // What one of them does not change beside the others it is not told of.
        expected.retain(|id| {
            let others: Vec<&str> = ids.iter().copied().filter(|other| other != id).collect();
            !is_same(&with(&others).skin(figure), &theirs)
        });
        if expected.is_empty() {
            assert_eq!(found["outcome"], "right", "{test}: {found}");
            continue;
        }
        assert_eq!(found["outcome"], "explained", "{ids:?} on {test}: {found}");
        expected.sort_unstable();
        let causes = found["causes"].as_array().unwrap().iter();
        let mut causes = causes.map(|ids| {
            let mut ids: Vec<&str> = ids
                .as_array()
                .unwrap()
                .iter()
                .filter_map(Value::as_str)
                .collect();
            ids.sort_unstable();
            ids
        });
        assert!(
            causes.any(|causes| causes == expected),
            "{ids:?} on {test}: {found}"
        );
        is_told |= expected.len() == ids.len();
    }
    assert!(is_told, "{ids:?} make no difference in any test");
}

#[test]
fn an_untouched_mesh_gets_no_points_in_any_section_of_its_test() {
    let class = Class::new(&["adult"]);
    let (test, figure) = &class.tests[0];
    let at_rest = obj(&figure.positions, figure, FORMATS[1]);
    class.write(&format!("class/ada/{test}.obj"), at_rest);
    let report = class.graded();
    let ada = result(&report, "ada", test);
    assert_eq!(ada["causes"][0], json!(["pose-not-applied"]));
    assert_eq!(ada["points"], json!({"3.2": 0.0, "3.4": 0.0, "4.2": 0.0}));
}

#[test]
fn a_mistake_costs_points_in_its_section_and_the_rest_counts_as_right() {
    let class = Class::new(&["adult"]);
    for ids in [
        &["euler-zyx"][..],
        &["no-inverse-bind"],
        &["weights-shifted", "euler-zyx"],
    ] {
        class.submit(&ids.join("+"), &with(ids), FORMATS[1]);
    }
    let report = class.graded();
    let sections = |name: &str| result(&report, name, "adult-1")["points"].clone();
    assert_eq!(
        sections("euler-zyx"),
        json!({"3.2": 4.0, "3.4": 3.0, "4.2": 10.0})
    );
    assert_eq!(
        sections("no-inverse-bind"),
        json!({"3.2": 4.0, "3.4": 6.0, "4.2": 5.0})
    );
    assert_eq!(
        sections("weights-shifted+euler-zyx"),
        json!({"3.2": 4.0, "3.4": 3.0, "4.2": 5.0})
    );
    let groups = report["mistakes"].as_array().unwrap().iter();
    let groups: Vec<Value> = groups
        .map(|group| json!([group["id"], group["submissions"]]))
        .collect();
    let expected = json!([
        ["euler-zyx", {"euler-zyx": ["adult-1"], "weights-shifted+euler-zyx": ["adult-1"]}],
        ["no-inverse-bind", {"no-inverse-bind": ["adult-1"]}],
        ["weights-shifted", {"weights-shifted+euler-zyx": ["adult-1"]}],
    ]);
    assert_eq!(Value::from(groups), expected);
}
