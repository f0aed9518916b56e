use crate::math::{Aabb, Ray, TriangleHit};
use glam::{Vec2, Vec3};
use std::ops::Range;
use std::sync::Arc;

/// A triangle mesh in model space.
///
/// `triangles` wind counter-clockwise seen from outside. Every index is below
/// `positions.len()`; [`Mesh::new`] and the importers see to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corner positions, in the order of the file they came from.
    pub positions: Vec<Vec3>,
    /// Corners of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
    /// How the surface is shaded.
    pub normals: Normals,
    /// Texture coordinates of each vertex, (0, 0) at the picture's lower left; empty if none.
    pub texture_coordinates: Vec<Vec2>,
    /// Ranges of triangles with a material of their own, in order, not overlapping. Triangles in
    /// none take the shape's color.
    pub groups: Vec<MaterialGroup>,
}

/// Where the normals of a mesh come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Normals {
    /// One normal a triangle, from its current corners.
    #[default]
    Flat,
    /// One normal a vertex, unit length, as many as there are positions.
    PerVertex(Vec<Vec3>),
}

/// A run of triangles that share a material.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialGroup {
    /// Which triangles.
    pub triangles: Range<usize>,
    /// What they look like.
    pub material: Material,
}

/// The look of a group of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name in the file.
    pub name: String,
    /// Diffuse color, linear in the stored 0..1 values as everywhere in this program.
    pub color: Vec3,
    /// A picture that replaces the color, if the file names one that could be read.
    pub texture: Option<Arc<Picture>>,
}

/// A picture in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// RGBA, one byte a channel, top row first; `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

impl Mesh {
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

    /// The same mesh shaded with one normal a vertex.
    pub fn with_normals(self, normals: Vec<Vec3>) -> Self {
        Self {
            normals: Normals::PerVertex(normals),
            ..self
        }
    }

    /// The smallest box around all positions, in model space.
    pub fn bounds(&self) -> Aabb {
        Aabb::from_points(self.positions.iter().copied())
    }
}

/// The nearest triangle that `ray` meets, with its index. `ray` and `positions` share a space;
/// `triangles` index into `positions`.
pub fn nearest_triangle(
    ray: &Ray,
    positions: &[Vec3],
    triangles: &[[u32; 3]],
) -> Option<(usize, TriangleHit)> {
    triangles
        .iter()
        .enumerate()
        .filter_map(|(index, corners)| {
            let hit = ray.triangle(corners.map(|corner| positions[corner as usize]))?;
            Some((index, hit))
        })
        .min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))
}
