//! A mesh on its way into the memory of the graphics card, part by part: browsers stand still while they take a large
//! buffer.

use super::cached_mesh::{NORMAL, POSITION, current_normals, current_positions, gathered};
use super::mesh_upload::{MeshKey, MeshUpload};
use super::skinning_tables::{Run, Skin};
use crate::geometry::{Facets, Mesh, Normals};
use crate::gpu::{
    Attribute, Buffer, Gl, GpuError, IndexBuffer, Usage, VertexArray, VertexArrayBuilder,
};
use crate::scene::EvaluatedGeometry;
use bytemuck::Pod;
use glam::{Vec2, Vec3};
use std::rc::Rc;

/// Attribute locations in `skinned_vertex.glsl` and the other vertex shaders of meshes.
const RUN: u32 = 2;
const FIRST_POSITION: u32 = 3;
const FIRST_RUN: u32 = 4;
const SECOND_POSITION: u32 = 5;
const SECOND_RUN: u32 = 6;
const TEXTURE_COORDINATES: u32 = 7;

/// An upload of which some parts are made.
#[derive(Debug)]
pub(super) struct MeshUploading {
    key: MeshKey,
    facets: Option<Facets>,
    builder: VertexArrayBuilder,
    skin: Option<Skin>,
    next: Part,
}

/// Parts of an upload, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Indices,
    TextureCoordinates,
    /// Of a mesh that the vertex shader skins with all that it needs for that.
    Positions,
    Normals,
    Done,
}

impl MeshUploading {
    /// The upload of `key`, which is that of `geometry`, of which nothing is made yet.
    pub fn new(gl: &Gl, key: MeshKey, geometry: &EvaluatedGeometry) -> Self {
        let mesh = &geometry.mesh;
        let triangles = mesh.vertex_triangles();
        let is_flat = key.is_flat(mesh);
        Self {
            facets: is_flat.then(|| Facets::new(mesh.vertex_count(), triangles)),
            key,
            builder: VertexArray::builder(gl),
            skin: None,
            next: Part::Indices,
        }
    }

    pub fn key(&self) -> &MeshKey {
        &self.key
    }

    /// Makes the next part; whether that was the last. The table of a skin has at most `most_rows` rows.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn go_on(
        &mut self,
        gl: &Gl,
        geometry: &EvaluatedGeometry,
        most_rows: u32,
    ) -> Result<bool, GpuError> {
        let mesh = &geometry.mesh;
        let Self {
            key,
            facets,
            builder,
            skin,
            next,
        } = self;
        let facets = facets.as_ref();
        let is_fixed = !key.moves() && !key.is_skinned();
        let mut layout = Layout { gl, builder };
        *next = match *next {
            Part::Indices => {
                let triangles = mesh.vertex_triangles();
                let drawn = facets.map_or(triangles, |facets| &facets.triangles);
                let indices = IndexBuffer::new(gl, Usage::Static, drawn.as_flattened())?;
                layout.extend(|builder| builder.indices(&indices));
                match &*mesh.texture_coordinates {
                    [] => Part::Positions,
                    _ => Part::TextureCoordinates,
                }
            }
            Part::TextureCoordinates => {
                let coordinates = gathered(&mesh.texture_coordinates, facets);
                layout.attribute(&coordinates, TEXTURE_COORDINATES)?;
                Part::Positions
            }
            Part::Positions => {
                if let Some(character) = key.skinned() {
                    let (its, runs) = Skin::new(gl, character, most_rows)?;
                    layout.bind_pose(mesh, facets, &runs)?;
                    *skin = Some(its);
                }
                if is_fixed {
                    layout.attribute(&current_positions(geometry, facets), POSITION)?;
                }
                Part::Normals
            }
            Part::Normals => {
                if is_fixed {
                    layout.attribute(&current_normals(geometry, facets), NORMAL)?;
                }
                Part::Done
            }
            Part::Done => Part::Done,
        };
        // Nothing else follows what a pose changes.
        if *next == Part::Normals && !is_fixed {
            *next = Part::Done;
        }
        Ok(*next == Part::Done)
    }

    /// The upload without textures, once all its parts are made.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn finish(self) -> Result<MeshUpload, GpuError> {
        Ok(MeshUpload {
            vertex_array: Rc::new(self.builder.build()?),
            skin: self.skin,
            facets: self.facets,
            textures: Vec::new(),
        })
    }
}

/// Collects the attributes of a mesh.
struct Layout<'a> {
    gl: &'a Gl,
    builder: &'a mut VertexArrayBuilder,
}

impl Layout<'_> {
    /// Adds an attribute that never changes.
    fn attribute<T: FixedAttribute>(
        &mut self,
        values: &[T],
        location: u32,
    ) -> Result<(), GpuError> {
        let buffer = Buffer::vertices(self.gl, Usage::Static, values)?;
        self.extend(|builder| builder.attribute(&buffer, T::attribute(location)));
        Ok(())
    }

    fn extend(&mut self, by: impl FnOnce(VertexArrayBuilder) -> VertexArrayBuilder) {
        let empty = VertexArray::builder(self.gl);
        *self.builder = by(std::mem::replace(self.builder, empty));
    }

    /// Adds the mesh at rest with its influences; facetted, every last corner has those of the other
    /// two corners of its triangle as well.
    fn bind_pose(
        &mut self,
        mesh: &Mesh,
        facets: Option<&Facets>,
        runs: &[Run],
    ) -> Result<(), GpuError> {
        let positions = gathered(&mesh.at_vertices(&mesh.positions), facets).into_owned();
        let runs = gathered(&mesh.at_vertices(runs), facets).into_owned();
        self.attribute(&positions, POSITION)?;
        self.attribute(&runs, RUN)?;
        if let Some(facets) = facets {
            let corners = facets.first_corners();
            for (which, position, run) in [
                (0, FIRST_POSITION, FIRST_RUN),
                (1, SECOND_POSITION, SECOND_RUN),
            ] {
                let of_corner = corners.iter().map(|pair| pair[which] as usize);
                let positions: Vec<Vec3> = of_corner.clone().map(|i| positions[i]).collect();
                let runs: Vec<Run> = of_corner.map(|i| runs[i]).collect();
                self.attribute(&positions, position)?;
                self.attribute(&runs, run)?;
            }
        } else if let Normals::PerVertex(normals) = &mesh.normals {
            self.attribute(normals, NORMAL)?;
        }
        Ok(())
    }
}

/// A type of attributes that never change.
trait FixedAttribute: Pod {
    fn attribute(location: u32) -> Attribute;
}

impl FixedAttribute for Vec3 {
    fn attribute(location: u32) -> Attribute {
        Attribute::f32(location, 3)
    }
}

impl FixedAttribute for Vec2 {
    fn attribute(location: u32) -> Attribute {
        Attribute::f32(location, 2)
    }
}

impl FixedAttribute for Run {
    fn attribute(location: u32) -> Attribute {
        Attribute::u32(location, 2)
    }
}
