//! Volume that a closed mesh encloses.

use glam::{DVec3, Vec3};

/// Sum of the area vectors, relative to the area, up to which a mesh counts as closed.
const OPENING: f64 = 1e-3;

/// Volume enclosed by `triangles` (indices of `positions`), as the sum of signed tetrahedra; negative if
/// they face inwards. `None` if the mesh is not closed: then its area vectors do not cancel out, and
/// the sum would depend on where the origin is.
pub fn enclosed_volume(positions: &[Vec3], triangles: &[[u32; 3]]) -> Option<f64> {
    let (mut volume, mut area, mut opening) = (0.0, 0.0, DVec3::ZERO);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| positions[corner as usize].as_dvec3());
        volume += a.dot(b.cross(c)) / 6.0;
        let normal = (b - a).cross(c - a);
        area += normal.length();
        opening += normal;
    }
    (area > 0.0 && opening.length() <= OPENING * area && volume != 0.0).then_some(volume)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_has_a_volume_wherever_it_stands_and_none_without_one_of_its_sides() {
        let at = Vec3::new(4.0, -2.0, 7.0);
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z].map(|corner| corner + at);
        let sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let volume = enclosed_volume(&corners, &sides).expect("it is closed");
        assert!((volume - 1.0 / 6.0).abs() < 1e-6, "{volume}");
        assert_eq!(enclosed_volume(&corners, &sides[1..]), None);
        assert_eq!(enclosed_volume(&[], &[]), None);
    }
}
