use super::{MaterialGroup, Mesh, Normals, Seams, face_normal};
use glam::{Vec2, Vec3};

/// Corner of a triangle in a file format that indexes positions, normals and texture coordinates
/// separately.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Index of the position.
    pub position: u32,
    /// Unit normal, if the file has one here.
    pub normal: Option<Vec3>,
    /// Texture coordinates, if the file has them here.
    pub texture: Option<Vec2>,
}

/// Builder of a [`Mesh`] from triangles whose corners have normals and texture coordinates of their
/// own.
///
/// Positions stay as they are, one a position of the file, used or not. Corners that share a
/// position and agree in the rest become one vertex; others get copies of the position ([`Seams`]).
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    positions: Vec<Vec3>,
    triangles: Vec<[Corner; 3]>,
    groups: Vec<MaterialGroup>,
}

/// Number of vertices at one position that are compared with a new one. More do not occur in
/// practice, and a file made to have them must not take time that grows with the square of its
/// size.
const MOST_COMPARED: usize = 64;
const NONE: u32 = u32::MAX;

impl MeshBuilder {
    /// An empty builder.
    pub fn new() -> Self {
        Self::default()
    }

    /// The positions so far, in model space.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Number of triangles so far.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Appends positions; corners name them by their index among all.
    pub fn extend_positions(&mut self, positions: impl IntoIterator<Item = Vec3>) {
        self.positions.extend(positions);
    }

    /// Appends a triangle, corners counter-clockwise seen from outside. A triangle that names a
    /// position which does not exist yet is left out.
    pub fn push_triangle(&mut self, corners: [Corner; 3]) {
        let known = |corner: &Corner| (corner.position as usize) < self.positions.len();
        if corners.iter().all(known) {
            self.triangles.push(corners);
        }
    }

    /// Gives the triangles from `group.triangles.start` on a material of their own.
    pub fn push_group(&mut self, group: MaterialGroup) {
        if !group.triangles.is_empty() {
            self.groups.push(group);
        }
    }

    /// The mesh. If no corner has a normal it is flat, if some have, the others take that of their
    /// triangle; texture coordinates that are missing beside others are (0, 0).
    pub fn build(self) -> Mesh {
        let corners = || self.triangles.iter().flatten();
        let has_normals = corners().any(|corner| corner.normal.is_some());
        let has_texture = corners().any(|corner| corner.texture.is_some());
        let mut vertices = Vertices::new(self.positions.len());
        let triangles = self
            .triangles
            .iter()
            .map(|corners| {
                let positions = corners.map(|corner| self.positions[corner.position as usize]);
                let flat = if has_normals {
                    face_normal(positions)
                } else {
                    Vec3::ZERO
                };
                corners.map(|corner| {
                    let normal = corner.normal.unwrap_or(flat);
                    let normal = if has_normals { normal } else { Vec3::ZERO };
                    vertices.find_or_add(
                        corner.position,
                        normal,
                        corner.texture.unwrap_or_default(),
                    )
                })
            })
            .collect();
        let seams = (!vertices.copies.is_empty()).then_some(Seams {
            copies: vertices.copies,
            triangles,
        });
        Mesh {
            triangles: self
                .triangles
                .iter()
                .map(|corners| corners.map(|corner| corner.position))
                .collect(),
            positions: self.positions,
            normals: if has_normals {
                Normals::PerVertex(vertices.normals)
            } else {
                Normals::Flat
            },
            seams,
            texture_coordinates: if has_texture {
                vertices.texture
            } else {
                Vec::new()
            },
            groups: self.groups,
        }
    }
}

/// Vertices by position: the first at a position has its index, the others follow in a chain.
struct Vertices {
    used: Vec<bool>,
    next: Vec<u32>,
    normals: Vec<Vec3>,
    texture: Vec<Vec2>,
    copies: Vec<u32>,
}

