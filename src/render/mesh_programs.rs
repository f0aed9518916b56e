use super::cached_mesh::{CachedMesh, MeshKind};
use crate::gpu::{Gl, GpuError, Program};

/// One way to draw surfaces, for meshes that come as they are and for those that are skinned on
/// the way: a fragment shader under each of the vertex shaders.
#[derive(Debug)]
pub(super) struct MeshPrograms {
    label: &'static str,
    fragment: &'static str,
    plain: Program,
    /// Compiled when they are first needed: on software OpenGL they never are.
    skinned: Option<[Program; 2]>,
}

impl MeshPrograms {
    /// For meshes that come as they are; see [`MeshPrograms::add_skinned`].
    pub fn new(gl: &Gl, label: &'static str, fragment: &'static str) -> Result<Self, GpuError> {
        let vertex = include_str!("../../shaders/surface_vertex.glsl");
        Ok(Self {
            label,
            fragment,
            plain: Program::new(gl, label, vertex, fragment)?,
            skinned: None,
        })
    }

    /// For skinned meshes too, from now on.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        if self.skinned.is_none() {
            let program = |kind: &str, vertex: &str| {
                Program::new(gl, &format!("{kind} {}", self.label), vertex, self.fragment)
            };
            self.skinned = Some([
                program("skinned", SMOOTH)?,
                program("skinned, facetted", FACETTED)?,
            ]);
        }
        Ok(())
    }

    /// All of them, to be told what they share.
    pub fn all(&self) -> impl Iterator<Item = &Program> {
        std::iter::once(&self.plain).chain(self.skinned.iter().flatten())
    }

    /// The one that draws `mesh`.
    pub fn of(&self, mesh: &CachedMesh) -> &Program {
        match (mesh.kind(), &self.skinned) {
            (MeshKind::Skinned, Some([smooth, _])) => smooth,
            (MeshKind::SkinnedFacets, Some([_, facetted])) => facetted,
            _ => &self.plain,
        }
    }
}

/// Vertex shader of [`MeshKind::Skinned`].
pub(super) const SMOOTH: &str = concat!(
    include_str!("../../shaders/skinning.glsl"),
    include_str!("../../shaders/skinned_vertex.glsl")
);
/// Vertex shader of [`MeshKind::SkinnedFacets`].
pub(super) const FACETTED: &str = concat!(
    include_str!("../../shaders/skinning.glsl"),
    include_str!("../../shaders/skinned_facets_vertex.glsl")
);
