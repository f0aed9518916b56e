//! The passes of a picture, in their order.

use super::area::Area;
use super::backdrop_pass::draw_axis;
use super::curve_pass::CurvePass;
use super::frame::{Background, Frame, PassContext, has_ground};
use super::ground_pass::hides_below;
use super::renderer::Renderer;
use super::skeleton_pass::draw_mannequin_bones;
use crate::gpu::{Framebuffer, GpuError};
use crate::scene::Look;
use std::ops::Range;

/// Which passes a picture is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// All of them.
    All,
    /// All but the shadows and the lines round marked shapes, for each of which all triangles are drawn once more.
    Sketch,
}

impl Renderer {
    /// Draws them.
    pub(super) fn draw_passes(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        context: &PassContext,
        passes: Passes,
    ) -> Result<(), GpuError> {
        self.draw_surfaces(frame, target, context, 0..u64::MAX);
        let mut drawn = self.draw_lines(frame, context);
        if has_ground(frame) {
            let (gl, meshes) = (&self.gl, &self.meshes);
            let shadows = (passes == Passes::All)
                .then(|| self.shadows.draw(gl, context, frame, meshes, None))
                .transpose();
            let (picture, result) = match shadows {
                Ok(picture) => (picture, Ok(())),
                Err(error) => (None, Err(error)),
            };
            drawn = drawn.and(result);
            let whole = Area::whole([context.width, context.height]);
            (self.ground).draw_all(gl, context, frame, picture, whole, target);
        }
        self.draw_rest(frame, context);
        match passes {
            Passes::All => drawn.and(self.draw_outlines(frame, target, context)),
            Passes::Sketch => drawn,
        }
    }

    /// Draws, of what comes before all else, the surfaces that hide what is behind them, those `triangles` which
    /// [`SurfacePass::draw_opaque`](super::surface_pass::SurfacePass::draw_opaque) counts, and the background
    /// before the first of them. Returns their number.
    pub(super) fn draw_surfaces(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        context: &PassContext,
        triangles: Range<u64>,
    ) -> u64 {
        let Self {
            gl,
            meshes,
            immediate,
            ..
        } = self;
        if triangles.start == 0 {
            self.background.draw(gl, context, frame.view.look, target);
            let has_floor = frame.view.grid && frame.view.look == Look::Mannequin;
            if has_floor && context.background == Background::Look {
                self.floor.draw(gl, context, &frame.view.camera);
            }
            // A ground with lines of its own comes under the axes.
            if frame.view.axis && !has_ground(frame) {
                draw_axis(gl, immediate, context, None);
            }
        }
        self.surfaces
            .draw_opaque(gl, context, frame, meshes, triangles)
    }

    /// Draws what comes after the surfaces and before the ground.
    pub(super) fn draw_lines(
        &mut self,
        frame: &Frame,
        context: &PassContext,
    ) -> Result<(), GpuError> {
        let Self { gl, immediate, .. } = self;
        self.ghosts.draw_opaque(gl, context, frame, &self.surfaces);
        self.curves.draw(gl, context, frame, immediate);
        if frame.view.look == Look::Mannequin {
            draw_mannequin_bones(gl, context, frame, immediate);
            return Ok(());
        }
        self.skeletons.draw(gl, context, frame, immediate)
    }

    /// Draws what comes after the ground, but for the lines round marked shapes.
    pub(super) fn draw_rest(&mut self, frame: &Frame, context: &PassContext) {
        let Self {
            gl,
            meshes,
            immediate,
            ghosts,
            ..
        } = self;
        if frame.view.axis && has_ground(frame) {
            let floor = hides_below(context, &frame.view.camera).then_some(context.ground);
            draw_axis(gl, immediate, context, floor);
        }
        if frame.view.look != Look::Mannequin {
            self.surfaces.draw_translucent(gl, context, frame, meshes);
        }
        ghosts.draw_translucent(gl, context, frame, &self.surfaces);
        CurvePass::draw_marked(gl, context, frame, immediate);
    }

    /// Draws the lines round marked shapes.
    pub(super) fn draw_outlines(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        context: &PassContext,
    ) -> Result<(), GpuError> {
        let lines = (&mut self.skeletons, &mut self.immediate);
        let scene = (context, frame, &self.meshes);
        self.outline.draw(&self.gl, scene, lines, target)
    }
}
