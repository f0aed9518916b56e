//! The ground below shapes: how low they reach at rest, but for how far they were moved down.

use super::{EvaluatedGeometry, Shape};
use crate::math::{Aabb, Transform};
use glam::{Mat4, Vec3};

impl EvaluatedGeometry {
    /// Bounds in model space without a pose.
    fn bounds_at_rest(&self) -> Aabb {
        match &self.curves {
            Some(_) => self.bounds(),
            None => self.mesh.bounds(),
        }
    }

    /// Height, in the world, of the lowest vertex at rest, or of the box round a curve; infinite if there is none.
    pub fn lowest_at_rest(&self, world_from_model: Mat4) -> f32 {
        let up = world_from_model.row(1);
        // What is not turned needs no look at every vertex.
        let is_of_box = self.curves.is_some() || up.x == 0.0 && up.z == 0.0;
        let bounds = self.bounds_at_rest();
        match is_of_box && !bounds.is_empty() {
            true => bounds.transformed(world_from_model).min.y,
            false => lowest(&self.mesh.positions, world_from_model),
        }
    }

    /// Height, in the world, of the lowest vertex; infinite if there is none.
    pub fn lowest(&self, world_from_model: Mat4) -> f32 {
        lowest(self.positions(), world_from_model)
    }
}

/// See [`super::EvaluatedShape::ground`].
pub(super) fn ground(shape: &Shape, geometry: &EvaluatedGeometry) -> f32 {
    let world_from_model = shape.placement.transform.world_from_model();
    geometry.lowest_at_rest(world_from_model) + sunk(shape, geometry)
}

/// How far a shape was moved down from where it was inserted, in the world; 0 if it was not. What is scaled about its middle
/// has another position, but has not been moved; what is turned about its feet has its middle elsewhere, but has not been
/// moved either. Nor has a figure that is scaled about its feet, or about those that it had before it was turned.
fn sunk(shape: &Shape, geometry: &EvaluatedGeometry) -> f32 {
    let middle = geometry.bounds_at_rest().center();
    let is_figure = shape.front().is_some();
    let heights = |transform: Transform, upright: Transform| {
        let world_from_model = transform.world_from_model();
        let feet = |transform: Transform| geometry.lowest_at_rest(transform.world_from_model());
        let of_all = [
            transform.position.y,
            world_from_model.transform_point3(middle).y,
        ];
        let of_figure = is_figure.then(|| [feet(transform), feet(upright)]);
        of_all.into_iter().chain(of_figure.into_iter().flatten())
    };
    let (start, now) = (shape.start.transform, shape.placement.transform);
    let (before, now) = (heights(start, start), heights(now, shape.upright()));
    let down = before.zip(now);
    let down = down.map(|(before, now)| (before - now).max(0.0));
    // The middle of nothing is nowhere, and has not sunk either.
    down.fold(f32::INFINITY, f32::min)
}

/// Least height, in the world, of `positions` in a model's space; infinite without any.
fn lowest(positions: &[Vec3], world_from_model: Mat4) -> f32 {
    let up = world_from_model.row(1);
    let heights = positions.iter().map(|at| up.dot(at.extend(1.0)));
    heights.fold(f32::INFINITY, f32::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Influence, Joint, SkeletalModel};
    use crate::geometry::{Mesh, SharedMesh};
    use crate::math::Euler;
    use crate::revision::Revision;
    use crate::scene::{CharacterShape, Evaluator, NewShape, Scene, ShapeKind};
    use std::sync::Arc;

    /// A shape of this kind with vertices at the corners of the box from `low` to `high`, placed so since it was inserted at the origin.
    fn how_far_sunk(
        kind: ShapeKind,
        (low, high): (Vec3, Vec3),
        (y, scale, turn): (f32, Vec3, f32),
    ) -> f32 {
        let bounds = Aabb::from_points([low, high]);
        let mesh = SharedMesh::new(Mesh::new(bounds.corners().to_vec(), Vec::new()));
        let geometry = EvaluatedGeometry::rigid(mesh, bounds, Revision::new());
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Shape", kind));
        let shape = scene.shape_mut(id).unwrap();
        let transform = &mut shape.placement.transform;
        transform.position.y = y;
        transform.scale = scale;
        transform.rotation = Euler::from_degrees(Vec3::X * turn);
        sunk(shape, &geometry)
    }

    #[test]
    fn a_figure_has_sunk_if_it_was_moved_down_and_not_if_it_was_scaled_or_turned_about_itself() {
        let figure = || {
            let mut attachments = Attachments::new();
            attachments.push_vertex([Influence {
                joint: 0,
                weight: 1.0,
            }]);
            let skeleton = SkeletalModel::new(vec![Joint::default()]).unwrap();
            let mesh = Mesh::new(vec![Vec3::ZERO], Vec::new());
            let character = Character::new(skeleton, attachments, mesh).unwrap();
            ShapeKind::Character(CharacterShape::new(Arc::new(character)))
        };
        let sunk_by = |within: (Vec3, Vec3), y: f32, scale: f32, turn: f32| {
            how_far_sunk(figure(), within, (y, Vec3::splat(scale), turn))
        };
        let tall = (Vec3::new(-0.2, 0.0, 0.0), Vec3::new(0.2, 2.0, 0.1));
        assert_eq!(sunk_by(tall, -0.5, 1.0, 0.0), 0.5);
        assert_eq!(sunk_by(tall, 0.5, 1.0, 0.0), 0.0);
        // Twice as large about the middle, which stays at 1.
        assert_eq!(sunk_by(tall, -1.0, 2.0, 0.0), 0.0);
        assert_eq!(sunk_by(tall, -1.5, 2.0, 0.0), 0.5);
        assert_eq!(sunk_by(tall, 0.0, 1.0, 90.0), 0.0);
        // About its lower end, where the origin is in its middle.
        let round = (Vec3::new(-0.2, -1.0, 0.0), Vec3::new(0.2, 1.0, 0.1));
        assert_eq!(sunk_by(round, -0.5, 0.5, 0.0), 0.0);
        // The same of what is turned before: a corner is lower then.
        let cube = (Vec3::NEG_ONE, Vec3::ONE);
        assert_eq!(sunk_by(cube, -0.5, 0.5, 45.0), 0.0);
        assert_eq!(sunk_by(cube, -0.5, 1.0, 45.0), 0.5);
    }

    #[test]
    fn a_shape_that_is_no_figure_has_sunk_as_far_as_it_was_moved_down_however_it_was_scaled_and_turned()
     {
        let round = (Vec3::splat(-0.5), Vec3::splat(0.5));
        let long = Vec3::new(0.5, 0.5, 1.5);
        for y in [0.0, -0.3, -1.0] {
            let sunk = how_far_sunk(ShapeKind::Sphere, round, (y, long, 45.0));
            assert_eq!(sunk, -y);
        }
    }

    #[test]
    fn the_ground_is_below_the_lowest_vertex_and_not_below_a_turned_box_round_all() {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Sphere", ShapeKind::Sphere));
        let ground = |scene: &Scene| Evaluator::new().evaluate(scene, 0.0).shapes[0].ground;
        let before = ground(&scene);
        let transform = &mut scene.shape_mut(id).unwrap().placement.transform;
        transform.rotation = Euler::from_degrees(Vec3::new(30.0, 0.0, 40.0));
        assert!((ground(&scene) - before).abs() < 0.01, "{before}");
    }
}
