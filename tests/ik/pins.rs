//! Pinned joints stay where they are and as they are, while others are dragged or moved.

use crate::ik::chains::frames;
use editor_core::character::ik::{IkChain, IkGoal, hold_pins};
use editor_core::character::{Joint, Pose, SkeletalModel};
use editor_core::math::Euler;
use glam::Vec3;
use std::collections::BTreeSet;

/// A pelvis with two legs of thigh, shin and foot, and a spine of two with an arm of two.
fn figure() -> SkeletalModel {
    let mut joints = Vec::new();
    let mut add = |parent: Option<usize>, offset: [f32; 3]| {
        joints.push(Joint {
            parent,
            offset: offset.into(),
            ..Joint::default()
        });
        joints.len() - 1
    };
    let pelvis = add(None, [0.0, 2.0, 0.0]);
    for x in [-0.3, 0.3] {
        let thigh = add(Some(pelvis), [x, 0.0, 0.0]);
        let shin = add(Some(thigh), [0.0, -1.0, 0.2]);
        add(Some(shin), [0.0, -0.9, -0.2]);
    }
    let spine = add(Some(pelvis), [0.0, 0.5, 0.0]);
    let chest = add(Some(spine), [0.0, 0.5, 0.05]);
    let upper = add(Some(chest), [0.5, 0.2, 0.0]);
    let elbow = add(Some(upper), [0.6, 0.0, -0.05]);
    add(Some(elbow), [0.6, 0.0, 0.1]);
    SkeletalModel::new(joints).expect("a figure is a tree")
}

const FEET: [usize; 2] = [3, 6];
const CHEST: usize = 8;
const HAND: usize = 11;

fn moved(skeleton: &SkeletalModel, a: &Pose, b: &Pose, joint: usize) -> f32 {
    let (a, b) = (frames(skeleton, a)[joint], frames(skeleton, b)[joint]);
    let columns = [
        a.x_axis - b.x_axis,
        a.y_axis - b.y_axis,
        a.z_axis - b.z_axis,
        a.w_axis - b.w_axis,
    ];
    columns
        .iter()
        .map(|column| column.length())
        .fold(0.0, f32::max)
}

#[test]
fn the_feet_stay_on_the_ground_while_the_pelvis_sinks() {
    let skeleton = figure();
    let before = Pose::new();
    let mut after = before.clone();
    after.set_root_offset(0, Vec3::new(0.1, -0.4, 0.05));
    let pins = BTreeSet::from(FEET);
    let held = hold_pins(&skeleton, &before, &after, &pins, &[0]);
    for foot in FEET {
        assert!(moved(&skeleton, &before, &after, foot) > 0.3);
        let off = moved(&skeleton, &before, &held, foot);
        assert!(off < 1e-5, "foot {foot} is off by {off}");
        let knee = frames(&skeleton, &held)[foot - 1].w_axis;
        assert!(knee.z > 0.3, "the knees bend forwards");
    }
    assert_eq!(held.root_offset(0), after.root_offset(0));
}

#[test]
fn a_pinned_hand_stays_while_the_chest_is_dragged() {
    let skeleton = figure();
    let before = Pose::new();
    let pins = BTreeSet::from([HAND, 0]);
    let chain = IkChain::to_joint(&skeleton, &before, CHEST, 3, &pins).unwrap();
    assert_eq!(chain.joints(), [7], "the pelvis is pinned");
    let goal = IkGoal::to(Vec3::new(0.2, 2.9, 0.2));
    let dragged = chain.solve(&skeleton, &before, &goal).unwrap().pose;
    let mut busy = chain.joints().to_vec();
    busy.extend(chain.end());
    let held = hold_pins(&skeleton, &before, &dragged, &pins, &busy);
    assert!(moved(&skeleton, &before, &dragged, HAND) > 0.1);
    assert!(moved(&skeleton, &before, &held, HAND) < 1e-5);
    assert!(moved(&skeleton, &dragged, &held, CHEST) < 1e-6);
    assert_eq!(moved(&skeleton, &before, &held, 0), 0.0);
}

