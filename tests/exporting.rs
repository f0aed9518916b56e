//! Characters and materials that are written are read back as they were.

use editor_core::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
use editor_core::disk::files;
use editor_core::geometry::Mesh;
use editor_core::io::builtin::{BuiltinKind, catalogue, resolve};
use editor_core::io::{
    Files, Loaded, PoseFile, export_character, export_obj, export_obj_with_materials,
    read_character, read_shape_obj,
};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{
    CharacterShape, Evaluator, NewShape, Placement, Scene, Shape, ShapeColor, ShapeKind,
};
use glam::Vec3;
use proptest::prelude::*;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Largest distance of a vertex that is read back from where it was, of the size of the mesh.
const TOLERANCE: f32 = 1e-5;

fn the_character(shape: &Shape) -> &CharacterShape {
    match &shape.kind {
        ShapeKind::Character(character) => character,
        other => panic!("expected a character, found {other:?}"),
    }
}

/// Vertices of the only shape of `scene`, in the world.
fn vertices(scene: &Scene) -> Vec<Vec3> {
    let evaluated = Evaluator::new().evaluate(scene, 0.0);
    let shape = &evaluated.shapes[0];
    let positions = shape.geometry.positions().iter();
    let place = |&position: &Vec3| shape.world_from_model.transform_point3(position);
    positions.map(place).collect()
}

/// Writes the only shape of `scene`, reads it with our importers, and poses it with the pose that
/// was written. Returns it with its vertices.
fn written_and_read(scene: &Scene) -> (Character, Vec<Vec3>) {
    let shape = &scene.shapes()[0];
    let written = export_character(shape, the_character(shape)).unwrap();
    let files: HashMap<PathBuf, Vec<u8>> = HashMap::from([
        (PathBuf::from("a.skel"), written.skel.into_bytes()),
        (PathBuf::from("a.attach"), written.attach.into_bytes()),
        (PathBuf::from("a.obj"), written.obj.into_bytes()),
        (PathBuf::from("a.json"), written.pose.into_bytes()),
    ]);
    let character = read_character(&files, Path::new("a.obj")).unwrap().value;
    let pose = files.read(Path::new("a.json")).unwrap();
    let pose = PoseFile::read(Path::new("a.json"), &pose).unwrap();
    let pose = pose.pose_of(character.skeleton()).unwrap();
    let posed = character.skin_pose(&pose);
    (character, posed)
}

/// Volume that the triangles enclose, negative if they are inside out; of an open mesh, with the
/// middle of its vertices.
fn volume(positions: &[Vec3], triangles: &[[u32; 3]]) -> f32 {
    let middle = positions.iter().sum::<Vec3>() / positions.len() as f32;
    let corners = triangles
        .iter()
        .map(|corners| corners.map(|at| positions[at as usize] - middle));
    corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
}

/// How far apart the two are at most, of the size of `expected`.
fn apart(expected: &[Vec3], found: &[Vec3]) -> f32 {
    assert_eq!(expected.len(), found.len());
    let low = expected.iter().copied().reduce(Vec3::min).unwrap();
    let high = expected.iter().copied().reduce(Vec3::max).unwrap();
    let far = expected.iter().zip(found).map(|(a, b)| a.distance(*b));
    far.fold(0.0, f32::max) / (high - low).length()
}

fn all_characters() -> impl Iterator<Item = (&'static str, Scene)> {
    let named = catalogue().into_iter();
    let named = named.filter(|known| known.kind == BuiltinKind::Character);
    named.map(|known| {
        let mut loaded = Loaded::default();
        let path = PathBuf::from(format!("builtin:{}", known.name));
        loaded.add(&files(), &path).unwrap();
        let scene = Scene::from_iter(loaded.shapes);
        assert_eq!(scene.shapes().len(), 1, "{}", known.name);
        (known.name, scene)
    })
}

