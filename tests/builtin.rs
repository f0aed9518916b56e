//! The files inside the program: all that is made for it is there, and works.

use editor_core::disk::Disk;
use editor_core::editor::{Edit, Session};
use editor_core::geometry::{Mesh, SharedMesh};
use editor_core::io::builtin::{BuiltinKind, PREFIX, WithBuiltin, catalogue, resolve};
use editor_core::io::{Files, Loaded, PoseFile};
use editor_core::scene::{CurveVisibility, EvaluatedShape, Shape, ShapeKind, SurfaceVisibility};
use editor_core::ui::{COMMANDS, Command, Entry, Navigation};
use egui::Key;
use glam::Vec3;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

fn named(name: &str) -> PathBuf {
    PathBuf::from(format!("{PREFIX}{name}"))
}

fn load(name: &str) -> Loaded {
    let mut loaded = Loaded::default();
    loaded.add(&WithBuiltin(Disk), &named(name)).unwrap();
    assert_eq!(loaded.warnings, [], "{name}");
    loaded
}

/// A session that shows the built-in file of this name.
fn open(name: &str) -> Session {
    let loaded = load(name);
    Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default())
}

/// Every shape with what follows from it.
fn both(session: &Session) -> impl Iterator<Item = (&Shape, &EvaluatedShape)> {
    let shapes = session.scene().shapes().iter();
    shapes.zip(&session.evaluated().shapes)
}

/// One rig or two in each; the keys 1 to 7 open them.
fn mannequin_scenes() -> impl Iterator<Item = String> {
    (1..=7).map(|number| format!("mannequin-{number}"))
}

#[test]
fn every_file_made_for_it_is_inside_the_program() {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    for folder in ["characters", "curves", "poses", "rigs", "scenes", "shapes"] {
        for entry in std::fs::read_dir(assets.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let inside = path.strip_prefix(&assets).unwrap().to_str().unwrap();
            let bytes = WithBuiltin(Disk).read(&named(inside)).unwrap();
            assert!(bytes == std::fs::read(&path).unwrap(), "{inside}");
        }
    }
}

#[test]
fn everything_in_the_catalogue_opens_by_its_name() {
    for builtin in catalogue() {
        if matches!(builtin.kind, BuiltinKind::Scene | BuiltinKind::Pose) {
            continue;
        }
        let loaded = load(builtin.name);
        let [shape] = &loaded.shapes[..] else {
            panic!("{builtin:?}");
        };
        let kind = match shape.kind {
            ShapeKind::Character(_) => BuiltinKind::Character,
            ShapeKind::Curve(_) => BuiltinKind::Curve,
            _ => BuiltinKind::Shape,
        };
        assert_eq!(kind, builtin.kind);
        assert_eq!(shape.name.to_lowercase(), builtin.name);
        assert_eq!(
            shape.source.as_ref().unwrap().file,
            format!("builtin:{}", builtin.name)
        );
    }
}

#[test]
fn the_menu_opens_every_scene_and_digits_those_of_the_mannequin() {
    let in_menu = |name: &str| {
        let opens = |entry: &&Entry| matches!(entry.command, Command::OpenScene(it) if it == name);
        COMMANDS.iter().find(opens)
    };
    for builtin in catalogue() {
        if builtin.kind == BuiltinKind::Scene {
            assert!(in_menu(builtin.name).is_some(), "{}", builtin.name);
        }
    }
    for (scene, key) in mannequin_scenes().zip([
        Key::Num1,
        Key::Num2,
        Key::Num3,
        Key::Num4,
        Key::Num5,
        Key::Num6,
        Key::Num7,
    ]) {
        let entry = in_menu(&scene).unwrap();
        assert_eq!(entry.only_in, Some(Navigation::Mannequin));
        assert_eq!(entry.shortcuts[0].logical_key, key, "{scene}");
    }
}

#[test]
fn a_scene_says_how_its_curves_are_drawn() {
    let loaded = load("turned");
    let mut curves = 0;
    for shape in &loaded.shapes {
        let ShapeKind::Curve(curve) = &shape.kind else {
            continue;
        };
        curves += 1;
        assert!(!curve.display.control_points, "{}", shape.name);
        assert_eq!(curve.display.curve, CurveVisibility::Off);
        assert_eq!(curve.display.surface, SurfaceVisibility::Shaded);
        assert!(curve.frame_closing());
    }
    assert_eq!(curves, 4);
}

