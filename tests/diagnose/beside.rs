//! Mistakes in one line of the skeleton, in the weights or the pose of single joints and with numbers from the mesh, each
//! beside another mistake.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::sorted;
use crate::diagnose::student::{Student, Weights, with};
use editor_core::diagnose::Verdict;
use glam::Vec3;

const SEED: u32 = 57;
const ROOT: usize = 0;
const ELBOW: usize = 14;
const COLLARBONE: usize = 12;
const KNEE: usize = 10;

/// Mistakes in each part of a program.
const OTHERS: [&str; 7] = [
    "euler-zyx",
    "angles-negated",
    "degrees-as-radians",
    "no-inverse-bind",
    "weights-normalized",
    "influences-cut-4",
    "weights-shifted",
];

/// The figure with weights that do not quite sum to 1, in a pose.
fn adult_in(pose: impl Fn(usize) -> Vec3) -> Figure {
    let figure = Figure::builtin("adult", pose);
    let rows = figure.rows.iter().enumerate().map(|(index, row)| {
        let by = 1.0 + 0.0004 * (index % 3) as f32;
        row.iter().map(|weight| weight * by).collect()
    });
    let rows = rows.collect();
    figure.with_rows(rows)
}

fn adult() -> Figure {
    adult_in(turned(SEED))
}

/// That `theirs` is explained by these two mistakes, of which `id` is told in these words.
#[track_caller]
fn assert_both(theirs: &[Vec3], other: &str, id: &str, how: &str) {
    let found = adult().diagnose(&written(theirs, 6));
    let together = sorted(&found);
    let mut expected = [other, id];
    expected.sort_unstable();
    assert_eq!(together, expected, "{found}");
    let told = found.mistakes.iter().find(|mistake| mistake.id == id);
    assert_eq!(told.unwrap().how, how, "{found}");
}

#[test]
fn a_wrong_parent_is_named_beside_another_mistake() {
    let mut wrong = adult();
    wrong.parents[ELBOW] = Some(COLLARBONE);
    let how = "Right elbow (14) on Right collarbone (12) instead of Right shoulder (13)";
    for other in OTHERS {
        assert_both(&with(&[other]).skin(&wrong), other, "one-wrong-parent", how);
    }
}

#[test]
fn a_wrong_offset_is_named_beside_another_mistake() {
    let mut wrong = adult();
    let real = wrong.offsets[KNEE];
    wrong.offsets[KNEE].y *= -1.0;
    let told = |of: Vec3| {
        let [x, y, z] = of
            .to_array()
            .map(|value| (f64::from(value) * 1e4).round() / 1e4);
        format!("({x}, {y}, {z})")
    };
    let how = format!(
        "Left knee (10) {} instead of {}",
        told(wrong.offsets[KNEE]),
        told(real)
    );
    for other in OTHERS {
        assert_both(
            &with(&[other]).skin(&wrong),
            other,
            "one-wrong-offset",
            &how,
        );
    }
}

#[test]
fn weights_of_a_joint_that_are_left_out_or_exchanged_with_anothers_are_named_beside_another_mistake()
 {
    for other in ["euler-zyx", "angles-negated", "no-inverse-bind"] {
        let left_out = Student {
            joint_of_column: |column| {
                if column + 1 == KNEE {
                    usize::MAX
                } else {
                    column + 1
                }
            },
            ..with(&[other])
        };
        let how = "Left knee (10)";
        assert_both(&left_out.skin(&adult()), other, "joint-left-out", how);
        let exchanged = Student {
            joint_of_column: |column| match column + 1 {
                ELBOW => KNEE,
                KNEE => ELBOW,
                joint => joint,
            },
            ..with(&[other])
        };
        let how = "Left knee (10) and Right elbow (14)";
        assert_both(&exchanged.skin(&adult()), other, "weights-exchanged", how);
    }
}

#[test]
fn small_weights_that_are_left_out_are_named_beside_another_mistake() {
    let both = Student {
        weights: |weights| {
            weights
                .into_iter()
                .filter(|(_, weight)| *weight >= 0.15)
                .collect()
        },
        ..with(&["euler-zyx"])
    };
    let found = adult().diagnose(&written(&both.skin(&adult()), 6));
    assert_eq!(
        found.together(),
        ["euler-zyx", "small-weights-left-out"],
        "{found}"
    );
}

#[test]
fn a_factor_of_the_angles_is_named_beside_another_mistake() {
    for other in ["weights-normalized", "euler-zyx", "no-inverse-bind"] {
        let gradians = Student {
            to_radians: |degrees| degrees * std::f32::consts::PI / 200.0,
            ..with(&[other])
        };
        let how = "each is 0.9 times as large";
        assert_both(&gradians.skin(&adult()), other, "angles-scaled", how);
    }
}

/// The pose in which these joints are not turned.
fn without(joints: &[usize]) -> impl Fn(usize) -> Vec3 {
    |joint| match joints.contains(&joint) {
        true => Vec3::ZERO,
        false => turned(SEED)(joint),
    }
}

#[test]
fn a_joint_that_is_not_turned_is_named_beside_another_mistake() {
    let posed = adult_in(without(&[KNEE]));
    let (id, how) = ("joint-not-turned", "Left knee (10)");
    for other in OTHERS {
        assert_both(&with(&[other]).skin(&posed), other, id, how);
    }
}

