use super::bend::arc;
use super::links::Links;
use glam::{DQuat, DVec3};

/// Each halves what is not known yet of the blend: to rounding.
const HALVINGS: usize = 54;

/// Opens or closes the chain's bends until its end is `distance` from its first joint, which must
/// be between what its links can reach at least and at most, and `aim` is the way to it; both
/// to rounding. `normal` is what the chain folds about, across `aim`.
///
/// Between the chain as it is and the chain pulled straight, or folded up, the distance changes
/// without a jump, so that it is right somewhere on the way.
pub(super) fn close(links: &Links, distance: f64, aim: DVec3, normal: DVec3) -> Vec<DVec3> {
    let opens = links.end().length() < distance;
    let goals = if opens {
        let along = links.end().try_normalize().unwrap_or(aim);
        vec![along; links.lengths.len()]
    } else {
        folded(links, aim, normal)
    };
    let ways = links.directions.iter().zip(goals);
    let ways: Vec<_> = ways
        .map(|(&from, to)| (from, arc(from, to, normal)))
        .collect();
    let blended = |part: f64| {
        let blend = |&(from, way): &(DVec3, DQuat)| DQuat::IDENTITY.slerp(way, part) * from;
        links.along(ways.iter().map(blend).collect())
    };
    let (mut near, mut far) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (near + far);
        if (blended(middle).end().length() < distance) == opens {
            near = middle;
        } else {
            far = middle;
        }
    }
    let closed = blended(0.5 * (near + far));
    let end = closed.end().try_normalize();
    let turn = end.map_or(DQuat::IDENTITY, |end| arc(end, aim, normal));
    closed.directions.into_iter().map(|d| turn * d).collect()
}

/// The links as three straight rods that bring the end as near to the first joint as can be:
/// there itself where they make a triangle, else the middle rod, longer than the others
/// together, lies along `aim` and the others against it.
fn folded(links: &Links, aim: DVec3, normal: DVec3) -> Vec<DVec3> {
    let half = 0.5 * links.total();
    let mut before = 0.0;
    let mut middle = 0;
    while middle + 1 < links.lengths.len() && before + links.lengths[middle] < half {
        before += links.lengths[middle];
        middle += 1;
    }
    let rod = links.lengths[middle];
    let after = (links.total() - before - rod).max(0.0);
    let [first, second, third] = if rod >= half {
        [-aim, aim, -aim]
    } else {
        triangle([before, rod, after], aim, normal)
    };
    let mut directions = vec![first; middle];
    directions.push(second);
    directions.resize(links.lengths.len(), third);
    directions
}

/// The sides of a triangle, one after the other, as unit vectors; the first along `aim`.
fn triangle([a, b, c]: [f64; 3], aim: DVec3, normal: DVec3) -> [DVec3; 3] {
    let across = normal.cross(aim);
    let x = (a * a + c * c - b * b) / (2.0 * a);
    let corner = x * aim + (c * c - x * x).max(0.0).sqrt() * across;
    let second = (corner - a * aim).try_normalize().unwrap_or(-aim);
    let third = (-corner).try_normalize().unwrap_or(-aim);
    [aim, second, third]
}
