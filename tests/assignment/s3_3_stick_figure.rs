//! 3.3 The stick figure: joints and bones as they are drawn.

use crate::assignment::characters::{BODY, skeleton};
use editor_core::character::{Pose, StickFigure};
use editor_core::geometry::BONE_HALF_WIDTH;
use glam::Vec3;

fn figure(skel: &str) -> StickFigure {
    let skeleton = skeleton(skel);
    let rest = skeleton.update_current_joint_to_world_transforms(&Pose::new());
    StickFigure::new(&skeleton, &rest)
}

#[test]
fn every_joint_is_drawn_and_a_bone_for_every_joint_but_the_root() {
    let figure = figure(BODY);
    assert_eq!(figure.joints.len(), 5);
    let between = [(0, 1), (1, 2), (1, 3), (2, 4)];
    assert_eq!(figure.bones.len(), between.len());
    for (bone, (joint, child)) in figure.bones.iter().zip(between) {
        assert_eq!(bone.joint, joint);
        let ends = (figure.joints[joint], figure.joints[child]);
        assert_eq!((bone.start, bone.end), ends);
    }
}

#[test]
fn the_box_of_a_bone_reaches_from_joint_to_joint_and_has_its_half_width() {
    for bone in figure(BODY).bones {
        let model_from_unit = bone.model_from_unit(BONE_HALF_WIDTH).unwrap();
        let corner = |x, y, z| model_from_unit.transform_point3(Vec3::new(x, y, z));
        assert!(corner(0.0, 0.0, 0.0).abs_diff_eq(bone.start, 1e-6));
        assert!(corner(0.0, 0.0, 1.0).abs_diff_eq(bone.end, 1e-6));
        let width = corner(1.0, 0.0, 0.0).distance(corner(-1.0, 0.0, 0.0));
        assert!((width - 2.0 * BONE_HALF_WIDTH).abs() < 1e-6, "{width}");
    }
}

#[test]
fn a_bone_of_zero_length_has_no_box_and_no_nan() {
    let figure = figure("1 1 1 -1\n0 0 0 0\n");
    assert_eq!(figure.bones[0].model_from_unit(BONE_HALF_WIDTH), None);
    assert!(figure.joints.iter().all(|joint| joint.is_finite()));
}
