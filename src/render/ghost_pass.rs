//! Meshes that are drawn beside those of the scene.

use super::cached_mesh::CachedMesh;
use super::frame::{Frame, PassContext};
use super::mesh_upload::{MeshKey, MeshUpload};
use super::number_marks::{Ghost, GhostPaint};
use super::surface_pass::SurfacePass;
use crate::gpu::{Gl, GpuError};
use crate::scene::{EvaluatedGeometry, Shading, Skinning};
use glam::{Mat4, Vec3};
use std::rc::Rc;
use std::sync::Arc;

/// Opacity of a mesh that is seen through.
const ALPHA: f32 = 0.4;
/// How much farther away, in normalized depth, it counts where it lies on another mesh.
const BEHIND: f32 = 1e-4;

/// The uploads of ghosts.
#[derive(Debug, Default)]
pub(super) struct GhostPass {
    uploads: Vec<(Arc<EvaluatedGeometry>, CachedMesh)>,
}

impl GhostPass {
    /// Uploads the ghosts that are new and drops those that are gone.
    ///
    /// # Errors
    /// If the driver cannot take one of them.
    pub fn update(&mut self, gl: &Gl, frame: &Frame, most_rows: u32) -> Result<(), GpuError> {
        let ghosts = &frame.marks.ghosts;
        let is_shown = |geometry: &Arc<EvaluatedGeometry>| {
            let mut shown = ghosts.iter();
            shown.any(|ghost| Arc::ptr_eq(&ghost.geometry, geometry))
        };
        self.uploads.retain(|(geometry, _)| is_shown(geometry));
        for ghost in ghosts {
            if self.upload(ghost).is_none() {
                let (shading, skinning) = (Shading::AsAuthored, Skinning::Cpu);
                let geometry = &ghost.geometry;
                let key = MeshKey::new(geometry, shading, skinning);
                let upload = Rc::new(MeshUpload::new(gl, &key, geometry, most_rows)?);
                let upload = CachedMesh::new(gl, &upload, geometry, true)?;
                gl.check("uploading a mesh to compare")?;
                self.uploads.push((Arc::clone(geometry), upload));
            }
            if let GhostPaint::Numbers(numbers) = &ghost.paint {
                let mut uploads = self.uploads.iter_mut();
                let own = uploads.find(|(geometry, _)| Arc::ptr_eq(geometry, &ghost.geometry));
                if let Some((_, upload)) = own {
                    upload.update_numbers(&ghost.geometry.mesh, Some(numbers))?;
                }
            }
        }
        Ok(())
    }

    fn upload(&self, ghost: &Ghost) -> Option<&CachedMesh> {
        let mut uploads = self.uploads.iter();
        let own = uploads.find(|(geometry, _)| Arc::ptr_eq(geometry, &ghost.geometry));
        own.map(|(_, upload)| upload)
    }

    /// Draws the ghosts that are opaque.
    pub fn draw_opaque(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        surfaces: &SurfacePass,
    ) {
        for ghost in &frame.marks.ghosts {
            if let (GhostPaint::Numbers(_), Some(upload)) = (&ghost.paint, self.upload(ghost)) {
                surfaces.draw_numbered(gl, context, frame, upload, ghost.world_from_model);
            }
        }
    }

    /// Draws the ghosts that are seen through, over all that is opaque. Each is behind the surfaces
    /// that it lies on, so that where meshes agree nothing flickers.
    pub fn draw_translucent(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        surfaces: &SurfacePass,
    ) {
        let behind = Mat4::from_translation(Vec3::Z * BEHIND) * context.clip_from_world;
        let context = PassContext {
            clip_from_world: behind,
            ..*context
        };
        for ghost in &frame.marks.ghosts {
            if let (GhostPaint::Translucent(color), Some(upload)) =
                (&ghost.paint, self.upload(ghost))
            {
                let place = ghost.world_from_model;
                surfaces.draw_seen_through(gl, &context, frame, upload, place, (*color, ALPHA));
            }
        }
    }
}
