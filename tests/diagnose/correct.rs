//! Meshes that are right have no cause, whoever computed and wrote them.

use crate::diagnose::figures::{Figure, turned, written, written_in_all};
use crate::diagnose::student::RIGHT;
use crate::reference_data::{course, course_pose, posed};
use editor_core::character::Pose;
use editor_core::diagnose::{Diagnosis, NearlyRight, Verdict};
use glam::Vec3;

#[track_caller]
fn assert_right(found: &Diagnosis, case: &str) {
    assert_eq!(found.verdict, Verdict::Right, "{case}: {found}");
    assert!(found.causes.is_empty() && found.same_as.is_empty() && found.first.is_none());
    assert!(
        found.nearest.is_none() && found.regions.is_empty(),
        "{case}"
    );
}

#[test]
fn fifty_right_meshes_of_other_precision_have_no_cause() {
    let mut cases = 0;
    for (name, seed) in [
        ("adult", 1),
        ("adult", 2),
        ("adult", 3),
        ("dog", 4),
        ("dog", 5),
        ("robot", 6),
        ("robot", 7),
    ] {
        let figure = Figure::builtin(name, turned(seed));
        let theirs = RIGHT.skin(&figure);
        for digits in [4, 5, 6, 7, 9] {
            assert_right(&figure.diagnose(&written(&theirs, digits)), name);
        }
        for digits in [4, 5, 6] {
            assert_right(&figure.diagnose(&written_in_all(&theirs, digits)), name);
        }
        assert_right(&figure.diagnose(&theirs), name);
        cases += 9;
    }
    assert!(cases >= 50);
}

#[test]
fn a_mesh_whose_root_is_moved_is_right_and_one_whose_root_stays_is_not() {
    let figure = Figure {
        moved: Vec3::new(0.3, -0.1, 0.2),
        ..Figure::builtin("adult", turned(9))
    };
    let stays = RIGHT.skin(&figure);
    let moved: Vec<Vec3> = stays.iter().map(|place| *place + figure.moved).collect();
    assert_right(&figure.diagnose(&moved), "moved");
    let found = figure.diagnose(&stays);
    assert_eq!(found.causes, ["root-not-moved"], "{found}");
    // Elsewhere it is moved as a whole.
    let aside = stays
        .iter()
        .map(|place| *place + Vec3::X)
        .collect::<Vec<_>>();
    let found = figure.diagnose(&aside);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    let moved = "the exact result, moved by (0.700000, 0.100000, -0.200000)";
    assert!(found.findings[0].to_string().ends_with(moved), "{found}");
}

#[test]
fn a_mesh_that_is_right_and_at_rest_has_no_cause() {
    let figure = Figure::builtin("adult", |_| Vec3::ZERO);
    assert_right(&figure.diagnose(&RIGHT.skin(&figure)), "at rest");
    assert_right(&figure.diagnose(&figure.positions), "as in the file");
}

#[test]
fn a_mesh_of_a_collada_file_is_right_wherever_vertices_without_weights_are() {
    for name in ["humanoid", "tentacle", "creature", "crate", "lizard"] {
        let figure = Figure::builtin(name, turned(8));
        let theirs = figure.character.skin_pose(&figure.pose());
        assert_right(&figure.diagnose(&theirs), name);
        let summed = theirs.iter().enumerate().map(|(vertex, &place)| {
            match figure.character.attachments().of_vertex(vertex) {
                [] => Vec3::ZERO,
                _ => place,
            }
        });
        let summed: Vec<Vec3> = summed.collect();
        assert_right(&figure.diagnose(&summed), name);
    }
}

