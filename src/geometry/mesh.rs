use super::TriangleOrder;
use crate::math::Aabb;
use crate::revision::Revision;
use glam::{Vec2, Vec3};
use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::{Deref, Range};
use std::sync::{Arc, OnceLock};

/// Triangle mesh in model space.
///
/// `triangles` wind counter-clockwise seen from outside. Every index is below `positions.len()`;
/// [`Mesh::new`] and the importers see to it.
///
/// # Positions and vertices
/// Posing, picking, export and the weights of a character refer to *positions*: one for each that
/// the file lists. Drawing refers to *vertices*: a position with a normal and texture coordinates.
/// Most meshes have one vertex per position. Where the corners that meet in a position disagree
/// about the rest, [`Mesh::seams`] adds copies of it, after all positions, so that vertex `i` is
/// position `i` for as long as there are positions: buffers of positions stay valid and only grow
/// at the end ([`Mesh::at_vertices`]).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corner positions, in the order of the file they came from.
    pub positions: Vec<Vec3>,
    /// Corners of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
    /// Normals that the surface is shaded with.
    pub normals: Normals,
    /// Vertices beyond one per position; `None` for a mesh that needs none.
    pub seams: Option<Seams>,
    /// Texture coordinates of each vertex, (0, 0) at the picture's lower left; empty if none.
    pub texture_coordinates: Vec<Vec2>,
    /// Ranges of triangles with a material of their own, in order, not overlapping. Triangles in
    /// none take the shape's color.
    pub groups: Vec<MaterialGroup>,
}

/// Normals of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Normals {
    /// One normal per triangle, from its current corners.
    #[default]
    Flat,
    /// One unit normal per vertex ([`Mesh::vertex_count`]).
    PerVertex(Vec<Vec3>),
}

/// The vertices of a mesh whose corners disagree in normals or texture coordinates where they share
/// a position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Seams {
    /// Vertex `positions.len() + k` lies at position `copies[k]`.
    pub copies: Vec<u32>,
    /// [`Mesh::triangles`] once more, in the same order, as indices of vertices.
    pub triangles: Vec<[u32; 3]>,
}

/// Range of triangles that share a material.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialGroup {
    /// Indices of the triangles.
    pub triangles: Range<usize>,
    /// Material of all of them.
    pub material: Material,
}

/// Material of a group of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name in the file.
    pub name: String,
    /// Diffuse color, linear in the stored 0..1 values as everywhere in this program.
    pub color: Vec3,
    /// Texture that replaces the color, if the file names one that could be read.
    pub texture: Option<Arc<Picture>>,
}

/// Picture in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels per row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// RGBA, one byte per channel, top row first; `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

impl Mesh {
    /// Estimated memory of vertices and triangles, in bytes.
    pub fn memory(&self) -> usize {
        let normals = match &self.normals {
            Normals::Flat => 0,
            Normals::PerVertex(normals) => size_of_val(&**normals),
        };
        let seams = self.seams.as_ref();
        let seams = seams.map_or(0, |s| size_of_val(&*s.copies) + size_of_val(&*s.triangles));
        size_of_val(&*self.positions)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.texture_coordinates)
            + normals
            + seams
    }

    /// A mesh with flat normals and no materials.
    ///
    /// # Panics
    /// If an index is out of range: for meshes made in code. Importers check first.
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Self {
        let count = positions.len();
        assert!(
            triangles.iter().flatten().all(|&i| (i as usize) < count),
            "a triangle names a vertex that does not exist"
        );
        Self {
            positions,
            triangles,
            ..Self::default()
        }
    }

    /// The same mesh with one normal per vertex, of unit length.
    pub fn with_normals(self, normals: Vec<Vec3>) -> Self {
        Self {
            normals: Normals::PerVertex(normals),
            ..self
        }
    }

    /// Number of vertices to draw: at least as many as positions.
    pub fn vertex_count(&self) -> usize {
        self.positions.len() + self.seams.as_ref().map_or(0, |seams| seams.copies.len())
    }

    /// Corners of each triangle as indices of vertices, in the order of [`Mesh::triangles`].
    pub fn vertex_triangles(&self) -> &[[u32; 3]] {
        self.seams
            .as_ref()
            .map_or(&self.triangles, |seams| &seams.triangles)
    }

    /// Attributes of all vertices from attributes of all positions (such as where they are now, or
    /// their influences): `of_positions`, one per position, followed by those of the copies.
    pub fn at_vertices<'a, T: Copy>(&self, of_positions: &'a [T]) -> Cow<'a, [T]> {
        match &self.seams {
            None => Cow::Borrowed(of_positions),
            Some(seams) => {
                let copies = seams.copies.iter().map(|&i| of_positions[i as usize]);
                Cow::Owned(of_positions.iter().copied().chain(copies).collect())
            }
        }
    }

    /// Index of the position of each vertex: `0..positions.len()`, then the copies.
    pub fn position_of_vertices(&self) -> impl Iterator<Item = u32> + '_ {
        let copies = self.seams.iter().flat_map(|seams| &seams.copies).copied();
        (0..self.positions.len() as u32).chain(copies)
    }

    /// The smallest box around all positions, in model space.
    pub fn bounds(&self) -> Aabb {
        Aabb::from_points(self.positions.iter().copied())
    }
}

/// Immutable mesh shared by reference, with a revision that caches compare.
#[derive(Clone, Debug)]
pub struct SharedMesh {
    mesh: Arc<Mesh>,
    revision: Revision,
    triangle_order: Arc<OnceLock<TriangleOrder>>,
    bounds: Arc<OnceLock<Aabb>>,
}

impl SharedMesh {
    /// Estimated memory in bytes; 0 if the mesh is among those `counted` already, by address.
    pub fn memory(&self, counted: &mut HashSet<usize>) -> usize {
        if counted.insert(Arc::as_ptr(&self.mesh).addr()) {
            self.mesh.memory()
        } else {
            0
        }
    }

    /// Shares `mesh` under a new revision.
    pub fn new(mesh: Mesh) -> Self {
        Self {
            mesh: Arc::new(mesh),
            revision: Revision::new(),
            triangle_order: Arc::default(),
            bounds: Arc::default(),
        }
    }

    /// Shares `mesh`, which stands for another one within these `bounds`.
    pub fn with_bounds(mesh: Mesh, bounds: Aabb) -> Self {
        Self {
            bounds: Arc::new(bounds.into()),
            ..Self::new(mesh)
        }
    }

    /// Order of the triangles for rays, worked out when it is first asked for.
    pub fn triangle_order(&self) -> &TriangleOrder {
        let new = || TriangleOrder::new(&self.positions, &self.triangles);
        self.triangle_order.get_or_init(new)
    }

    /// [`Mesh::bounds`], worked out when they are first asked for.
    pub fn bounds(&self) -> Aabb {
        *self.bounds.get_or_init(|| self.mesh.bounds())
    }

    /// The revision, the same for all copies.
    pub fn revision(&self) -> Revision {
        self.revision
    }
}

impl Deref for SharedMesh {
    type Target = Mesh;

    fn deref(&self) -> &Mesh {
        &self.mesh
    }
}
