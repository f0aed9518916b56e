//! 3.2 The skeleton: its file, and the two transforms of each joint.

use crate::assignment::characters::{BODY, skeleton};
use editor_core::character::Pose;
use editor_core::math::Euler;
use glam::{Mat4, Vec3};

#[test]
fn each_line_is_a_joint_with_its_offset_and_parent() {
    let skeleton = skeleton(BODY);
    let joints = skeleton.joints();
    assert_eq!(joints.len(), 5);
    assert_eq!(joints[0].offset, Vec3::new(0.5, 1.0, 0.0));
    let parents: Vec<_> = joints.iter().map(|joint| joint.parent).collect();
    assert_eq!(parents, [None, Some(0), Some(1), Some(1), Some(2)]);
    assert_eq!(skeleton.roots(), [0]);
    assert_eq!(skeleton.children(1), [2, 3]);
}

#[test]
fn positions_are_the_sums_of_the_offsets_from_the_root() {
    let expected = [[0.5, 1.0], [0.5, 2.0], [1.5, 2.0], [-0.5, 2.0], [2.0, 2.0]];
    let expected = expected.map(|[x, y]| Vec3::new(x, y, 0.0));
    assert_eq!(skeleton(BODY).bind_positions(), expected);
}

#[test]
fn bind_world_to_joint_undoes_the_bind_pose() {
    let skeleton = skeleton(BODY);
    let rest = skeleton.update_current_joint_to_world_transforms(&Pose::new());
    for (model_from_joint, joint_from_model) in rest.iter().zip(skeleton.bind_joint_from_model()) {
        let product = *model_from_joint * *joint_from_model;
        assert!(product.abs_diff_eq(Mat4::IDENTITY, 1e-6), "{product}");
    }
}

#[test]
fn a_joint_carries_all_below_it_and_nothing_else() {
    let skeleton = skeleton(BODY);
    let mut pose = Pose::new();
    pose.set_joint_transform(2, Euler::from_degrees(Vec3::Z * 90.0));
    let rest = skeleton.bind_positions();
    let posed = skeleton.update_current_joint_to_world_transforms(&pose);
    let posed: Vec<Vec3> = posed.iter().map(|m| m.w_axis.truncate()).collect();
    assert_eq!(posed[..4], rest[..4]);
    assert!(
        posed[4].abs_diff_eq(Vec3::new(1.5, 2.5, 0.0), 1e-6),
        "{}",
        posed[4]
    );
}

#[test]
fn transforms_multiply_from_the_root_down() {
    let skeleton = skeleton(BODY);
    let mut pose = Pose::new();
    let angles =
        [Vec3::new(10.0, 20.0, 30.0), Vec3::new(-40.0, 50.0, 60.0)].map(Euler::from_degrees);
    pose.set_joint_transform(0, angles[0]);
    pose.set_joint_transform(1, angles[1]);
    let current = skeleton.update_current_joint_to_world_transforms(&pose);
    let local =
        |x, y, angles: Euler| Mat4::from_translation(Vec3::new(x, y, 0.0)) * angles.to_mat4();
    let chest = local(0.5, 1.0, angles[0]) * local(0.0, 1.0, angles[1]);
    assert!(current[1].abs_diff_eq(chest, 1e-6));
    assert!(current[2].abs_diff_eq(chest * Mat4::from_translation(Vec3::X), 1e-6));
}

#[test]
fn parents_may_come_after_their_children() {
    let ordered = skeleton("0 1 0 -1\n0 2 0 0\n0 3 0 1\n");
    let reversed = skeleton("0 3 0 1\n0 2 0 2\n0 1 0 -1\n");
    let mut positions = reversed.bind_positions();
    positions.reverse();
    assert_eq!(positions, ordered.bind_positions());
}

#[test]
fn a_chain_of_a_hundred_thousand_joints_overflows_nothing() {
    let mut text = "0 0 0 -1\n".to_owned();
    (0..100_000).for_each(|parent| text.push_str(&format!("0 0.001 0 {parent}\n")));
    let top = skeleton(&text).bind_positions()[100_000];
    assert!((top.y - 100.0).abs() < 0.5, "{top}");
}
