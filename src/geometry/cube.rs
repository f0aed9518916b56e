use super::Mesh;
use glam::Vec3;

/// A cube from -0.5 to 0.5 on each axis, flat normals: 24 vertices, 12 triangles.
#[doc(alias = "Cube")]
pub fn cube() -> Mesh {
    let mut positions = Vec::with_capacity(24);
    let mut triangles = Vec::with_capacity(12);
    for axis in 0..3 {
        for side in [-0.5, 0.5] {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let first = positions.len() as u32;
            for (a, b) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
                let mut corner = Vec3::ZERO;
                corner[axis] = side;
                // Walking u before v goes round the outward normal only on the positive side.
                let (a, b) = if side > 0.0 { (a, b) } else { (b, a) };
                corner[u] = a;
                corner[v] = b;
                positions.push(corner);
            }
            triangles.push([first, first + 1, first + 2]);
            triangles.push([first, first + 2, first + 3]);
        }
    }
    Mesh::new(positions, triangles)
}
