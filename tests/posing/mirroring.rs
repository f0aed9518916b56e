//! Mirrored poses, by where the joints are then.

use editor_core::character::{Joint, Mirror, Pose, SkeletalModel};
use editor_core::math::Euler;
use glam::Vec3;

fn skeleton(joints: &[(&str, Option<usize>, [f32; 3])]) -> SkeletalModel {
    let joints = joints.iter().map(|&(name, parent, offset)| Joint {
        name: name.to_owned(),
        parent,
        offset: offset.into(),
        ..Joint::default()
    });
    SkeletalModel::new(joints.collect()).unwrap()
}

/// Where a joint is once `turned` is turned by 40° about X, Y and Z, and that pose mirrored or not.
fn place(skeleton: &SkeletalModel, turned: usize, mirrored: bool, joint: usize) -> Vec3 {
    let mut pose = Pose::new();
    pose.set_joint_transform(turned, Euler::from_degrees(Vec3::splat(40.0)));
    if mirrored {
        pose = Mirror::new(skeleton).pose(&pose);
    }
    let frames = skeleton.update_current_joint_to_world_transforms(&pose);
    frames[joint].w_axis.truncate()
}

#[test]
fn a_figure_whose_left_is_along_z_is_mirrored_across_z() {
    let figure = skeleton(&[
        ("Body", None, [0.0, 1.0, 0.0]),
        ("Left arm", Some(0), [0.0, 0.4, 0.2]),
        ("Left hand", Some(1), [0.0, 0.0, 0.5]),
        ("Right arm", Some(0), [0.0, 0.4, -0.2]),
        ("Right hand", Some(3), [0.0, 0.0, -0.5]),
    ]);
    let left = place(&figure, 1, false, 2);
    let right = place(&figure, 1, true, 4);
    assert!(right.abs_diff_eq(left.with_z(-left.z), 1e-5), "{right}");
}

#[test]
fn without_names_an_arm_is_mirrored_to_the_arm_and_not_to_a_joint_in_its_place() {
    let figure = skeleton(&[
        ("a", None, [0.0, 0.0, 0.0]),
        ("b", Some(0), [0.5, 0.4, 0.0]),
        ("c", Some(1), [0.4, 0.1, 0.1]),
        ("d", Some(0), [0.5, 0.4, 0.0]),
        ("e", Some(0), [-0.5, 0.4, 0.0]),
        ("f", Some(0), [-0.5, 0.4, 0.0]),
        ("g", Some(5), [-0.4, 0.1, 0.1]),
    ]);
    let left = place(&figure, 1, false, 2);
    let right = place(&figure, 1, true, 6);
    assert!(right.abs_diff_eq(left.with_x(-left.x), 1e-5), "{right}");
}

#[test]
fn a_root_that_was_moved_and_turned_stands_where_it_was_moved_to() {
    let figure = skeleton(&[("Root", None, [1.0, 2.0, 3.0])]);
    let mut pose = Pose::new();
    pose.set_root_offset(0, Vec3::new(0.5, 0.0, -4.0));
    pose.set_joint_transform(0, Euler::from_degrees(Vec3::new(0.0, 90.0, 0.0)));
    let frames = figure.update_current_joint_to_world_transforms(&pose);
    let at = frames[0].w_axis.truncate();
    assert_eq!(at, Vec3::new(1.5, 2.0, -1.0));
}
