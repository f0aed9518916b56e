//! A mistake in a mesh that is moved, scaled or has other axes as a whole.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, with};
use editor_core::diagnose::Verdict;
use glam::Vec3;

type Place = fn(Vec3) -> Vec3;

const PLACES: [(Place, &str); 5] = [
    (|v| Vec3::new(v.x, -v.z, v.y), "the axes x, -z, y"),
    (|v| v * 100.0, "100 times as large"),
    (|v| v * 0.01, "0.01 times as large"),
    (|v| v - Vec3::new(3.0, 0.0, 4.0), "moved by 5"),
    (
        |v| Vec3::new(-v.z, v.y, v.x) * 2.0,
        "the axes -z, y, x, 2 times as large",
    ),
];

#[test]
fn a_mistake_is_named_in_a_mesh_that_is_elsewhere_of_another_size_or_on_other_axes() {
    let figure = Figure::builtin("adult", turned(71)).with_weights_of(2);
    for id in [
        "euler-zyx",
        "weights-shifted",
        "weights-normalized",
        "no-inverse-bind",
        "pose-not-applied",
    ] {
        let skinned = with(&[id]).skin(&figure);
        for (place, how) in PLACES {
            let theirs: Vec<Vec3> = skinned.iter().copied().map(place).collect();
            let found = figure.diagnose(&written(&theirs, 6));
            assert_eq!(found.verdict, Verdict::Explained, "{id} {how}: {found}");
            assert!(
                named(&found).contains(&vec![id, "moved-as-a-whole"]),
                "{id} {how}: {found}"
            );
            assert_eq!(found.mistakes[1].how, how, "{found}");
            assert!(found.error < 1e-4, "{found}");
        }
    }
}

#[test]
fn a_mesh_that_is_right_but_for_its_place_has_no_mistake() {
    let figure = Figure::builtin("adult", turned(71));
    let exact = RIGHT.skin(&figure);
    for (place, how) in PLACES {
        let theirs: Vec<Vec3> = exact.iter().copied().map(place).collect();
        let found = figure.diagnose(&written(&theirs, 6));
        assert_eq!(found.verdict, Verdict::Unexplained, "{how}: {found}");
        assert!(found.causes.is_empty(), "{how}: {found}");
        assert!(
            found.to_string().starts_with("nearly right: "),
            "{how}: {found}"
        );
    }
}

#[test]
fn a_mesh_that_is_placed_otherwise_and_has_two_mistakes_has_none_of_them_named() {
    let figure = Figure::builtin("adult", turned(72));
    let skinned = with(&["euler-zyx", "weights-shifted"]).skin(&figure);
    let theirs: Vec<Vec3> = skinned.into_iter().map(|v| v * 100.0).collect();
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
}
