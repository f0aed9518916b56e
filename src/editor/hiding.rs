//! Whether shapes that are added would hide a figure that is inside of them.

use crate::math::Ray;
use crate::scene::{Evaluated, EvaluatedShape};
use glam::Vec3;

/// Vertices of the figure that are looked at, at most, from all over it.
const SAMPLE: usize = 48;
/// Share of them that has to be hidden.
const HIDDEN: f32 = 0.5;

/// Whether `shapes` would hide most of `figure` from an eye in the direction of `eye`, however far away: a closed pot does,
/// an open stage does not.
pub(super) fn hide(shapes: &Evaluated, figure: &EvaluatedShape, eye: Vec3) -> bool {
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
        hidden += usize::from(shapes.shapes.iter().any(|shape| meets(&ray, shape)));
    }
    all > 0 && hidden as f32 >= HIDDEN * all as f32
}

/// Whether a ray in the world meets a triangle of a shape.
fn meets(ray: &Ray, shape: &EvaluatedShape) -> bool {
    let ray = ray.transformed(shape.world_from_model.inverse());
    if ray.entry(&shape.geometry.bounds()).is_none() {
        return false;
    }
    let vertices = shape.geometry.positions();
    let mut triangles = shape.geometry.mesh.triangles.iter();
    triangles.any(|corners| {
        let corners = corners.map(|corner| vertices[corner as usize]);
        ray.triangle(corners).is_some()
    })
}
