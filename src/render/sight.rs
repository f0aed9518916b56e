//! What can be seen of a shape in a picture at all.

use super::frame::{Frame, PassContext, has_ground};
use super::ground_pass::ground_from_world;
use crate::math::Aabb;
use crate::scene::EvaluatedShape;
use glam::{Mat4, Vec3, Vec4};

/// Share of the terms of a sum by which rounding, here and in the driver, may change it.
const ROUNDING: f32 = 1e-5;

/// The space that a picture shows, and the space whose shadows it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// From the world to the picture.
    pub clip_from_world: Mat4,
    /// From the world to its shadow on the ground, in the picture; `None` without shadows.
    pub clip_from_shadowed: Option<Mat4>,
}

impl Sight {
    /// That of a picture of `frame`.
    pub fn new(context: &PassContext, frame: &Frame) -> Self {
        let shadowed = || context.clip_from_world * ground_from_world(context.ground);
        Self {
            clip_from_world: context.clip_from_world,
            clip_from_shadowed: has_ground(frame).then(shadowed),
        }
    }

    /// Whether a surface, or a shadow, may be seen of the shape.
    pub fn has(&self, shape: &EvaluatedShape) -> bool {
        let around = shape.world_box();
        let shadowed = self.clip_from_shadowed;
        may_be_seen(self.clip_from_world, &around)
            || shadowed.is_some_and(|clip| may_be_seen(clip, &around))
    }
}

/// Whether any part of a box in the world may be in the picture: not all of it lies beyond one of the
/// picture's edges, or out of depth, with some room for rounding. An empty box, which tells nothing,
/// may.
pub(super) fn may_be_seen(clip_from_world: Mat4, bounds: &Aabb) -> bool {
    let corners = bounds.corners().into_iter();
    let corners: Vec<(Vec4, f32)> = corners
        .map(|corner| {
            let largest = largest_terms(clip_from_world, corner);
            let clip = clip_from_world * corner.extend(1.0);
            (clip, ROUNDING * (largest.max_element() + largest.w))
        })
        .collect();
    let beyond = |outside: fn(&Vec4) -> f32| corners.iter().all(|(c, room)| outside(c) > *room);
    corners.is_empty()
        || !(beyond(|c| -c.x - c.w)
            || beyond(|c| c.x - c.w)
            || beyond(|c| -c.y - c.w)
            || beyond(|c| c.y - c.w)
            || beyond(|c| -c.z - c.w)
            || beyond(|c| c.z - c.w))
}

/// Sums of the terms of `matrix * point`, each without its sign.
pub(super) fn largest_terms(matrix: Mat4, point: Vec3) -> Vec4 {
    let point = point.abs();
    matrix.x_axis.abs() * point.x
        + matrix.y_axis.abs() * point.y
        + matrix.z_axis.abs() * point.z
        + matrix.w_axis.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;

    #[test]
    fn a_box_is_out_of_sight_only_as_a_whole() {
        let clip_from_world = Camera::default().clip_from_world(1.0);
        let seen = |center: Vec3| {
            let bounds = Aabb {
                min: center - 0.5,
                max: center + 0.5,
            };
            may_be_seen(clip_from_world, &bounds)
        };
        // From (0, 0, 5) half of the height that is seen at the origin is 5 tan(22.5°) = 2.07.
        assert!(seen(Vec3::ZERO) && seen(Vec3::X * 2.3) && seen(Vec3::NEG_Y * 2.3));
        assert!(!seen(Vec3::X * 3.0) && !seen(Vec3::NEG_X * 3.0));
        assert!(!seen(Vec3::Y * 3.0) && !seen(Vec3::NEG_Y * 3.0));
        assert!(seen(Vec3::Z * 5.0), "the eye is in it");
        assert!(!seen(Vec3::Z * 6.0), "it is behind the eye");
        assert!(seen(Vec3::Z * -95.0) && !seen(Vec3::Z * -105.0));
        assert!(may_be_seen(clip_from_world, &Aabb::EMPTY));
    }
}