fn set_pose(scene: &mut Scene, pose: Pose) {
    let id = scene.shapes()[0].id;
    match &mut scene.shape_mut(id).unwrap().kind {
        ShapeKind::Character(character) => character.set_pose(pose),
        other => panic!("expected a character, found {other:?}"),
    }
}

fn place(scene: &mut Scene, transform: Transform) {
    let id = scene.shapes()[0].id;
    scene.shape_mut(id).unwrap().placement.transform = transform;
}

/// A pose that turns every joint, up to a turn and more, and moves each root.
fn wild_pose(skeleton: &SkeletalModel, seed: u64) -> Pose {
    let mut state = seed | 1;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1_u64 << 23) as f32 - 1.0
    };
    let mut pose = Pose::new();
    for joint in 0..skeleton.joints().len() {
        let degrees = Vec3::new(next(), next(), next()) * 400.0;
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    }
    for &root in skeleton.roots() {
        pose.set_root_offset(root, Vec3::new(next(), next(), next()));
    }
    pose
}

fn uneven_placement(mirrored: bool) -> Transform {
    Transform {
        position: Vec3::new(0.3, -1.7, 2.2),
        rotation: Euler::from_degrees(Vec3::new(-90.0, 31.0, 77.0)),
        scale: Vec3::new(if mirrored { -2.5 } else { 2.5 }, 2.5, 2.5),
    }
}

#[test]
fn every_character_and_rig_comes_back_in_its_bind_pose_and_posed() {
    let mut worst = 0.0_f32;
    for (name, mut scene) in all_characters() {
        let skeleton = the_character(&scene.shapes()[0])
            .character
            .skeleton()
            .clone();
        for seed in 0..4 {
            let pose = if seed == 0 {
                Pose::new()
            } else {
                wild_pose(&skeleton, seed)
            };
            set_pose(&mut scene, pose);
            let (_, read) = written_and_read(&scene);
            let apart = apart(&vertices(&scene), &read);
            assert!(apart <= TOLERANCE, "{name} {seed}: {apart}");
            worst = worst.max(apart);
        }
    }
    eprintln!("worst of all: {worst}");
}

#[test]
fn every_character_comes_back_turned_scaled_moved_and_mirrored() {
    let mut worst = 0.0_f32;
    for (name, mut scene) in all_characters() {
        let skeleton = the_character(&scene.shapes()[0])
            .character
            .skeleton()
            .clone();
        for mirrored in [false, true] {
            place(&mut scene, uneven_placement(mirrored));
            set_pose(&mut scene, wild_pose(&skeleton, 7));
            let (character, read) = written_and_read(&scene);
            let apart = apart(&vertices(&scene), &read);
            assert!(apart <= TOLERANCE, "{name} {mirrored}: {apart}");
            let mesh = character.bind_mesh();
            let volume = self::volume(&mesh.positions, &mesh.triangles);
            let before = the_character(&scene.shapes()[0])
                .character
                .bind_mesh()
                .clone();
            let before = self::volume(&before.positions, &before.triangles);
            assert!(
                volume * before > 0.0,
                "{name} {mirrored}: inside out, {volume}"
            );
            worst = worst.max(apart);
        }
    }
    eprintln!("worst of all: {worst}");
}

#[test]
fn poses_that_the_program_brings_come_back() {
    for known in catalogue()
        .into_iter()
        .filter(|known| known.kind == BuiltinKind::Pose)
    {
        let rig = known.name.split('-').next().unwrap();
        let (_, mut scene) = all_characters().find(|(name, _)| *name == rig).unwrap();
        let path = resolve(Path::new(&format!("builtin:poses/{}", known.name))).unwrap();
        let pose = PoseFile::read(&path, &files().read(&path).unwrap()).unwrap();
        let (_, pose) = pose.poses_for(&scene).unwrap().remove(0);
        set_pose(&mut scene, pose);
        let (_, read) = written_and_read(&scene);
        let apart = apart(&vertices(&scene), &read);
        assert!(apart <= TOLERANCE, "{}: {apart}", known.name);
    }
}