#[test]
fn every_pose_fits_the_character_that_it_is_named_for() {
    let mut poses = 0;
    for builtin in catalogue() {
        if builtin.kind != BuiltinKind::Pose {
            continue;
        }
        let (character, _) = builtin.name.split_once('-').unwrap();
        let path = resolve(&named(&format!("poses/{}", builtin.name))).unwrap();
        let pose = PoseFile::read(&path, &WithBuiltin(Disk).read(&path).unwrap()).unwrap();
        let posed = pose.poses_for(open(character).scene()).unwrap();
        assert_eq!(posed.len(), 1, "{}", builtin.name);
        poses += 1;
    }
    assert!(poses >= 13);
}

#[test]
fn reset_brings_a_shape_of_a_scene_back_to_its_place_there() {
    let mut session = open("showcase");
    let scene = session.scene();
    let moved = scene.shapes().iter().find(|shape| {
        let position = shape.placement.transform.position;
        position.length() > 0.1
    });
    let (id, placement) = moved.map(|shape| (shape.id, shape.placement)).unwrap();
    let mut transform = placement.transform;
    transform.position.x += 5.0;
    session.edit(Edit::SetTransform(id, transform)).unwrap();
    assert_ne!(session.scene().shape(id).unwrap().placement, placement);
    session.edit(Edit::Reset(id)).unwrap();
    assert_eq!(session.scene().shape(id).unwrap().placement, placement);
}

#[test]
fn the_showcase_has_posed_characters_that_stand_on_the_ground() {
    assert!(load("showcase").view.is_some());
    let session = open("showcase");
    let mut posed = 0;
    for (shape, evaluated) in both(&session) {
        let ShapeKind::Character(character) = &shape.kind else {
            continue;
        };
        posed += usize::from(!character.pose().is_bind());
        let positions = evaluated.geometry.positions().iter();
        let heights = positions.map(|&p| evaluated.world_from_model.transform_point3(p).y);
        let lowest = heights.fold(f32::INFINITY, f32::min);
        assert!(lowest.abs() < 0.01, "{} stands at {lowest}", shape.name);
    }
    assert!(posed >= 2);
}

#[test]
fn the_mannequins_scenes_stand_on_its_floor_within_its_view_and_show_every_rig() {
    const FLOOR: f32 = -2.0;
    let mut shown = HashSet::new();
    for scene in mannequin_scenes() {
        let session = open(&scene);
        let camera = session.view().camera;
        assert!(
            camera.eye().z < -4.0,
            "{scene} is seen from the mannequin's side"
        );
        let clip_from_world = camera.clip_from_world(1.0);
        let mut lowest = f32::INFINITY;
        for (shape, evaluated) in both(&session) {
            assert!(matches!(shape.kind, ShapeKind::Character(_)), "{scene}");
            shown.insert(shape.name.to_lowercase());
            for &p in evaluated.geometry.positions().iter() {
                let world = evaluated.world_from_model.transform_point3(p);
                let seen = clip_from_world.project_point3(world);
                assert!(
                    seen.truncate().abs().max_element() < 1.0,
                    "{scene}: {}",
                    shape.name
                );
                lowest = lowest.min(world.y);
            }
        }
        // The creature floats.
        let most = if scene.ends_with('7') { 0.4 } else { 0.01 };
        assert!(
            (-0.01..most).contains(&(lowest - FLOOR)),
            "{scene} stands at {lowest}"
        );
    }
    let is_rig = |name: &str| resolve(&named(&format!("rigs/{name}"))).is_ok();
    for rig in catalogue().iter().filter(|builtin| is_rig(builtin.name)) {
        assert!(shown.contains(rig.name), "{} is in no scene", rig.name);
    }
}

