use super::{Camera, Evaluated, EvaluatedShape, ShapeId};
use crate::math::Ray;
use glam::{Vec2, Vec3};

/// Relative error of distances to the same point.
const ROUNDING: f32 = 1e-4;

/// Picks the shape whose surface `ray`, in the world, meets first, or whose curve it first passes
/// close to; with the distance along the ray. Shapes that are hidden or locked are ignored.
///
/// A character shown as a skeleton is picked by its mesh all the same: thin bones are hard to hit,
/// and nothing else is in that place.
pub fn pick_shape(evaluated: &Evaluated, ray: &Ray) -> Option<(ShapeId, f32)> {
    let shapes = evaluated.shapes.iter().filter(|shape| shape.pickable);
    let mut nearest = None;
    let mut keep = |id: ShapeId, distance: Option<f32>| {
        if let Some(distance) = distance
            && nearest.is_none_or(|(_, least)| distance < least)
        {
            nearest = Some((id, distance));
        }
        nearest.map_or(f32::INFINITY, |(_, least)| least)
    };
    // Boxes first, then the meshes in the order in which the ray enters their boxes: those behind a
    // hit are not tested, and characters that the pointer is not near are not skinned.
    let mut boxes = Vec::new();
    for shape in shapes {
        keep(shape.id, nearest_curve(shape, ray));
        let model_ray = ray.transformed(shape.world_from_model.inverse());
        if let Some(entry) = model_ray.entry(&shape.geometry.conservative_bounds()) {
            boxes.push((entry, shape, model_ray));
        }
    }
    boxes.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (entry, shape, model_ray) in boxes {
        let least = keep(shape.id, None);
        // By rounding, a hit on the side of a box may come before the box.
        if entry * (1.0 - ROUNDING) > least {
            break;
        }
        keep(shape.id, shape.geometry.nearest_surface(&model_ray));
    }
    nearest
}

/// Distance from the ray up to which a curve is picked, relative to its distance from the eye:
/// about seven pixels of an 800×600 picture at the initial field of view.
const LINE_REACH: f32 = 0.01;
/// Distance from a control point, in pixels, up to which it is picked.
const POINT_REACH: f32 = 8.0;

/// Picks the control point of `shape` at `pixel`, from the top left, in a picture of `size`: the
/// indices of its curve in the [`super::CurveSet`] and of the point in the curve. Of several within
/// reach the nearest in the picture; of points in one place the first. `None` if the shape is
/// hidden or locked.
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

/// Distance at which `ray`, in the world, first passes within reach of a curve of `shape`.
fn nearest_curve(shape: &EvaluatedShape, ray: &Ray) -> Option<f32> {
    let curves = shape.geometry.curves.iter().flat_map(|all| &all.curves);
    let segments = curves.flat_map(|curve| curve.points.windows(2));
    segments
        .filter_map(|pair| {
            let [a, b] = [&pair[0], &pair[1]]
                .map(|point| shape.world_from_model.transform_point3(point.position));
            passing(ray, ray.nearest_on_segment(a, b))
        })
        .min_by(f32::total_cmp)
}

