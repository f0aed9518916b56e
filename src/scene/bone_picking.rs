//! Bones under the pointer.

use super::picking::pick_shape;
use super::{
    Camera, CharacterShape, Evaluated, EvaluatedShape, ModelDisplay, Scene, ShapeId, ShapeKind,
};
use crate::character::Influence;
use crate::math::{Cylinder, Ray, distance_from_segment};
use glam::{Vec2, Vec3};

/// Half the width, in pixels, in which the line of a bone is under the pointer.
const LINE: f32 = 3.0;

/// Distance from a joint, in pixels, within which the pointer is on its ball …
const BALL: f32 = 6.0;
/// … and relative to the length of the bone that ends there, which is picked beyond it.
const MOST_OF_BONE: f32 = 0.25;

/// Most triangles of a mesh whose surface decides between bones: a larger one would hold the pointer up after each
/// change of the pose.
const LARGEST: usize = 200_000;

/// Radius of the cylinder around a bone by which it is picked, in the character's space.
const BONE_RADIUS: f32 = 0.1;
/// Upper bound of that radius, relative to the bone's length: the cylinders of fingers would
/// otherwise hide each other and the hand.
const MOST_OF_LENGTH: f32 = 0.4;

/// Bone under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoneHit {
    /// Identifier of the character.
    pub shape: ShapeId,
    /// Index of the joint that turns the bone.
    pub joint: usize,
    /// Index in [`crate::character::Character::bones`].
    pub bone: usize,
    /// Distance from the eye, in the world, along the ray under the pointer.
    pub distance: f32,
    /// Intersection of that ray with the bone's cylinder, in the world.
    pub point: Vec3,
}

/// Bones of an evaluated character, in the order of [`crate::character::Character::bones`]: the
/// index of the joint, and both ends in the world. Empty if the shape is no character.
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

/// Picks the bone of any character that the ray under `pixel`, in a picture of `size`, meets first.
/// A bone is a cylinder with flat ends, of radius 0.1 times the shape's scale, thinner for short
/// bones, and at least `reach` pixels on the screen, so that thin rigs can be picked. Where there is none, the balls of
/// joints reach beyond the ends. Characters that are hidden or locked are ignored.
///
/// Where the ray meets several bones and a mesh is seen there, it is one of that character: one whose line is under the
/// pointer, or else the one that moves most what is seen, or else the first. A hand before a thigh is a hand, though
/// the thigh's cylinder reaches out before it, and what is stuck inside another character is not seen.
pub fn pick_bone(
    scene: &Scene,
    evaluated: &Evaluated,
    camera: &Camera,
    pixel: Vec2,
    size: Vec2,
    reach: f32,
) -> Option<BoneHit> {
    let ray = camera.ray(pixel, size);
    let characters = || {
        let shapes = scene.shapes().iter().zip(&evaluated.shapes);
        shapes
            .filter(|(shape, _)| matches!(shape.kind, ShapeKind::Character(_)))
            .filter(|(_, evaluated)| evaluated.pickable)
            .map(|(_, evaluated)| evaluated)
    };
    let hit = |shape: &EvaluatedShape, bone: usize, (joint, start, end), beyond: f32| {
        let nearest = ray.nearest_on_segment(start, end);
        let depth = (nearest - ray.origin).dot(ray.direction).max(0.0);
        let pixel_there = camera.pixel_at_depth(depth, size.y);
        let radius = BONE_RADIUS * shape.scale();
        let radius = radius.min(start.distance(end) * MOST_OF_LENGTH);
        let along = beyond * pixel_there * (end - start).normalize_or_zero();
        let cylinder = Cylinder {
            start: start - along,
            end: end + along,
            radius: radius.max(reach * pixel_there),
        };
        let distance = cylinder.entry(&ray)?;
        let hit = BoneHit {
            shape: shape.id,
            joint,
            bone,
            distance,
            point: ray.at(distance),
        };
        let place = [start, end].map(|at| camera.pixel(at, size));
        Some((hit, is_on_line(place, pixel)))
    };
    let hits_beyond = |beyond: f32| -> Vec<(BoneHit, bool)> {
        let bones = characters().flat_map(|shape| {
            let bones = bones_in_world(scene, shape).enumerate();
            bones.filter_map(move |(index, bone)| hit(shape, index, bone, beyond))
        });
        bones.collect()
    };
    let mut hits = hits_beyond(0.0);
    if hits.is_empty() {
        hits = hits_beyond(BALL);
    }
    hits.sort_by(|(a, _), (b, _)| a.distance.total_cmp(&b.distance));
    let (first, _) = *hits.first()?;
    let is_first = |hit: &BoneHit| (hit.shape, hit.joint) == (first.shape, first.joint);
    if hits.iter().all(|(hit, _)| is_first(hit)) {
        return Some(first);
    }
    let Some(Seen::Mesh(shape, joint)) = seen_by(scene, evaluated, &ray) else {
        return Some(first);
    };
    hits.retain(|(hit, _)| hit.shape == shape);
    let on_line = hits.iter().find(|(_, is_on_line)| *is_on_line);
    let joint = joint.map(|influence| influence.joint as usize);
    let seen = || hits.iter().find(|(hit, _)| Some(hit.joint) == joint);
    let hit = on_line.or_else(seen).or_else(|| hits.first());
    Some(hit.map_or(first, |(hit, _)| *hit))
}

