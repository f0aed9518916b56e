//! A picture that is drawn step by step.

use super::area::Area;
use super::frame::{Background, Frame, PassContext, has_ground};
use super::renderer::{RenderError, Renderer};
use super::sight::Sight;
use super::tile::Tile;
use crate::gpu::{Framebuffer, Gl, GpuError};
use std::ops::Range;

/// Triangles that are drawn in a step, each copy of a mesh counted: about 50 ms of a picture with samples on
/// software OpenGL.
const STEP: u64 = 25_000;
/// Triangles whose shadows are drawn in a step, for each whose surface is: they take no light and no depth.
const SHADOWS: u64 = 4;
/// Pixels of the ground that are drawn in a step, in whole rows: about 40 ms.
const GROUND: u32 = 400_000;

/// A picture without the lines round marked shapes, drawn in steps between which the program can answer to its
/// user. Each is drawn into the samples of those before: the pixels are those of [`Renderer::draw`].
#[derive(Debug)]
pub struct GradualPicture {
    picture: Framebuffer,
    /// The shadows on the ground; none before they are drawn.
    shadows: Option<Framebuffer>,
    /// Whether the large meshes in it are uploaded, which comes first, part by part.
    is_uploaded: bool,
    next: Step,
    pub(super) most: Most,
}

/// What is drawn in a step at most.
#[derive(Clone, Copy, Debug)]
pub(super) struct Most {
    pub triangles: u64,
    /// Rows of the ground.
    pub rows: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    /// Surfaces, from this triangle on.
    Surfaces(u64),
    /// Shadows on the ground, from that of this triangle on.
    Shadows(u64),
    /// The ground, from this row on.
    Ground(u32),
    /// What comes after the ground.
    Rest,
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
            shadows: None,
            is_uploaded: false,
            next: Step::Surfaces(0),
            most: Most {
                triangles: STEP,
                rows: (GROUND / width.max(1)).max(1),
            },
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
        if !self.is_uploaded {
            let tile = Tile::whole((self.picture.width(), self.picture.height()));
            let context = renderer.context(frame, &self.picture, tile, Background::Look);
            self.is_uploaded = renderer.upload_part(frame, &Sight::new(&context, frame));
            if !self.is_uploaded {
                return Ok(());
            }
        }
        let step = self.next;
        // What comes next if this fails, or where nothing more of the same is left.
        self.next = match step {
            Step::Surfaces(_) if has_ground(frame) => Step::Shadows(0),
            Step::Shadows(_) => Step::Ground(0),
            Step::Surfaces(_) | Step::Ground(_) => Step::Rest,
            Step::Rest | Step::Complete => Step::Complete,
        };
        if step == Step::Complete {
            return Ok(());
        }
        let size = (self.picture.width(), self.picture.height());
        let tile = (Tile::whole(size), Background::Look);
        let target = &self.picture;
        let (shadows, most) = (&mut self.shadows, self.most);
        let mut more = None;
        let drawn = renderer.draw_by(frame, target, tile, |renderer, context| {
            target.bind();
            match step {
                Step::Surfaces(from) => {
                    let to = from + most.triangles;
                    if to < renderer.draw_surfaces(frame, target, context, from..to) {
                        more = Some(Step::Surfaces(to));
                        return Ok(());
                    }
                    return renderer.draw_lines(frame, context);
                }
                Step::Shadows(from) => {
                    let to = from + SHADOWS * most.triangles;
                    if to < draw_shadows(renderer, shadows, (frame, context), from..to)? {
                        more = Some(Step::Shadows(to));
                    }
                }
                Step::Ground(row) => {
                    let end = context.height.min(row + most.rows);
                    let rows = Area {
                        first: [0, row],
                        end: [context.width, end],
                    };
                    let (gl, shadows) = (&renderer.gl, shadows.as_ref());
                    (renderer.ground).draw_all(gl, context, frame, shadows, rows, target);
                    more = (end < context.height).then_some(Step::Ground(end));
                }
                Step::Rest | Step::Complete => {
                    renderer.come_to_rest(frame);
                    renderer.draw_rest(frame, context);
                }
            }
            Ok(())
        });
        self.next = more.unwrap_or(self.next);
        drawn
    }
}

/// Adds the shadows of those `triangles` to `picture`, which is made with the first. Returns the number of all.
fn draw_shadows(
    renderer: &Renderer,
    picture: &mut Option<Framebuffer>,
    (frame, context): (&Frame, &PassContext),
    triangles: Range<u64>,
) -> Result<u64, GpuError> {
    let gl = &renderer.gl;
    let picture = match picture {
        Some(begun) => begun,
        none => {
            let made = Framebuffer::new(gl, context.width, context.height, 0)?;
            made.clear([0.0; 4]);
            none.insert(made)
        }
    };
    let scene = (context, frame, &renderer.meshes);
    Ok((renderer.shadows).draw_part(gl, scene, picture, triangles))
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
            rows in 1..150u32,
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
            gradual.most = Most { triangles: step, rows };
            let mut steps = 0;
            while !gradual.is_complete() {
                // Something else is drawn in between.
                renderer.draw(&frame, &Framebuffer::new(gl, 40, 30, 0).unwrap()).unwrap();
                gradual.draw_next(&mut renderer, &frame).unwrap();
                steps += 1;
            }
            prop_assert!(gradual.picture().read_rgba() == whole.read_rgba());
            let ground = has_ground(&frame);
            let [shadows, grounds] = [triangles.div_ceil(SHADOWS * step), 110u64.div_ceil(rows.into())];
            let more = if ground { shadows + grounds } else { 0 };
            prop_assert_eq!(steps, triangles.div_ceil(step) + more + 1);
        }
    }

    #[test]
    fn large_meshes_are_uploaded_part_by_part_before_the_first_surface() {
        let headless = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = headless.gl();
        let ball = sphere(1.0, 300, 200, Poles::Y);
        let flat = Mesh::new(ball.positions.clone(), ball.triangles.clone());
        let mut scene = Scene::new();
        for mesh in [ball, flat] {
            let mesh = SharedMesh::new(mesh);
            scene.add(NewShape::new("A", ShapeKind::Mesh(mesh.clone())));
            scene.add(NewShape::new("Its copy", ShapeKind::Mesh(mesh)));
        }
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let view = ViewSettings::default();
        let frame = Frame::plain(&scene, &evaluated, &view);
        let whole = Framebuffer::new(gl, 150, 110, 0).unwrap();
        Renderer::new(gl).unwrap().draw(&frame, &whole).unwrap();
        let mut renderer = Renderer::new(gl).unwrap();
        // Indices, positions and normals of two meshes: the last part of the first comes with the first of the second,
        // and that of the second with the surfaces.
        for steps in [4, 0] {
            let mut gradual = GradualPicture::new(gl, (150, 110), 0).unwrap();
            let before = gradual.picture().read_rgba().unwrap();
            for step in 0..steps {
                gradual.draw_next(&mut renderer, &frame).unwrap();
                assert!(gradual.picture().read_rgba().unwrap() == before, "{step}");
            }
            gradual.draw_next(&mut renderer, &frame).unwrap();
            assert!(gradual.picture().read_rgba().unwrap() != before);
            while !gradual.is_complete() {
                gradual.draw_next(&mut renderer, &frame).unwrap();
            }
            assert!(gradual.picture().read_rgba() == whole.read_rgba());
        }
    }
}
