//! 3.4 The sliders: `setJointTransform(index, rX, rY, rZ)`.

use crate::assignment::characters::{BODY, skeleton};
use editor_core::character::Pose;
use editor_core::math::Euler;
use glam::{Mat3, Vec3};

#[test]
fn angles_mean_rx_times_ry_times_rz() {
    let mut pose = Pose::new();
    pose.set_joint_transform(0, Euler::from_degrees(Vec3::new(30.0, 40.0, 50.0)));
    let current = skeleton(BODY).update_current_joint_to_world_transforms(&pose);
    let [x, y, z] = [30.0_f32, 40.0, 50.0].map(f32::to_radians);
    let expected = Mat3::from_rotation_x(x) * Mat3::from_rotation_y(y) * Mat3::from_rotation_z(z);
    assert!(Mat3::from_mat4(current[0]).abs_diff_eq(expected, 1e-6));
}

#[test]
fn a_slider_replaces_and_does_not_accumulate() {
    let mut pose = Pose::new();
    let angles = Euler::from_degrees(Vec3::new(0.0, 25.0, 0.0));
    pose.set_joint_transform(1, angles);
    let once = pose.clone();
    pose.set_joint_transform(1, angles);
    assert_eq!(pose, once);
    pose.set_joint_transform(1, Euler::ZERO);
    assert!(pose.is_bind());
}
