//! The lines round marked shapes, drawn after all else into a picture whose samples were averaged before.

use super::frame::{Background, Frame};
use super::renderer::{RenderError, Renderer};
use super::tile::Tile;
use crate::gpu::Framebuffer;

impl Renderer {
    /// Draws the lines round marked shapes over a [`GradualPicture`](super::GradualPicture): the
    /// pixels of both are those of [`Renderer::draw`], also where `target` has the averages of samples,
    /// since the lines cover whole pixels.
    ///
    /// # Errors
    /// When a GL error occurred. Meshes that the driver does not take have no line.
    pub fn draw_outlines_over(
        &mut self,
        frame: &Frame,
        target: &Framebuffer,
    ) -> Result<(), RenderError> {
        let tile = Tile::whole((target.width(), target.height()));
        let context = self.context(frame, target, tile, Background::Look);
        // None of the triangles of surfaces need be chosen: they are not drawn.
        let chosen = self.choose_triangles(frame, &context, true);
        let drawn = chosen.and_then(|()| self.draw_outlines(frame, target, &context));
        Ok(drawn.and(self.gl.check("drawing outlines"))?)
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::Basis;
    use crate::gpu::{Backend, Framebuffer, HeadlessContext};
    use crate::render::{Frame, GradualPicture, Marks, Renderer};
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
                renderer.draw_outlines_over(&frame, &averages).unwrap();
                let [expected, found] = [&full, &averages].map(|it| it.read_rgba().unwrap());
                assert!(found == expected, "{look:?}, {at}");
                assert!(found != before, "{look:?}, {at}: there are outlines");
            }
        }
    }
}
