//! The course's poses: the matrices of all joints and every vertex of the deformed mesh.

use crate::reference_data::{course, course_pose, posed};
use editor_core::character::{Character, Pose};
use editor_core::disk::Disk;
use editor_core::io::read_character;
use editor_core::math::Euler;
use glam::{Mat4, Vec3};

const TOLERANCE: f32 = 2e-5;

fn model1() -> Option<Character> {
    let path = course("characters/Model1.obj")?;
    Some(read_character(&Disk, &path).unwrap().value)
}

fn pose(name: &str) -> Option<Pose> {
    let mut pose = Pose::new();
    for (joint, degrees) in course_pose(name)? {
        pose.set_joint_transform(joint.parse().unwrap(), Euler::from_degrees(degrees.into()));
    }
    Some(pose)
}

#[test]
fn joints_stand_where_the_original_has_them() {
    for name in ["walk", "twist"] {
        let (Some(character), Some(pose), Some(golden)) =
            (model1(), pose(name), posed(&format!("model1_{name}"), "j "))
        else {
            return;
        };
        let ours = character
            .skeleton()
            .update_current_joint_to_world_transforms(&pose);
        assert_eq!(ours.len(), golden.len());
        for (joint, (ours, golden)) in ours.iter().zip(&golden).enumerate() {
            let columns: Vec<f32> = ours
                .to_cols_array_2d()
                .iter()
                .flat_map(|c| c[..3].to_vec())
                .collect();
            for (ours, golden) in columns.iter().zip(golden) {
                assert!(
                    (ours - golden).abs() < TOLERANCE,
                    "{name} joint {joint}: {ours} {golden}"
                );
            }
        }
    }
}

#[test]
fn vertices_go_where_the_original_has_them() {
    for name in ["walk", "twist"] {
        let (Some(character), Some(pose), Some(golden)) =
            (model1(), pose(name), posed(&format!("model1_{name}"), "v "))
        else {
            return;
        };
        let ours = character.skin_pose(&pose);
        assert_eq!(ours.len(), golden.len());
        for (vertex, (ours, golden)) in ours.iter().zip(&golden).enumerate() {
            let golden = Vec3::from_slice(golden);
            assert!(
                ours.abs_diff_eq(golden, TOLERANCE),
                "{name} vertex {vertex}: {ours} {golden}"
            );
        }
    }
}

#[test]
fn an_untouched_skeleton_leaves_every_joint_and_vertex_in_place() {
    let Some(character) = model1() else { return };
    let skeleton = character.skeleton();
    let rest = skeleton.update_current_joint_to_world_transforms(&Pose::new());
    for moved in skeleton.palette(&rest) {
        assert!(moved.abs_diff_eq(Mat4::IDENTITY, 1e-6), "{moved}");
    }
    // The rows of the file sum up to 1 within 4e-4 only, and are used as they are.
    let skinned = character.skin_pose(&Pose::new());
    for (skinned, bind) in skinned.iter().zip(&character.bind_mesh().positions) {
        assert!(skinned.abs_diff_eq(*bind, 5e-4), "{skinned} {bind}");
    }
}
