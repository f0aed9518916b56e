//! Whether a shape hides a figure that is inside of it.

use crate::math::Ray;
use crate::scene::EvaluatedShape;
use glam::Vec3;

/// Vertices of the figure that are looked at, at most, from all over it.
const SAMPLE: usize = 48;
/// Share of them that has to be hidden.
const HIDDEN: f32 = 0.5;

/// Whether `shape` hides most of `figure` from an eye in the direction of `eye`, however far away: a closed pot does, an
/// open stage does not.
pub(super) fn hides(shape: &EvaluatedShape, figure: &EvaluatedShape, eye: Vec3) -> bool {
    let vertices = figure.geometry.positions();
    let step = vertices.len().div_ceil(SAMPLE).max(1);
    let (mut all, mut hidden) = (0, 0);
    for vertex in vertices.iter().step_by(step) {
        let origin = figure.world_from_model.transform_point3(*vertex);
        let ray = Ray {
            origin,
            direction: eye - origin,
        };
        all += 1;
        hidden += usize::from(shape.is_met_by(&ray));
    }
    all > 0 && hidden as f32 >= HIDDEN * all as f32
}
