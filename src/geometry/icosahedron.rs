use super::Mesh;
use glam::Vec3;

const CIRCUMRADIUS: f32 = 0.7;

/// A regular icosahedron of circumradius 0.7 with vertices along (0, ±1, ±φ), (±1, ±φ, 0) and (±φ,
/// 0, ±1), φ the golden ratio, as the course's pictures have it; flat normals.
#[doc(alias = "Icosahedron")]
pub fn icosahedron() -> Mesh {
    let golden = (1.0 + 5.0_f32.sqrt()) / 2.0;
    let scale = CIRCUMRADIUS / (1.0 + golden * golden).sqrt();
    let mut positions = Vec::with_capacity(12);
    for a in [golden, -golden] {
        for b in [1.0, -1.0] {
            positions.push(Vec3::new(0.0, b, a) * scale);
            positions.push(Vec3::new(b, a, 0.0) * scale);
            positions.push(Vec3::new(a, 0.0, b) * scale);
        }
    }
    // The faces are the triples of vertices that are one edge (2 · scale) apart from each other.
    let near = |a: usize, b: usize| positions[a].distance(positions[b]) < 2.1 * scale;
    let mut triangles = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(a, c) {
                    let (p, q, r): (Vec3, Vec3, Vec3) = (positions[a], positions[b], positions[c]);
                    let outward = (q - p).cross(r - p).dot(p) > 0.0;
                    let [b, c] = if outward { [b, c] } else { [c, b] };
                    triangles.push([a as u32, b as u32, c as u32]);
                }
            }
        }
    }
    Mesh::new(positions, triangles)
}
