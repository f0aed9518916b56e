use super::curve_picking::nearest_curve;
use super::{Evaluated, EvaluatedShape, ShapeId};
use crate::geometry::nearest_triangle;
use crate::math::Ray;

/// The shape whose surface `ray`, in the world, meets first, or whose curve it first passes close
/// by, with the distance along the ray. It passes through shapes that are hidden or locked.
///
/// A character shown as a skeleton is picked by its mesh all the same: thin bones are hard to
/// hit and nothing else stands in that place.
pub fn pick_shape(evaluated: &Evaluated, ray: &Ray) -> Option<(ShapeId, f32)> {
    evaluated
        .shapes
        .iter()
        .filter(|shape| shape.pickable)
        .filter_map(|shape| {
            let hits = [nearest_surface(shape, ray), nearest_curve(shape, ray)];
            let nearest = hits.into_iter().flatten().min_by(f32::total_cmp)?;
            Some((shape.id, nearest))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

fn nearest_surface(shape: &EvaluatedShape, ray: &Ray) -> Option<f32> {
    let model_from_world = shape.world_from_model.inverse();
    let model_ray = ray.transformed(model_from_world);
    if !model_ray.meets(&shape.geometry.bounds()) {
        return None;
    }
    let geometry = &shape.geometry;
    let (_, hit) = nearest_triangle(&model_ray, geometry.positions(), &geometry.mesh.triangles)?;
    Some(hit.distance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Evaluator, Scene, ShapeKind};
    use glam::Vec3;

    #[test]
    fn the_nearer_of_two_shapes_is_picked_and_empty_space_picks_none() {
        let mut scene = Scene::new();
        let near = scene.add("Cube".into(), ShapeKind::Cube, None);
        let far = scene.add("Sphere".into(), ShapeKind::Sphere, None);
        if let Some(shape) = scene.shape_mut(far) {
            shape.placement.transform.position = Vec3::new(0.3, 0.0, -4.0);
            shape.placement.transform.scale = Vec3::splat(3.0);
        }
        let evaluated = Evaluator::new().evaluate(&scene);
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
}