/// Two trees of two joints; each vertex hangs on one joint.
fn two_trees() -> CharacterShape {
    let joint = |name: &str, parent, x: f32| Joint {
        name: name.to_owned(),
        parent,
        offset: Vec3::new(x, 1.0, 0.0),
        ..Joint::default()
    };
    let joints = vec![
        joint("Left", None, -1.0),
        joint("Left tip", Some(0), 0.0),
        joint("Right # root", None, 1.0),
        joint("Added root", Some(2), 0.5),
    ];
    let mut attachments = Attachments::new();
    for joint in 0..4 {
        attachments.push_vertex([Influence { joint, weight: 1.0 }]);
    }
    attachments.push_vertex([]);
    let corner = |x: f32, y: f32| Vec3::new(x, y, 0.25);
    let positions = vec![
        corner(-1.0, 0.0),
        corner(-1.0, 3.0),
        corner(1.0, 0.0),
        corner(2.0, 3.0),
        corner(0.0, 5.0),
    ];
    let mesh = Mesh::new(positions, vec![[0, 2, 1], [1, 2, 3], [1, 3, 4]]);
    let skeleton = SkeletalModel::new(joints).unwrap();
    CharacterShape::new(Arc::new(
        Character::new(skeleton, attachments, mesh).unwrap(),
    ))
}

fn scene_of(character: CharacterShape) -> Scene {
    Scene::from_iter([NewShape::new("Two trees", ShapeKind::Character(character))])
}

#[test]
fn several_roots_come_under_one_that_is_added_and_has_a_name_of_its_own() {
    let (read, _) = written_and_read(&scene_of(two_trees()));
    let joints = read.skeleton().joints().iter();
    let found: Vec<_> = joints.map(|joint| (&*joint.name, joint.parent)).collect();
    let expected = [
        ("Added root 2", None),
        ("Left", Some(0)),
        ("Left tip", Some(1)),
        ("Right # root", Some(0)),
        ("Added root", Some(3)),
    ];
    assert_eq!(found, expected);
    assert_eq!(
        read.bind_mesh().triangles,
        [[0, 2, 1], [1, 2, 3], [1, 3, 4]]
    );
    assert_eq!(read.attachments().of_vertex(4), []);
}

#[test]
fn a_root_that_moved_otherwise_than_the_first_hangs_on_a_lever_half_way() {
    let mut scene = scene_of(two_trees());
    let mut pose = Pose::new();
    pose.set_root_offset(0, Vec3::Y);
    pose.set_root_offset(2, Vec3::new(2.0, 1.0, 0.0));
    set_pose(&mut scene, pose);
    let (read, posed) = written_and_read(&scene);
    let joints = read.skeleton().joints();
    let lever = &joints[5];
    let found = (&*lever.name, lever.parent, lever.offset);
    // The root is at rest at (1, 1, 0), and has moved by (2, 0, 0) relative to the first one.
    let half_way = Vec3::new(2.0, 1.0, 0.0);
    assert_eq!(found, ("Lever of Right # root", Some(0), half_way));
    assert_eq!((joints[3].parent, joints[3].offset), (Some(5), -Vec3::X));
    assert!(posed[0].distance(Vec3::new(-1.0, 1.0, 0.25)) < 1e-5);
    assert!(posed[2].distance(Vec3::new(3.0, 1.0, 0.25)) < 1e-5);
    // Put back to rest, it stands where it stood at first.
    let rest = read.skin_pose(&Pose::new());
    assert_eq!(rest[2], Vec3::new(1.0, 0.0, 0.25));
}

#[test]
fn a_root_without_weights_stays_the_root() {
    let (_, adult) = all_characters().find(|(name, _)| *name == "adult").unwrap();
    let skeleton = the_character(&adult.shapes()[0])
        .character
        .skeleton()
        .clone();
    let (read, _) = written_and_read(&adult);
    assert_eq!(read.skeleton().joints(), skeleton.joints());
}

