use super::curve::CurvePoint;
use crate::math::Aabb;

/// Ends that are closer than this, measured against the size of the curve, meet.
const MEETING: f32 = 1e-5;
/// Tangents at the ends that differ by less than this (cosine, about 2.5°) run on.
const RUNNING_ON: f32 = 0.999;

/// Whether the curve ends where it starts.
pub fn is_closed(points: &[CurvePoint]) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return false;
    };
    let size = Aabb::from_points(points.iter().map(|point| point.position))
        .size()
        .length();
    points.len() > 2 && first.position.distance(last.position) <= MEETING * size
}

/// Closes the frames of a curve that ends where it starts, in the direction that it starts in:
/// the angle by which the carried frame misses the first one is spread along the curve in
/// proportion to arc length, so that a surface swept along it closes without a step. The last
/// point becomes the first. Other curves are left as they are.
///
/// Returns the angle in radians, −π..π, by which the last frame had to turn.
pub fn close_frames(points: &mut [CurvePoint]) -> Option<f32> {
    let (&first, &last) = (points.first()?, points.last()?);
    let runs_on = first.frame.tangent.dot(last.frame.tangent) > RUNNING_ON;
    if !runs_on || !is_closed(points) {
        return None;
    }
    let angle = last.frame.angle_to(first.frame);
    let length: f32 = points
        .windows(2)
        .map(|pair| pair[0].position.distance(pair[1].position))
        .sum();
    let mut walked = 0.0;
    let mut before = first.position;
    for point in points.iter_mut() {
        walked += point.position.distance(before);
        before = point.position;
        point.frame = point.frame.turned(angle * walked / length);
    }
    if let Some(last) = points.last_mut() {
        *last = first;
    }
    Some(angle)
}
