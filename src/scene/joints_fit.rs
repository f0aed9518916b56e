//! The camera before joints: what is framed with them, and that nothing of their character is cut open before them.

use super::{Camera, EvaluatedShape, FitArea, ModelDisplay, Scene, bones_in_world};
use crate::character::{Attachments, Character, Influence};
use crate::math::{Aabb, Ray};
use std::collections::HashSet;

/// Part of the distance to the target that nothing before what is fitted is nearer than: it would fill the picture.
const NEAREST: f32 = 0.3;

/// Size of what is below a joint, by that of its own skin, up to which it belongs to it: the two ends of a finger are about as
/// long as its first bone.
const SMALLER: f32 = 1.1;

/// Factor by which the eye is farther away at each try.
const FARTHER: f32 = 1.05;

impl Camera {
    /// Fits joints of an evaluated character into the free part of a picture as [`Camera::fit`] does: their bones, and
    /// where the mesh is shown the skin that is theirs, with that of smaller parts below them: fingers belong to a hand.
    /// The eye stays outside of the mesh. Whether there is anything to fit; if not, the camera is as it was.
    pub fn fit_joints(
        &mut self,
        scene: &Scene,
        shape: &EvaluatedShape,
        joints: &[usize],
        area: FitArea,
    ) -> bool {
        let Some(shown) = scene.character(shape.id) else {
            return false;
        };
        let has_skin = shown.display.mode != ModelDisplay::Skeleton
            && !shape.geometry.mesh.triangles.is_empty();
        let parts = match has_skin {
            true => with_smaller_parts(&shown.character, joints),
            false => joints.iter().copied().collect(),
        };
        let bones = bones_in_world(scene, shape).filter(|(joint, ..)| parts.contains(joint));
        let mut bounds = Aabb::from_points(bones.flat_map(|(_, start, end)| [start, end]));
        if has_skin {
            let owners = shown.character.attachments().vertices().map(owner);
            let vertices = shape.geometry.positions().iter().zip(owners);
            let own = vertices.filter(|(_, owner)| owner.is_some_and(|it| parts.contains(&it)));
            let own = own.map(|(at, _)| shape.world_from_model.transform_point3(*at));
            bounds = bounds.union(Aabb::from_points(own));
        }
        if bounds.is_empty() {
            return false;
        }
        self.fit(&bounds, area);
        if has_skin {
            self.stay_outside(shape, &bounds, area.aspect);
        }
        true
    }

    /// Moves the eye of a camera that is fitted to `bounds` away from them until nothing of the shape is near before them,
    /// nor seen from its inside, and the near plane before all that is seen. Where that comes to nothing, as between walls
    /// that are seen from their back however far away, the eye stays.
    fn stay_outside(&mut self, shape: &EvaluatedShape, bounds: &Aabb, aspect: f32) {
        let fitted = *self;
        let towards_eye = |of: &Aabb| {
            let along = of.corners().into_iter();
            let along = along.map(|corner| (corner - fitted.target).dot(fitted.outward()));
            along.fold(f32::NEG_INFINITY, f32::max)
        };
        let front = towards_eye(bounds);
        // There, all of the shape is as far before the eye as what is fitted was.
        let farthest = fitted.radius + (towards_eye(&shape.world_bounds()) - front).max(0.0);
        let mut nearest = self.nearest_before(shape, front, aspect);
        while nearest.is_none() && self.radius < farthest {
            self.radius = (self.radius * FARTHER).min(farthest);
            nearest = self.nearest_before(shape, front, aspect);
        }
        match nearest {
            Some(depth) => {
                self.near = self.near.min(0.5 * depth);
                self.far += self.radius - fitted.radius;
            }
            None => *self = fitted,
        }
    }

    /// Depth of the nearest that is seen of a shape, infinite where nothing is; `None` if something is too near or seen from
    /// its inside, before the plane that is `front` from the target towards the eye.
    fn nearest_before(&self, shape: &EvaluatedShape, front: f32, aspect: f32) -> Option<f32> {
        let model_from_world = shape.world_from_model.inverse();
        let mut nearest = f32::INFINITY;
        for ray in self.rays(aspect) {
            let in_model = ray.transformed(model_from_world);
            let Some((distance, is_inside)) = met(shape, &in_model) else {
                continue;
            };
            let depth = self.depth(ray.at(distance));
            if depth < self.radius - front && (is_inside || depth < NEAREST * self.radius) {
                return None;
            }
            nearest = nearest.min(depth);
        }
        Some(nearest)
    }
}

/// Distance at which `ray`, in model space, first meets the mesh, and whether it comes from within there.
fn met(shape: &EvaluatedShape, ray: &Ray) -> Option<(f32, bool)> {
    let (triangle, hit) = shape.geometry.nearest_triangle(ray)?;
    let corners = shape.geometry.mesh.triangles[triangle];
    let [a, b, c] = corners.map(|corner| shape.geometry.positions()[corner as usize]);
    let is_inside = (b - a).cross(c - a).dot(ray.direction) > 0.0;
    Some((hit.distance, is_inside))
}

/// The joint whose skin a vertex with these influences is.
fn owner(influences: &[Influence]) -> Option<usize> {
    Attachments::strongest(influences).map(|joint| joint as usize)
}

/// The joints with all below them that is hardly larger at rest than their own skin: fingers of a hand and the hand of a
/// forearm, but not the forearm of an upper arm.
fn with_smaller_parts(character: &Character, joints: &[usize]) -> HashSet<usize> {
    let skeleton = character.skeleton();
    let mut skin = vec![Aabb::EMPTY; skeleton.joints().len()];
    let owners = character.attachments().vertices().map(owner);
    for (&at, owner) in character.bind_mesh().positions.iter().zip(owners) {
        if let Some(joint) = owner {
            skin[joint] = skin[joint].union(Aabb::from_points([at]));
        }
    }
    let size = |of: &Aabb| match of.is_empty() {
        true => 0.0,
        false => of.size().length(),
    };
    let mut parts: HashSet<usize> = joints.iter().copied().collect();
    for &joint in joints {
        for &child in skeleton.children(joint) {
            let below = with_all_below(character, child);
            let all = below.iter().map(|&part| skin[part]);
            let all = all.fold(Aabb::EMPTY, Aabb::union);
            if size(&all) <= SMALLER * size(&skin[joint]) {
                parts.extend(below);
            }
        }
    }
    parts
}

/// A joint and all below it.
fn with_all_below(character: &Character, joint: usize) -> Vec<usize> {
    let mut below = vec![joint];
    let mut next = 0;
    while let Some(&joint) = below.get(next) {
        below.extend(character.skeleton().children(joint));
        next += 1;
    }
    below
}