#[test]
fn uneven_scales_and_what_lies_too_far_out_are_refused_with_the_reason() {
    let mut scene = scene_of(two_trees());
    let refused = |scene: &Scene| {
        let shape = &scene.shapes()[0];
        export_character(shape, the_character(shape))
            .unwrap_err()
            .to_string()
    };
    let scaled = |x: f32| Transform {
        scale: Vec3::new(x, 1.0, 1.0),
        ..Transform::IDENTITY
    };
    place(&mut scene, scaled(2.0));
    assert_eq!(
        refused(&scene),
        "expected a character with one scale for all axes, found “Two trees” with scales of 2, 1 \
         and 1: its joints cannot turn in a .skel file as they do here"
    );
    place(&mut scene, scaled(0.0));
    assert_eq!(
        refused(&scene),
        "expected a character with a size, found “Two trees” with a scale of 0"
    );
    place(
        &mut scene,
        Transform {
            position: Vec3::X * 3e38,
            scale: Vec3::splat(3e38),
            ..scaled(1.0)
        },
    );
    assert!(
        refused(&scene).contains("a vertex too far out"),
        "{}",
        refused(&scene)
    );
}

proptest! {
    #[test]
    fn any_pose_comes_back_in_any_place(
        degrees in prop::array::uniform4(prop::array::uniform3(-720.0_f32..720.0)),
        offsets in prop::array::uniform2(prop::array::uniform3(-5.0_f32..5.0)),
        together in any::<bool>(),
        turn in prop::array::uniform3(-180.0_f32..180.0),
        position in prop::array::uniform3(-3.0_f32..3.0),
        scale in 0.01_f32..100.0,
        mirrored in any::<bool>(),
        locked in any::<bool>(),
    ) {
        let mut pose = Pose::new();
        for (joint, mut angles) in degrees.into_iter().enumerate() {
            if locked {
                angles[1] = 90.0;
            }
            pose.set_joint_transform(joint, Euler::from_degrees(Vec3::from(angles)));
        }
        pose.set_root_offset(0, Vec3::from(offsets[0]));
        pose.set_root_offset(2, Vec3::from(offsets[usize::from(!together)]));
        let mut scene = scene_of(two_trees());
        set_pose(&mut scene, pose);
        place(&mut scene, Transform {
            position: Vec3::from(position) * scale,
            rotation: Euler::from_degrees(Vec3::from(turn)),
            scale: Vec3::new(scale, if mirrored { -scale } else { scale }, scale),
        });
        let (_, read) = written_and_read(&scene);
        let apart = apart(&vertices(&scene), &read);
        prop_assert!(apart <= TOLERANCE, "{apart}");
    }
}

/// A crate with a picture and a plant with colors, both in a color of their own; a gem; a cube that
/// is turned and mirrored, and one of the same name that is not.
fn colored() -> Scene {
    let mut loaded = Loaded::default();
    for name in ["builtin:crate", "builtin:plant", "builtin:gem"] {
        loaded.add(&files(), Path::new(name)).unwrap();
    }
    let mut scene = Scene::from_iter(loaded.shapes);
    for (id, preset) in scene
        .shapes()
        .iter()
        .map(|shape| shape.id)
        .zip([3, 4])
        .collect::<Vec<_>>()
    {
        scene.shape_mut(id).unwrap().placement.color = ShapeColor::Preset(preset);
    }
    let cube = scene.add(NewShape::new("My cube # 1", ShapeKind::Cube));
    scene.add(NewShape::new("My cube # 1", ShapeKind::Cube));
    scene.shape_mut(cube).unwrap().placement = Placement {
        transform: uneven_placement(true),
        ..Placement::at_origin(5)
    };
    scene
}

