//! Skinning many vertices at once, on every character that comes along and the course's.

use crate::reference_data::course;
use editor_core::character::{Character, Pose};
use editor_core::disk::Disk;
use editor_core::geometry::Normals;
use editor_core::io::builtin::{BuiltinKind, PREFIX, WithBuiltin, catalogue};
use editor_core::io::{Loaded, read_character};
use editor_core::math::Euler;
use editor_core::scene::ShapeKind;
use glam::Vec3;
use std::path::PathBuf;

/// Every joint turned, no two alike.
fn lively(character: &Character) -> Pose {
    let mut pose = Pose::new();
    for joint in 0..character.skeleton().joints().len() {
        let angle = 40.0 * (joint as f32 + 1.0).sin();
        let angles = Vec3::new(angle, -0.7 * angle, 1.3 * angle);
        pose.set_joint_transform(joint, Euler::from_degrees(angles));
    }
    pose
}

fn assert_bits(name: &str, character: &Character) {
    let skeleton = character.skeleton();
    let frames = skeleton.update_current_joint_to_world_transforms(&lively(character));
    let (one, all) = (character.skin_one_by_one(&frames), character.skin(&frames));
    let bits =
        |of: &[Vec3]| -> Vec<_> { of.iter().map(|v| v.to_array().map(f32::to_bits)).collect() };
    assert_ne!(one.positions, character.bind_mesh().positions, "{name}");
    assert!(bits(&one.positions) == bits(&all.positions), "{name}");
    let normals = (
        one.normals.unwrap_or_default(),
        all.normals.unwrap_or_default(),
    );
    assert!(bits(&normals.0) == bits(&normals.1), "{name}");
}

#[test]
fn characters_of_the_program_are_skinned_to_the_bits_of_the_reference() {
    let mut with_normals = 0;
    for builtin in catalogue() {
        if matches!(builtin.kind, BuiltinKind::Pose) {
            continue;
        }
        let mut loaded = Loaded::default();
        let path = PathBuf::from(format!("{PREFIX}{}", builtin.name));
        loaded.add(&WithBuiltin(Disk), &path).unwrap();
        for shape in loaded.shapes {
            let ShapeKind::Character(shape) = shape.kind else {
                continue;
            };
            let character = &shape.character;
            assert_bits(builtin.name, character);
            let normals = &character.bind_mesh().normals;
            with_normals += usize::from(matches!(normals, Normals::PerVertex(_)));
        }
    }
    assert!(with_normals > 0);
}

#[test]
fn characters_of_the_course_are_skinned_to_the_bits_of_the_reference() {
    for name in ["Model1", "Model2"] {
        let Some(path) = course(&format!("characters/{name}.obj")) else {
            return;
        };
        assert_bits(name, &read_character(&Disk, &path).unwrap().value);
    }
}
