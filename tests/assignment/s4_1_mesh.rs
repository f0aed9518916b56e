//! 4.1 The mesh: vertices in the order of the file, one normal a triangle.

use editor_core::geometry::{Mesh, Normals, face_normals};
use editor_core::io::read_character_obj;
use glam::Vec3;
use std::path::Path;

const TENT: &str = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 1 0\nf 1 3 2\nf 4 1 2\n";

fn tent() -> Mesh {
    read_character_obj(Path::new("a.obj"), TENT.as_bytes())
        .unwrap()
        .value
}

#[test]
fn vertices_and_faces_come_as_they_stand() {
    let mesh = tent();
    assert_eq!(
        mesh.positions,
        [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 0.0, 1.0), Vec3::Y]
    );
    assert_eq!(mesh.triangles, [[0, 2, 1], [3, 0, 1]]);
    assert_eq!(mesh.normals, Normals::Flat);
}

#[test]
fn each_triangle_has_the_normal_of_its_current_corners() {
    let mesh = tent();
    assert_eq!(
        face_normals(&mesh.positions, &mesh.triangles),
        [Vec3::Y, Vec3::Z]
    );
    let turned: Vec<Vec3> = mesh
        .positions
        .iter()
        .map(|p| Vec3::new(p.y, -p.x, p.z))
        .collect();
    assert_eq!(face_normals(&turned, &mesh.triangles), [Vec3::X, Vec3::Z]);
}
