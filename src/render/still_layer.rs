//! What stands still while something else is dragged.

use super::backdrop::Backdrop;
use super::frame::{Frame, PassContext, has_ground};
use super::ground_pass::hides_below;
use super::surface_pass::is_surface_alone;
use crate::gpu::Framebuffer;
use crate::scene::{
    Evaluated, EvaluatedGeometry, EvaluatedShape, Look, Shape, ShapeId, ViewSettings,
};
use glam::{Mat4, Vec3};
use std::collections::HashSet;
use std::sync::Arc;

/// Color and depth of the shapes that stand still, over which those that move are drawn: a drag costs
/// as much among a hundred characters as alone. Where two shapes are equally deep at a pixel, the one
/// that is drawn first is seen, and here that is the one that stands still, whatever their order.
#[derive(Debug, Default)]
pub(super) struct StillLayer {
    /// State of the picture before.
    before: Option<State>,
    /// State of the picture for which the layer was drawn, and the shapes that are not in it.
    drawn_for: Option<(State, HashSet<ShapeId>)>,
    /// Background, shapes and ground, without the axes.
    pub picture: Option<Framebuffer>,
    /// The shadows of the shapes.
    pub shadows: Option<Framebuffer>,
}

/// Way in which a picture is drawn.
#[derive(Debug)]
pub(super) enum Plan {
    /// All of it.
    Whole,
    /// The layer and `moving` over it. Where there is a `new_layer`, that is drawn before.
    Over {
        moving: Evaluated,
        new_layer: Option<Evaluated>,
    },
}

/// Everything that the picture of shapes follows from.
#[derive(Clone, Debug)]
struct State {
    view: ViewSettings,
    backdrop: Backdrop,
    size: (u32, u32),
    ground: f32,
    shapes: Vec<ShapeState>,
}

/// Everything that the picture of one shape follows from.
#[derive(Clone, Debug)]
struct ShapeState {
    id: ShapeId,
    visible: bool,
    world_from_model: Mat4,
    color: Vec3,
    geometry: Arc<EvaluatedGeometry>,
}

impl StillLayer {
    /// The way in which `frame` is drawn, if something in it moves from one picture to the next.
    pub fn plan(&mut self, frame: &Frame, context: &PassContext) -> Plan {
        let state = State::of(frame, context);
        let before = self.before.replace(state.clone());
        // From below everything is seen through the ground, which could not be drawn over itself.
        let may_have_ground_drawn_over =
            !has_ground(frame) || hides_below(context, &frame.view.camera);
        let is_plain = frame.view.look != Look::Mannequin
            && !frame.marks.change_meshes()
            && may_have_ground_drawn_over
            && frame.shapes().all(|(shape, _)| is_surface_alone(shape));
        if !is_plain {
            return Plan::Whole;
        }
        let fits = |(drawn, moving): &(State, HashSet<ShapeId>)| {
            drawn
                .moved_to(&state)
                .is_some_and(|moved| moved.is_subset(moving))
        };
        let is_new = !self.drawn_for.as_ref().is_some_and(fits);
        if is_new {
            let moved = before.and_then(|before| before.moved_to(&state));
            match moved.filter(|moved| !moved.is_empty()) {
                Some(moved) => self.drawn_for = Some((state, moved)),
                None => return Plan::Whole,
            }
        }
        let Some((_, moving)) = &self.drawn_for else {
            return Plan::Whole;
        };
        Plan::Over {
            moving: only(frame.evaluated, |id| moving.contains(&id)),
            new_layer: is_new.then(|| only(frame.evaluated, |id| !moving.contains(&id))),
        }
    }

    /// Has the next layer be drawn anew, such as after a failure.
    pub fn forget(&mut self) {
        self.drawn_for = None;
    }
}

impl State {
    fn of(frame: &Frame, context: &PassContext) -> Self {
        let shapes = frame.scene.shapes().iter().zip(&frame.evaluated.shapes);
        Self {
            view: *frame.view,
            backdrop: frame.backdrop,
            size: (context.width, context.height),
            ground: context.ground,
            shapes: shapes.map(ShapeState::of).collect(),
        }
    }

    /// The shapes that differ in `next`; `None` if anything else does.
    fn moved_to(&self, next: &Self) -> Option<HashSet<ShapeId>> {
        let ids = |state: &Self| {
            state
                .shapes
                .iter()
                .map(|shape| shape.id)
                .collect::<Vec<_>>()
        };
        let is_same = self.view == next.view
            && self.backdrop == next.backdrop
            && self.size == next.size
            && self.ground == next.ground
            && ids(self) == ids(next);
        let pairs = self.shapes.iter().zip(&next.shapes);
        let moved = pairs.filter(|(was, is)| !was.is_as(is));
        is_same.then(|| moved.map(|(was, _)| was.id).collect())
    }
}

impl ShapeState {
    fn of((shape, evaluated): (&Shape, &EvaluatedShape)) -> Self {
        Self {
            id: shape.id,
            visible: evaluated.visible,
            world_from_model: evaluated.world_from_model,
            color: shape.placement.color.rgb(),
            geometry: Arc::clone(&evaluated.geometry),
        }
    }

