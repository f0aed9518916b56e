use super::palettes::Palettes;
use super::skin::{Run, Skin};
use super::texture_cache::TextureCache;
use crate::geometry::{Facets, Mesh, Normals, face_normals, smooth_normals};
use crate::gpu::{
    Attribute, Buffer, Gl, GpuError, IndexBuffer, Program, Texture, Usage, VertexArray,
    VertexArrayBuilder,
};
use crate::math::Aabb;
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedGeometry, Shading, ShapeId, Skinning};
use bytemuck::Pod;
use glam::{Vec2, Vec3};
use std::borrow::Cow;
use std::rc::Rc;

/// Where the vertex shaders of `surface_vertex.glsl` and its kin find what a vertex carries.
const POSITION: u32 = 0;
const NORMAL: u32 = 1;
const RUN: u32 = 2;
const FIRST_POSITION: u32 = 3;
const FIRST_RUN: u32 = 4;
const SECOND_POSITION: u32 = 5;
const SECOND_RUN: u32 = 6;
const TEXTURE_COORDINATES: u32 = 7;

/// Texture units of a skinned mesh; unit 0 is its material's.
const PALETTES: u32 = 1;
const INFLUENCES: u32 = 2;

/// One shape's mesh, ready to be drawn.
#[derive(Debug)]
pub(super) struct CachedMesh {
    pub vertex_array: VertexArray,
    /// The weights, where the vertex shader moves the mesh; it is uploaded in its bind pose then.
    pub skin: Option<Skin>,
    /// The picture of each of the mesh's material groups, where it has one.
    pub textures: Vec<Option<Rc<Texture>>>,
    /// Around the mesh at rest, in model space.
    pub rest_bounds: Aabb,
    /// How the mesh was rearranged to be drawn facetted; `None` if it is drawn smooth.
    facets: Option<Facets>,
    mesh: Revision,
    shading: Shading,
    /// What is written again when the positions change, and which ones it holds.
    moving: Option<Moving>,
}

/// Current positions and normals of a mesh that the processor moves, or that nothing does.
#[derive(Debug)]
struct Moving {
    revision: Revision,
    positions: Buffer<Vec3>,
    normals: Buffer<Vec3>,
}

/// Which vertex shader a mesh is for.
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
    /// Uploads the mesh. A skin's table has at most `most_rows` rows.
    pub fn new(
        gl: &Gl,
        geometry: &EvaluatedGeometry,
        shading: Shading,
        skinning: Skinning,
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
            rest_bounds: mesh.bounds(),
            facets,
            mesh: mesh.revision(),
            shading,
            moving,
        })
    }

    /// Uploads the pictures of the materials of `mesh`, which this is. One on a mesh without texture
    /// coordinates cannot be shown.
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

    /// Which vertex shader draws it.
    pub fn kind(&self) -> MeshKind {
        match (&self.skin, self.is_flat()) {
            (None, _) => MeshKind::Plain,
            (Some(_), false) => MeshKind::Skinned,
            (Some(_), true) => MeshKind::SkinnedFacets,
        }
    }

    /// Lets `program`, which is one for its kind of mesh, find its joints, those of shape `id`.
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

    /// Whether it is of this geometry, whatever its pose, and drawn in this way.
    pub fn fits(&self, geometry: &EvaluatedGeometry, shading: Shading, skinning: Skinning) -> bool {
        let skin_fits = match (&self.skin, deformation_to_skin(geometry, shading, skinning)) {
            (Some(skin), Some(deformation)) => skin.is_of(deformation.character()),
            (skin, deformation) => skin.is_none() && deformation.is_none(),
        };
        skin_fits && self.mesh == geometry.mesh.revision() && self.shading == shading
    }

    /// Uploads new positions, if it holds others and the vertex shader does not make them. Whether
    /// it did.
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

/// What the vertex shader is to do, if anything.
fn deformation_to_skin(
    geometry: &EvaluatedGeometry,
    shading: Shading,
    skinning: Skinning,
) -> Option<&Deformation> {
    let needs_sums = geometry.mesh.normals == Normals::Flat && shading == Shading::Smooth;
    geometry
        .deformation
        .as_ref()
        .filter(|_| skinning == Skinning::Gpu && !needs_sums)
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

    /// Something that never changes.
    fn attribute<T: Carried>(&mut self, values: &[T], location: u32) -> Result<(), GpuError> {
        let buffer = Buffer::vertices(self.gl, Usage::Static, values)?;
        self.attach(&buffer, T::attribute(location));
        Ok(())
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

    /// The mesh at rest with its influences; facetted, every last corner knows the other two.
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

/// What vertices carry that never changes.
trait Carried: Pod {
    fn attribute(location: u32) -> Attribute;
}

impl Carried for Vec3 {
    fn attribute(location: u32) -> Attribute {
        Attribute::f32(location, 3)
    }
}

impl Carried for Vec2 {
    fn attribute(location: u32) -> Attribute {
        Attribute::f32(location, 2)
    }
}

impl Carried for Run {
    fn attribute(location: u32) -> Attribute {
        Attribute::u32(location, 2)
    }
}

fn gathered<'a, T: Copy>(of_vertices: &'a [T], facets: Option<&Facets>) -> Cow<'a, [T]> {
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
