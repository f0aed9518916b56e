use super::axis_pass::draw_axis;
use super::background_pass::BackgroundPass;
use super::bone_lines::draw_bone_lines;
use super::curve_pass::CurvePass;
use super::floor_pass::FloorPass;
use super::frame::{Frame, PassContext};
use super::ground_pass::GroundPass;
use super::mesh_cache::MeshCache;
use super::outline_pass::OutlinePass;
use super::shadow_pass::ShadowPass;
use super::skeleton_pass::SkeletonPass;
use super::skinning_choice::SkinningChoice;
use super::surface_pass::SurfacePass;
use crate::gpu::{Framebuffer, Gl, GpuError, Immediate};
use crate::scene::Look;

/// Draws frames into pictures, and keeps what it uploaded for the next.
#[derive(Debug)]
pub struct Renderer {
    pub(super) gl: Gl,
    pub(super) meshes: MeshCache,
    pub(super) skinning: SkinningChoice,
    pub(super) notices: Vec<String>,
    background: BackgroundPass,
    pub(super) surfaces: SurfacePass,
    curves: CurvePass,
    skeletons: SkeletonPass,
    pub(super) shadows: ShadowPass,
    ground: GroundPass,
    floor: FloorPass,
    pub(super) outline: OutlinePass,
    immediate: Immediate,
}

impl Renderer {
    /// Compiles the shaders.
    ///
    /// # Errors
    /// When the driver refuses a shader or a buffer.
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        Ok(Self {
            gl: gl.clone(),
            meshes: MeshCache::new(gl.info().max_texture_size),
            skinning: SkinningChoice::automatic(gl.info()),
            notices: Vec::new(),
            background: BackgroundPass::new(gl)?,
            surfaces: SurfacePass::new(gl)?,
            curves: CurvePass::default(),
            skeletons: SkeletonPass::new(gl)?,
            shadows: ShadowPass::new(gl)?,
            ground: GroundPass::new(gl)?,
            floor: FloorPass::new(gl)?,
            outline: OutlinePass::new(gl)?,
            immediate: Immediate::new(gl)?,
        })
    }

    /// Draws the whole of `target` anew. Whatever state the context is in does not matter. What
    /// fails is left out, and all the rest is drawn.
    ///
    /// # Errors
    /// When something does not fit into the driver's memory or limits, or a GL error occurred:
    /// whatever was first.
    pub fn draw(&mut self, frame: &Frame, target: &Framebuffer) -> Result<(), GpuError> {
        // What others left behind is no fault of a mesh.
        let before = self.gl.check("what came before the scene");
        let updated = self.update_meshes(frame);
        self.curves.update(&self.gl, frame, &mut self.immediate);
        let drawn = self.draw_passes(frame, target);
        let after = self.gl.check("drawing the scene");
        let mut parts = self.meshes.left_out(frame);
        parts.extend(self.curves.left_out(frame));
        let whole = if parts.is_empty() {
            Ok(())
        } else {
            Err(GpuError::LeftOut { parts })
        };
        before.and(updated).and(whole).and(drawn).and(after)
    }

    fn draw_passes(&mut self, frame: &Frame, target: &Framebuffer) -> Result<(), GpuError> {
        let Self {
            gl,
            meshes,
            immediate,
            ..
        } = self;
        let (width, height) = (target.width(), target.height());
        let camera = &frame.view.camera;
        let aspect = width as f32 / height as f32;
        let clip_from_world = camera.clip_from_world(aspect);
        let context = PassContext {
            width,
            height,
            clip_from_world,
            ground: meshes.ground_height(frame.evaluated),
        };

        self.background.draw(gl, &context, frame.view.look, target);
        let is_mannequin = frame.view.look == Look::Mannequin;
        if frame.view.grid && is_mannequin {
            self.floor.draw(gl, &context, camera);
        }
        if frame.view.axis {
            draw_axis(gl, immediate, &context);
        }
        let mut drawn = Ok(());
        self.surfaces.draw_opaque(gl, &context, frame, meshes);
        self.curves.draw(gl, &context, frame, immediate);
        if is_mannequin {
            draw_bone_lines(gl, &context, frame, immediate);
        } else {
            drawn = self.skeletons.draw(gl, &context, frame, immediate);
            self.surfaces.draw_translucent(gl, &context, frame, meshes);
        }
        if frame.view.grid && frame.view.look == Look::Studio {
            let shadows = self.shadows.draw(gl, &context, frame, meshes);
            let (shadows, result) = match shadows {
                Ok(shadows) => (Some(shadows), Ok(())),
                Err(error) => (None, Err(error)),
            };
            drawn = drawn.and(result);
            self.ground.draw(gl, &context, camera, shadows, target);
        }
        let outlined = self.outline.draw(
            gl,
            &context,
            frame,
            meshes,
            (&mut self.skeletons, immediate),
            target,
        );
        drawn.and(outlined)
    }
}
