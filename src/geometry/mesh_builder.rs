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
    triangles: Vec<[u32; 3]>,
    vertices: Vertices,
    groups: Vec<MaterialGroup>,
}

impl MeshBuilder {
    /// An empty builder.
    pub fn new() -> Self {
        Self::default()
    }

    /// A builder with `positions`, in model space.
    pub fn over(positions: Vec<Vec3>) -> Self {
        Self {
            positions,
            ..Self::default()
        }
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
        if !corners.iter().all(known) {
            return;
        }
        let has_normals = corners.iter().any(|corner| corner.normal.is_some());
        let has_texture = corners.iter().any(|corner| corner.texture.is_some());
        let so_far = &self.vertices;
        if has_normals && !so_far.has_normals || has_texture && !so_far.has_texture {
            self.begin(has_normals, has_texture);
        }
        self.vertices
            .push(corners, &self.positions, &self.triangles);
        self.triangles.push(corners.map(|corner| corner.position));
    }

    /// Numbers the vertices of all triangles anew: the next is the first with normals or texture
    /// coordinates.
    fn begin(&mut self, has_normals: bool, has_texture: bool) {
        let before = std::mem::take(&mut self.vertices);
        self.vertices.has_normals = before.has_normals || has_normals;
        self.vertices.has_texture = before.has_texture || has_texture;
        for (at, &positions) in self.triangles.iter().enumerate() {
            let vertices = before.triangles.get(at).unwrap_or(&positions);
            let corners = [0, 1, 2].map(|corner| {
                let (attributes, vertex) = before.attributes(vertices[corner]);
                Corner {
                    position: positions[corner],
                    normal: attributes.normals.get(vertex).copied(),
                    texture: attributes.texture.get(vertex).copied(),
                }
            });
            self.vertices
                .push(corners, &self.positions, &self.triangles[..at]);
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
        let mut vertices = self.vertices;
        let count = self.positions.len();
        vertices.reach(count);
        for vertex in vertices.triangles.iter_mut().flatten() {
            if *vertex & COPY != 0 {
                *vertex = count as u32 + (*vertex & !COPY);
            }
        }
        let Attributes {
            mut normals,
            mut texture,
            ..
        } = vertices.first;
        normals.append(&mut vertices.copies.normals);
        texture.append(&mut vertices.copies.texture);
        Mesh {
            positions: self.positions,
            triangles: self.triangles,
            normals: if vertices.has_normals {
                Normals::PerVertex(normals)
            } else {
                Normals::Flat
            },
            seams: (!vertices.copied.is_empty()).then_some(Seams {
                copies: vertices.copied,
                triangles: vertices.triangles,
            }),
            texture_coordinates: texture,
            groups: self.groups,
        }
    }
}

/// Vertices by position: the first at a position has its index, copies follow in a chain. Those of
/// a mesh without normals and texture coordinates are its positions, and nothing is kept of them.
#[derive(Clone, Debug, Default)]
struct Vertices {
    has_normals: bool,
    has_texture: bool,
    first: Attributes,
    copies: Attributes,
    /// Position of each copy.
    copied: Vec<u32>,
    /// The triangles once more, as vertices; empty as long as there are no copies.
    triangles: Vec<[u32; 3]>,
}

/// What vertices have beside their positions; the lists of what none of them has are empty.
#[derive(Clone, Debug, Default)]
struct Attributes {
    normals: Vec<Vec3>,
    texture: Vec<Vec2>,
    /// Next vertex at the same position, [`LAST`], or [`UNUSED`].
    next: Vec<u32>,
}

/// Number of vertices at one position that are compared with a new one. More do not occur in
/// practice, and a file made to have them must not take time that grows with the square of its
/// size.
const MOST_COMPARED: usize = 64;
/// The bit of a vertex that is a copy, as long as more positions may come before copies.
const COPY: u32 = 1 << 31;
const LAST: u32 = u32::MAX;
const UNUSED: u32 = u32::MAX - 1;

impl Vertices {
    /// Finds or adds the vertices of one more triangle after `triangles`.
    fn push(&mut self, corners: [Corner; 3], positions: &[Vec3], triangles: &[[u32; 3]]) {
        if !self.has_normals && !self.has_texture {
            return;
        }
        self.reach(positions.len());
        let flat = if self.has_normals && corners.iter().any(|corner| corner.normal.is_none()) {
            face_normal(corners.map(|corner| positions[corner.position as usize]))
        } else {
            Vec3::ZERO
        };
        let vertices = corners.map(|corner| {
            self.find_or_add(
                corner.position,
                corner.normal.unwrap_or(flat),
                corner.texture.unwrap_or_default(),
            )
        });
        if self.triangles.is_empty() && !self.copied.is_empty() {
            self.triangles = triangles.to_vec();
        }
        if !self.copied.is_empty() {
            self.triangles.push(vertices);
        }
    }

