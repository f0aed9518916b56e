//! 4.2 Skeletal subspace deformation: `v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v`.

use crate::assignment::characters::character;
use editor_core::character::{Character, Pose};
use editor_core::math::Euler;
use glam::Vec3;

/// An arm along X with an elbow at 1, and a vertex on each half and on the elbow.
fn arm(attach: &str) -> Character {
    let skel = "0 0 0 -1\n0 0 0 0\n1 0 0 1\n";
    character(skel, attach, "v 0.5 0 0\nv 1 0.1 0\nv 2 0 0\nf 1 2 3\n")
}

fn bent(degrees: f32) -> Pose {
    let mut pose = Pose::new();
    pose.set_joint_transform(2, Euler::from_degrees(Vec3::Z * degrees));
    pose
}

#[test]
fn an_untouched_skeleton_leaves_the_mesh_in_place() {
    let arm = arm("1 0\n0.5 0.5\n0 1\n");
    assert_eq!(arm.skin_pose(&Pose::new()), arm.bind_mesh().positions);
}

#[test]
fn a_vertex_of_one_joint_goes_with_it() {
    let skinned = arm("1 0\n0.5 0.5\n0 1\n").skin_pose(&bent(90.0));
    assert!(skinned[0].abs_diff_eq(Vec3::new(0.5, 0.0, 0.0), 1e-6));
    assert!(skinned[2].abs_diff_eq(Vec3::new(1.0, 1.0, 0.0), 1e-6));
}

#[test]
fn a_vertex_of_two_joints_goes_half_way_between_them() {
    let skinned = arm("1 0\n0.5 0.5\n0 1\n").skin_pose(&bent(90.0));
    let ways = [Vec3::new(1.0, 0.1, 0.0), Vec3::new(0.9, 0.0, 0.0)];
    let half = (ways[0] + ways[1]) * 0.5;
    assert!(skinned[1].abs_diff_eq(half, 1e-6), "{}", skinned[1]);
}

#[test]
fn weights_are_used_as_they_are_and_not_brought_to_1() {
    let skinned = arm("1 0\n0.25 0.25\n0 1\n").skin_pose(&Pose::new());
    assert!(skinned[1].abs_diff_eq(Vec3::new(0.5, 0.05, 0.0), 1e-6));
}

#[test]
fn no_weight_is_dropped_however_many_there_are() {
    let joints = 20;
    let mut skel = "0 0 0 -1\n".to_owned();
    (1..joints).for_each(|_| skel.push_str("0 0 0 0\n"));
    let row = "0.0526315789 ".repeat(joints - 1);
    let body = character(
        &skel,
        &format!("{row}\n").repeat(3),
        "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n",
    );
    assert_eq!(body.attachments().most_influences(), joints - 1);
    let mut pose = Pose::new();
    pose.set_joint_transform(joints - 1, Euler::from_degrees(Vec3::Z * 180.0));
    let skinned = body.skin_pose(&pose);
    // Of 19 equal shares one points the other way.
    assert!((skinned[0].x - 17.0 / 19.0).abs() < 1e-5, "{}", skinned[0]);
}

#[test]
fn a_turned_root_turns_the_whole_mesh_rigidly() {
    let arm = arm("1 0\n0.5 0.5\n0 1\n");
    let mut pose = Pose::new();
    let angles = Euler::from_degrees(Vec3::new(20.0, -50.0, 75.0));
    pose.set_joint_transform(0, angles);
    for (skinned, bind) in arm.skin_pose(&pose).iter().zip(&arm.bind_mesh().positions) {
        assert!(skinned.abs_diff_eq(angles.to_mat3() * *bind, 1e-6));
    }
}
