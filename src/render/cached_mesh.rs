//! The mesh of one shape in the memory of the graphics card.

use super::coverage::Raster;
use super::mesh_numbers::MeshNumbers;
use super::mesh_upload::MeshUpload;
use super::palettes::Palettes;
use super::samples::Samples;
use super::shown_triangles::{Purpose, Shown, ShownTriangles};
use crate::geometry::{Facets, Mesh, face_normals, smooth_normals};
use crate::gpu::{Attribute, Buffer, Gl, GpuError, Primitive, Program, Usage, VertexArray};
use crate::revision::Revision;
use crate::scene::{EvaluatedGeometry, VertexNumbers};
use glam::Vec3;
use std::borrow::Cow;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

/// Attribute locations in `surface_vertex.glsl` and the other vertex shaders of meshes.
pub(super) const POSITION: u32 = 0;
pub(super) const NORMAL: u32 = 1;
const NUMBER: u32 = 8;

/// Texture units of a skinned mesh; unit 0 is its material's.
const PALETTES: u32 = 1;
const INFLUENCES: u32 = 2;

/// The uploaded mesh of a shape.
#[derive(Debug)]
pub(super) struct CachedMesh {
    pub vertex_array: Rc<VertexArray>,
    /// What it shares with its copies.
    pub upload: Rc<MeshUpload>,
    /// What of it is drawn.
    pub shown: ShownTriangles,
    /// The buffers that are written anew when the positions change; `None` where the processor deforms
    /// nothing.
    moving: Option<Moving>,
    /// The numbers that it is colored by, if there is room for some.
    numbers: Option<MeshNumbers>,
}

/// Current positions and normals of a mesh that the processor deforms.
#[derive(Debug)]
struct Moving {
    revision: Revision,
    positions: Buffer<Vec3>,
    normals: Buffer<Vec3>,
}

impl Moving {
    fn new(
        gl: &Gl,
        geometry: &EvaluatedGeometry,
        facets: Option<&Facets>,
    ) -> Result<Self, GpuError> {
        let positions = current_positions(geometry, facets);
        let normals = current_normals(geometry, facets);
        Ok(Self {
            revision: geometry.revision,
            positions: Buffer::vertices(gl, Usage::Stream, &positions)?,
            normals: Buffer::vertices(gl, Usage::Stream, &normals)?,
        })
    }
}

/// Kinds of vertex shaders that draw meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MeshKind {
    /// Positions and normals as they are.
    Plain,
    /// The bind pose, to be skinned.
    Skinned,
    /// The bind pose, to be skinned, with one normal a triangle.
    SkinnedFacets,
}

impl CachedMesh {
    /// The mesh of `geometry`, whose upload it shares, with room for numbers if it `has_numbers`.
    ///
    /// # Errors
    /// If the driver cannot take what is its own.
    pub fn new(
        gl: &Gl,
        upload: &Rc<MeshUpload>,
        geometry: &EvaluatedGeometry,
        has_numbers: bool,
    ) -> Result<Self, GpuError> {
        let mesh = &geometry.mesh;
        let facets = upload.facets.as_ref();
        let mut builder = upload.vertex_array.extended();
        let moves = upload.skin.is_none() && geometry.deformation.is_some();
        let moving = moves.then(|| Moving::new(gl, geometry, facets));
        let moving = moving.transpose()?;
        if let Some(moving) = &moving {
            builder = builder
                .attribute(&moving.positions, Attribute::f32(POSITION, 3))
                .attribute(&moving.normals, Attribute::f32(NORMAL, 3));
        }
        let numbers = has_numbers.then(|| MeshNumbers::new(gl, mesh, facets));
        let numbers = numbers.transpose()?;
        if let Some(numbers) = &numbers {
            builder = builder.attribute(&numbers.buffer, Attribute::f32(NUMBER, 1));
        }
        let vertex_array = if moves || has_numbers {
            Rc::new(builder.build()?)
        } else {
            Rc::clone(&upload.vertex_array)
        };
        Ok(Self {
            vertex_array,
            upload: Rc::clone(upload),
            shown: ShownTriangles::default(),
            moving,
            numbers,
        })
    }

    /// Whether each triangle has one normal, which its last corner carries.
    pub fn is_flat(&self) -> bool {
        self.upload.facets.is_some()
    }

    /// Draws the triangles of `range` of so many copies, as far as they are shown.
    pub fn draw(&self, program: &Program, purpose: Purpose, range: Range<u32>, copies: u32) {
        let all = || Some((&*self.vertex_array, range.clone()));
        let shown = match self.shown.of(purpose) {
            Shown::All => all(),
            Shown::None => None,
            Shown::Some(kept) => kept.within(&range).or_else(all),
        };
        if let Some((vertex_array, triangles)) = shown {
            let indices = triangles.start * 3..triangles.end * 3;
            vertex_array.draw_indexed_instanced(program, Primitive::Triangles, indices, copies);
        }
    }