#[test]
fn with_materials_the_vertices_are_the_same_and_every_triangle_has_its_color_and_its_picture() {
    let scene = colored();
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let plain = export_obj(&scene, &evaluated).unwrap();
    let written = export_obj_with_materials(&scene, &evaluated, "out").unwrap();
    let lines = |text: &str| -> Vec<String> {
        let kept = text
            .lines()
            .filter(|line| line.starts_with("v ") || line.starts_with("o "));
        kept.map(str::to_owned).collect()
    };
    assert_eq!(lines(&written.obj), lines(&plain));

    let names: Vec<&str> = written.beside.iter().map(|(name, _)| &**name).collect();
    assert_eq!(names, ["out-1.png", "out.mtl"]);
    let beside = written.beside.into_iter();
    let mut files: HashMap<PathBuf, Vec<u8>> =
        beside.map(|(name, bytes)| (name.into(), bytes)).collect();
    files.insert("out.obj".into(), written.obj.into_bytes());
    let obj = files.read(Path::new("out.obj")).unwrap();
    let read = read_shape_obj(&files, Path::new("out.obj"), &obj).unwrap();
    assert_eq!(read.warnings, []);
    let read = read.value;

    // What each triangle of the scene looks like, as the renderer has it.
    let mut first = 0;
    for (shape, evaluated) in scene.shapes().iter().zip(&evaluated.shapes) {
        let mesh = &evaluated.geometry.mesh;
        let own = shape.placement.color.rgb();
        for triangle in 0..mesh.triangles.len() {
            let of = |groups: &[editor_core::geometry::MaterialGroup], triangle| {
                let found = groups
                    .iter()
                    .find(|group| group.triangles.contains(&triangle));
                found.map(|group| group.material.clone())
            };
            let drawn = of(&mesh.groups, triangle);
            let found = of(&read.groups, first + triangle).unwrap();
            let texture = drawn.as_ref().and_then(|material| material.texture.clone());
            let color = match (&drawn, &texture) {
                (Some(material), None) => material.color * own,
                _ => own,
            };
            assert!(found.texture == texture, "{} {triangle}", shape.name);
            assert_eq!(found.color, color, "{} {triangle}", shape.name);
        }
        first += mesh.triangles.len();
    }
    assert_eq!(read.triangles.len(), first);
}

#[test]
fn names_that_no_line_could_hold_become_others() {
    let scene = colored();
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let written = export_obj_with_materials(&scene, &evaluated, " my # file").unwrap();
    assert!(written.obj.starts_with("mtllib my _ file.mtl\n"));
    let beside = written.beside.into_iter();
    let files: HashMap<PathBuf, Vec<u8>> =
        beside.map(|(name, bytes)| (name.into(), bytes)).collect();
    let read = read_shape_obj(&files, Path::new("a.obj"), written.obj.as_bytes()).unwrap();
    assert_eq!(read.warnings, []);
    let textures = read
        .value
        .groups
        .iter()
        .filter(|group| group.material.texture.is_some());
    assert!(textures.count() > 0);
}

#[test]
fn with_materials_normals_point_where_the_surface_does_also_of_a_mirrored_shape() {
    let scene = colored();
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let written = export_obj_with_materials(&scene, &evaluated, "out").unwrap();
    let files: HashMap<PathBuf, Vec<u8>> = HashMap::new();
    let read = read_shape_obj(&files, Path::new("out.obj"), written.obj.as_bytes());
    let mesh = read.unwrap().value;
    let editor_core::geometry::Normals::PerVertex(normals) = &mesh.normals else {
        panic!("expected normals");
    };
    let mut seen = 0;
    for (triangle, corners) in mesh.triangles.iter().zip(mesh.vertex_triangles()) {
        let [a, b, c] = triangle.map(|at| mesh.positions[at as usize]);
        let face = (b - a).cross(c - a).normalize_or_zero();
        for &corner in corners {
            let along = normals[corner as usize].dot(face);
            assert!(face == Vec3::ZERO || along > 0.0, "{triangle:?}: {along}");
            seen += 1;
        }
    }
    assert!(seen > 100);
}
