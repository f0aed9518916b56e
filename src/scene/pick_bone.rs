use super::{Camera, Evaluated, EvaluatedShape, Scene, ShapeId, ShapeKind};
use crate::math::{Cylinder, Ray};
use glam::{Vec2, Vec3};

/// Radius of the cylinder round a bone that can be hit, in the character's space.
const RADIUS: f32 = 0.1;
/// The most it is, as a share of the bone's length: the cylinders of fingers would else hide
/// each other and the hand.
const MOST_OF_LENGTH: f32 = 0.4;
/// The least it is on screen, in pixels, so that thin rigs can be hit.
const LEAST_PIXELS: f32 = 8.0;

/// A bone under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoneHit {
    /// The character.
    pub shape: ShapeId,
    /// The joint that turns the bone.
    pub joint: usize,
    /// Index in [`crate::character::Character::bones`].
    pub bone: usize,
    /// Along the ray under the pointer, whose direction has unit length.
    pub distance: f32,
    /// Where that ray meets the bone's cylinder, in the world.
    pub point: Vec3,
}

/// Both ends in the world of every bone of `shape` as it stands, in the order of
/// [`crate::character::Character::bones`]; none if it is no character.
pub fn bones_in_world<'a>(
    scene: &'a Scene,
    evaluated: &'a EvaluatedShape,
) -> impl Iterator<Item = (usize, Vec3, Vec3)> + 'a {
    let world = evaluated.world_from_model;
    let figure = evaluated.geometry.figure.as_ref();
    let bones = scene
        .character(evaluated.id)
        .map_or(&[][..], |character| character.character.bones());
    bones.iter().filter_map(move |bone| {
        let (start, end) = bone.ends(&figure?.model_from_joint)?;
        let (start, end) = (world.transform_point3(start), world.transform_point3(end));
        Some((bone.joint, start, end))
    })
}

/// The bone of any character that the ray under `pixel`, in a picture of `size`, meets first:
/// a cylinder with flat ends round each bone, of radius 0.1 times the shape's scale, slimmer for
/// short bones, and never so thin that it is hard to point at. Characters that are hidden or
/// locked have none.
pub fn pick_bone(
    scene: &Scene,
    evaluated: &Evaluated,
    camera: &Camera,
    pixel: Vec2,
    size: Vec2,
) -> Option<BoneHit> {
    let ray = camera.ray(pixel, size);
    let world_per_pixel = 2.0 * (camera.fovy * 0.5).tan() / size.y;
    let characters = scene
        .shapes()
        .iter()
        .zip(&evaluated.shapes)
        .filter(|(shape, _)| matches!(shape.kind, ShapeKind::Character(_)))
        .filter(|(_, evaluated)| evaluated.pickable);
    let hits = characters.flat_map(|(_, shape)| {
        let determinant = shape.world_from_model.determinant();
        let radius = RADIUS * determinant.abs().cbrt();
        bones_in_world(scene, shape)
            .enumerate()
            .filter_map(move |(bone, (joint, start, end))| {
                let depth = depth_where_nearest(&ray, start, end);
                let least = LEAST_PIXELS * world_per_pixel * depth;
                let radius = radius.min(start.distance(end) * MOST_OF_LENGTH);
                let cylinder = Cylinder {
                    start,
                    end,
                    radius: radius.max(least),
                };
                let distance = cylinder.entry(&ray)?;
                Some(BoneHit {
                    shape: shape.id,
                    joint,
                    bone,
                    distance,
                    point: ray.at(distance),
                })
            })
    });
    hits.min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// How far along the ray, of unit direction, the segment comes nearest to it; not below zero.
fn depth_where_nearest(ray: &Ray, start: Vec3, end: Vec3) -> f32 {
    let across = |point: Vec3| (point - ray.origin).reject_from_normalized(ray.direction);
    let (from, to) = (across(start), across(end));
    let along = to - from;
    let share = if along == Vec3::ZERO {
        0.0
    } else {
        (-from.dot(along) / along.length_squared()).clamp(0.0, 1.0)
    };
    let nearest = start.lerp(end, share);
    (nearest - ray.origin).dot(ray.direction).max(0.0)
}
