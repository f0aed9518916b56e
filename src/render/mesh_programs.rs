//! Shader programs that draw meshes.

use super::cached_mesh::{CachedMesh, MeshKind};
use crate::gpu::{Gl, GpuError, Program};

/// A fragment shader with each of the vertex shaders for meshes: the plain one, and those that
/// skin.
#[derive(Debug)]
pub(super) struct MeshPrograms {
    label: &'static str,
    fragment: String,
    plain: Program,
    /// Compiled when first needed, which is never on software OpenGL.
    skinned: Option<[Program; 2]>,
}

impl MeshPrograms {
    /// Those for plain meshes; see [`MeshPrograms::add_skinned`].
    pub fn new(gl: &Gl, label: &'static str, fragment: &str) -> Self {
        let vertex = include_str!("../../shaders/surface_vertex.glsl");
        Self {
            label,
            fragment: fragment.to_owned(),
            plain: Program::when_used(gl, label, vertex, fragment),
            skinned: None,
        }
    }

    /// Compiles the programs for skinned meshes, unless that is done.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        if self.skinned.is_none() {
            let program = |kind: &str, vertex: &str| {
                Program::new(
                    gl,
                    &format!("{kind} {}", self.label),
                    vertex,
                    &self.fragment,
                )
            };
            self.skinned = Some([
                program("skinned", SMOOTH)?,
                program("skinned, facetted", FACETTED)?,
            ]);
        }
        Ok(())
    }

    /// All programs, for uniforms that they share.
    pub fn all(&self) -> impl Iterator<Item = &Program> {
        std::iter::once(&self.plain).chain(self.skinned.iter().flatten())
    }

    /// The program that draws `mesh`.
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
