use crate::geometry::{Facets, Normals, Revision, SharedMesh, face_normals, smooth_normals};
use crate::gpu::{Attribute, Buffer, Gl, GpuError, IndexBuffer, Usage, VertexArray};
use crate::scene::{Evaluated, EvaluatedGeometry, Shading, ShapeId};
use glam::Vec3;
use std::borrow::Cow;
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
    /// How the mesh was rearranged to be drawn facetted; `None` if it is drawn smooth.
    facets: Option<Facets>,
    mesh: Revision,
    positions: Revision,
    shading: Shading,
    position_buffer: Buffer<Vec3>,
    normal_buffer: Buffer<Vec3>,
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
        let usage = if geometry.deformation.is_some() {
            Usage::Stream
        } else {
            Usage::Static
        };
        let is_flat = match shading {
            Shading::AsAuthored => mesh.normals == Normals::Flat,
            Shading::Flat => true,
            Shading::Smooth => false,
        };
        let triangles = mesh.vertex_triangles();
        let facets = is_flat.then(|| Facets::new(mesh.vertex_count(), triangles));
        let (positions, normals) = vertices(geometry, facets.as_ref());
        let position_buffer = Buffer::vertices(gl, usage, &positions)?;
        let normal_buffer = Buffer::vertices(gl, usage, &normals)?;
        let drawn = facets
            .as_ref()
            .map_or(triangles, |facets| &facets.triangles);
        let index_buffer = IndexBuffer::new(gl, Usage::Static, drawn.as_flattened())?;
        let vertex_array = VertexArray::builder(gl)
            .attribute(&position_buffer, Attribute::f32(0, 3))
            .attribute(&normal_buffer, Attribute::f32(1, 3))
            .indices(&index_buffer)
            .build()?;
        Ok(Self {
            vertex_array,
            facets,
            mesh: mesh.revision(),
            positions: geometry.revision,
            shading,
            position_buffer,
            normal_buffer,
        })
    }

    /// Whether each triangle has one normal, which its last corner carries.
    pub fn is_flat(&self) -> bool {
        self.facets.is_some()
    }

    fn fits(&self, mesh: &SharedMesh, shading: Shading) -> bool {
        self.mesh == mesh.revision() && self.shading == shading
    }

    fn update_positions(&mut self, geometry: &EvaluatedGeometry) -> Result<(), GpuError> {
        if self.positions == geometry.revision {
            return Ok(());
        }
        let (positions, normals) = vertices(geometry, self.facets.as_ref());
        self.position_buffer.update(&positions)?;
        self.normal_buffer.update(&normals)?;
        self.positions = geometry.revision;
        Ok(())
    }
}

/// Current positions and normals as they are uploaded.
fn vertices<'a>(
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
