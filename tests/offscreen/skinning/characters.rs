//! Who is skinned: a column made here, the program's own characters, and the reference files.

use crate::reference_data::reference;
use editor_core::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
use editor_core::disk::Disk;
use editor_core::geometry::{Corner, MeshBuilder};
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::math::Euler;
use editor_core::scene::NewShape;
use editor_core::scene::{CharacterShape, Scene, ShapeId, ShapeKind};
use glam::{Vec2, Vec3};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Everything there is to skin, each in a scene of its own and bent at every joint.
pub fn all() -> Vec<(String, Scene)> {
    let mut all = vec![
        ("column with normals".to_owned(), scene_of(column(true))),
        ("column with facets".to_owned(), scene_of(column(false))),
    ];
    let mut files: Vec<PathBuf> = ["adult", "dog", "robot"]
        .map(|name| format!("builtin:{name}").into())
        .into();
    files.extend(reference_files());
    all.extend(
        files
            .iter()
            .map(|path| (path.display().to_string(), load(path))),
    );
    for (_, scene) in &mut all {
        bend(scene);
    }
    all
}

fn reference_files() -> Vec<PathBuf> {
    let figures = ["head", "robot", "long_cubes", "mapped_cube"];
    let figures = figures.iter().map(|name| format!("mannequin/{name}.dae"));
    let models = [1, 2].map(|number| format!("course/characters/Model{number}.obj"));
    let names = figures.chain(models);
    names.filter_map(|name| reference(&name)).collect()
}

fn load(path: &Path) -> Scene {
    let mut loaded = Loaded::default();
    let added = loaded.add(&WithBuiltin(Disk), path);
    added.unwrap_or_else(|error| panic!("{error}"));
    loaded.shapes.into_iter().collect()
}

pub fn scene_of(character: Character) -> Scene {
    let mut scene = Scene::new();
    let shape = CharacterShape::new(Arc::new(character));
    scene.add(NewShape::new("Column", ShapeKind::Character(shape)));
    scene
}

pub fn ids(scene: &Scene) -> Vec<ShapeId> {
    scene.shapes().iter().map(|shape| shape.id).collect()
}

/// Turns every joint of every character by another angle, and moves the roots.
pub fn bend(scene: &mut Scene) {
    for id in ids(scene) {
        let Some(shape) = scene.character_mut(id) else {
            continue;
        };
        let skeleton = shape.character.skeleton();
        let mut pose = Pose::new();
        for joint in 0..skeleton.joints().len() {
            let angle = |k: f32| 30.0 * (joint as f32 * 12.9898 + k).sin();
            let degrees = Vec3::new(angle(0.0), angle(1.0), angle(2.0));
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        for &root in skeleton.roots() {
            pose.set_root_offset(root, Vec3::new(0.05, -0.1, 0.02));
        }
        shape.set_pose(pose);
    }
}

/// A square column of 13 joints one above the other. Its rings have 0, 1, 2 … 13 influences whose
/// weights do not sum to one, and its sides meet in seams.
pub fn column(with_normals: bool) -> Character {
    const RINGS: u32 = 14;
    let joint = |i: usize| Joint {
        name: format!("joint {i}"),
        parent: i.checked_sub(1),
        offset: Vec3::Y * if i == 0 { -0.9 } else { 0.15 },
        ..Joint::default()
    };
    let skeleton = SkeletalModel::new((0..13).map(joint).collect()).expect("a skeleton");

    let sides = [Vec3::Z, Vec3::X, Vec3::NEG_Z, Vec3::NEG_X];
    let mut builder = MeshBuilder::new();
    let mut attachments = Attachments::new();
    for ring in 0..RINGS {
        for side in 0..4 {
            let corner = (sides[side] + sides[(side + 1) % 4]) * 0.15;
            builder.extend_positions([corner + Vec3::Y * (0.14 * ring as f32 - 0.9)]);
            attachments.push_vertex((0..ring).map(|joint| Influence {
                joint,
                weight: (1.0 + 0.1 * joint as f32) / (ring as f32 * 1.5),
            }));
        }
    }
    for ring in 0..RINGS - 1 {
        for side in 0..4_u32 {
            let corner = |ring: u32, side: u32| Corner {
                position: ring * 4 + side % 4,
                normal: None,
                texture: None,
            };
            let facing = |corner: Corner, across: f32, up: f32| Corner {
                normal: with_normals.then_some(sides[(side as usize + 1) % 4]),
                texture: Some(Vec2::new(across, up)),
                ..corner
            };
            let [a, b] = [side, side + 1].map(|s| (corner(ring, s), corner(ring + 1, s)));
            let [a, b] = [
                (facing(a.0, 0.0, 0.0), facing(a.1, 0.0, 1.0)),
                (facing(b.0, 1.0, 0.0), facing(b.1, 1.0, 1.0)),
            ];
            builder.push_triangle([a.0, b.0, b.1]);
            builder.push_triangle([a.0, b.1, a.1]);
        }
    }
    Character::new(skeleton, attachments, builder.build()).expect("a character")
}
