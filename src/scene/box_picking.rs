use super::{Camera, Evaluated, EvaluatedShape, Scene, ShapeId, bones_in_world};
use glam::{Mat4, Vec2, Vec3};
use std::collections::BTreeSet;

/// Picks every shape of which any part is seen in the box between two pixels, from the top left, in
/// a picture of `size`: a corner of its mesh, a curve or a bone is enough, also behind other shapes.
/// Those that are hidden or locked are ignored.
pub fn pick_in_box(
    scene: &Scene,
    evaluated: &Evaluated,
    camera: &Camera,
    (one, other): (Vec2, Vec2),
    size: Vec2,
) -> Vec<ShapeId> {
    let Some(frustum) = Frustum::new(camera, one.min(other), one.max(other), size) else {
        return Vec::new();
    };
    let shapes = evaluated.shapes.iter().filter(|shape| shape.pickable);
    shapes
        .filter(|shape| is_in(scene, shape, &frustum))
        .map(|shape| shape.id)
        .collect()
}

/// The joints of `shape` of which a bone is seen in the box between two pixels, as by [`pick_in_box`].
pub fn pick_joints_in_box(
    scene: &Scene,
    shape: &EvaluatedShape,
    camera: &Camera,
    (one, other): (Vec2, Vec2),
    size: Vec2,
) -> Vec<usize> {
    let Some(frustum) = Frustum::new(camera, one.min(other), one.max(other), size) else {
        return Vec::new();
    };
    let bones = bones_in_world(scene, shape);
    let seen = bones.filter(|(_, start, end)| frustum.holds_part_of(&[*start, *end]));
    let joints: BTreeSet<usize> = seen.map(|(joint, ..)| joint).collect();
    joints.into_iter().collect()
}

fn is_in(scene: &Scene, shape: &EvaluatedShape, frustum: &Frustum) -> bool {
    let geometry = &shape.geometry;
    let world = |point: Vec3| shape.world_from_model.transform_point3(point);
    let curves = geometry.curves.iter().flat_map(|all| &all.curves);
    let mut lines = curves.flat_map(|curve| curve.points.windows(2));
    let mut bones = bones_in_world(scene, shape);
    if lines.any(|pair| frustum.holds_part_of(&[world(pair[0].position), world(pair[1].position)]))
        || bones.any(|(_, start, end)| frustum.holds_part_of(&[start, end]))
    {
        return true;
    }
    // In model space no vertex has to be moved, and of a character that is not near the box none
    // has to be skinned.
    let frustum = frustum.in_model(shape.world_from_model);
    let bounds = geometry.conservative_bounds();
    if bounds.is_empty() || frustum.is_beside(bounds.min, bounds.max) {
        return false;
    }
    let positions = geometry.positions();
    let mut triangles = geometry.mesh.triangles.iter();
    triangles.any(|triangle| {
        let corners = triangle.map(|index| positions.get(index as usize).copied());
        matches!(corners, [Some(a), Some(b), Some(c)] if frustum.holds_part_of(&[a, b, c]))
    })
}

/// Part of the space that is seen in a box of the picture: where all of these are positive.
struct Frustum {
    /// Planes as `(normal, offset)`: inside, `normal · point + offset ≥ 0`.
    planes: [(Vec3, f32); 5],
}