/// The bone that was picked as `hit`, or else the one that the joint at its end turns, if the ball of that is under
/// `pixel`, in a picture of `size`; where the ray met the bone stays.
pub fn turned_there(
    scene: &Scene,
    evaluated: &Evaluated,
    camera: &Camera,
    hit: BoneHit,
    (pixel, size): (Vec2, Vec2),
) -> BoneHit {
    let bones = || {
        let shape = evaluated.shape(hit.shape).into_iter();
        shape.flat_map(|shape| bones_in_world(scene, shape))
    };
    let Some((_, start, end)) = bones().nth(hit.bone) else {
        return hit;
    };
    if !is_at_end([start, end].map(|at| camera.pixel(at, size)), pixel) {
        return hit;
    }
    let near = start.distance(end) * 1e-3;
    let mut others = bones().enumerate();
    let beyond = others.find(|(_, (_, other, _))| other.distance(end) <= near);
    beyond.map_or(hit, |(bone, (joint, ..))| BoneHit { joint, bone, ..hit })
}

/// Whether the end of a bone between two places in a picture has its ball at `pixel`.
fn is_at_end([start, end]: [Option<Vec2>; 2], pixel: Vec2) -> bool {
    start.zip(end).is_some_and(|(start, end)| {
        pixel.distance(end) <= BALL.min(start.distance(end) * MOST_OF_BONE)
    })
}

/// Whether the line between two places in a picture, if both are seen, is drawn at `pixel`.
fn is_on_line([start, end]: [Option<Vec2>; 2], pixel: Vec2) -> bool {
    let line = start.zip(end);
    line.is_some_and(|(start, end)| distance_from_segment(pixel, [start, end]) < LINE)
}

/// What is seen at the end of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Seen {
    /// The mesh of a character, and the strongest influence of a joint on it there.
    Mesh(ShapeId, Option<Influence>),
    /// A shape without bones, or a character of which the skeleton is seen.
    Other(ShapeId),
}

/// The shape that is seen at the end of `ray`; `None` if that is nothing, and where a shape is too large to find it in time.
pub fn shape_seen_by(evaluated: &Evaluated, ray: &Ray) -> Option<ShapeId> {
    let are_large = |shape: &EvaluatedShape| shape.geometry.mesh.triangles.len() > LARGEST;
    if evaluated.shapes.iter().any(are_large) {
        return None;
    }
    pick_shape(evaluated, ray).map(|(id, _)| id)
}