#[test]
fn joints_that_are_not_turned_are_another_pose_where_no_other_mistake_is_made() {
    // That the root is not turned is a mistake by itself.
    for joints in [&[KNEE][..], &[KNEE, ELBOW], &[ROOT, KNEE]] {
        let theirs = with(&[]).skin(&adult_in(without(joints)));
        let found = adult().diagnose(&written(&theirs, 6));
        let other = found.other_pose.as_ref().expect("another pose");
        let told: Vec<usize> = other.joints.iter().map(|it| it.joint_index).collect();
        assert_eq!(told, joints, "{found}");
    }
    // Of weights that sum to 1 a mistake in their sum is not seen, and few digits hide that no other is needed.
    let figure = Figure::builtin("adult", turned(SEED));
    let posed = Figure::builtin("adult", without(&[KNEE]));
    let found = figure.diagnose(&written(&with(&[]).skin(&posed), 2));
    let other = found.other_pose.as_ref().expect("another pose");
    let turned: Vec<String> = other.joints.iter().map(ToString::to_string).collect();
    let knee = "Left knee (0°, 0°, 0°) instead of ";
    assert!(turned.len() == 1 && turned[0].starts_with(knee), "{found}");
    assert_eq!(found.coarse.map(|coarse| coarse.rounded_to), Some(0.01));
    let told = "\n  found    its numbers are rounded to 0.01, which may hide smaller mistakes: write at least ";
    assert!(found.to_string().contains(told), "{found}");
}

#[test]
fn of_two_joints_none_is_said_not_to_be_turned_beside_another_mistake() {
    // Less than half of the pose would be there.
    let pose = |of: &[usize]| {
        let of = of.to_vec();
        move |joint: usize| match of.contains(&joint) {
            true => turned(SEED)(joint),
            false => Vec3::ZERO,
        }
    };
    let (expected, posed) = (pose(&[KNEE, ELBOW]), pose(&[ELBOW]));
    let theirs = with(&["euler-zyx"]).skin(&adult_in(posed));
    let found = adult_in(expected).diagnose(&written(&theirs, 6));
    assert_eq!(found.verdict, Verdict::OtherPose, "{found}");
}

#[test]
fn of_joints_whose_offsets_give_the_same_the_one_with_the_plainest_slip_is_told_first() {
    // Its collarbone is not turned, so that the shoulder's offset may as well be added to that one's.
    let (collarbone, shoulder) = (15, 16);
    let pose = |joint: usize| match joint == collarbone {
        true => Vec3::ZERO,
        false => turned(SEED)(joint),
    };
    let figure = Figure::builtin("adult", pose);
    let mut wrong = Figure::builtin("adult", pose);
    let real = figure.offsets[shoulder];
    for slip in [
        real * Vec3::new(-1.0, 1.0, 1.0),
        real * Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(real.y, real.x, real.z),
    ] {
        wrong.offsets[shoulder] = slip;
        let found = figure.diagnose(&with(&[]).skin(&wrong));
        assert_eq!(found.causes, ["one-wrong-offset"], "{found}");
        let how = &found.mistakes[0].how;
        assert!(how.starts_with("Left shoulder (16) "), "{slip}: {how}");
        assert!(how.contains(", or Left collarbone (15) "), "{slip}: {how}");
    }
}

#[test]
fn a_mesh_of_another_pose_is_told_though_a_mistake_moves_it_a_little_besides() {
    let posed = adult_in(|joint| match joint == ELBOW {
        true => Vec3::new(10.0, 20.0, -30.0),
        false => turned(SEED)(joint),
    });
    let theirs = with(&["weights-normalized"]).skin(&posed);
    let corners = adult().character.bind_mesh().triangles.concat();
    let of_corners = corners.iter().map(|&corner| theirs[corner as usize]);
    let of_corners: Vec<Vec3> = of_corners.collect();
    for theirs in [theirs, of_corners] {
        let found = adult().diagnose(&written(&theirs, 6));
        assert_eq!(found.verdict, Verdict::OtherPose, "{found}");
        let other = found.other_pose.as_ref().unwrap();
        let besides = other.besides.as_ref().map(|mistake| mistake.id);
        assert_eq!(besides, Some("weights-normalized"), "{found}");
        let turned: Vec<String> = other.joints.iter().map(ToString::to_string).collect();
        let elbow = "Right elbow (10°, 20°, -30°) instead of ";
        assert!(turned.len() == 1 && turned[0].starts_with(elbow), "{found}");
        let begins = "another pose: but for weights-normalized, this is the exact result of a pose";
        assert!(found.to_string().starts_with(begins), "{found}");
    }
}

#[test]
fn a_joint_that_is_left_out_before_weights_are_divided_by_their_sum_is_named_with_that() {
    let both = Student {
        weights: |weights| {
            let used: Weights = weights
                .into_iter()
                .filter(|(joint, _)| *joint != KNEE)
                .collect();
            let sum: f32 = used.iter().map(|(_, weight)| weight).sum();
            let by = if sum == 0.0 { 1.0 } else { 1.0 / sum };
            used.into_iter()
                .map(|(joint, weight)| (joint, weight * by))
                .collect()
        },
        ..with(&[])
    };
    let (id, how) = ("joint-left-out", "Left knee (10)");
    assert_both(&both.skin(&adult()), "weights-normalized", id, how);
}

#[test]
fn a_sum_that_is_overwritten_is_named_beside_weights_that_are_left_out() {
    let both = Student {
        weights: |weights| {
            let mut largest = weights;
            largest.sort_by(|a, b| b.1.total_cmp(&a.1));
            largest.truncate(2);
            largest
                .into_iter()
                .max_by_key(|(joint, _)| *joint)
                .into_iter()
                .collect()
        },
        ..with(&[])
    };
    let found = adult().diagnose(&written(&both.skin(&adult()), 6));
    let together = sorted(&found);
    assert_eq!(
        together,
        ["influences-cut-fewer", "sum-overwritten"],
        "{found}"
    );
}
