//! Files of a real exporter, with poses worked out by another program.

use crate::reference_data::reference;
use editor_core::character::{Character, Pose};
use editor_core::disk::Disk;
use editor_core::editor::set_beside_each_other;
use editor_core::io::Imported;
use editor_core::io::dae::{DaeScene, read_dae};
use editor_core::math::Euler;
use editor_core::scene::{Camera, CharacterShape, NewShape, ShapeKind, ViewDirection};
use glam::{Mat3, Mat4, Vec3};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const NAMES: [&str; 5] = ["split_cube", "long_cubes", "mapped_cube", "robot", "head"];

fn folder() -> Option<PathBuf> {
    reference("mannequin")
}

fn import(folder: &Path, name: &str) -> Imported<DaeScene> {
    read_dae(&Disk, &folder.join(format!("{name}.dae"))).unwrap_or_else(|e| panic!("{e}"))
}

fn only_character(folder: &Path, name: &str) -> Character {
    let mut scene = import(folder, name).value;
    assert_eq!(
        (scene.characters.len(), scene.meshes.len()),
        (1, 0),
        "{name}"
    );
    scene.characters.remove(0).character
}

fn json(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn numbers(value: &Value) -> Vec<f32> {
    let numbers = value.as_array().into_iter().flatten();
    numbers.filter_map(|n| Some(n.as_f64()? as f32)).collect()
}

fn golden_pose(folder: &Path, name: &str, character: &Character) -> Pose {
    let poses = json(&folder.join("poses.json"));
    let mut pose = Pose::new();
    for (sid, change) in poses[name].as_object().into_iter().flatten() {
        let joint = Pose::find_joint(character.skeleton(), sid).unwrap();
        if let Some(degrees) = change.get("euler") {
            let degrees = Vec3::from_slice(&numbers(degrees));
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        if let Some(axis) = change.get("axis") {
            let axis = Vec3::from_slice(&numbers(axis)).normalize_or_zero();
            let angle = change["angle"].as_f64().unwrap_or(0.0).to_radians() as f32;
            let turn = Mat3::from_axis_angle(axis, angle).to_euler(glam::EulerRot::XYZ);
            pose.set_joint_transform(joint, Euler::from_radians(turn.into()));
        }
        if let Some(offset) = change.get("t") {
            pose.set_root_offset(joint, Vec3::from_slice(&numbers(offset)));
        }
    }
    pose
}

/// Rest, posed by all influences, posed by four: one of each a position.
fn golden_positions(folder: &Path, name: &str) -> Vec<[Vec3; 3]> {
    let path = folder.join(format!("posed/{name}.txt"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    text.lines()
        .filter(|line| !line.starts_with('#') && !line.trim().is_empty())
        .map(|line| {
            let numbers: Vec<f32> = line
                .split_whitespace()
                .map(|word| word.parse().unwrap())
                .collect();
            [0, 3, 6].map(|at| Vec3::from_slice(&numbers[at..at + 3]))
        })
        .collect()
}

fn worst(found: &[Vec3], golden: &[[Vec3; 3]], column: usize) -> f32 {
    assert_eq!(found.len(), golden.len());
    let distances = found.iter().zip(golden).map(|(f, g)| f.distance(g[column]));
    distances.fold(0.0, f32::max)
}

#[test]
fn rest_and_golden_poses_agree_within_a_hundred_thousandth_of_the_models_size() {
    let Some(folder) = folder() else { return };
    for name in NAMES {
        let character = only_character(&folder, name);
        let golden = golden_positions(&folder, name);
        let size = character.bind_mesh().bounds().size().max_element();
        let pose = golden_pose(&folder, name, &character);
        let found = [
            character.skin_pose(&Pose::new()),
            character.skin_pose(&pose),
            character.limited(4).skin_pose(&pose),
        ];
        for (column, found) in found.iter().enumerate() {
            let worst = worst(found, &golden, column) / size;
            eprintln!("{name} column {column}: {worst:.1e} of the size");
            assert!(worst < 1e-5, "{name} column {column}: {worst:e}");
        }
    }
}

#[test]
fn joints_stand_where_the_golden_pose_has_them() {
    let Some(folder) = folder() else { return };
    for name in NAMES {
        let character = only_character(&folder, name);
        let skeleton = character.skeleton();
        let size = character.bind_mesh().bounds().size().max_element();
        let pose = golden_pose(&folder, name, &character);
        let current = skeleton.update_current_joint_to_world_transforms(&pose);
        let golden = json(&folder.join(format!("posed/{name}.joints.json")));
        let golden = golden.as_array().unwrap();
        assert_eq!(golden.len(), skeleton.joints().len());
        for (index, golden) in golden.iter().enumerate() {
            let joint = &skeleton.joints()[index];
            assert_eq!(joint.sid.as_deref(), golden["sid"].as_str(), "{name}");
            let parent = golden["parent"].as_i64().unwrap();
            assert_eq!(joint.parent, usize::try_from(parent).ok(), "{name}");
            let rest = Vec3::from_slice(&numbers(&golden["rest_position"]));
            let found = skeleton.bind_positions()[index];
            assert!(found.distance(rest) < 1e-5 * size, "{name}: {found} {rest}");
            let golden = Mat4::from_cols_slice(&numbers(&golden["D_row_major"])).transpose();
            let difference = current[index] - golden;
            let difference = difference.to_cols_array().map(f32::abs);
            let difference = difference.into_iter().fold(0.0, f32::max);
            assert!(
                difference < 1e-5 * size.max(1.0),
                "{name} {index}: {difference:e}"
            );
        }
    }
}

#[test]
fn counts_are_those_of_the_files() {
    let Some(folder) = folder() else { return };
    let table = [
        (16, 24, 3, 1, 1),
        (40, 60, 5, 1, 2),
        (8, 12, 1, 1, 1),
        (9749, 11034, 53, 1, 3),
        (10891, 21588, 36, 1, 12),
    ];
    for (name, expected) in NAMES.iter().zip(table) {
        let character = only_character(&folder, name);
        let mesh = character.bind_mesh();
        let found = (
            mesh.positions.len(),
            mesh.triangles.len(),
            character.skeleton().joints().len(),
            character.skeleton().roots().len(),
            character.attachments().most_influences(),
        );
        assert_eq!(found, expected, "{name}");
    }
}

#[test]
fn materials_textures_and_bind_matrices_are_found() {
    let Some(folder) = folder() else { return };
    for name in NAMES {
        let imported = import(&folder, name);
        assert_eq!(imported.warnings, [], "{name}");
        let worst = imported.value.report.worst_inverse_bind.unwrap();
        assert!(worst.difference < 3e-6, "{name}: {worst:?}");
        let (least, most) = imported.value.report.weight_sums.unwrap();
        eprintln!("{name}: weights sum to {least}..{most}, {worst:?}");
    }
    let head = only_character(&folder, "head");
    assert_eq!(head.bind_mesh().groups.len(), 8);
    assert_eq!(head.bind_mesh().groups[0].material.name, "Hair");
    let cube = only_character(&folder, "mapped_cube");
    let texture = cube.bind_mesh().groups[0].material.texture.clone().unwrap();
    assert_eq!(
        texture.rgba.len() as u32,
        4 * texture.width * texture.height
    );
    assert_eq!(
        cube.bind_mesh().texture_coordinates.len(),
        cube.bind_mesh().vertex_count()
    );
}

#[test]
fn bones_that_the_exporter_calls_connected_end_at_their_child() {
    let Some(folder) = folder() else { return };
    let cubes = only_character(&folder, "split_cube");
    let joints = cubes.skeleton().joints();
    let tips: Vec<Vec3> = joints.iter().map(|joint| joint.tip.unwrap()).collect();
    super::support::assert_near(&tips, &[Vec3::Y, 3.0 * Vec3::Z, -3.0 * Vec3::Z]);
}

#[test]
fn whatever_comes_after_a_head_stands_on_its_ground_and_in_nothing_else() {
    let Some(folder) = folder() else { return };
    let orders = [
        ["head", "robot", "split_cube", "long_cubes"],
        ["robot", "head", "mapped_cube", "split_cube"],
        ["mapped_cube", "long_cubes", "head", "robot"],
    ];
    for names in orders {
        let shapes = names.map(|name| {
            let character = Arc::new(only_character(&folder, name));
            NewShape::new(name, ShapeKind::Character(CharacterShape::new(character)))
        });
        let camera = Camera::preset(ViewDirection::MinusZ);
        let placed = set_beside_each_other(shapes.to_vec(), [1; 4].into_iter(), &camera);
        // Joints may hang below.
        let boxes = placed.iter().map(|shape| {
            let mesh = shape.kind.mesh().bounds();
            mesh.transformed(shape.placement.transform.world_from_model())
        });
        let boxes: Vec<_> = boxes.collect();
        let head = names.iter().position(|name| *name == "head").unwrap();
        for (index, one) in boxes.iter().enumerate().filter(|(index, _)| *index > head) {
            let up = one.min.y - boxes[head].min.y;
            assert!(
                up.abs() < 0.05,
                "{} of {names:?} is {up} above the ground",
                names[index]
            );
        }
        for (index, one) in boxes.iter().enumerate() {
            for other in &boxes[..index] {
                let common = one.max.min(other.max) - one.min.max(other.min);
                assert!(
                    common.min_element() < 0.01,
                    "{} of {names:?}: {one:?} {other:?}",
                    names[index]
                );
            }
        }
    }
}