/// Distance at which `ray` passes `point`; `None` behind the eye and out of reach.
fn passing(ray: &Ray, point: Vec3) -> Option<f32> {
    let distance = (point - ray.origin).dot(ray.direction) / ray.direction.length_squared();
    let far = distance * ray.direction.length();
    let miss = ray.at(distance).distance(point) / far;
    (distance > 0.0 && miss <= LINE_REACH).then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
    use crate::geometry::{Basis, Mesh};
    use crate::math::{Euler, Transform};
    use crate::scene::{
        CharacterShape, CurveSet, CurveShape, Evaluator, NewShape, Scene, ShapeKind,
    };
    use proptest::prelude::*;
    use std::sync::Arc;

    #[test]
    fn the_nearer_of_two_shapes_is_picked_and_empty_space_picks_none() {
        let mut scene = Scene::new();
        let near = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let far = scene.add(NewShape::new("Sphere", ShapeKind::Sphere));
        if let Some(shape) = scene.shape_mut(far) {
            shape.placement.transform.position = Vec3::new(0.3, 0.0, -4.0);
            shape.placement.transform.scale = Vec3::splat(3.0);
        }
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let ray = |x| Ray {
            origin: Vec3::new(x, 0.0, 5.0),
            direction: -Vec3::Z,
        };
        assert_eq!(pick_shape(&evaluated, &ray(0.0)), Some((near, 4.5)));
        assert_eq!(
            pick_shape(&evaluated, &ray(1.0)).map(|(id, _)| id),
            Some(far)
        );
        assert_eq!(pick_shape(&evaluated, &ray(4.0)), None);
    }

    /// Two triangles, one held by each of two joints, a third shared by both with weights that sum
    /// to less than one.
    fn character(bend: f32) -> ShapeKind {
        let joint = |parent, offset| Joint {
            parent,
            offset,
            ..Joint::default()
        };
        let joints = vec![joint(None, Vec3::ZERO), joint(Some(0), Vec3::X)];
        let mut attachments = Attachments::new();
        let corners = [Vec3::ZERO, Vec3::X * 0.9, Vec3::Y];
        let mut positions = Vec::new();
        for (weights, at) in [([1.0, 0.0], 0.0), ([0.0, 1.0], 1.0), ([0.3, 0.5], 2.0)] {
            for corner in corners {
                let influence = |joint: usize| Influence {
                    joint: joint as u32,
                    weight: weights[joint],
                };
                attachments.push_vertex([influence(0), influence(1)]);
                positions.push(corner + Vec3::X * at);
            }
        }
        let mesh = Mesh::new(positions, vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]]);
        let skeleton = SkeletalModel::new(joints).unwrap();
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(Vec3::new(0.0, bend, bend)));
        shape.set_pose(pose);
        ShapeKind::Character(shape)
    }

    /// Every triangle of every shape, in the world.
    fn by_brute_force(evaluated: &Evaluated, ray: &Ray) -> Option<(ShapeId, f32)> {
        let mut nearest: Option<(ShapeId, f32)> = None;
        for shape in evaluated.shapes.iter().filter(|shape| shape.pickable) {
            let geometry = &shape.geometry;
            let world = |corner: u32| {
                let position = geometry.positions()[corner as usize];
                shape.world_from_model.transform_point3(position)
            };
            for triangle in &geometry.mesh.triangles {
                if let Some(hit) = ray.triangle(triangle.map(world))
                    && nearest.is_none_or(|(_, least)| hit.distance < least)
                {
                    nearest = Some((shape.id, hit.distance));
                }
            }
        }
        nearest
    }

    fn vectors(size: f32) -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-size..size).prop_map(Vec3::from_array)
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

        #[test]
        fn what_is_picked_is_what_the_ray_meets_first_of_all_triangles(
            placed in prop::collection::vec((vectors(1.0), vectors(3.0), vectors(2.0), 0..4_u8), 1..9),
            bend in -180.0..180.0_f32,
            eye in vectors(1.0), aim in vectors(1.0), hidden in 0..9_usize,
        ) {
            let mut scene = Scene::new();
            for (index, (position, turn, scale, kind)) in placed.into_iter().enumerate() {
                let kind = match kind {
                    0 => ShapeKind::Cube,
                    1 => ShapeKind::Sphere,
                    _ => character(bend),
                };
                let id = scene.add(NewShape::new("Shape", kind));
                let shape = scene.shape_mut(id).unwrap();
                shape.locked = index == hidden;
                shape.placement.transform = Transform { position, rotation: Euler { radians: turn }, scale: scale + scale.signum() * 0.2 };
            }
            let eye = eye.normalize_or(Vec3::Z) * 9.0;
            let ray = Ray { origin: eye, direction: (aim - eye).normalize_or(Vec3::X) };
            let picked = pick_shape(&Evaluator::new().evaluate(&scene, 0.0), &ray);
            let wanted = by_brute_force(&Evaluator::new().evaluate(&scene, 0.0), &ray);
            match (picked, wanted) {
                (None, None) => {}
                (Some((id, at)), Some((wanted, distance))) => {
                    prop_assert!((at - distance).abs() < 1e-3, "{picked:?} {wanted:?} {distance}");
                    prop_assert!(id == wanted || (at - distance).abs() < 1e-4);
                }
                // Rounding decides at the edge of a triangle.
                (found, other) => {
                    let near = |to: Vec3| Ray { direction: to.normalize_or(Vec3::X), ..ray };
                    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
                    let around = [Vec3::X, Vec3::Y, Vec3::Z].iter().flat_map(|&side| [side, -side]);
                    let hits = around.filter(|&side| by_brute_force(&evaluated, &near(ray.direction + side * 1e-4)).is_some());
                    let count = hits.count();
                    prop_assert!(count > 0 && count < 6, "{found:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn no_vertex_is_moved_for_a_ray_that_passes_a_character_or_meets_something_before_it() {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Character", character(30.0)));
        let cube = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        scene.shape_mut(cube).unwrap().placement.transform.position = Vec3::new(0.2, 0.2, 2.0);
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let deformation = evaluated.shapes[0].geometry.deformation.as_ref().unwrap();
        let ray = |x, y| Ray {
            origin: Vec3::new(x, y, 5.0),
            direction: -Vec3::Z,
        };
        assert_eq!(pick_shape(&evaluated, &ray(-2.0, 0.2)), None);
        let found = pick_shape(&evaluated, &ray(0.2, 0.2)).map(|(shape, _)| shape);
        assert_eq!(found, Some(cube));
        assert!(!deformation.is_worked_out());
        let found = pick_shape(&evaluated, &ray(0.75, 0.1)).map(|(shape, _)| shape);
        assert_eq!(found, Some(id));
    }

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
