//! A picture that is drawn step by step.

use super::frame::{Background, Frame};
use super::renderer::{RenderError, Renderer};
use super::still_layer::StillLayer;
use super::tile::Tile;
use crate::gpu::{Framebuffer, Gl, GpuError};

/// Triangles that are drawn in a step, each copy of a mesh counted: about 50 ms of a picture with samples on
/// software OpenGL.
const STEP: u64 = 60_000;

/// A picture without the lines round marked shapes, drawn in steps between which the program can answer to its
/// user. Each is drawn into the samples of those before: the pixels are those of [`Renderer::draw`].
#[derive(Debug)]
pub struct GradualPicture {
    picture: Framebuffer,
    next: Step,
    /// Triangles in a step.
    pub(super) step: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    /// Surfaces, from this triangle on.
    Surfaces(u64),
    /// What comes after the surfaces.
    Others,
    Complete,
}

impl GradualPicture {
    /// A picture of `size` pixels with so many samples each, of which nothing is drawn yet.
    ///
    /// # Errors
    /// See [`Framebuffer::new`].
    pub fn new(gl: &Gl, (width, height): (u32, u32), samples: u32) -> Result<Self, GpuError> {
        Ok(Self {
            picture: Framebuffer::new(gl, width, height, samples)?,
            next: Step::Surfaces(0),
            step: STEP,
        })
    }

    /// Whether all of it is drawn.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.next == Step::Complete
    }

    /// As much of it as is drawn.
    #[must_use]
    pub fn picture(&self) -> &Framebuffer {
        &self.picture
    }

    /// Draws the next step, if there is one, of `frame`, the same in all of them but for the lines round shapes.
    /// A step that fails is not tried again.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub fn draw_next(&mut self, renderer: &mut Renderer, frame: &Frame) -> Result<(), RenderError> {
        let Self {
            picture,
            next,
            step: most,
        } = self;
        let step = *next;
        *next = match step {
            Step::Surfaces(_) => Step::Others,
            Step::Others => Step::Complete,
            Step::Complete => return Ok(()),
        };
        let whole = Tile::whole((picture.width(), picture.height()));
        let tile = (whole, Background::Look);
        renderer.draw_by(frame, picture, tile, |renderer, context| {
            picture.bind();
            if let Step::Surfaces(from) = step {
                let to = from + *most;
                if to < renderer.draw_surfaces(frame, picture, context, from..to) {
                    *next = Step::Surfaces(to);
                }
                return Ok(());
            }
            // What moved is at rest: its pictures and old meshes need no memory any more.
            renderer.layer = StillLayer::default();
            renderer.draw_others(frame, picture, context)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Basis, Material, MaterialGroup, Mesh, Poles, SharedMesh, sphere};
    use crate::gpu::{Backend, HeadlessContext};
    use crate::scene::{
        CurveSet, CurveShape, Evaluator, Look, NewShape, Scene, ShapeKind, ViewSettings,
    };
    use glam::Vec3;
    use proptest::prelude::*;

    /// A ball of two materials through which a cube reaches, and a curve round both.
    fn scene() -> (Scene, u64) {
        let ball = sphere(1.0, 20, 20, Poles::Y);
        let mut ball = Mesh::new(ball.positions, ball.triangles);
        let triangles = ball.triangles.len();
        let group = |triangles, color| MaterialGroup {
            triangles,
            material: Material {
                name: String::new(),
                color,
                texture: None,
            },
        };
        ball.groups = vec![group(50..300, Vec3::X), group(300..triangles, Vec3::Y)];
        let curve = ShapeKind::Curve(CurveShape::new(CurveSet::start_spline(Basis::Bezier)));
        let mut scene = Scene::new();
        for kind in [
            ShapeKind::Mesh(SharedMesh::new(ball)),
            ShapeKind::Cube,
            curve,
        ] {
            let id = scene.add(NewShape::new("A", kind));
            let placement = &mut scene.shape_mut(id).unwrap().placement;
            placement.transform.scale = Vec3::new(1.4, 0.9, 1.2);
        }
        (scene, triangles as u64 + 12)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        #[test]
        fn a_picture_drawn_in_steps_has_the_pixels_of_one_that_is_drawn_at_once(
            step in 1..1000u64,
            look in prop::sample::select(vec![Look::Course, Look::Studio, Look::Mannequin]),
            samples in prop::sample::select(vec![0, 4]),
        ) {
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let gl = headless.gl();
            let mut renderer = Renderer::new(gl).unwrap();
            let (scene, triangles) = scene();
            let evaluated = Evaluator::new().evaluate(&scene, 0.0);
            let view = ViewSettings { look, grid: true, axis: true, ..ViewSettings::default() };
            let frame = Frame::plain(&scene, &evaluated, &view);
            let whole = Framebuffer::new(gl, 150, 110, samples).unwrap();
            renderer.draw(&frame, &whole).unwrap();
            let mut gradual = GradualPicture::new(gl, (150, 110), samples).unwrap();
            gradual.step = step;
            let mut steps = 0;
            while !gradual.is_complete() {
                // Something else is drawn in between.
                renderer.draw(&frame, &Framebuffer::new(gl, 40, 30, 0).unwrap()).unwrap();
                gradual.draw_next(&mut renderer, &frame).unwrap();
                steps += 1;
            }
            prop_assert!(gradual.picture().read_rgba() == whole.read_rgba());
            prop_assert_eq!(steps, triangles.div_ceil(step) + 1);
        }
    }
}
