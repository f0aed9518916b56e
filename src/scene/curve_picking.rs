use super::{Camera, EvaluatedShape};
use crate::math::Ray;
use glam::{Vec2, Vec3};

/// How far from the ray a line or point is still meant, as a part of its distance from the eye:
/// about seven pixels of an 800×600 picture at the first field of view.
const REACH: f32 = 0.01;
/// How far from a control point the pointer still grabs it, in pixels.
const POINT_REACH: f32 = 8.0;

/// The control point of `shape` at `pixel` in a picture of `size`, from the top left: the indices
/// of its curve in the [`super::CurveSet`] and of the point in the curve. Of several within reach
/// the nearest in the picture; of points in one place the first. None of a shape that is hidden
/// or locked.
pub fn pick_control_point(
    shape: &EvaluatedShape,
    camera: &Camera,
    pixel: Vec2,
    size: Vec2,
) -> Option<(usize, usize)> {
    let mut nearest = None;
    let mut reach = POINT_REACH;
    if !shape.pickable {
        return None;
    }
    let curves = shape.geometry.curves.iter().flat_map(|all| &all.curves);
    for curve in curves {
        for (point, &position) in curve.control_points.iter().enumerate() {
            let world = shape.world_from_model.transform_point3(position);
            let place = camera.pixel(world, size);
            let Some(place) = place.filter(|_| camera.is_in_depth(world)) else {
                continue;
            };
            if place.distance(pixel) < reach {
                reach = place.distance(pixel);
                nearest = Some((curve.item, point));
            }
        }
    }
    nearest
}

/// Where `ray`, in the world, first passes within reach of a curve of `shape`, as the distance
/// along the ray.
pub(super) fn nearest_curve(shape: &EvaluatedShape, ray: &Ray) -> Option<f32> {
    let curves = shape.geometry.curves.iter().flat_map(|all| &all.curves);
    let segments = curves.flat_map(|curve| curve.points.windows(2));
    segments
        .filter_map(|pair| {
            let [a, b] = [&pair[0], &pair[1]]
                .map(|point| shape.world_from_model.transform_point3(point.position));
            let (distance, _) = passing(ray, closest_on_segment(ray, a, b))?;
            Some(distance)
        })
        .min_by(f32::total_cmp)
}

/// The distance along `ray` where it passes `point`, and by how much it misses it as a part of
/// that distance; `None` behind the eye and out of reach.
fn passing(ray: &Ray, point: Vec3) -> Option<(f32, f32)> {
    let distance = (point - ray.origin).dot(ray.direction) / ray.direction.length_squared();
    let far = distance * ray.direction.length();
    let miss = ray.at(distance).distance(point) / far;
    (distance > 0.0 && miss <= REACH).then_some((distance, miss))
}

/// The point between `a` and `b` that is closest to the line of `ray`.
fn closest_on_segment(ray: &Ray, a: Vec3, b: Vec3) -> Vec3 {
    let (along, to_start) = (b - a, a - ray.origin);
    // What is left of both across the ray.
    let across =
        |v: Vec3| v - ray.direction * (v.dot(ray.direction) / ray.direction.length_squared());
    let (along_across, start_across) = (across(along), across(to_start));
    let t = -start_across.dot(along_across) / along_across.length_squared();
    // A segment along the ray, or without length, divides by zero.
    if t.is_finite() {
        a + along * t.clamp(0.0, 1.0)
    } else {
        a
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Basis;
    use crate::scene::NewShape;
    use crate::scene::{
        CurveSet, CurveShape, Evaluated, Evaluator, Scene, ShapeId, ShapeKind, pick_shape,
    };

    fn scene(set: CurveSet) -> (Evaluated, ShapeId) {
        let mut scene = Scene::new();
        let kind = ShapeKind::Curve(CurveShape::new(set));
        let id = scene.add(NewShape::new("Curve", kind));
        if let Some(shape) = scene.shape_mut(id) {
            shape.placement.transform.position = Vec3::Y;
        }
        (Evaluator::new().evaluate(&scene, 0.0), id)
    }

    fn from_the_front(x: f32, y: f32) -> Ray {
        Ray {
            origin: Vec3::new(x, y, 5.0),
            direction: -Vec3::Z,
        }
    }

    #[test]
    fn a_curve_without_a_surface_is_picked_by_its_line() {
        let (evaluated, id) = scene(CurveSet::start_circle());
        let pick = |x, y| pick_shape(&evaluated, &from_the_front(x, y)).map(|(id, _)| id);
        assert_eq!(pick(1.02, 1.0), Some(id));
        assert_eq!(pick(0.0, 2.0), Some(id));
        assert_eq!(pick(0.0, 1.0), None);
        assert_eq!(pick(1.1, 1.0), None);
    }

    #[test]
    fn a_line_behind_the_eye_is_not_picked() {
        let (evaluated, _) = scene(CurveSet::start_circle());
        let away = Ray {
            origin: Vec3::new(1.0, 1.0, 5.0),
            direction: Vec3::Z,
        };
        assert_eq!(pick_shape(&evaluated, &away), None);
    }

    #[test]
    fn the_control_point_closest_to_the_pointer_is_picked() {
        let (evaluated, _) = scene(CurveSet::start_spline(Basis::Bezier));
        let (shape, size) = (&evaluated.shapes[0], Vec2::new(800.0, 600.0));
        let camera = Camera::default();
        let pick = |pixel| pick_control_point(shape, &camera, pixel, size);
        let at = camera.pixel(Vec3::new(1.4, 0.5, 0.0), size).unwrap();
        assert_eq!(pick(at + Vec2::new(5.0, -6.0)), Some((0, 1)));
        assert_eq!(pick(at + Vec2::new(6.0, -6.0)), None);
    }

    #[test]
    fn a_control_point_in_front_of_the_near_plane_is_not_picked() {
        let (evaluated, _) = scene(CurveSet::start_spline(Basis::Bezier));
        let point = Vec3::new(1.4, 0.5, 0.0);
        let size = Vec2::new(800.0, 600.0);
        for (radius, picked) in [(0.5, Some((0, 1))), (0.09, None)] {
            let camera = Camera {
                target: point,
                radius,
                ..Camera::default()
            };
            let pick = pick_control_point(&evaluated.shapes[0], &camera, size * 0.5, size);
            assert_eq!(pick, picked);
        }
    }
}
