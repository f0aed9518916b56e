//! The lines round marked shapes, drawn after all else into a picture whose samples were averaged before.

use super::frame::{Background, Frame};
use super::outline_pass::has_outlines;
use super::renderer::{RenderError, Renderer};
use super::tile::Tile;
use crate::gpu::{Framebuffer, Gl, GpuError};

/// Triangles of masks that are drawn in a step: about 50 ms on software OpenGL.
const STEP: u64 = 200_000;

/// The lines round marked shapes, drawn over a [`GradualPicture`](super::GradualPicture): the pixels of both are those
/// of [`Renderer::draw`], also where the picture has the averages of samples, since the lines cover whole pixels. What
/// they go round is found out in steps.
#[derive(Debug)]
pub struct GradualOutlines {
    mask: Framebuffer,
    next: u64,
    pub(super) most: u64,
}

impl GradualOutlines {
    /// Those over a picture of this width and height, of which nothing is found out yet.
    ///
    /// # Errors
    /// See [`Framebuffer::new`].
    pub fn new(gl: &Gl, (width, height): (u32, u32)) -> Result<Self, GpuError> {
        let mask = Framebuffer::new(gl, width, height, 0)?;
        mask.clear([0.0; 4]);
        Ok(Self {
            mask,
            next: 0,
            most: STEP,
        })
    }

    /// Goes on to find out what the lines of `frame`, the same in all steps, go round; whether that was the last
    /// step.
    ///
    /// # Errors
    /// When a GL error occurred. Meshes that the driver does not take have no line.
    pub fn draw_next(
        &mut self,
        renderer: &mut Renderer,
        frame: &Frame,
    ) -> Result<bool, RenderError> {
        if !has_outlines(frame) {
            return Ok(true);
        }
        let context = renderer.context(frame, &self.mask, self.tile(), Background::Look);
        // None of the triangles of surfaces need be chosen: they are not drawn.
        renderer.choose_triangles(frame, &context, true)?;
        let triangles = self.next..self.next + self.most;
        self.next = triangles.end;
        let Renderer {
            gl,
            meshes,
            outline,
            skeletons,
            immediate,
            ..
        } = renderer;
        let scene = (&context, frame, &*meshes);
        let end = triangles.end;
        let all = outline.draw_mask(gl, scene, (skeletons, immediate), &self.mask, triangles)?;
        gl.check("drawing masks")?;
        Ok(all <= end)
    }

    /// Draws the lines into `target`, after the last step.
    ///
    /// # Errors
    /// When a GL error occurred.
    pub fn draw_over(
        &self,
        renderer: &mut Renderer,
        frame: &Frame,
        target: &Framebuffer,
    ) -> Result<(), RenderError> {
        if !has_outlines(frame) {
            return Ok(());
        }
        let context = renderer.context(frame, target, self.tile(), Background::Look);
        let Renderer { gl, outline, .. } = renderer;
        outline.draw_lines_round(gl, (&context, frame), &self.mask, target)?;
        Ok(gl.check("drawing outlines")?)
    }

    fn tile(&self) -> Tile {
        Tile::whole((self.mask.width(), self.mask.height()))
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::Basis;
    use crate::gpu::{Backend, Framebuffer, HeadlessContext};
    use crate::render::{Frame, GradualOutlines, GradualPicture, Marks, Renderer};
    use crate::scene::{
        CurveSet, CurveShape, Evaluator, Look, NewShape, Scene, ShapeKind, ViewSettings,
    };
    use glam::Vec3;

    #[test]
    fn outlines_over_the_averages_of_samples_have_the_pixels_of_those_under_them() {
        let headless = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = headless.gl();
        let mut scene = Scene::new();
        let curve = ShapeKind::Curve(CurveShape::new(CurveSet::start_spline(Basis::Bezier)));
        for (kind, at) in [
            (ShapeKind::Cube, Vec3::X),
            (ShapeKind::Pyramid, Vec3::ZERO),
            (ShapeKind::Sphere, Vec3::new(0.7, 0.4, 0.6)),
            (curve, Vec3::Y * 0.5),
        ] {
            let id = scene.add(NewShape::new("A", kind));
            scene.shape_mut(id).unwrap().placement.transform.position = at;
        }
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let ids: Vec<_> = scene.shapes().iter().map(|shape| shape.id).collect();
        for look in [Look::Course, Look::Studio, Look::Mannequin] {
            let view = ViewSettings {
                look,
                ..ViewSettings::default()
            };
            for (at, &hovered) in ids.iter().enumerate() {
                let marks = Marks {
                    selected: Some(ids[(at + 1) % ids.len()]),
                    also_selected: vec![ids[(at + 2) % ids.len()]],
                    hovered: Some(hovered),
                    ..Marks::default()
                };
                let frame = Frame {
                    marks,
                    ..Frame::plain(&scene, &evaluated, &view)
                };
                let full = Framebuffer::new(gl, 150, 110, 4).unwrap();
                let mut without = GradualPicture::new(gl, (150, 110), 4).unwrap();
                let averages = Framebuffer::new(gl, 150, 110, 0).unwrap();
                let mut renderer = Renderer::new(gl).unwrap();
                renderer.draw(&frame, &full).unwrap();
                while !without.is_complete() {
                    without.draw_next(&mut renderer, &frame).unwrap();
                }
                let before = without.picture().read_rgba().unwrap();
                let whole = averages.rect();
                without
                    .picture()
                    .blit_into(&averages, whole, whole)
                    .unwrap();
                let mut outlines = GradualOutlines::new(gl, (150, 110)).unwrap();
                outlines.most = [1, 5, 100, 100_000][at];
                while !outlines.draw_next(&mut renderer, &frame).unwrap() {
                    // Something else is drawn in between.
                    let other = Framebuffer::new(gl, 40, 30, 0).unwrap();
                    renderer.draw(&frame, &other).unwrap();
                }
                outlines
                    .draw_over(&mut renderer, &frame, &averages)
                    .unwrap();
                let [expected, found] = [&full, &averages].map(|it| it.read_rgba().unwrap());
                assert!(found == expected, "{look:?}, {at}");
                assert!(found != before, "{look:?}, {at}: there are outlines");
            }
        }
    }
}