#[test]
fn names_are_completed_and_unknown_ones_are_told_with_all_that_exist() {
    assert_eq!(resolve(&named("adult")), Ok(named("characters/adult.obj")));
    assert_eq!(
        resolve(&named("poses/adult-walk")),
        Ok(named("poses/adult-walk.json"))
    );
    assert_eq!(resolve(Path::new("adult")), Ok(PathBuf::from("adult")));
    let error = resolve(&named("nobody")).unwrap_err().to_string();
    assert!(
        error.contains("adult") && error.contains("showcase"),
        "{error}"
    );
    assert!(!WithBuiltin(Disk).exists(&named("nobody")));
}

#[test]
fn the_examples_of_the_documentation_work() {
    let text = include_str!("../docs/files.md");
    let examples: Vec<&str> = text
        .split("```json\n")
        .skip(1)
        .filter_map(|rest| rest.split("```").next())
        .collect();
    let [pose, scenes @ ..] = &examples[..] else {
        panic!("{examples:?}");
    };
    assert_eq!(scenes.len(), 2);
    for scene in scenes {
        let path = PathBuf::from("example.scene");
        let table = HashMap::from([(path.clone(), scene.as_bytes().to_vec())]);
        let mut loaded = Loaded::default();
        loaded.add(&WithBuiltin(table), &path).unwrap();
        assert_eq!(loaded.shapes.len(), 2);
        let pose = PoseFile::read(Path::new("example.json"), pose.as_bytes()).unwrap();
        let session = Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default());
        assert!(!pose.poses_for(session.scene()).unwrap().is_empty());
    }
}

/// Volumes of the parts of `mesh` that are closed: positive where their triangles face outward.
/// Vertices at the same place are one, as are all that triangles join.
fn volumes_of_closed_parts(mesh: &Mesh) -> Vec<f64> {
    let mut numbers = HashMap::new();
    let place = |position: &Vec3| (position.as_dvec3() * 1e5).round().as_i64vec3();
    let vertices = mesh.positions.iter().map(|position| {
        let next = numbers.len();
        *numbers.entry(place(position)).or_insert(next)
    });
    let vertex: Vec<usize> = vertices.collect();
    let mut parts: Vec<usize> = (0..numbers.len()).collect();
    let triangles = || mesh.triangles.iter().map(|t| t.map(|at| at as usize));
    let edges = |t: [usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    while triangles().fold(false, |changed, triangle| {
        let corners = triangle.map(|at| vertex[at]);
        let least = corners.map(|at| parts[at]).into_iter().min().unwrap_or(0);
        let differ = corners.iter().any(|&at| parts[at] != least);
        corners.iter().for_each(|&at| parts[at] = least);
        changed || differ
    }) {}
    let mut balance: HashMap<[usize; 2], i32> = HashMap::new();
    let mut volumes: HashMap<usize, f64> = HashMap::new();
    for triangle in triangles() {
        for [a, b] in edges(triangle.map(|at| vertex[at])) {
            *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
        let [a, b, c] = triangle.map(|at| mesh.positions[at].as_dvec3());
        *volumes.entry(parts[vertex[triangle[0]]]).or_default() += a.dot(b.cross(c)) / 6.0;
    }
    for ([a, _], balance) in balance {
        if balance != 0 {
            volumes.remove(&parts[a]);
        }
    }
    volumes.into_values().collect()
}

#[test]
fn closed_meshes_face_outward() {
    let kinds = [
        ShapeKind::Cube,
        ShapeKind::Sphere,
        ShapeKind::Pyramid,
        ShapeKind::Teapot,
        ShapeKind::Icosahedron,
        ShapeKind::Custom,
    ];
    let mut meshes: Vec<(&str, SharedMesh)> = kinds.iter().map(|k| (k.label(), k.mesh())).collect();
    for builtin in catalogue() {
        if !matches!(builtin.kind, BuiltinKind::Scene | BuiltinKind::Pose) {
            let session = open(builtin.name);
            let shapes = session.evaluated().shapes.iter();
            meshes.extend(shapes.map(|shape| (builtin.name, shape.geometry.mesh.clone())));
        }
    }
    let mut open = Vec::new();
    for (name, mesh) in &meshes {
        let volumes = volumes_of_closed_parts(mesh);
        assert!(volumes.iter().all(|&v| v > 0.0), "{name}: {volumes:?}");
        if volumes.is_empty() {
            open.push(*name);
        }
    }
    assert_eq!(open, ["Teapot", "plant", "spring"], "no closed part");
}
