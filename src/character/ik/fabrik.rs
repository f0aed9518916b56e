use super::links::Links;
use glam::DVec3;

/// More rounds bring little: what is left is closed exactly afterwards.
const ROUNDS: usize = 32;
/// Part of the chain's length.
const NEAR: f64 = 1e-9;

/// The links' directions after FABRIK has drawn the end towards `target`: backwards from there,
/// forwards from the first joint, in turn, each point on the line to its neighbor. The joints
/// start at `points`, which need not be as far apart as they should.
pub(super) fn fabrik(links: &Links, mut points: Vec<DVec3>, target: DVec3) -> Vec<DVec3> {
    let mut directions = links.directions.clone();
    let last = links.lengths.len();
    let towards =
        |from: DVec3, to: DVec3, direction: DVec3| (to - from).try_normalize().unwrap_or(direction);
    for _ in 0..ROUNDS {
        points[last] = target;
        for i in (0..last).rev() {
            let direction = towards(points[i], points[i + 1], directions[i]);
            points[i] = points[i + 1] - links.lengths[i] * direction;
        }
        points[0] = DVec3::ZERO;
        for i in 0..last {
            directions[i] = towards(points[i], points[i + 1], directions[i]);
            points[i + 1] = points[i] + links.lengths[i] * directions[i];
        }
        if points[last].distance(target) <= NEAR * links.total() {
            break;
        }
    }
    directions
}
