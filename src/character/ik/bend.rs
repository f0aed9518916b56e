use super::links::Links;
use glam::{DQuat, DVec3};

/// A chain whose joints are off the line between its ends by less than this part of its length,
/// on the average, counts as straight: which way it bends is rounding.
const STRAIGHT: f64 = 1e-4;

/// From the first joint towards the end; along the first link where both are in one place.
pub(super) fn axis(links: &Links) -> DVec3 {
    let end = links.end();
    let far = end.length() > 1e-6 * links.total();
    end.try_normalize()
        .filter(|_| far)
        .unwrap_or(links.directions[0])
}

/// To which side of its axis the chain bends, of unit length; `None` if it is straight.
pub(super) fn side(links: &Links) -> Option<DVec3> {
    let axis = axis(links);
    let points = links.points();
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let off = mean.reject_from_normalized(axis);
    let clear = off.length() > STRAIGHT * links.total();
    off.try_normalize().filter(|_| clear)
}

/// The side that a straight chain bends to if it is one that bends about `normal`.
pub(super) fn side_about(normal: DVec3, axis: DVec3) -> DVec3 {
    let side = normal.cross(axis).reject_from_normalized(axis);
    side.try_normalize()
        .filter(|_| side.length() > 1e-6 * normal.length())
        .unwrap_or_else(|| axis.any_orthonormal_vector())
}

/// What the chain bends about, of unit length. Of a straight chain nobody knows, so it is that of
/// a knee if it is upright, else that of an elbow, of a figure that looks along `front`.
pub(super) fn normal(links: &Links, front: DVec3) -> DVec3 {
    let axis = axis(links);
    let guess = || {
        let bends_to = if axis.y.abs() > 0.5 { front } else { -front };
        let side = bends_to.reject_from_normalized(axis);
        let clear = side.length() > 0.1;
        let side = side.try_normalize().filter(|_| clear);
        side.unwrap_or_else(|| axis.any_orthonormal_vector())
    };
    axis.cross(side(links).unwrap_or_else(guess))
}

/// The shortest turn from one unit vector to another; about `normal`, as far as it can be, where
/// they are opposite.
pub(super) fn arc(from: DVec3, to: DVec3, normal: DVec3) -> DQuat {
    if from.dot(to) > -1.0 + 1e-12 {
        return DQuat::from_rotation_arc(from, to);
    }
    let about = normal.reject_from_normalized(from);
    let about = about
        .try_normalize()
        .unwrap_or_else(|| from.any_orthonormal_vector());
    DQuat::from_axis_angle(about, std::f64::consts::PI)
}

/// The turn about the unit vector `axis` that brings `from` as near to `to` as can be.
pub(super) fn twist(axis: DVec3, from: DVec3, to: DVec3) -> DQuat {
    let angle = axis.dot(from.cross(to));
    let along = from.dot(to) - axis.dot(from) * axis.dot(to);
    DQuat::from_axis_angle(axis, angle.atan2(along))
}