#[test]
fn a_vertex_without_weights_may_stay_at_rest_or_go_to_the_origin_but_nowhere_else() {
    let figure = Figure::builtin("adult", turned(10));
    let mut rows = figure.rows.clone();
    rows[5].fill(0.0);
    let figure = figure.with_rows(rows);
    let at_the_origin = RIGHT.skin(&figure);
    assert_eq!(at_the_origin[5], Vec3::ZERO);
    let mut theirs = at_the_origin.clone();
    for (place, verdict) in [
        (Vec3::ZERO, Verdict::Right),
        (figure.positions[5], Verdict::Right),
        (figure.positions[5] * 0.5, Verdict::Unexplained),
    ] {
        theirs[5] = place;
        let found = figure.diagnose(&theirs);
        assert_eq!(found.verdict, verdict, "{place}: {found}");
        let first = found.first.map(|first| (first.vertex, first.joint));
        assert_eq!(first, (verdict != Verdict::Right).then_some((5, None)));
    }
}

#[test]
fn what_the_course_s_own_program_gives_is_right() {
    for name in ["walk", "twist"] {
        let Some(model) = course("characters/Model1.obj") else {
            return;
        };
        let Some(joints) = course_pose(name) else {
            return;
        };
        let degrees = |joint: usize| {
            let of_joint = joints.iter().find(|(index, _)| *index == joint.to_string());
            of_joint.map_or(Vec3::ZERO, |(_, degrees)| Vec3::from(*degrees))
        };
        let figure = Figure::new(&model, degrees);
        assert!(figure.pose() != Pose::new());
        let Some(golden) = posed(&format!("model1_{name}"), "v ") else {
            return;
        };
        let theirs: Vec<Vec3> = golden.iter().map(|v| Vec3::from_slice(v)).collect();
        for digits in [4, 9] {
            assert_right(&figure.diagnose(&written(&theirs, digits)), name);
        }
    }
}

#[test]
fn at_rest_the_mesh_of_the_file_is_nearly_right_whatever_its_weights_sum_to() {
    let figure = Figure::builtin("adult", |_| Vec3::ZERO);
    let rows = figure.rows.clone().into_iter();
    let rows = rows.map(|row| row.iter().map(|weight| weight * 1.0004).collect());
    let figure = figure.with_rows(rows.collect());
    let found = figure.diagnose(&figure.positions);
    assert_eq!(found.nearly_right(), Some(NearlyRight::Close), "{found}");
    assert!(found.is_as_in_file && found.causes.is_empty(), "{found}");
    let told = "it is the mesh at rest as the character's file has it, not skinned";
    assert!(found.to_string().contains(told), "{found}");
    // What is skinned is right, and in a pose the same mesh is one that is not posed.
    assert_right(&figure.diagnose(&RIGHT.skin(&figure)), "skinned");
    let posed = Figure::builtin("adult", turned(5)).with_rows(figure.rows);
    let found = posed.diagnose(&posed.positions);
    assert_eq!(found.causes[0], "pose-not-applied", "{found}");
}

#[test]
fn mistakes_that_the_pose_does_not_show_are_told_of_a_mesh_that_is_right() {
    // One joint about one axis: the order of the axes is the same.
    let bent = |joint| {
        if joint == 3 {
            Vec3::X * 40.0
        } else {
            Vec3::ZERO
        }
    };
    let figure = Figure::builtin("robot", bent);
    let found = figure.diagnose(&RIGHT.skin(&figure));
    assert_right(&found, "one axis");
    for id in [
        "euler-xzy",
        "euler-zyx",
        "one-axis-ignored-y",
        "sign-flipped-z",
    ] {
        assert!(found.unseen.contains(&id), "{id}: {found}");
    }
    for id in [
        "one-axis-ignored-x",
        "rotation-transposed",
        "no-inverse-bind",
    ] {
        assert!(!found.unseen.contains(&id), "{id}: {found}");
    }
    assert!(
        found
            .to_string()
            .contains("euler-zyx, euler-xzy, euler-yxz"),
        "{found}"
    );
    let figure = Figure::builtin("robot", turned(5));
    let found = figure.diagnose(&RIGHT.skin(&figure));
    assert!(
        !found.unseen.iter().any(|id| id.starts_with("euler")),
        "{found}"
    );
}
