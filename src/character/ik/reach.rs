use super::bend::{self, arc, twist};
use super::closing::close;
use super::fabrik::fabrik;
use super::links::Links;
use glam::{DQuat, DVec3};

/// How far a straight chain is bent to begin with, of its length: FABRIK does not leave a line.
const BEND: f64 = 0.1;
/// A target nearer to the first joint than this part of the chain's length has no direction.
const AT_THE_START: f64 = 1e-9;
/// A pole that is nearer to the line from the first joint to the target than this (sine of the
/// angle) says nothing.
const IN_LINE: f64 = 1e-3;

/// How a chain gets its end to a target.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reach {
    /// Turns the whole chain, as it is, towards the target and its bend towards the pole.
    pub turn: DQuat,
    /// Where the links then point, unit vectors.
    pub directions: Vec<DVec3>,
}

/// Brings the end of `links` to `target`, both seen from the first joint; or as near as it gets,
/// on the line to the target. The chain bends towards `pole` if there is one, else as it does
/// now, and about `normal` if it is straight.
pub(super) fn reach(links: &Links, target: DVec3, pole: Option<DVec3>, normal: DVec3) -> Reach {
    let (least, total) = (links.least(), links.total());
    let axis = bend::axis(links);
    let far = target.length() > AT_THE_START * total;
    let aim = target.try_normalize().filter(|_| far).unwrap_or(axis);
    let swing = arc(axis, aim, normal);
    let side_now = swing * bend::side(links).unwrap_or_else(|| bend::side_about(normal, axis));
    let side = towards_pole(aim, pole, links).unwrap_or(side_now);
    let turn = twist(aim, side_now, side) * swing;
    let turned = links.along(links.directions.iter().map(|&d| turn * d).collect());
    let distance = target.length().clamp(least, total);
    let count = links.lengths.len();
    let directions = if count == 1 || distance >= total * (1.0 - 1e-15) {
        vec![aim; count]
    } else if count == 2 {
        two_bones(&links.lengths, distance, aim, side).to_vec()
    } else {
        many_bones(&turned, distance, aim, side, pole.is_some())
    };
    Reach { turn, directions }
}

/// To which side the pole is; `None` without one, or if it is in line with the target.
fn towards_pole(aim: DVec3, pole: Option<DVec3>, links: &Links) -> Option<DVec3> {
    let pole = pole?.try_normalize().filter(|_| links.lengths.len() > 1)?;
    let side = pole.reject_from_normalized(aim);
    side.try_normalize().filter(|_| side.length() > IN_LINE)
}

/// The law of cosines; `distance` is one that both together can span.
fn two_bones(lengths: &[f64], distance: f64, aim: DVec3, side: DVec3) -> [DVec3; 2] {
    let (a, b) = (lengths[0], lengths[1]);
    let cos = if distance > 0.0 {
        ((a * a + distance * distance - b * b) / (2.0 * a * distance)).clamp(-1.0, 1.0)
    } else {
        0.0
    };
    let upper = cos * aim + (1.0 - cos * cos).max(0.0).sqrt() * side;
    let lower = (distance * aim - a * upper).try_normalize();
    [upper, lower.unwrap_or(-upper)]
}

fn many_bones(links: &Links, distance: f64, aim: DVec3, side: DVec3, has_pole: bool) -> Vec<DVec3> {
    let mut points = links.points();
    if bend::side(links).is_none() {
        let total = links.total();
        let mut along = 0.0;
        for (point, length) in points.iter_mut().zip(&links.lengths) {
            *point += BEND * total * (std::f64::consts::PI * along / total).sin() * side;
            along += length;
        }
    }
    let drawn = links.along(fabrik(links, points, distance * aim));
    let closed = links.along(close(&drawn, distance, aim, aim.cross(side)));
    match bend::side(&closed).filter(|_| has_pole) {
        Some(bent) => {
            let turn = twist(aim, bent, side);
            closed.directions.into_iter().map(|d| turn * d).collect()
        }
        None => closed.directions,
    }
}