#[test]
fn of_a_limb_two_joints_make_up_for_what_they_can_and_no_other_limb_moves() {
    let skeleton = figure();
    let mut before = Pose::new();
    before.set_joint_transform(10, Euler::from_degrees(Vec3::new(0.0, 50.0, 0.0)));
    let mut after = before.clone();
    after.set_joint_transform(7, Euler::from_degrees(Vec3::new(0.0, 20.0, 0.0)));
    let held = hold_pins(&skeleton, &before, &after, &BTreeSet::from([HAND]), &[7]);
    let turned: Vec<usize> = (0..12)
        .filter(|&joint| held.rotation(joint) != after.rotation(joint))
        .collect();
    assert_eq!(turned, [9, 10, HAND]);
    assert!(moved(&skeleton, &before, &held, HAND) < 1e-5);
}

#[test]
fn a_pinned_foot_out_of_reach_does_not_tip_the_figure_over() {
    let skeleton = figure();
    let before = Pose::new();
    let mut after = before.clone();
    after.set_root_offset(0, Vec3::Y * 0.3);
    let foot = BTreeSet::from([FEET[0]]);
    // The pelvis is not what is dragged here, and could turn.
    let held = hold_pins(&skeleton, &before, &after, &foot, &[]);
    assert!(held.rotation(0).radians.abs_diff_eq(Vec3::ZERO, 1e-6));
    assert!(moved(&skeleton, &after, &held, CHEST) < 1e-6);
}

#[test]
fn a_pin_out_of_reach_is_pointed_at_and_nothing_is_torn() {
    let skeleton = figure();
    let before = Pose::new();
    let mut after = before.clone();
    after.set_root_offset(0, Vec3::Y * 5.0);
    let held = hold_pins(&skeleton, &before, &after, &BTreeSet::from(FEET), &[0]);
    for foot in FEET {
        let all = frames(&skeleton, &held);
        let at = |joint: usize| all[joint].w_axis.truncate();
        let (thigh, foot_now) = (at(foot - 2), at(foot));
        let was = frames(&skeleton, &before)[foot].w_axis.truncate();
        let line = (was - thigh).normalize_or_zero();
        let leg = Vec3::new(0.0, -1.0, 0.2).length() + Vec3::new(0.0, -0.9, -0.2).length();
        assert!(foot_now.abs_diff_eq(thigh + line * leg, 1e-4));
    }
}

#[test]
fn pins_that_do_not_move_change_nothing() {
    let skeleton = figure();
    let mut pose = Pose::new();
    pose.set_root_offset(0, Vec3::X);
    // A pin that does not exist, one that was dragged itself, and one that stands still.
    let pins = BTreeSet::from([99, HAND, FEET[0]]);
    let held = hold_pins(&skeleton, &pose, &pose, &pins, &[HAND]);
    assert_eq!(held, pose);
}

#[test]
fn pins_are_held_from_the_root_outward_in_whatever_order_the_file_has_them() {
    let joint = |parent, offset| Joint {
        parent,
        offset,
        ..Joint::default()
    };
    // Hand, elbow, shoulder, and a root in the shoulder's place.
    let joints = vec![
        joint(Some(1), Vec3::X),
        joint(Some(2), Vec3::X),
        joint(Some(3), Vec3::ZERO),
        joint(None, Vec3::ZERO),
    ];
    let skeleton = SkeletalModel::new(joints).unwrap();
    let before = Pose::new();
    let mut after = before.clone();
    after.set_joint_transform(3, Euler::from_degrees(Vec3::Z * 30.0));
    let held = hold_pins(&skeleton, &before, &after, &BTreeSet::from([0, 2]), &[3]);
    for pin in [0, 2] {
        let off = moved(&skeleton, &before, &held, pin);
        assert!(off < 1e-5, "pin {pin} is off by {off}");
    }
}
