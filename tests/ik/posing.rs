//! How a limb looks on its way: bends keep their side, and hinges their axis.

use crate::ik::chains::{Row, frames};
use editor_core::character::ik::{IkChain, IkGoal};
use editor_core::character::{Joint, Pose, SkeletalModel};
use glam::{Quat, Vec3};
use std::collections::BTreeSet;

/// An upright leg from (0, 2, 0) down to the ground, its knee a little forward.
fn leg() -> Row {
    let bones = [Vec3::new(0.0, -1.0, 0.1), Vec3::new(0.0, -1.0, -0.1)];
    Row::new(Vec3::Y * 2.0, &bones, &[])
}

fn solved(row: &Row, chain: &IkChain, pose: &Pose, goal: &IkGoal) -> Pose {
    let solution = chain.solve(&row.skeleton, pose, goal);
    solution.expect("a finite goal has an answer").pose
}

#[test]
fn two_bones_follow_the_law_of_cosines() {
    let bones = [Vec3::Y * 3.0, Vec3::new(0.0, 0.1, 4.0)];
    let row = Row::new(Vec3::ZERO, &bones, &[]);
    let chain = row.chain().unwrap();
    let lengths = row.lengths(0);
    let pose = solved(&row, &chain, &row.pose, &IkGoal::to(Vec3::X * 5.0));
    let elbow = row.point(&pose, 1);
    let along = (9.0 + 25.0 - lengths[1] * lengths[1]) / 10.0;
    assert!((elbow.x - along).abs() < 1e-5, "{elbow}");
    let across = (9.0 - along * along).sqrt();
    assert!((elbow.y.hypot(elbow.z) - across).abs() < 1e-5, "{elbow}");
}

#[test]
fn a_knee_stays_a_hinge() {
    let row = leg();
    let chain = row.chain().unwrap();
    for target in [
        Vec3::new(0.0, 0.9, 0.3),
        Vec3::new(1.0, 1.0, 0.5),
        Vec3::new(-0.4, 1.5, -1.0),
    ] {
        let pose = solved(&row, &chain, &row.pose, &IkGoal::to(target));
        let knee = Quat::from_mat3(&pose.rotation(1).to_mat3());
        let (axis, angle) = knee.to_axis_angle();
        assert!(angle > 0.1, "the knee bends");
        assert!(axis.cross(Vec3::X).length() < 1e-4, "{target}: {axis}");
    }
}

#[test]
fn an_arm_pulled_straight_bends_back_as_it_was() {
    let row = leg();
    let chain = row.chain().unwrap();
    let near = IkGoal::to(Vec3::new(0.0, 0.7, 0.2));
    let bent = solved(&row, &chain, &row.pose, &near);
    let mut pose = bent.clone();
    for target in [
        Vec3::new(0.0, -3.0, 1.0),
        Vec3::new(3.0, 0.0, 1.0),
        Vec3::new(0.0, -3.0, 1.0),
    ] {
        pose = solved(&row, &chain, &pose, &IkGoal::to(target));
    }
    pose = solved(&row, &chain, &pose, &near);
    let (was, is) = (row.point(&bent, 1), row.point(&pose, 1));
    assert!(is.z > 0.3, "the knee is at {is}, and was at {was}");
}

#[test]
fn small_steps_of_the_hand_are_small_steps_of_the_elbow() {
    for bones in [
        vec![Vec3::new(0.0, -1.0, 0.1), Vec3::new(0.0, -1.0, -0.1)],
        vec![Vec3::new(0.0, -0.6, 0.05); 4],
    ] {
        let row = Row::new(Vec3::ZERO, &bones, &[]);
        let chain = row.chain().unwrap();
        let mut pose = row.pose.clone();
        let mut last = None;
        // From hanging to overhead, on a way that passes out of reach.
        for step in 0..=400 {
            let angle = std::f32::consts::PI * step as f32 / 400.0;
            let far = 1.5 + (angle * 2.0).sin();
            let target = Vec3::new(angle.sin() * far, -angle.cos() * far, 0.3);
            pose = solved(&row, &chain, &pose, &IkGoal::to(target));
            let elbow = row.point(&pose, 1);
            if let Some(last) = last {
                assert!(elbow.distance(last) < 0.12, "{step}: {last} to {elbow}");
            }
            last = Some(elbow);
        }
    }
}

#[test]
fn the_bend_follows_the_pole() {
    let long = Row::new(Vec3::Y * 2.0, &[Vec3::new(0.0, -0.5, 0.05); 5], &[]);
    for (row, joint) in [(leg(), 1), (long, 2)] {
        let chain = row.chain().unwrap();
        for pole in [Vec3::X, Vec3::NEG_X, Vec3::NEG_Z, Vec3::new(1.0, 0.0, 1.0)] {
            let goal = IkGoal {
                pole: Some(pole),
                ..IkGoal::to(Vec3::Y)
            };
            let pose = solved(&row, &chain, &row.pose, &goal);
            let bend = row.point(&pose, joint).reject_from(Vec3::Y);
            let off = bend.normalize_or_zero().distance(pole.normalize_or_zero());
            assert!(off < 2e-2, "{pole}: {bend}");
        }
    }
}

