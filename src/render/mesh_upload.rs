//! What all copies of a mesh share in the memory of the graphics card.

use super::cached_mesh::{NORMAL, POSITION, current_vertices, gathered};
use super::mesh_cache::TextureCache;
use super::skinning_tables::{Run, Skin};
use crate::character::Character;
use crate::geometry::{Facets, Mesh, Normals};
use crate::gpu::{
    Attribute, Buffer, Gl, GpuError, IndexBuffer, Texture, Usage, VertexArray, VertexArrayBuilder,
};
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedGeometry, Shading, Skinning};
use bytemuck::Pod;
use glam::{Vec2, Vec3};
use std::rc::{Rc, Weak};
use std::sync::Arc;

/// Attribute locations in `skinned_vertex.glsl` and the other vertex shaders of meshes.
const RUN: u32 = 2;
const FIRST_POSITION: u32 = 3;
const FIRST_RUN: u32 = 4;
const SECOND_POSITION: u32 = 5;
const SECOND_RUN: u32 = 6;
const TEXTURE_COORDINATES: u32 = 7;

/// Everything about a mesh that does not change with a pose, once for all its copies.
#[derive(Debug)]
pub(super) struct MeshUpload {
    /// Indices and attributes that never change: all of a mesh that the vertex shader skins, or that
    /// nothing deforms.
    pub vertex_array: Rc<VertexArray>,
    /// The weights, if the vertex shader skins the mesh; it is then uploaded in its bind pose.
    pub skin: Option<Skin>,
    /// Rearrangement of the mesh for facetted drawing; `None` if it is drawn smooth.
    pub facets: Option<Facets>,
    /// The texture of each material group of the mesh, where it has one.
    pub textures: Vec<Option<Rc<Texture>>>,
}

/// Identity of an upload.
#[derive(Clone, Debug)]
pub(super) struct MeshKey {
    mesh: Revision,
    shading: Shading,
    /// Whether the processor deforms it.
    moves: bool,
    /// The character, if the vertex shader skins it.
    skinned: Option<Arc<Character>>,
}

impl MeshKey {
    pub fn new(geometry: &EvaluatedGeometry, shading: Shading, skinning: Skinning) -> Self {
        let deformation = deformation_to_skin(geometry, shading, skinning);
        Self {
            mesh: geometry.mesh.revision(),
            shading,
            moves: deformation.is_none() && geometry.deformation.is_some(),
            skinned: deformation.map(|deformation| deformation.character().clone()),
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
        let rest = |key: &Self| (key.mesh, key.shading, key.moves);
        is_same_skin && rest(self) == rest(other)
    }
}

/// The uploads that meshes share, for as long as one of them is there.
#[derive(Debug, Default)]
pub(super) struct MeshUploads(Vec<(MeshKey, Weak<MeshUpload>)>);

impl MeshUploads {
    /// The upload of `key`, which is that of `geometry`, made if there is none. The table of a skin has
    /// at most `most_rows` rows.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn get(
        &mut self,
        gl: &Gl,
        key: &MeshKey,
        geometry: &EvaluatedGeometry,
        textures: &mut TextureCache,
        most_rows: u32,
    ) -> Result<Rc<MeshUpload>, GpuError> {
        let mut same = self.0.iter().filter(|(known, _)| known == key);
        if let Some(known) = same.find_map(|(_, known)| known.upgrade()) {
            return Ok(known);
        }
        let mut upload = MeshUpload::new(gl, key, geometry, most_rows)?;
        upload.add_textures(gl, &geometry.mesh, textures);
        let upload = Rc::new(upload);
        self.0.push((key.clone(), Rc::downgrade(&upload)));
        Ok(upload)
    }

    /// Drops what no mesh shares any more.
    pub fn forget_unused(&mut self) {
        self.0.retain(|(_, upload)| upload.strong_count() > 0);
    }
}

impl MeshUpload {
    /// Uploads it without textures. The table of a skin has at most `most_rows` rows.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn new(
        gl: &Gl,
        key: &MeshKey,
        geometry: &EvaluatedGeometry,
        most_rows: u32,
    ) -> Result<Self, GpuError> {
        let mesh = &geometry.mesh;
        let triangles = mesh.vertex_triangles();
        let is_flat = is_flat(mesh, key.shading);
        let facets = is_flat.then(|| Facets::new(mesh.vertex_count(), triangles));
        let drawn = facets.as_ref().map_or(triangles, |f| &f.triangles);
        let indices = IndexBuffer::new(gl, Usage::Static, drawn.as_flattened())?;
        let mut layout = Layout {
            gl,
            builder: VertexArray::builder(gl).indices(&indices),
        };
        if !mesh.texture_coordinates.is_empty() {
            let coordinates = gathered(&mesh.texture_coordinates, facets.as_ref());
            layout.attribute(&coordinates, TEXTURE_COORDINATES)?;
        }
        let mut skin = None;
        if let Some(character) = &key.skinned {
            let (its, runs) = Skin::new(gl, character, most_rows)?;
            layout.bind_pose(mesh, facets.as_ref(), &runs)?;
            skin = Some(its);
        } else if !key.moves {
            let (positions, normals) = current_vertices(geometry, facets.as_ref());
            layout.attribute(&positions, POSITION)?;
            layout.attribute(&normals, NORMAL)?;
        }
        Ok(Self {
            vertex_array: Rc::new(layout.builder.build()?),
            skin,
            facets,
            textures: Vec::new(),
        })
    }

    /// Uploads the pictures of the materials of `mesh`, of which this is the upload. Without texture
    /// coordinates none can be shown.
    fn add_textures(&mut self, gl: &Gl, mesh: &Mesh, textures: &mut TextureCache) {
        if mesh.texture_coordinates.is_empty() {
            return;
        }
        self.textures = mesh
            .groups
            .iter()
            .map(|group| textures.texture(gl, group.material.texture.as_ref()?))
            .collect();
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

impl Layout<'_> {
    /// Adds an attribute that never changes.
    fn attribute<T: FixedAttribute>(
        &mut self,
        values: &[T],
        location: u32,
    ) -> Result<(), GpuError> {
        let buffer = Buffer::vertices(self.gl, Usage::Static, values)?;
        let empty = VertexArray::builder(self.gl);
        let builder = std::mem::replace(&mut self.builder, empty);
        self.builder = builder.attribute(&buffer, T::attribute(location));
        Ok(())
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