    /// Makes room for the first vertices of so many positions.
    fn reach(&mut self, positions: usize) {
        let first = &mut self.first;
        if self.has_normals {
            first.normals.resize(positions, Vec3::ZERO);
        }
        if self.has_texture {
            first.texture.resize(positions, Vec2::ZERO);
        }
        first.next.resize(positions, UNUSED);
    }

    /// The attributes of `vertex`: which, and where in them.
    fn attributes(&self, vertex: u32) -> (&Attributes, usize) {
        if vertex & COPY == 0 {
            (&self.first, vertex as usize)
        } else {
            (&self.copies, (vertex & !COPY) as usize)
        }
    }

    fn find_or_add(&mut self, position: u32, normal: Vec3, texture: Vec2) -> u32 {
        let first = position as usize;
        if self.first.next[first] == UNUSED {
            self.first.next[first] = LAST;
            if self.has_normals {
                self.first.normals[first] = normal;
            }
            if self.has_texture {
                self.first.texture[first] = texture;
            }
            return position;
        }
        let mut at = position;
        for _ in 0..MOST_COMPARED {
            let (attributes, vertex) = self.attributes(at);
            let is_normal = |&of: &Vec3| of == normal;
            let is_texture = |&of: &Vec2| of == texture;
            if attributes.normals.get(vertex).is_none_or(is_normal)
                && attributes.texture.get(vertex).is_none_or(is_texture)
            {
                return at;
            }
            if attributes.next[vertex] == LAST {
                break;
            }
            at = attributes.next[vertex];
        }
        let added = COPY | self.copied.len() as u32;
        // After the last that was compared; what followed it is not looked at again.
        if at & COPY == 0 {
            self.first.next[at as usize] = added;
        } else {
            self.copies.next[(at & !COPY) as usize] = added;
        }
        self.copies.next.push(LAST);
        if self.has_normals {
            self.copies.normals.push(normal);
        }
        if self.has_texture {
            self.copies.texture.push(texture);
        }
        self.copied.push(position);
        added
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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

    /// Positions, normals and texture coordinates of which there are few, so that many agree.
    fn few() -> impl Strategy<Value = Parts> {
        let normal = prop::option::of((0..3_usize).prop_map(|i| Vec3::AXES[i]));
        let texture = prop::option::of((0..3_u8).prop_map(|u| Vec2::splat(u.into())));
        (0..4_u32, normal, texture)
    }

    proptest! {
        #[test]
        fn every_corner_has_what_was_given_and_corners_that_agree_are_one_vertex(
            bare in prop::collection::vec(prop::array::uniform3(0..4_u32), 0..6),
            triangles in prop::collection::vec([few(), few(), few()], 0..20),
        ) {
            // Those without anything come first: what begins late holds for them, too.
            let bare = bare.iter().map(|t| t.map(|position| (position, None, None)));
            let triangles: Vec<_> = bare.chain(triangles).collect();
            let mesh = mesh(&triangles);
            let corners = || triangles.iter().flatten();
            let has_normals = corners().any(|corner| corner.1.is_some());
            let has_texture = corners().any(|corner| corner.2.is_some());
            prop_assert_eq!(has_normals, mesh.normals != Normals::Flat);
            prop_assert_eq!(has_texture, !mesh.texture_coordinates.is_empty());
            let positions = mesh.at_vertices(&mesh.positions);
            let mut numbers = std::collections::HashMap::new();
            for (at, triangle) in triangles.iter().enumerate() {
                let flat = face_normal(triangle.map(|corner| SQUARE[corner.0 as usize]));
                for (&(position, normal, texture), vertex) in triangle.iter().zip(mesh.vertex_triangles()[at]) {
                    let vertex = vertex as usize;
                    prop_assert_eq!(positions[vertex], SQUARE[position as usize]);
                    let normal = has_normals.then_some(normal.unwrap_or(flat));
                    if let Normals::PerVertex(normals) = &mesh.normals {
                        prop_assert_eq!(Some(normals[vertex]), normal);
                    }
                    let texture = has_texture.then_some(texture.unwrap_or_default());
                    prop_assert_eq!(mesh.texture_coordinates.get(vertex).copied(), texture);
                    let bits = (position, normal.map(|n| n.to_array().map(f32::to_bits)), texture.map(|t| t.to_array().map(f32::to_bits)));
                    prop_assert_eq!(*numbers.entry(bits).or_insert(vertex), vertex);
                }
            }
            // A copy that nothing uses would be drawn from, and uploaded, for nothing.
            let used: std::collections::HashSet<_> = mesh.vertex_triangles().iter().flatten().collect();
            let copies = 4..mesh.vertex_count() as u32;
            prop_assert!(copies.clone().all(|copy| used.contains(&copy)));
        }
    }
}