#[test]
fn the_length_says_how_many_joints_turn_and_pins_hold_those_above() {
    let row = Row::new(Vec3::ZERO, &[Vec3::Y, Vec3::X, Vec3::Y, Vec3::Z], &[]);
    let (skeleton, pose) = (&row.skeleton, &row.pose);
    let none = BTreeSet::new();
    let joints = |chain: Option<IkChain>| chain.map(|chain| chain.joints().to_vec());
    assert_eq!(joints(row.chain_of(2)), Some(vec![2, 3]));
    assert_eq!(joints(row.chain_of(9)), Some(vec![0, 1, 2, 3]));
    let to_joint = |joint, length, fixed: &BTreeSet<usize>| {
        joints(IkChain::to_joint(skeleton, pose, joint, length, fixed))
    };
    assert_eq!(to_joint(3, 2, &none), Some(vec![1, 2]));
    assert_eq!(to_joint(3, 9, &BTreeSet::from([0])), Some(vec![1, 2]));
    assert_eq!(to_joint(3, 9, &BTreeSet::from([2])), None);
    assert_eq!(to_joint(0, 2, &none), None, "a root has nothing above it");
    assert_eq!(to_joint(4, 2, &none), None, "there is no such joint");
}

#[test]
fn joints_without_a_bone_stay_as_they_are() {
    let bones = [Vec3::Y, Vec3::ZERO, Vec3::Y];
    let angles = [Vec3::ZERO, Vec3::new(10.0, 20.0, 30.0), Vec3::X * 5.0];
    let row = Row::new(Vec3::ZERO, &bones, &angles);
    let chain = row.chain().unwrap();
    let pose = solved(&row, &chain, &row.pose, &IkGoal::to(Vec3::X));
    assert_eq!(pose.rotation(1), row.pose.rotation(1));
    assert!(row.end(&pose).abs_diff_eq(Vec3::X, 1e-5));
}

#[test]
fn a_foot_stays_flat_if_it_is_to() {
    let joint = |parent, offset| Joint {
        parent,
        offset,
        ..Joint::default()
    };
    let skeleton = SkeletalModel::new(vec![
        joint(None, Vec3::Y * 2.0),
        joint(Some(0), Vec3::new(0.0, -1.0, 0.1)),
        joint(Some(1), Vec3::new(0.0, -1.0, -0.1)),
    ])
    .unwrap();
    let pose = Pose::new();
    let chain = IkChain::to_joint(&skeleton, &pose, 2, 2, &BTreeSet::new()).unwrap();
    let target = Vec3::new(0.3, 0.8, 0.2);
    for keep_orientation in [false, true] {
        let goal = IkGoal {
            keep_orientation,
            ..IkGoal::to(target)
        };
        let solved = chain.solve(&skeleton, &pose, &goal).unwrap().pose;
        let foot = frames(&skeleton, &solved)[2];
        assert!(foot.w_axis.truncate().abs_diff_eq(target, 1e-5));
        let flat = foot.y_axis.truncate().abs_diff_eq(Vec3::Y, 1e-5);
        assert_eq!(flat, keep_orientation);
        let kept = solved.rotation(2) == pose.rotation(2);
        assert_eq!(kept, !keep_orientation);
    }
}

#[test]
fn a_target_where_the_end_is_changes_no_angle() {
    let row = leg();
    let chain = row.chain().unwrap();
    let end = row.end(&row.pose);
    let pose = solved(&row, &chain, &row.pose, &IkGoal::to(end));
    for joint in 0..2 {
        let angles = pose.rotation(joint).degrees();
        assert!(angles.length() < 1e-3, "{joint}: {angles}");
    }
}

#[test]
fn the_angles_are_the_nearest_to_those_shown() {
    let angles = [Vec3::new(350.0, 0.0, -10.0), Vec3::new(-370.0, 0.0, 0.0)];
    let bones = [Vec3::new(0.0, -1.0, 0.1), Vec3::new(0.0, -1.0, -0.1)];
    let row = Row::new(Vec3::ZERO, &bones, &angles);
    let chain = row.chain().unwrap();
    let end = row.end(&row.pose) + Vec3::new(0.01, 0.02, 0.0);
    let pose = solved(&row, &chain, &row.pose, &IkGoal::to(end));
    for (joint, shown) in angles.iter().enumerate() {
        let change = (pose.rotation(joint).degrees() - *shown)
            .abs()
            .max_element();
        assert!(change < 40.0, "{joint} changes by {change}");
    }
}

#[test]
fn a_straight_knee_bends_to_where_its_figure_looks_and_an_elbow_away_from_it() {
    for side in [1.0, -1.0] {
        let limbs = [
            ("Body", None, Vec3::Y * 2.0),
            ("Hip.L", Some(0), Vec3::X * 0.2 * side),
            ("Knee.L", Some(1), Vec3::NEG_Y),
            ("Foot.L", Some(2), Vec3::NEG_Y),
            ("Shoulder.R", Some(0), Vec3::new(-0.3 * side, 1.0, 0.0)),
            ("Elbow.R", Some(4), Vec3::NEG_X * side),
            ("Hand.R", Some(5), Vec3::NEG_X * side),
        ];
        let joints = limbs.iter().map(|&(name, parent, offset)| Joint {
            name: name.to_owned(),
            parent,
            offset,
            ..Joint::default()
        });
        let skeleton = SkeletalModel::new(joints.collect()).expect("a tree");
        let pose = Pose::new();
        for (end, toward, forward) in [(3, Vec3::Y, 1.0), (6, Vec3::X * side, -1.0)] {
            let chain = IkChain::to_joint(&skeleton, &pose, end, 2, &BTreeSet::new());
            let chain = chain.expect("two joints are above it");
            let target = chain.end_position(&skeleton, &pose) + toward * 0.4;
            let solution = chain.solve(&skeleton, &pose, &IkGoal::to(target));
            let bent = frames(&skeleton, &solution.expect("it is in reach").pose);
            let middle = bent[end - 1].w_axis.truncate();
            assert!(middle.z * side * forward > 0.3, "{side} {end}: {middle}");
        }
    }
}
