use super::EvaluatedShape;
use crate::math::Ray;
use glam::Vec3;

/// How far from the ray a line or point is still meant, as a part of its distance from the eye:
/// about seven pixels of an 800×600 picture at the first field of view.
const REACH: f32 = 0.01;

/// A control point that a ray passes close by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlPointHit {
    /// Index of its curve in the [`super::CurveSet`].
    pub curve: usize,
    /// Its index in the curve.
    pub point: usize,
    /// Distance along the ray, in multiples of its direction.
    pub distance: f32,
}

/// The control point of `shape` that `ray`, in the world, passes closest by, if one is within
/// reach. Of points in one place it is the first.
pub fn pick_control_point(shape: &EvaluatedShape, ray: &Ray) -> Option<ControlPointHit> {
    let mut best: Option<(f32, ControlPointHit)> = None;
    let curves = shape.geometry.curves.iter().flat_map(|all| &all.curves);
    for curve in curves {
        for (point, &position) in curve.control_points.iter().enumerate() {
            let world = shape.world_from_model.transform_point3(position);
            let Some((distance, miss)) = passing(ray, world) else {
                continue;
            };
            if best.is_none_or(|(closest, _)| miss < closest) {
                let hit = ControlPointHit {
                    curve: curve.item,
                    point,
                    distance,
                };
                best = Some((miss, hit));
            }
        }
    }
    best.map(|(_, hit)| hit)
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
    use crate::scene::{
        CurveSet, CurveShape, Evaluated, Evaluator, Scene, ShapeId, ShapeKind, pick_shape,
    };

    fn scene(set: CurveSet) -> (Evaluated, ShapeId) {
        let mut scene = Scene::new();
        let kind = ShapeKind::Curve(CurveShape::new(set));
        let id = scene.add("Curve".into(), kind, None);
        if let Some(shape) = scene.shape_mut(id) {
            shape.placement.transform.position = Vec3::Y;
        }
        (Evaluator::new().evaluate(&scene), id)
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
    fn the_control_point_closest_to_the_ray_is_picked() {
        let (evaluated, _) = scene(CurveSet::start_spline(Basis::Bezier));
        let pick = |x, y| pick_control_point(&evaluated.shapes[0], &from_the_front(x, y));
        let hit = pick(-0.48, 2.01).unwrap();
        assert_eq!((hit.curve, hit.point, hit.distance), (0, 1, 5.0));
        assert_eq!(pick(0.0, 1.0), None);
    }
}