    /// Draws all triangles of so many copies, as far as they are shown.
    pub fn draw_whole(&self, program: &Program, purpose: Purpose, copies: u32) {
        self.draw(
            program,
            purpose,
            0..self.vertex_array.index_count() / 3,
            copies,
        );
    }

    /// Leaves out the triangles without a sample; all are drawn if the vertex shader moves them.
    ///
    /// # Errors
    /// If the driver cannot take a list of the others.
    pub fn leave_out_uncovered(
        &mut self,
        gl: &Gl,
        purpose: Purpose,
        geometry: &EvaluatedGeometry,
        raster: Raster,
        samples: &Samples,
    ) -> Result<(), GpuError> {
        if self.is_skinned() {
            // Which are covered is known to the graphics card alone. It may have been out of sight before.
            self.shown.set_seen(purpose, true);
            return Ok(());
        }
        let triangles = geometry.mesh.vertex_triangles();
        let drawn = self
            .upload
            .facets
            .as_ref()
            .map_or(triangles, |f| &f.triangles);
        let drawn = (drawn, &*self.vertex_array);
        (self.shown).set_covering(gl, purpose, geometry, drawn, raster, samples)
    }

    /// Kind of vertex shader that draws it.
    pub fn kind(&self) -> MeshKind {
        match (&self.upload.skin, self.is_flat()) {
            (None, _) => MeshKind::Plain,
            (Some(_), false) => MeshKind::Skinned,
            (Some(_), true) => MeshKind::SkinnedFacets,
        }
    }

    /// Whether the vertex shader skins it.
    pub fn is_skinned(&self) -> bool {
        self.upload.skin.is_some()
    }

    /// Sets the tables of `program`, one for its kind of mesh, for skinning copies of it, which start at
    /// `instances` in `palettes`.
    pub fn bind_skin(&self, program: &Program, instances: &[i32], palettes: &Palettes) {
        if let Some(skin) = &self.upload.skin {
            palettes.bind(PALETTES);
            skin.bind(INFLUENCES);
            program.set_sampler("palettes", PALETTES);
            program.set_sampler("influences", INFLUENCES);
            program.set_i32s("instances", instances);
        }
    }

    /// The numbers that it is colored by, if it is.
    pub fn numbers(&self) -> Option<&VertexNumbers> {
        self.numbers.as_ref()?.written()
    }

    /// Uploads the numbers of the positions of `mesh`, of which this is the upload, if they are others
    /// than before. Without room for any it does nothing.
    pub fn update_numbers(
        &mut self,
        mesh: &Mesh,
        wanted: Option<&Arc<VertexNumbers>>,
    ) -> Result<(), GpuError> {
        match &mut self.numbers {
            Some(numbers) => numbers.update(mesh, self.upload.facets.as_ref(), wanted),
            None => Ok(()),
        }
    }

    /// Uploads the positions if they have changed and the vertex shader does not compute them.
    /// Whether it did.
    pub fn update_positions(&mut self, geometry: &EvaluatedGeometry) -> Result<bool, GpuError> {
        let Some(moving) = &mut self.moving else {
            return Ok(false);
        };
        if moving.revision == geometry.revision {
            return Ok(false);
        }
        let facets = self.upload.facets.as_ref();
        let positions = current_positions(geometry, facets);
        moving.positions.update(&positions)?;
        moving.normals.update(&current_normals(geometry, facets))?;
        moving.revision = geometry.revision;
        Ok(true)
    }
}

/// Values of vertices in the order in which the mesh is uploaded.
pub(super) fn gathered<'a, T: Copy>(of_vertices: &'a [T], facets: Option<&Facets>) -> Cow<'a, [T]> {
    match facets {
        Some(facets) => facets.gather(of_vertices).into(),
        None => of_vertices.into(),
    }
}

/// Current positions as they are uploaded.
pub(super) fn current_positions<'a>(
    geometry: &'a EvaluatedGeometry,
    facets: Option<&Facets>,
) -> Cow<'a, [Vec3]> {
    let positions = geometry.mesh.at_vertices(geometry.positions());
    match facets {
        Some(facets) => facets.gather(&positions).into(),
        None => positions,
    }
}

/// Current normals as they are uploaded.
pub(super) fn current_normals<'a>(
    geometry: &'a EvaluatedGeometry,
    facets: Option<&Facets>,
) -> Cow<'a, [Vec3]> {
    let (mesh, positions) = (&geometry.mesh, geometry.positions());
    if let Some(facets) = facets {
        let normals = face_normals(positions, &mesh.triangles);
        return facets.at_last_corners(&normals).into();
    }
    let of_triangles = || {
        let normals = smooth_normals(positions, &mesh.triangles);
        mesh.at_vertices(&normals).into_owned().into()
    };
    geometry.normals().map_or_else(of_triangles, Cow::from)
}
