use glam::Vec3;

/// A mesh rearranged so that every triangle has a last corner of its own, which can carry the
/// triangle's normal: what OpenGL calls the provoking vertex.
///
/// The other corners are shared as before, so this takes about one vertex a triangle where
/// separate triangles would take three.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facets {
    /// Which vertex of the mesh each vertex here is a copy of.
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

    /// What each vertex here takes from its vertex of the mesh.
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

    /// One entry a vertex here, with each triangle's normal at its last corner.
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
