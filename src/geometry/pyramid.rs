use super::Mesh;
use glam::Vec3;

/// A pyramid with its apex at (0, 0.5, 0) over a square base of ±0.7 at y = -0.5; flat normals.
#[doc(alias = "Pyramid")]
pub fn pyramid() -> Mesh {
    let positions = vec![
        Vec3::new(0.0, 0.5, 0.0),
        Vec3::new(-0.7, -0.5, 0.7),
        Vec3::new(0.7, -0.5, 0.7),
        Vec3::new(0.7, -0.5, -0.7),
        Vec3::new(-0.7, -0.5, -0.7),
    ];
    let triangles = vec![
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 1],
        [1, 4, 3],
        [1, 3, 2],
    ];
    Mesh::new(positions, triangles)
}
