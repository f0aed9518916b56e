//! Pictures of something that is dragged, one after the other.

use super::area::Area;
use super::backdrop_pass::draw_axis;
use super::frame::{Background, Frame, Marks, PassContext, has_ground};
use super::ground_pass::{Shadows, shadow_area};
use super::passes::Passes;
use super::renderer::{RenderError, Renderer};
use super::still_layer::Plan;
use super::tile::Tile;
use crate::gpu::{Framebuffer, GpuError};
use crate::scene::Evaluated;

impl Renderer {
    /// As [`Renderer::draw`], with the same pixels, but fast where it is called for one picture after
    /// the other of something that is dragged: what stands still is kept. `target` has no samples.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub fn draw_moving(&mut self, frame: &Frame, target: &Framebuffer) -> Result<(), RenderError> {
        self.draw_moving_by(frame, target, Passes::All)
    }

    /// As [`Renderer::draw_moving`], but with fewer triangles where there are many, and where nothing stands still by
    /// these `passes`.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub fn draw_coarse(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        passes: Passes,
    ) -> Result<(), RenderError> {
        let Some(evaluated) = self.coarse.of(frame) else {
            return self.draw_moving_by(frame, target, passes);
        };
        let coarse = Frame {
            evaluated: &evaluated,
            ..frame.clone()
        };
        std::mem::swap(&mut self.meshes, &mut self.coarse.meshes);
        let drawn = self.draw_moving_by(&coarse, target, passes);
        std::mem::swap(&mut self.meshes, &mut self.coarse.meshes);
        drawn
    }

    fn draw_moving_by(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
        passes: Passes,
    ) -> Result<(), RenderError> {
        let tile = Tile::whole((target.width(), target.height()));
        self.draw_by(
            frame,
            target,
            (tile, Background::Look),
            |renderer, context| match renderer.layer.plan(frame, context) {
                Plan::Whole => renderer.draw_passes(frame, target, context, passes),
                Plan::Over { moving, new_layer } => {
                    let layer = new_layer.map_or(Ok(()), |still| {
                        renderer.draw_layer(&without_marks(frame, &still), context)
                    });
                    let moving = without_marks(frame, &moving);
                    let drawn =
                        layer.and_then(|()| renderer.draw_over(frame, &moving, target, context));
                    if drawn.is_err() {
                        renderer.layer.forget();
                    }
                    drawn
                }
            },
        )
    }

    /// Draws the layer of what stands still.
    fn draw_layer(&mut self, still: &Frame, context: &PassContext) -> Result<(), GpuError> {
        let Self {
            gl, meshes, layer, ..
        } = self;
        let (width, height) = (context.width, context.height);
        let picture = Framebuffer::fitting(&mut layer.picture, gl, width, height)?;
        self.background.draw(gl, context, still.view.look, picture);
        self.surfaces
            .draw_opaque(gl, context, still, meshes, 0..u64::MAX);
        if !has_ground(still) {
            return Ok(());
        }
        let drawn = self.shadows.draw(gl, context, still, meshes, None)?;
        let shadows = Framebuffer::fitting(&mut layer.shadows, gl, width, height)?;
        drawn.copy_into(shadows)?;
        let shadows = Shadows {
            picture: drawn,
            area: shadow_area(context, still),
        };
        let whole = Area::whole([width, height]);
        let camera = &still.view.camera;
        self.ground
            .draw(gl, context, camera, Some(shadows), whole, picture);
        Ok(())
    }

    /// Draws the shapes that move, those of `moving`, over the layer of what stands still, and what
    /// marks shapes of `frame`.
    fn draw_over(
        &mut self,
        frame: &Frame,
        moving: &Frame,
        target: &Framebuffer,
        context: &PassContext,
    ) -> Result<(), GpuError> {
        let Self {
            gl,
            meshes,
            layer,
            immediate,
            ..
        } = self;
        let size = [context.width, context.height];
        let kept = Framebuffer::fitting(&mut layer.picture, gl, size[0], size[1])?;
        kept.copy_into(target)?;
        self.surfaces
            .draw_opaque(gl, context, moving, meshes, 0..u64::MAX);
        if has_ground(frame) {
            let others = layer.shadows.as_ref();
            let picture = self.shadows.draw(gl, context, moving, meshes, others)?;
            let shadows = Shadows {
                picture,
                area: shadow_area(context, frame),
            };
            // The ground before shapes that have moved, and in their shadows.
            let boxes = moving.shapes().map(|(_, evaluated)| {
                let corners = evaluated.world_box().corners();
                Area::around(&corners, context.clip_from_world, size)
            });
            let within = boxes.fold(shadow_area(context, moving), Area::union);
            let camera = &frame.view.camera;
            self.ground
                .draw(gl, context, camera, Some(shadows), within, target);
        }
        if frame.view.axis {
            let floor = has_ground(frame).then_some(context.ground);
            draw_axis(gl, immediate, context, floor);
        }
        self.draw_outlines(frame, target, context)
    }
}

/// Some of the shapes of `frame`: those that are visible in `evaluated`.
fn without_marks<'a>(frame: &Frame<'a>, evaluated: &'a Evaluated) -> Frame<'a> {
    Frame {
        evaluated,
        marks: Marks::default(),
        ..frame.clone()
    }
}