impl Vertices {
    fn new(positions: usize) -> Self {
        Self {
            used: vec![false; positions],
            next: vec![NONE; positions],
            normals: vec![Vec3::ZERO; positions],
            texture: vec![Vec2::ZERO; positions],
            copies: Vec::new(),
        }
    }

    fn find_or_add(&mut self, position: u32, normal: Vec3, texture: Vec2) -> u32 {
        let first = position as usize;
        if !std::mem::replace(&mut self.used[first], true) {
            self.normals[first] = normal;
            self.texture[first] = texture;
            return position;
        }
        let mut at = position;
        for _ in 0..MOST_COMPARED {
            let vertex = at as usize;
            if self.normals[vertex] == normal && self.texture[vertex] == texture {
                return at;
            }
            if self.next[vertex] == NONE {
                break;
            }
            at = self.next[vertex];
        }
        let added = self.next.len() as u32;
        // After the last that was compared; what followed it is not looked at again.
        self.next[at as usize] = added;
        self.next.push(NONE);
        self.normals.push(normal);
        self.texture.push(texture);
        self.copies.push(position);
        added
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];

    type Parts = (u32, Option<Vec3>, Option<Vec2>);

    fn mesh(triangles: &[[Parts; 3]]) -> Mesh {
        let mut builder = MeshBuilder::new();
        builder.extend_positions(SQUARE);
        for corners in triangles {
            builder.push_triangle(corners.map(|(position, normal, texture)| Corner {
                position,
                normal,
                texture,
            }));
        }
        builder.build()
    }

    #[test]
    fn corners_that_agree_are_one_vertex_and_need_no_seams() {
        let corner = |position| (position, Some(Vec3::Z), Some(Vec2::splat(position as f32)));
        let mesh = mesh(&[[0, 1, 2].map(corner), [0, 2, 3].map(corner)]);
        assert_eq!(mesh.seams, None);
        assert_eq!(mesh.normals, Normals::PerVertex(vec![Vec3::Z; 4]));
        assert_eq!(mesh.texture_coordinates[3], Vec2::splat(3.0));
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn corners_that_disagree_get_copies_after_all_positions() {
        let up = |position| (position, Some(Vec3::Z), None);
        let side = |position| (position, Some(Vec3::X), None);
        let mesh = mesh(&[[0, 1, 2].map(up), [0, 2, 3].map(side)]);
        let seams = mesh.seams.clone().unwrap();
        assert_eq!(seams.copies, [0, 2]);
        assert_eq!(seams.triangles, [[0, 1, 2], [4, 5, 3]]);
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh.vertex_count(), 6);
        assert_eq!(mesh.at_vertices(&mesh.positions)[5], SQUARE[2]);
        assert!(mesh.texture_coordinates.is_empty());
    }

    #[test]
    fn a_mesh_without_normals_is_flat_and_one_with_some_takes_the_triangles_for_the_others() {
        let bare = |position| (position, None, None);
        assert_eq!(mesh(&[[0, 1, 2].map(bare)]).normals, Normals::Flat);
        let mixed = mesh(&[
            [0, 1, 2].map(|i| (i, Some(Vec3::X), None)),
            [0, 2, 3].map(bare),
        ]);
        let Normals::PerVertex(normals) = &mixed.normals else {
            panic!("{mixed:?}");
        };
        assert_eq!(normals[3], Vec3::Z);
    }

    #[test]
    fn a_position_with_more_vertices_than_are_compared_still_draws_them_all() {
        let triangles: Vec<_> = (0..200)
            .map(|i| [0, 1, 2].map(|p| (p, None, Some(Vec2::splat(i as f32)))))
            .collect();
        let mesh = mesh(&triangles);
        for (i, corners) in mesh.vertex_triangles().iter().enumerate() {
            for &vertex in corners {
                assert_eq!(mesh.texture_coordinates[vertex as usize].x, i as f32);
            }
        }
    }
}
