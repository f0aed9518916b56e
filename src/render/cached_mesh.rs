//! The mesh of one shape in the memory of the graphics card.

use super::coverage::Raster;
use super::mesh_cache::TextureCache;
use super::mesh_numbers::MeshNumbers;
use super::samples::Samples;
use super::shown_triangles::{Purpose, Shown, ShownTriangles};
use super::skinning_tables::{Palettes, Run, Skin};
use crate::character::Character;
use crate::geometry::{Facets, Mesh, Normals, face_normals, smooth_normals};
use crate::gpu::{
    Attribute, Buffer, Gl, GpuError, IndexBuffer, Primitive, Program, Texture, Usage, VertexArray,
    VertexArrayBuilder,
};
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedGeometry, Shading, ShapeId, Skinning, VertexNumbers};
use bytemuck::Pod;
use glam::{Vec2, Vec3};
use std::borrow::Cow;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

/// Attribute locations in `surface_vertex.glsl` and the other vertex shaders of meshes.
const POSITION: u32 = 0;
const NORMAL: u32 = 1;
const RUN: u32 = 2;
const FIRST_POSITION: u32 = 3;
const FIRST_RUN: u32 = 4;
const SECOND_POSITION: u32 = 5;
const SECOND_RUN: u32 = 6;
const TEXTURE_COORDINATES: u32 = 7;
const NUMBER: u32 = 8;

/// Texture units of a skinned mesh; unit 0 is its material's.
const PALETTES: u32 = 1;
const INFLUENCES: u32 = 2;

/// The uploaded mesh of a shape.
#[derive(Debug)]
pub(super) struct CachedMesh {
    pub vertex_array: VertexArray,
    /// The weights, if the vertex shader skins the mesh; it is then uploaded in its bind pose.
    pub skin: Option<Skin>,
    /// The texture of each material group of the mesh, where it has one.
    pub textures: Vec<Option<Rc<Texture>>>,
    /// What of it is drawn.
    pub shown: ShownTriangles,
    /// Rearrangement of the mesh for facetted drawing; `None` if it is drawn smooth.
    facets: Option<Facets>,
    /// The buffers that are written anew when the positions change; `None` for a skinned mesh.
    moving: Option<Moving>,
    /// The numbers that it is colored by, if there is room for some.
    numbers: Option<MeshNumbers>,
}

/// Identity of an uploaded mesh, apart from its pose.
#[derive(Debug)]
pub(super) struct MeshKey {
    mesh: Revision,
    shading: Shading,
    /// The character, if the vertex shader skins it.
    skinned: Option<Arc<Character>>,
    /// Whether it has numbers to be colored by.
    has_numbers: bool,
}

impl MeshKey {
    pub fn new(
        geometry: &EvaluatedGeometry,
        shading: Shading,
        skinning: Skinning,
        has_numbers: bool,
    ) -> Self {
        let deformation = deformation_to_skin(geometry, shading, skinning);
        Self {
            mesh: geometry.mesh.revision(),
            shading,
            skinned: deformation.map(|deformation| deformation.character().clone()),
            has_numbers,
        }
    }

    /// Whether the vertex shader skins it.
    pub fn is_skinned(&self) -> bool {
        self.skinned.is_some()
    }
}

impl PartialEq for MeshKey {
    fn eq(&self, other: &Self) -> bool {
        let is_same_skin = match (&self.skinned, &other.skinned) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        let rest = |key: &Self| (key.mesh, key.shading, key.has_numbers);
        is_same_skin && rest(self) == rest(other)
    }
}

