//! What all copies of a mesh share in the memory of the graphics card.

use super::mesh_cache::TextureCache;
use super::mesh_uploading::MeshUploading;
use super::skinning_tables::Skin;
use crate::character::Character;
use crate::geometry::{Facets, Mesh, Normals};
use crate::gpu::{Gl, GpuError, Texture, VertexArray};
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedGeometry, Shading, Skinning};
use std::rc::{Rc, Weak};
use std::sync::Arc;

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

    /// The character, if the vertex shader skins it.
    pub fn skinned(&self) -> Option<&Arc<Character>> {
        self.skinned.as_ref()
    }

    /// Whether the processor deforms it.
    pub fn moves(&self) -> bool {
        self.moves
    }

    /// Whether `mesh` is drawn with one normal a triangle.
    pub fn is_flat(&self, mesh: &Mesh) -> bool {
        match self.shading {
            Shading::AsAuthored => mesh.normals == Normals::Flat,
            Shading::Flat => true,
            Shading::Smooth => false,
        }
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
pub(super) struct MeshUploads {
    known: Vec<(MeshKey, Weak<MeshUpload>)>,
    /// One that is made part by part.
    begun: Option<MeshUploading>,
    /// Those that were made so and are not shared yet.
    fresh: Vec<Rc<MeshUpload>>,
}

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
        loop {
            if let Some(known) = self.known(key) {
                return Ok(known);
            }
            self.go_on(gl, key, geometry, textures, most_rows)?;
        }
    }

    /// Makes the next part of what [`MeshUploads::get`] returns; whether all of it is there.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn go_on(
        &mut self,
        gl: &Gl,
        key: &MeshKey,
        geometry: &EvaluatedGeometry,
        textures: &mut TextureCache,
        most_rows: u32,
    ) -> Result<bool, GpuError> {
        if self.known(key).is_some() {
            return Ok(true);
        }
        let begun = self.begun.take().filter(|begun| begun.key() == key);
        let mut next = match begun {
            Some(begun) => begun,
            None => MeshUploading::new(gl, key.clone(), geometry),
        };
        if !next.go_on(gl, geometry, most_rows)? {
            self.begun = Some(next);
            return Ok(false);
        }
        let mut upload = next.finish()?;
        upload.add_textures(gl, &geometry.mesh, textures);
        let upload = Rc::new(upload);
        self.known.push((key.clone(), Rc::downgrade(&upload)));
        self.fresh.push(upload);
        Ok(true)
    }

    fn known(&self, key: &MeshKey) -> Option<Rc<MeshUpload>> {
        let mut same = self.known.iter().filter(|(known, _)| known == key);
        same.find_map(|(_, known)| known.upgrade())
    }

    /// Drops what no mesh shares, or will share.
    pub fn forget_unused(&mut self) {
        self.begun = None;
        self.fresh.clear();
        self.known.retain(|(_, upload)| upload.strong_count() > 0);
    }
}

impl MeshUpload {
    /// Uploads it without textures, in one go. The table of a skin has at most `most_rows` rows.
    ///
    /// # Errors
    /// If the driver cannot take it.
    pub fn new(
        gl: &Gl,
        key: &MeshKey,
        geometry: &EvaluatedGeometry,
        most_rows: u32,
    ) -> Result<Self, GpuError> {
        let mut uploading = MeshUploading::new(gl, key.clone(), geometry);
        while !uploading.go_on(gl, geometry, most_rows)? {}
        uploading.finish()
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
