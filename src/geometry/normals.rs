use glam::Vec3;

/// Unit normal of a triangle whose corners wind counter-clockwise; zero for one without area, which
/// then takes no light.
pub fn face_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

/// Unit normals, one per triangle, from the *current* positions: the assignment asks to compute
/// them each time the vertices change.
pub fn face_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    triangles
        .iter()
        .map(|corners| face_normal(corners.map(|i| positions[i as usize])))
        .collect()
}

/// Unit normals, one per vertex: the mean of the faces around it, weighted by their area. Zero for
/// a vertex without faces.
pub fn smooth_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for corners in triangles {
        let [a, b, c] = corners.map(|i| positions[i as usize]);
        let twice_the_area = (b - a).cross(c - a);
        for &corner in corners {
            sums[corner as usize] += twice_the_area;
        }
    }
    sums.into_iter().map(Vec3::normalize_or_zero).collect()
}

/// Mesh rearranged so that every triangle has a last corner of its own, which can carry the
/// triangle's normal: the provoking vertex of OpenGL.
///
/// The other corners are shared as before, so this takes about one vertex per triangle where
/// separate triangles would take three.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facets {
    /// Index of the mesh's vertex that each vertex here is a copy of.
    pub sources: Vec<u32>,
    /// The triangles in their order and winding, as indices into `sources`.
    pub triangles: Vec<[u32; 3]>,
}

impl Facets {
    /// Rearranges `triangles` over `vertex_count` vertices.
    pub fn new(vertex_count: usize, triangles: &[[u32; 3]]) -> Self {
        let mut sources: Vec<u32> = (0..vertex_count as u32).collect();
        let mut owned = vec![false; vertex_count];
        let triangles = triangles
            .iter()
            .map(|&[a, b, c]| {
                let turns = [[a, b, c], [b, c, a], [c, a, b]];
                if let Some(&turn) = turns.iter().find(|turn| !owned[turn[2] as usize]) {
                    owned[turn[2] as usize] = true;
                    turn
                } else {
                    sources.push(c);
                    [a, b, sources.len() as u32 - 1]
                }
            })
            .collect();
        Self { sources, triangles }
    }

    /// Attributes of all vertices here, copied from those of the mesh's vertices.
    pub fn gather<T: Copy>(&self, of_vertices: &[T]) -> Vec<T> {
        self.sources
            .iter()
            .map(|&source| of_vertices[source as usize])
            .collect()
    }

    /// The first two corners of the triangle that each vertex here is the last corner of, as
    /// indices into `sources`; the vertex itself, twice, where it is no last corner.
    pub fn first_corners(&self) -> Vec<[u32; 2]> {
        let mut corners: Vec<[u32; 2]> = (0..self.sources.len() as u32).map(|i| [i; 2]).collect();
        for &[first, second, last] in &self.triangles {
            corners[last as usize] = [first, second];
        }
        corners
    }

    /// Normals of all vertices here: each triangle's normal at its last corner, zero elsewhere.
    pub fn at_last_corners(&self, face_normals: &[Vec3]) -> Vec<Vec3> {
        let mut normals = vec![Vec3::ZERO; self.sources.len()];
        for (triangle, &normal) in self.triangles.iter().zip(face_normals) {
            normals[triangle[2] as usize] = normal;
        }
        normals
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Poles, icosahedron, sphere};
    use std::collections::HashSet;

    #[test]
    fn a_triangle_without_area_has_a_zero_normal_and_no_nan() {
        assert_eq!(face_normal([Vec3::ONE; 3]), Vec3::ZERO);
        assert_eq!(
            face_normal([Vec3::ZERO, Vec3::X, Vec3::X * 2.0]),
            Vec3::ZERO
        );
    }

    #[test]
    fn normals_follow_the_right_hand() {
        assert_eq!(face_normal([Vec3::ZERO, Vec3::X, Vec3::Y]), Vec3::Z);
    }

    #[test]
    fn smooth_normals_lean_towards_the_larger_face() {
        // Two right triangles share the corner at the origin: one of area 2 that faces +Z, one of
        // area 1/2 that faces +X.
        let positions = [Vec3::ZERO, Vec3::X * 2.0, Vec3::Y * 2.0, Vec3::Y, Vec3::Z];
        let normals = smooth_normals(&positions, &[[0, 1, 2], [0, 3, 4]]);
        let expected = Vec3::new(1.0, 0.0, 4.0) / 17.0_f32.sqrt();
        assert!(normals[0].abs_diff_eq(expected, 1e-6), "{}", normals[0]);
        assert_eq!((normals[1], normals[4]), (Vec3::Z, Vec3::X));
    }

    #[test]
    fn every_triangle_keeps_its_corners_and_owns_its_last_one() {
        for mesh in [icosahedron(), sphere(1.0, 9, 7, Poles::Z)] {
            let facets = Facets::new(mesh.positions.len(), &mesh.triangles);
            let mut last = HashSet::new();
            for (before, after) in mesh.triangles.iter().zip(&facets.triangles) {
                assert!(last.insert(after[2]), "two triangles share a last corner");
                let sources = after.map(|corner| facets.sources[corner as usize]);
                let turns = (0..3).map(|k| [before[k], before[(k + 1) % 3], before[(k + 2) % 3]]);
                assert!(turns.into_iter().any(|turn| turn == sources));
            }
            for &[first, second, last] in &facets.triangles {
                assert_eq!(facets.first_corners()[last as usize], [first, second]);
            }
            assert!(facets.sources.len() <= mesh.positions.len() + mesh.triangles.len());
        }
    }
}