    fn is_as(&self, other: &Self) -> bool {
        self.visible == other.visible
            && self.world_from_model == other.world_from_model
            && self.color == other.color
            && Arc::ptr_eq(&self.geometry, &other.geometry)
    }
}

/// The same with all shapes hidden but those that are `wanted`.
fn only(evaluated: &Evaluated, wanted: impl Fn(ShapeId) -> bool) -> Evaluated {
    let mut only = evaluated.clone();
    for shape in &mut only.shapes {
        shape.visible &= wanted(shape.id);
    }
    only
}

#[cfg(test)]
mod tests {
    use crate::gpu::{Backend, Framebuffer, HeadlessContext};
    use crate::render::{Backdrop, Frame, Marks, Renderer};
    use crate::scene::{
        Camera, Evaluated, Evaluator, Look, NewShape, Scene, ShapeId, ShapeKind, ViewSettings,
    };
    use glam::Vec3;
    use proptest::prelude::*;

    /// One of the shapes is moved, hidden or shown, or the camera turned.
    #[derive(Clone, Debug)]
    enum Step {
        Move(usize, [f32; 3]),
        Hide(usize),
        Turn(f32),
    }

    fn steps() -> impl Strategy<Value = Vec<Step>> {
        let by = || prop::array::uniform3(-0.4..0.4f32);
        let step = prop_oneof![
            6 => (Just(0usize), by()).prop_map(|(shape, by)| Step::Move(shape, by)),
            3 => (0..3usize, by()).prop_map(|(shape, by)| Step::Move(shape, by)),
            1 => (0..3usize).prop_map(Step::Hide),
            1 => (-0.2..0.2f32).prop_map(Step::Turn),
        ];
        proptest::collection::vec(step, 3..10)
    }

    fn scene() -> Scene {
        let mut scene = Scene::new();
        for (kind, x) in [
            (ShapeKind::Cube, 0.0),
            (ShapeKind::Sphere, 0.7),
            (ShapeKind::Pyramid, -0.9),
        ] {
            let id = scene.add(NewShape::new("A", kind));
            let transform = &mut scene.shape_mut(id).unwrap().placement.transform;
            transform.position = Vec3::new(x, 0.6, x);
        }
        scene
    }

    fn frame<'a>(scene: &'a Scene, evaluated: &'a Evaluated, view: &'a ViewSettings) -> Frame<'a> {
        let selected = scene.shapes().iter().map(|shape| shape.id).min();
        let marks = Marks {
            selected,
            ..Marks::default()
        };
        Frame {
            scene,
            evaluated,
            view,
            backdrop: Backdrop::default(),
            marks,
        }
    }

    fn last_first(scene: &Scene) -> Scene {
        let mut turned = scene.clone();
        for shape in scene.shapes() {
            turned.move_in_list(shape.id, 0);
        }
        turned
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(30))]

        /// Where shapes are equally deep, the pixel is that of the one or the other.
        #[test]
        fn a_picture_of_what_moves_has_the_pixels_of_one_that_is_drawn_as_a_whole(
            steps in steps(),
            look in prop::sample::select(vec![Look::Course, Look::Studio, Look::Mannequin]),
            (axis, grid) in any::<(bool, bool)>(),
            phi in -0.2..1.2f32,
        ) {
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let gl = headless.gl();
            let [mut fast, mut whole] = [(); 2].map(|()| Renderer::new(gl).unwrap());
            let [found, drawn] = [(); 2].map(|()| Framebuffer::new(gl, 120, 90, 0).unwrap());
            let mut scene = scene();
            let mut evaluator = Evaluator::new();
            let camera = Camera { phi, ..Camera::default() };
            let mut view = ViewSettings { camera, look, axis, grid, ..ViewSettings::default() };
            for (number, step) in steps.into_iter().enumerate() {
                let id = |index: usize| ShapeId(index as u32 + 1);
                match step {
                    Step::Move(index, by) => {
                        let shape = scene.shape_mut(id(index)).unwrap();
                        shape.placement.transform.position += Vec3::from(by);
                    }
                    Step::Hide(index) => {
                        let shape = scene.shape_mut(id(index)).unwrap();
                        shape.visible = !shape.visible;
                    }
                    Step::Turn(by) => view.camera.theta += by,
                }
                let evaluated = evaluator.evaluate(&scene, 0.0);
                fast.draw_moving(&frame(&scene, &evaluated, &view), &found).unwrap();
                let found = found.read_rgba().unwrap();
                let mut whole = |scene: &Scene| {
                    let evaluated = Evaluator::new().evaluate(scene, 0.0);
                    whole.draw(&frame(scene, &evaluated, &view), &drawn).unwrap();
                    drawn.read_rgba().unwrap()
                };
                let pictures = [whole(&scene), whole(&last_first(&scene))];
                let [first, last] = pictures.each_ref().map(|picture| picture.as_chunks::<4>().0);
                let pixels = found.as_chunks::<4>().0.iter().zip(first).zip(last);
                let same = pixels.into_iter().all(|((found, first), last)| found == first || found == last);
                prop_assert!(same, "picture {number}");
            }
        }
    }
}
