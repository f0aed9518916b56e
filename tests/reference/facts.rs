//! What is known about the course's files.

use crate::reference_data::course;
use editor_core::disk::Disk;
use editor_core::geometry::{Mesh, Normals};
use editor_core::io::{Files, read_character, read_shape_obj};
use glam::Vec3;

fn shape(name: &str) -> Option<Mesh> {
    let path = course(name)?;
    let bytes = Disk.read(&path).unwrap();
    let read = read_shape_obj(&Disk, &path, &bytes).unwrap();
    // Neither file has its .mtl beside it.
    assert_eq!(read.warnings.len(), 1, "{:?}", read.warnings);
    Some(read.value)
}

#[test]
fn a_character_has_18_joints_13336_vertices_and_26668_triangles() {
    for name in ["characters/Model1.obj", "characters/Model2.obj"] {
        let Some(path) = course(name) else { return };
        let read = read_character(&Disk, &path).unwrap();
        assert_eq!(read.warnings, []);
        let character = read.value;
        let skeleton = character.skeleton();
        assert_eq!(skeleton.joints().len(), 18);
        assert_eq!(skeleton.roots(), [0]);
        assert_eq!(skeleton.children(0), [1, 3, 12, 15]);
        assert_eq!(skeleton.joints()[17].name, "Left elbow");
        assert_eq!(character.bind_mesh().positions.len(), 13_336);
        assert_eq!(character.bind_mesh().triangles.len(), 26_668);
    }
}

#[test]
fn up_to_13_joints_move_a_vertex_and_its_weights_sum_up_to_about_1() {
    let Some(path) = course("characters/Model1.obj") else {
        return;
    };
    let character = read_character(&Disk, &path).unwrap().value;
    let attachments = character.attachments();
    assert_eq!(attachments.most_influences(), 13);
    for influences in attachments.vertices() {
        let sum: f64 = influences.iter().map(|i| f64::from(i.weight)).sum();
        assert!((0.9995..=1.0004).contains(&sum), "{sum}");
        assert!(influences.iter().all(|influence| influence.joint > 0));
    }
}

#[test]
fn vertices_keep_the_order_of_their_lines() {
    let Some(path) = course("characters/Model1.obj") else {
        return;
    };
    let character = read_character(&Disk, &path).unwrap().value;
    let text = std::fs::read_to_string(&path).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("v "));
    let in_file: Vec<Vec3> = lines
        .map(|line| {
            let numbers: Vec<f32> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            Vec3::from_slice(&numbers)
        })
        .collect();
    assert_eq!(character.bind_mesh().positions, in_file);
}

#[test]
fn the_teapot_and_the_torus_have_normals_and_texture_coordinates() {
    for (name, positions, triangles) in [
        ("obj/teapot.obj", 3_241, 6_320),
        ("obj/torus.obj", 800, 1_600),
    ] {
        let Some(mesh) = shape(name) else { return };
        assert_eq!(mesh.positions.len(), positions, "{name}");
        assert_eq!(mesh.triangles.len(), triangles, "{name}");
        assert_eq!(mesh.texture_coordinates.len(), mesh.vertex_count());
        let Normals::PerVertex(normals) = &mesh.normals else {
            panic!("{name} has flat normals");
        };
        assert_eq!(normals.len(), mesh.vertex_count());
        assert!(
            normals.iter().all(|normal| normal.is_normalized()),
            "{name}"
        );
    }
}