/// What is seen at the end of `ray`; `None` where no shape is ([`shape_seen_by`]).
pub fn seen_by(scene: &Scene, evaluated: &Evaluated, ray: &Ray) -> Option<Seen> {
    let id = shape_seen_by(evaluated, ray)?;
    let character = scene.character(id);
    let shows_mesh = |character: &&CharacterShape| character.display.mode != ModelDisplay::Skeleton;
    let Some(character) = character.filter(shows_mesh) else {
        return Some(Seen::Other(id));
    };
    let shape = evaluated.shape(id)?;
    let ray = ray.transformed(shape.world_from_model.inverse());
    let vertex = shape.geometry.nearest_vertex(&ray)?;
    let attachments = character.character.attachments();
    if vertex >= attachments.vertex_count() {
        return Some(Seen::Mesh(id, None));
    }
    let influences = attachments.of_vertex(vertex).iter();
    let strongest = influences.max_by(|a, b| a.weight.total_cmp(&b.weight));
    Some(Seen::Mesh(id, strongest.copied()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Joint, SkeletalModel};
    use crate::geometry::Mesh;
    use crate::scene::{CharacterShape, Evaluator, NewShape};
    use std::sync::Arc;

    /// Two bones upward from the ground, the first at `front` along Z and the other just behind it, between two squares:
    /// the front one is moved most by the joint `in_front`, the back one by the other.
    fn figure(front: f32, in_front: u32, mode: ModelDisplay) -> ShapeKind {
        let joint = |z| Joint {
            parent: None,
            offset: Vec3::new(0.0, 0.0, z),
            tip: Some(Vec3::Y),
            ..Joint::default()
        };
        let mut attachments = Attachments::new();
        let (mut positions, mut triangles) = (Vec::new(), Vec::new());
        for (z, joint) in [(0.5, in_front), (-0.5, 1 - in_front)] {
            let first = positions.len() as u32;
            for [x, y] in [[-1.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 1.0]] {
                let least = Influence {
                    joint: 1 - joint,
                    weight: 0.2,
                };
                attachments.push_vertex([Influence { joint, weight: 0.8 }, least]);
                positions.push(Vec3::new(x, y, z));
            }
            triangles.extend(
                [[0, 1, 2], [0, 2, 3]].map(|corners: [u32; 3]| corners.map(|at| at + first)),
            );
        }
        let skeleton = SkeletalModel::new(vec![joint(front), joint(front - 0.05)]).unwrap();
        let mesh = Mesh::new(positions, triangles);
        let character = Character::new(skeleton, attachments, mesh).unwrap();
        let mut shape = CharacterShape::new(Arc::new(character));
        shape.display.mode = mode;
        ShapeKind::Character(shape)
    }

    /// A camera before the middle of a figure, and the size of its picture.
    fn view() -> (Camera, Vec2) {
        let camera = Camera {
            target: Vec3::new(0.0, 0.5, 0.0),
            radius: 5.0,
            ..Camera::default()
        };
        (camera, Vec2::new(800.0, 600.0))
    }

    /// The index of the character, and the joint, whose bone is beside the middle of a picture.
    fn picked(figures: Vec<(ShapeKind, Vec3)>) -> Option<(usize, usize)> {
        let mut scene = Scene::new();
        let mut ids = Vec::new();
        for (kind, place) in figures {
            let id = scene.add(NewShape::new("Figure", kind));
            scene.shape_mut(id).unwrap().placement.transform.position = place;
            ids.push(id);
        }
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let (camera, size) = view();
        let beside = size / 2.0 + Vec2::new(4.0, 0.0);
        let hit = pick_bone(&scene, &evaluated, &camera, beside, size, 4.0)?;
        Some((ids.iter().position(|id| *id == hit.shape)?, hit.joint))
    }

    #[test]
    fn of_several_bones_the_one_is_picked_that_moves_what_is_seen_there() {
        for (in_front, mode, joint) in [
            (0, ModelDisplay::Mesh, 0),
            (1, ModelDisplay::Mesh, 1),
            (1, ModelDisplay::Both, 1),
            (1, ModelDisplay::Skeleton, 0),
        ] {
            let found = picked(vec![(figure(0.0, in_front, mode), Vec3::ZERO)]);
            assert_eq!(found, Some((0, joint)), "{in_front} {mode:?}");
        }
    }

    #[test]
    fn on_the_ball_between_two_bones_the_one_is_picked_that_the_joint_there_turns() {
        let upward = |parent, offset| Joint {
            parent,
            offset,
            tip: Some(Vec3::Y * 0.5),
            ..Joint::default()
        };
        let joints = vec![upward(None, Vec3::ZERO), upward(Some(0), Vec3::Y * 0.5)];
        let skeleton = SkeletalModel::new(joints).unwrap();
        let mut attachments = Attachments::new();
        let of_first = Influence {
            joint: 0,
            weight: 1.0,
        };
        let corners = [Vec3::ZERO, Vec3::X * 0.1, Vec3::Y];
        corners
            .iter()
            .for_each(|_| attachments.push_vertex([of_first]));
        let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]);
        let character = Arc::new(Character::new(skeleton, attachments, mesh).unwrap());
        let size = Vec2::new(800.0, 600.0);
        let camera = Camera {
            target: Vec3::new(0.0, 0.5, 0.0),
            radius: 3.0,
            ..Camera::default()
        };
        for mode in [ModelDisplay::Skeleton, ModelDisplay::Both] {
            let mut shape = CharacterShape::new(character.clone());
            shape.display.mode = mode;
            let mut scene = Scene::new();
            scene.add(NewShape::new("Arm", ShapeKind::Character(shape)));
            let evaluated = Evaluator::new().evaluate(&scene, 0.0);
            // The joint between them is in the middle of the picture, and the first bone below.
            for (below, joint) in [(-20.0, 1), (-3.0, 1), (0.0, 1), (4.0, 1), (20.0, 0)] {
                let pixel = size / 2.0 + Vec2::new(1.0, below);
                let hit = pick_bone(&scene, &evaluated, &camera, pixel, size, 4.0).unwrap();
                let hit = turned_there(&scene, &evaluated, &camera, hit, (pixel, size));
                assert_eq!(hit.joint, joint, "{mode:?} {below}");
            }
        }
    }

    #[test]
    fn the_whole_ball_at_the_end_of_a_bone_picks_it_and_nothing_beyond_does() {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new(
            "Figure",
            figure(0.0, 0, ModelDisplay::Skeleton),
        ));
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let (camera, size) = view();
        let shape = evaluated.shape(id).unwrap();
        let (_, start, end) = bones_in_world(&scene, shape).next().unwrap();
        for (place, away) in [(start, 1.0), (end, -1.0)] {
            let place = camera.pixel(place, size).unwrap();
            for (beyond, is_picked) in [(-5.0, true), (2.0, true), (5.5, true), (9.0, false)] {
                let pixel = place + Vec2::new(3.0, away * beyond);
                let hit = pick_bone(&scene, &evaluated, &camera, pixel, size, 4.0);
                assert_eq!(hit.is_some(), is_picked, "{away} {beyond}");
            }
        }
    }

    #[test]
    fn a_bone_that_is_stuck_inside_another_character_is_not_picked() {
        for (z, expected) in [(-0.1, 0), (0.1, 1)] {
            // Its bones are before ours, whichever mesh is in front.
            let [ours, other] = [0.0, 0.3].map(|front| figure(front, 0, ModelDisplay::Mesh));
            let found = picked(vec![(ours, Vec3::ZERO), (other, Vec3::Z * z)]);
            assert_eq!(found, Some((expected, 0)), "{z}");
        }
    }
}
