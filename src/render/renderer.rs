//! The renderer: frames in, pictures out.

use super::backdrop_pass::{BackgroundPass, FloorPass};
use super::coarse_meshes::CoarseMeshes;
use super::curve_pass::CurvePass;
use super::frame::{Background, Frame, PassContext};
use super::ghost_pass::GhostPass;
use super::ground_pass::{GroundPass, ShadowPass};
use super::mesh_cache::MeshCache;
use super::outline_pass::OutlinePass;
use super::passes::Passes;
use super::samples::Samples;
use super::sight::Sight;
use super::skeleton_pass::SkeletonPass;
use super::skinning_choice::SkinningChoice;
use super::still_layer::StillLayer;
use super::surface_pass::SurfacePass;
use super::tile::Tile;
use crate::gpu::{Framebuffer, Gl, GpuError, Immediate};

/// Why a picture is not, or not as a whole, as it should be.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// Parts that could not be drawn, while all the rest was.
    #[error("not everything is shown: {}", parts.join("; "))]
    LeftOut {
        /// One entry a part, with its reason.
        parts: Vec<String>,
    },
    /// A failure of OpenGL.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Draws frames into pictures, and keeps what it uploaded for the next.
#[derive(Debug)]
pub struct Renderer {
    pub(super) gl: Gl,
    pub(super) meshes: MeshCache,
    pub(super) coarse: CoarseMeshes,
    pub(super) skinning: SkinningChoice,
    pub(super) notices: Vec<String>,
    pub(super) background: BackgroundPass,
    pub(super) surfaces: SurfacePass,
    pub(super) curves: CurvePass,
    pub(super) ghosts: GhostPass,
    pub(super) skeletons: SkeletonPass,
    pub(super) shadows: ShadowPass,
    pub(super) ground: GroundPass,
    pub(super) floor: FloorPass,
    pub(super) outline: OutlinePass,
    pub(super) layer: StillLayer,
    pub(super) immediate: Immediate,
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
            coarse: CoarseMeshes::new(gl.info().max_texture_size),
            skinning: SkinningChoice::automatic(gl.info()),
            notices: Vec::new(),
            background: BackgroundPass::new(gl)?,
            surfaces: SurfacePass::new(gl),
            curves: CurvePass::default(),
            ghosts: GhostPass::default(),
            skeletons: SkeletonPass::new(gl)?,
            shadows: ShadowPass::new(gl),
            ground: GroundPass::new(gl)?,
            floor: FloorPass::new(gl)?,
            outline: OutlinePass::new(gl)?,
            layer: StillLayer::default(),
            immediate: Immediate::new(gl)?,
        })
    }

    /// Draws the whole of `target` anew, whatever state the context is in. Parts that fail are left
    /// out, and all the rest is drawn.
    ///
    /// # Errors
    /// When something does not fit into the driver's memory or limits, or a GL error occurred: the
    /// first of these.
    pub fn draw(&mut self, frame: &Frame, target: &Framebuffer) -> Result<(), RenderError> {
        self.come_to_rest(frame);
        let tile = Tile::whole((target.width(), target.height()));
        self.draw_tile(frame, target, tile, Background::Look)
    }

    /// Frees what only pictures of something that moves need, and of it what belongs to shapes that are gone.
    pub(super) fn come_to_rest(&mut self, frame: &Frame) {
        self.layer = StillLayer::default();
        self.coarse.forget_deleted(frame.evaluated);
    }

    /// As [`Renderer::draw`], but only the part `tile` of the picture, which `target` is as large as.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub(super) fn draw_tile(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        tile: Tile,
        background: Background,
    ) -> Result<(), RenderError> {
        self.draw_by(frame, target, (tile, background), |renderer, context| {
            renderer.draw_passes(frame, target, context, Passes::All)
        })
    }

    /// Draws a part of a frame by `passes`, after what is seen of its meshes was uploaded.
    pub(super) fn draw_by(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        (tile, background): (Tile, Background),
        passes: impl FnOnce(&mut Self, &PassContext) -> Result<(), GpuError>,
    ) -> Result<(), RenderError> {
        // Faults that came before are not those of a mesh.
        let before = self.gl.check("what came before the scene");
        let marked = self.prepare_marks(frame);
        let mut context = self.context(frame, target, tile, background);
        let mut updated = self.update_meshes(frame, &Sight::new(&context, frame));
        let grounded = self.context(frame, target, tile, background);
        // Without a mesh that the driver refused the ground, and so what has its shadow there, is another.
        if grounded.ground != context.ground {
            context = grounded;
            updated = updated.and(self.update_meshes(frame, &Sight::new(&context, frame)));
        }
        let chosen = self.choose_triangles(frame, &context, target.samples() > 0);
        self.curves.update(&self.gl, frame, &mut self.immediate);
        let drawn = chosen.and_then(|()| passes(self, &context));
        let after = self.gl.check("drawing the scene");
        before.and(updated).and(marked)?;
        let mut parts = self.meshes.left_out(frame);
        parts.extend(self.curves.left_out(frame));
        if !parts.is_empty() {
            return Err(RenderError::LeftOut { parts });
        }
        Ok(drawn.and(after)?)
    }

    /// Leaves out what is not seen of meshes. Software OpenGL spends most of its time on triangles, also
    /// on those in which there is no sample; a graphics card takes them as they come.
    pub(super) fn choose_triangles(
        &mut self,
        frame: &Frame,
        context: &PassContext,
        has_samples: bool,
    ) -> Result<(), GpuError> {
        let info = self.gl.info();
        let middle = info.is_software.then(|| Samples::middle(info));
        let of_surfaces = middle.as_ref().filter(|_| !has_samples);
        let sight = Sight::new(context, frame);
        let size = [context.width, context.height];
        let samples = (of_surfaces, middle.as_ref());
        (self.meshes).choose_triangles(&self.gl, frame, &sight, size, samples)
    }

    pub(super) fn context(
        &self,
        frame: &Frame,
        target: &Framebuffer,
        tile: Tile,
        background: Background,
    ) -> PassContext {
        let camera = &frame.view.camera;
        PassContext {
            width: target.width(),
            height: target.height(),
            tile,
            background,
            clip_from_world: tile.clip_from_whole() * camera.clip_from_world(tile.aspect()),
            ground: self.meshes.ground_height(frame.evaluated),
            colors: frame.backdrop.colors(frame.view.look),
        }
    }

    /// Notices for the user about how pictures are drawn, each once.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// Compiles and uploads what the marks of `frame` change about meshes, if anything.
    fn prepare_marks(&mut self, frame: &Frame) -> Result<(), GpuError> {
        if frame.marks.change_meshes() {
            self.surfaces.add_number_colors(&self.gl)?;
        }
        let most_rows = self.gl.info().max_texture_size;
        self.ghosts.update(&self.gl, frame, most_rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::{Basis, Mesh, Picture};
    use crate::gpu::test_driver::TestDriver;
    use crate::gpu::{Backend, HeadlessContext};
    use crate::render::read_picture;
    use crate::scene::{
        CharacterShape, CurveSet, CurveShape, Evaluator, NewShape, Scene, ShapeKind, Skinning,
        ViewSettings,
    };
    use glam::Vec3;
    use std::sync::Arc;

    fn moved_triangle() -> Scene {
        let skeleton = SkeletalModel::new(vec![Joint::default()]).unwrap();
        let mut attachments = Attachments::new();
        for _ in 0..3 {
            attachments.push_vertex([Influence {
                joint: 0,
                weight: 1.0,
            }]);
        }
        let mesh = Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]);
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = Pose::new();
        pose.set_root_offset(0, -Vec3::X);
        shape.set_pose(pose);
        let mut scene = Scene::new();
        scene.add(NewShape::new("Triangle", ShapeKind::Character(shape)));
        scene
    }

    fn picture(renderer: &mut Renderer, gl: &Gl, scene: &Scene) -> Picture {
        let (result, picture) = drawn(renderer, gl, scene);
        result.unwrap();
        picture
    }

    fn drawn(
        renderer: &mut Renderer,
        gl: &Gl,
        scene: &Scene,
    ) -> (Result<(), RenderError>, Picture) {
        let evaluated = Evaluator::new().evaluate(scene, 0.0);
        let view = ViewSettings::default();
        let frame = Frame::plain(scene, &evaluated, &view);
        let target = Framebuffer::new(gl, 64, 48, 0).unwrap();
        let result = renderer.draw(&frame, &target);
        (result, read_picture(&target).unwrap())
    }

    #[test]
    fn shaders_are_compiled_when_a_picture_needs_them() {
        let driver = TestDriver::new();
        let gl = driver.gl();
        let mut renderer = Renderer::new(gl).unwrap();
        renderer.set_skinning(Some(Skinning::Cpu));
        assert_eq!(TestDriver::linked(), 0);
        let scene = moved_triangle();
        picture(&mut renderer, gl, &scene);
        let first = TestDriver::linked();
        // In the Course look: the surface and the axes.
        assert_eq!(first, 2);
        picture(&mut renderer, gl, &scene);
        assert_eq!(TestDriver::linked(), 0);
    }

    #[test]
    fn what_the_driver_cannot_hold_is_skinned_by_the_processor_and_reported_once() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let scene = moved_triangle();
        let mut limited = Renderer::new(gl).unwrap();
        limited.meshes = MeshCache::new(0);
        assert!(limited.set_skinning(Some(Skinning::Gpu)) || !gl.info().is_software);
        let fallen_back = picture(&mut limited, gl, &scene);
        let notices = limited.take_notices();
        assert_eq!(notices.len(), 1, "{notices:?}");
        assert!(notices[0].contains("the processor does"), "{notices:?}");
        assert_eq!(limited.skinning(), Skinning::Cpu);
        assert_eq!(picture(&mut limited, gl, &scene), fallen_back);
        assert!(limited.take_notices().is_empty());

        let mut plain = Renderer::new(gl).unwrap();
        plain.set_skinning(Some(Skinning::Cpu));
        assert_eq!(picture(&mut plain, gl, &scene), fallen_back);
    }

    #[test]
    fn a_mesh_that_the_driver_cannot_take_is_left_out_and_named_and_all_else_is_drawn() {
        let driver = TestDriver::new();
        let gl = driver.gl();
        let mut scene = Scene::new();
        let cube = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        scene.shape_mut(cube).unwrap().placement.transform.position = Vec3::X;
        let alone = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);
        scene.add(NewShape::new("Ball", ShapeKind::Sphere));
        let both = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);

        let mut renderer = Renderer::new(gl).unwrap();
        TestDriver::limit_buffers(2000);
        for _ in 0..2 {
            let (result, found) = drawn(&mut renderer, gl, &scene);
            let message = result.unwrap_err().to_string();
            assert!(
                message.contains("“Ball”") && !message.contains("Cube"),
                "{message}"
            );
            assert_eq!(found, alone);
        }
        // Once there is memory, another way of drawing it is tried, and not before.
        TestDriver::limit_buffers(usize::MAX);
        assert!(drawn(&mut renderer, gl, &scene).0.is_err());
        let ball = scene.shapes()[1].id;
        scene.delete(ball);
        assert!(drawn(&mut renderer, gl, &scene).0.is_ok());
        scene.add(NewShape::new("Ball", ShapeKind::Sphere));
        assert_eq!(picture(&mut renderer, gl, &scene), both);
    }

    #[test]
    fn lines_that_the_driver_cannot_take_are_left_out_and_named_until_they_change() {
        let driver = TestDriver::new();
        let gl = driver.gl();
        let mut scene = Scene::new();
        let empty = picture(&mut Renderer::new(gl).unwrap(), gl, &scene);
        let curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
        let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(curve)));
        let mut renderer = Renderer::new(gl).unwrap();
        TestDriver::limit_buffers(250);
        for _ in 0..2 {
            let (result, found) = drawn(&mut renderer, gl, &scene);
            let message = result.unwrap_err().to_string();
            assert!(message.contains("the lines of “Wire”"), "{message}");
            assert_eq!(found, empty);
        }
        TestDriver::limit_buffers(usize::MAX);
        assert!(drawn(&mut renderer, gl, &scene).0.is_err());
        scene.curve_mut(id).unwrap().display.control_points = false;
        assert_ne!(picture(&mut renderer, gl, &scene), empty);
    }
}