/// Current positions and normals of a mesh that the processor deforms, or nothing does.
#[derive(Debug)]
struct Moving {
    revision: Revision,
    positions: Buffer<Vec3>,
    normals: Buffer<Vec3>,
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
    /// Uploads the mesh, with room for numbers if it `has_numbers`. A skin's table has at most
    /// `most_rows` rows.
    pub fn new(
        gl: &Gl,
        geometry: &EvaluatedGeometry,
        shading: Shading,
        skinning: Skinning,
        has_numbers: bool,
        most_rows: u32,
    ) -> Result<Self, GpuError> {
        let mesh = &geometry.mesh;
        let triangles = mesh.vertex_triangles();
        let facets = is_flat(mesh, shading).then(|| Facets::new(mesh.vertex_count(), triangles));
        let drawn = facets.as_ref().map_or(triangles, |f| &f.triangles);
        let indices = IndexBuffer::new(gl, Usage::Static, drawn.as_flattened())?;
        let mut builder = Layout::new(gl).indices(&indices);
        if !mesh.texture_coordinates.is_empty() {
            let coordinates = gathered(&mesh.texture_coordinates, facets.as_ref());
            builder.attribute(&coordinates, TEXTURE_COORDINATES)?;
        }
        let numbers = has_numbers.then(|| builder.numbers(mesh, facets.as_ref()));
        let numbers = numbers.transpose()?;
        let (skin, moving) = match deformation_to_skin(geometry, shading, skinning) {
            Some(deformation) => {
                let (skin, runs) = Skin::new(gl, deformation.character(), most_rows)?;
                builder.bind_pose(mesh, facets.as_ref(), &runs)?;
                (Some(skin), None)
            }
            None => (None, Some(builder.moving(geometry, facets.as_ref())?)),
        };
        Ok(Self {
            vertex_array: builder.builder.build()?,
            skin,
            textures: Vec::new(),
            shown: ShownTriangles::default(),
            facets,
            moving,
            numbers,
        })
    }

    /// Uploads the pictures of the materials of `mesh`, of which this is the upload. Without texture
    /// coordinates none can be shown.
    pub fn add_textures(&mut self, gl: &Gl, mesh: &Mesh, textures: &mut TextureCache) {
        if mesh.texture_coordinates.is_empty() {
            return;
        }
        self.textures = mesh
            .groups
            .iter()
            .map(|group| textures.texture(gl, group.material.texture.as_ref()?))
            .collect();
    }

    /// Whether each triangle has one normal, which its last corner carries.
    pub fn is_flat(&self) -> bool {
        self.facets.is_some()
    }

    /// Draws the triangles of `range`, as far as they are shown.
    pub fn draw(&self, program: &Program, purpose: Purpose, range: Range<u32>) {
        let all = || Some((&self.vertex_array, range.clone()));
        let shown = match self.shown.of(purpose) {
            Shown::All => all(),
            Shown::None => None,
            Shown::Some(kept) => kept.within(&range).or_else(all),
        };
        if let Some((vertex_array, triangles)) = shown {
            let indices = triangles.start * 3..triangles.end * 3;
            vertex_array.draw_indexed(program, Primitive::Triangles, indices);
        }
    }

    /// Draws all triangles, as far as they are shown.
    pub fn draw_whole(&self, program: &Program, purpose: Purpose) {
        self.draw(program, purpose, 0..self.vertex_array.index_count() / 3);
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
        if self.skin.is_some() {
            return Ok(());
        }
        let triangles = geometry.mesh.vertex_triangles();
        let drawn = self.facets.as_ref().map_or(triangles, |f| &f.triangles);
        let drawn = (drawn, &self.vertex_array);
        (self.shown).set_covering(gl, purpose, geometry, drawn, raster, samples)
    }

    /// Kind of vertex shader that draws it.
    pub fn kind(&self) -> MeshKind {
        match (&self.skin, self.is_flat()) {
            (None, _) => MeshKind::Plain,
            (Some(_), false) => MeshKind::Skinned,
            (Some(_), true) => MeshKind::SkinnedFacets,
        }
    }