impl Frustum {
    /// `None` for a box without an area.
    fn new(camera: &Camera, min: Vec2, max: Vec2, size: Vec2) -> Option<Self> {
        let corners = [min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y)];
        let rays = corners.map(|corner| camera.ray(corner, size).direction);
        let eye = camera.eye();
        let side = |i: usize| {
            let normal = rays[i].cross(rays[(i + 1) % 4]).try_normalize()?;
            Some((normal, -normal.dot(eye)))
        };
        let forward = camera.forward();
        let near = (forward, -forward.dot(eye) - camera.near);
        Some(Self {
            planes: [side(0)?, side(1)?, side(2)?, side(3)?, near],
        })
    }

    /// The same in model space.
    fn in_model(&self, world_from_model: Mat4) -> Self {
        let rows = world_from_model.transpose();
        let planes = self.planes.map(|(normal, offset)| {
            let plane = rows * normal.extend(offset);
            (plane.truncate(), plane.w)
        });
        Self { planes }
    }

    /// Whether a box along the axes lies outside of one plane.
    fn is_beside(&self, min: Vec3, max: Vec3) -> bool {
        self.planes.iter().any(|&(normal, offset)| {
            let farthest = Vec3::select(normal.cmpge(Vec3::ZERO), max, min);
            normal.dot(farthest) + offset < 0.0
        })
    }

    /// Whether any part of a segment or a convex polygon lies inside: it is cut by one plane after
    /// the other (Sutherland and Hodgman), until nothing is left or all planes are done.
    fn holds_part_of(&self, corners: &[Vec3]) -> bool {
        let mut left = corners.to_vec();
        for &(normal, offset) in &self.planes {
            let side = |point: Vec3| normal.dot(point) + offset;
            if left.iter().all(|&point| side(point) >= 0.0) {
                continue;
            }
            let mut cut = Vec::with_capacity(left.len() + 1);
            for (i, &from) in left.iter().enumerate() {
                let to = left[(i + 1) % left.len()];
                let (a, b) = (side(from), side(to));
                if a >= 0.0 {
                    cut.push(from);
                }
                if (a >= 0.0) != (b >= 0.0) {
                    cut.push(from.lerp(to, a / (a - b)));
                }
            }
            left = cut;
            if left.is_empty() {
                return false;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{CurveSet, CurveShape, Evaluator, NewShape, ShapeKind};

    const SIZE: Vec2 = Vec2::new(800.0, 600.0);

    /// A cube at the origin and a circle to the right of it.
    fn picked(from: Vec3, to: Vec3, camera: Camera) -> Vec<ShapeId> {
        let mut scene = Scene::new();
        scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let circle = ShapeKind::Curve(CurveShape::new(CurveSet::start_circle()));
        let circle = scene.add(NewShape::new("Circle", circle));
        scene
            .shape_mut(circle)
            .unwrap()
            .placement
            .transform
            .position = Vec3::X * 2.0;
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let corner = |world| camera.pixel(world, SIZE).expect("before the eye");
        let corners = (corner(from), corner(to));
        pick_in_box(&scene, &evaluated, &camera, corners, SIZE)
    }

    #[test]
    fn a_shape_is_in_the_box_if_any_part_of_it_is_and_not_merely_its_bounds() {
        let front = Camera::preset(crate::scene::ViewDirection::PlusZ);
        let at = |x: f32, y: f32| Vec3::new(x, y, 0.5);
        let boxed = |from, to| picked(from, to, front);
        let (cube, circle) = (ShapeId(1), ShapeId(2));
        assert_eq!(boxed(at(-0.6, -0.6), at(3.2, 1.2)), [cube, circle]);
        assert_eq!(boxed(at(-0.6, 0.4), at(-0.4, 0.6)), [cube], "a corner");
        assert_eq!(boxed(at(-0.1, -0.1), at(0.1, 0.1)), [cube], "inside");
        assert_eq!(boxed(at(0.1, 0.1), at(-0.1, -0.1)), [cube], "backwards");
        assert_eq!(boxed(at(2.4, -0.3), at(2.6, 0.3)), [], "in the circle");
        assert_eq!(boxed(at(0.51, -0.4), at(0.9, 0.4)), [], "between");
        assert_eq!(boxed(at(0.0, 0.0), at(0.0, 0.2)), [], "no area");
    }

    #[test]
    fn what_reaches_from_before_the_eye_to_behind_it_is_in_the_box_where_it_is_seen() {
        let camera = Camera {
            target: Vec3::new(0.0, 0.0, -1.0),
            radius: 1.2,
            ..Camera::default()
        };
        // The far face is ahead as a whole, the right one reaches past the eye.
        let ahead = |x: f32, y: f32| Vec3::new(x, y, -1.0);
        let boxed = |from, to| picked(from, to, camera);
        assert_eq!(boxed(ahead(-0.1, -0.1), ahead(0.1, 0.1)), [ShapeId(1)]);
        assert_eq!(boxed(ahead(0.95, -0.1), ahead(1.1, 0.1)), [ShapeId(1)]);
    }
}
