//! The numbers of the vertices of one mesh in the memory of the graphics card.

use super::cached_mesh::gathered;
use crate::geometry::{Facets, Mesh};
use crate::gpu::{Buffer, Gl, GpuError, Usage};
use crate::scene::VertexNumbers;
use std::sync::Arc;

/// Numbers that a mesh can be colored by.
#[derive(Debug)]
pub(super) struct MeshNumbers {
    /// Those that were written; `None` before any were, or while the mesh has its own colors.
    written: Option<Arc<VertexNumbers>>,
    pub buffer: Buffer<f32>,
}

impl MeshNumbers {
    /// Room for the numbers of `mesh`, which is uploaded as its `facets` if it has some.
    pub fn new(gl: &Gl, mesh: &Mesh, facets: Option<&Facets>) -> Result<Self, GpuError> {
        let none = vec![0.0; mesh.vertex_count()];
        Ok(Self {
            written: None,
            buffer: Buffer::vertices(gl, Usage::Stream, &gathered(&none, facets))?,
        })
    }

    /// The numbers that were written last, unless the mesh has its own colors again.
    pub fn written(&self) -> Option<&VertexNumbers> {
        self.written.as_deref()
    }

    /// Writes the numbers of the positions of `mesh`, unless they were. Those of another mesh have no
    /// place in it.
    pub fn update(
        &mut self,
        mesh: &Mesh,
        facets: Option<&Facets>,
        wanted: Option<&Arc<VertexNumbers>>,
    ) -> Result<(), GpuError> {
        let wanted = wanted.filter(|wanted| wanted.values.len() == mesh.positions.len());
        let Some(wanted) = wanted else {
            self.written = None;
            return Ok(());
        };
        let written = self.written.as_ref();
        if !written.is_some_and(|written| Arc::ptr_eq(written, wanted)) {
            let values = mesh.at_vertices(&wanted.values);
            self.buffer.update(&gathered(&values, facets))?;
            self.written = Some(Arc::clone(wanted));
        }
        Ok(())
    }
}