    /// Sets the tables of `program`, one for its kind of mesh, for skinning it as the shape `id`.
    pub fn bind_skin(&self, program: &Program, id: ShapeId, palettes: &Palettes) {
        if let Some(skin) = &self.skin
            && let Some(first_joint) = palettes.bind(PALETTES, id)
        {
            skin.bind(INFLUENCES);
            program.set_sampler("palettes", PALETTES);
            program.set_sampler("influences", INFLUENCES);
            program.set_i32("first_joint", first_joint as i32);
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
            Some(numbers) => numbers.update(mesh, self.facets.as_ref(), wanted),
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
        let (positions, normals) = current_vertices(geometry, self.facets.as_ref());
        moving.positions.update(&positions)?;
        moving.normals.update(&normals)?;
        moving.revision = geometry.revision;
        Ok(true)
    }
}

fn is_flat(mesh: &Mesh, shading: Shading) -> bool {
    match shading {
        Shading::AsAuthored => mesh.normals == Normals::Flat,
        Shading::Flat => true,
        Shading::Smooth => false,
    }
}

/// The deformation that the vertex shader computes, if it does: it knows the exact formula alone.
fn deformation_to_skin(
    geometry: &EvaluatedGeometry,
    shading: Shading,
    skinning: Skinning,
) -> Option<&Deformation> {
    let needs_sums = geometry.mesh.normals == Normals::Flat && shading == Shading::Smooth;
    geometry
        .deformation
        .as_ref()
        .filter(|deformation| skinning == Skinning::Gpu && deformation.is_exact() && !needs_sums)
}

/// Collects the attributes of a mesh.
struct Layout<'a> {
    gl: &'a Gl,
    builder: VertexArrayBuilder,
}

impl<'a> Layout<'a> {
    fn new(gl: &'a Gl) -> Self {
        let builder = VertexArray::builder(gl);
        Self { gl, builder }
    }

    fn indices(self, indices: &IndexBuffer) -> Self {
        let builder = self.builder.indices(indices);
        Self { builder, ..self }
    }

    fn attach<T: Pod>(&mut self, buffer: &Buffer<T>, attribute: Attribute) {
        let empty = VertexArray::builder(self.gl);
        self.builder = std::mem::replace(&mut self.builder, empty).attribute(buffer, attribute);
    }

    /// Adds an attribute that never changes.
    fn attribute<T: FixedAttribute>(
        &mut self,
        values: &[T],
        location: u32,
    ) -> Result<(), GpuError> {
        let buffer = Buffer::vertices(self.gl, Usage::Static, values)?;
        self.attach(&buffer, T::attribute(location));
        Ok(())
    }

    /// Adds numbers, which are written later.
    fn numbers(&mut self, mesh: &Mesh, facets: Option<&Facets>) -> Result<MeshNumbers, GpuError> {
        let numbers = MeshNumbers::new(self.gl, mesh, facets)?;
        self.attach(&numbers.buffer, Attribute::f32(NUMBER, 1));
        Ok(numbers)
    }

    fn moving(
        &mut self,
        geometry: &EvaluatedGeometry,
        facets: Option<&Facets>,
    ) -> Result<Moving, GpuError> {
        let usage = if geometry.deformation.is_some() {
            Usage::Stream
        } else {
            Usage::Static
        };
        let (positions, normals) = current_vertices(geometry, facets);
        let moving = Moving {
            revision: geometry.revision,
            positions: Buffer::vertices(self.gl, usage, &positions)?,
            normals: Buffer::vertices(self.gl, usage, &normals)?,
        };
        self.attach(&moving.positions, Attribute::f32(POSITION, 3));
        self.attach(&moving.normals, Attribute::f32(NORMAL, 3));
        Ok(moving)
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

/// Values of vertices in the order in which the mesh is uploaded.
pub(super) fn gathered<'a, T: Copy>(of_vertices: &'a [T], facets: Option<&Facets>) -> Cow<'a, [T]> {
    match facets {
        Some(facets) => facets.gather(of_vertices).into(),
        None => of_vertices.into(),
    }
}

/// Current positions and normals as they are uploaded.
fn current_vertices<'a>(
    geometry: &'a EvaluatedGeometry,
    facets: Option<&Facets>,
) -> (Cow<'a, [Vec3]>, Cow<'a, [Vec3]>) {
    let mesh = &geometry.mesh;
    let positions = mesh.at_vertices(geometry.positions());
    if let Some(facets) = facets {
        let normals = face_normals(geometry.positions(), &mesh.triangles);
        let normals = facets.at_last_corners(&normals);
        return (facets.gather(&positions).into(), normals.into());
    }
    let normals = geometry.normals().map_or_else(
        || {
            let normals = smooth_normals(geometry.positions(), &mesh.triangles);
            mesh.at_vertices(&normals).into_owned().into()
        },
        Cow::from,
    );
    (positions, normals)
}
