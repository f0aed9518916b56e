use crate::geometry::{Normals, Revision, SharedMesh, smooth_normals};
use crate::gpu::{Attribute, Buffer, Gl, GpuError, IndexBuffer, Usage, VertexArray};
use crate::scene::{Evaluated, EvaluatedGeometry, Shading, ShapeId};
use glam::Vec3;
use std::collections::HashMap;

/// The meshes of a scene in the memory of the graphics card. Only what has a new revision is
/// uploaded: a shape that nobody touches costs nothing but its draw.
#[derive(Debug, Default)]
pub(super) struct MeshCache {
    meshes: HashMap<ShapeId, CachedMesh>,
}

/// One shape's mesh, ready to be drawn.
#[derive(Debug)]
pub(super) struct CachedMesh {
    pub vertex_array: VertexArray,
    /// Whether `vertex_array` has normals; otherwise the surface is drawn facetted.
    pub has_normals: bool,
    mesh: Revision,
    positions: Revision,
    shading: Shading,
    position_buffer: Buffer<Vec3>,
    normal_buffer: Option<Buffer<Vec3>>,
}

impl MeshCache {
    /// Brings all shapes up to date and forgets those that are gone.
    pub fn update(
        &mut self,
        gl: &Gl,
        evaluated: &Evaluated,
        shading: Shading,
    ) -> Result<(), GpuError> {
        self.meshes.retain(|&id, _| evaluated.shape(id).is_some());
        for shape in &evaluated.shapes {
            let geometry = &shape.geometry;
            match self.meshes.get_mut(&shape.id) {
                Some(cached) if cached.fits(&geometry.mesh, shading) => {
                    cached.update_positions(geometry)?;
                }
                _ => {
                    self.meshes
                        .insert(shape.id, CachedMesh::new(gl, geometry, shading)?);
                }
            }
        }
        Ok(())
    }

    pub fn get(&self, id: ShapeId) -> Option<&CachedMesh> {
        self.meshes.get(&id)
    }
}

impl CachedMesh {
    fn new(gl: &Gl, geometry: &EvaluatedGeometry, shading: Shading) -> Result<Self, GpuError> {
        let mesh = &geometry.mesh;
        let usage = if geometry.skinned.is_some() {
            Usage::Stream
        } else {
            Usage::Static
        };
        let position_buffer = Buffer::vertices(gl, usage, geometry.positions())?;
        let normal_buffer = normals(geometry, shading)
            .map(|normals| Buffer::vertices(gl, usage, &normals))
            .transpose()?;
        let indices: &[u32] = mesh.triangles.as_flattened();
        let index_buffer = IndexBuffer::new(gl, Usage::Static, indices)?;
        let mut builder = VertexArray::builder(gl)
            .attribute(&position_buffer, Attribute::f32(0, 3))
            .indices(&index_buffer);
        if let Some(normals) = &normal_buffer {
            builder = builder.attribute(normals, Attribute::f32(1, 3));
        }
        Ok(Self {
            vertex_array: builder.build()?,
            has_normals: normal_buffer.is_some(),
            mesh: mesh.revision(),
            positions: geometry.revision,
            shading,
            position_buffer,
            normal_buffer,
        })
    }

    fn fits(&self, mesh: &SharedMesh, shading: Shading) -> bool {
        self.mesh == mesh.revision() && self.shading == shading
    }

    fn update_positions(&mut self, geometry: &EvaluatedGeometry) -> Result<(), GpuError> {
        if self.positions == geometry.revision {
            return Ok(());
        }
        self.position_buffer.update(geometry.positions())?;
        if let (Some(buffer), Some(normals)) =
            (&self.normal_buffer, normals(geometry, self.shading))
        {
            buffer.update(&normals)?;
        }
        self.positions = geometry.revision;
        Ok(())
    }
}

/// One normal a vertex; `None` where every triangle has its own, which the fragment shader finds
/// from the current positions.
fn normals(geometry: &EvaluatedGeometry, shading: Shading) -> Option<Vec<Vec3>> {
    let authored = match &geometry.mesh.normals {
        Normals::PerVertex(normals) => Some(normals),
        Normals::Flat => None,
    };
    match (shading, authored) {
        (Shading::Flat, _) | (Shading::AsAuthored, None) => None,
        (_, Some(normals)) if geometry.skinned.is_none() => Some(normals.clone()),
        _ => Some(smooth_normals(
            geometry.positions(),
            &geometry.mesh.triangles,
        )),
    }
}
