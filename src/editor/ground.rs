//! The ground that figures stand on, and on which they stay when they are scaled.

use super::Session;
use super::shape_group::{kept_at, pivot_of};
use crate::math::Transform;
use crate::scene::{EvaluatedShape, Shape, ShapeId};

/// Distance from the ground, relative to its height, from which on a figure hangs or sinks.
pub(super) const OFF_THE_GROUND: f32 = 0.02;

/// `transform`, in which the shape `id` is scaled otherwise than it is: moved so that the ground below a figure that
/// stands on it stays there.
pub fn kept_on_ground(session: &Session, id: ShapeId, transform: Transform) -> Transform {
    let on_ground = ground_below(session, id).zip(session.evaluated().shape(id));
    let Some((floor, shown)) = on_ground else {
        return transform;
    };
    let pivot = shown.world_from_model.transform_point3(pivot_of(shown));
    let foot = pivot.with_y(floor);
    let foot = shown.world_from_model.inverse().transform_point3(foot);
    match foot.is_finite() {
        true => kept_at(shown, foot, transform),
        false => transform,
    }
}

/// Height, in the world, of the ground on which the shape `id` is scaled; `None` if it stands on none, or is no figure.
///
/// That is where its feet are or, while it is turned, would be if it were upright again: what is turned, scaled, turned
/// back and scaled back is where it was, in whichever order. A figure that was moved while it is turned has feet
/// nowhere; it stands on the ground if the lowest vertex of its pose is there.
pub(super) fn ground_below(session: &Session, id: ShapeId) -> Option<f32> {
    let shape = session.scene().shape(id)?;
    shape.front()?;
    let shown = session.evaluated().shape(id)?;
    let figures = || figures(session);
    let started = figures().map(|(shape, shown)| lowest_at_start(shape, shown));
    let started = started.filter(|_| session.view().has_ground());
    let ground = started.reduce(f32::min)?;
    let feet = feet(shape, shown);
    let size = shown
        .geometry
        .mesh
        .bounds()
        .transformed(shape.upright().world_from_model())
        .size();
    let is_near = |one: f32, other: f32| (one - other).abs() <= OFF_THE_GROUND * size.y;
    if is_near(feet, ground) {
        return Some(feet);
    }
    let now = shown.geometry.lowest(shown.world_from_model);
    if is_near(now, ground) {
        return Some(now);
    }
    // All may have been moved up or down, and their ground with them.
    let moved = figures().map(|(shape, shown)| self::feet(shape, shown));
    let is_moved = moved.reduce(f32::min).is_some_and(|it| is_near(feet, it));
    (is_moved && is_near(lowest_at_rest(shown), feet)).then_some(feet)
}

/// The characters that are seen.
pub(super) fn figures(session: &Session) -> impl Iterator<Item = (&Shape, &EvaluatedShape)> {
    let shapes = session.scene().shapes().iter();
    let characters = shapes.filter(|shape| shape.visible && shape.front().is_some());
    characters.filter_map(|shape| Some((shape, session.evaluated().shape(shape.id)?)))
}

/// Height, in the world, of the lowest vertex of a shape at rest; infinite if it has none.
pub(super) fn lowest_at_rest(shown: &EvaluatedShape) -> f32 {
    shown.geometry.lowest_at_rest(shown.world_from_model)
}

/// The same where the shape began.
fn lowest_at_start(shape: &Shape, shown: &EvaluatedShape) -> f32 {
    let start = shape.start.transform.world_from_model();
    shown.geometry.lowest_at_rest(start)
}

/// The same of the shape turned as it began.
fn feet(shape: &Shape, shown: &EvaluatedShape) -> f32 {
    let upright = shape.upright().world_from_model();
    shown.geometry.lowest_at_rest(upright)
}
