//! The adult's joints, and which of them each place follows.
use super::super::field::smooth_step;
use super::super::rig::{self, Joint};
use super::body::{ANKLE, ELBOW, HIP, KNEE, SHOULDER, WRIST};
use super::{GROUND, hand};
use glam::DVec3;

/// Between the collar bones and the chest, and between chest and waist (heights).
const CHEST: f64 = 1.315;
const WAIST: f64 = 1.120;

/// The joints in the course's order, with the course's names.
pub fn joints() -> Vec<Joint> {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y - GROUND, z);
    let left = |p: DVec3| at(p.x, p.y, p.z);
    let right = |p: DVec3| at(-p.x, p.y, p.z);
    let hip = DVec3::new(0.030, 0.985, 0.0);
    let collarbone = DVec3::new(0.022, 1.440, 0.020);
    let chest = at(0.0, CHEST, -0.01);
    rig::joints(&[
        ("Root", -1, chest),
        ("Chest", 0, chest),
        ("Waist", 1, at(0.0, WAIST, -0.01)),
        ("Neck", 0, at(0.0, 1.500, -0.022)),
        ("Right hip", 2, right(hip)),
        ("Right leg", 4, right(HIP)),
        ("Right knee", 5, right(KNEE)),
        ("Right foot", 6, right(ANKLE)),
        ("Left hip", 2, left(hip)),
        ("Left leg", 8, left(HIP)),
        ("Left knee", 9, left(KNEE)),
        ("Left foot", 10, left(ANKLE)),
        ("Right collarbone", 0, right(collarbone)),
        ("Right shoulder", 12, right(SHOULDER)),
        ("Right elbow", 13, right(ELBOW)),
        ("Left collarbone", 0, left(collarbone)),
        ("Left shoulder", 15, left(SHOULDER)),
        ("Left elbow", 16, left(ELBOW)),
    ])
}

/// Which joint a place on the surface belongs to before the borders are softened.
pub fn owner(p: DVec3) -> usize {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let (hip, leg, knee, foot, collarbone, shoulder, elbow) = if p.x < 0.0 {
        (4, 5, 6, 7, 12, 13, 14)
    } else {
        (8, 9, 10, 11, 15, 16, 17)
    };
    if on_arm(near) {
        let bend = (SHOULDER - ELBOW).normalize_or_zero() - (WRIST - ELBOW).normalize_or_zero();
        return if (near - ELBOW).dot(bend) > 0.0 {
            shoulder
        } else {
            elbow
        };
    }
    if near.y < 0.076 || super::shoe::surface(near) < 0.0015 {
        return foot;
    }
    if near.y < KNEE.y {
        return knee;
    }
    // The groin rises from the crotch to the outside of the hip.
    if near.y < 0.845 + 0.85 * near.x.min(0.13) + 0.15 * near.z.min(0.0) {
        return leg;
    }
    if near.y > 1.490 - 0.25 * near.x + 0.25 * near.z.min(0.04) {
        return 3;
    }
    match near.y {
        y if y > CHEST => collarbone,
        y if y > WAIST - 0.03 => 1,
        y if y > 1.0 => 2,
        _ => hip,
    }
}

/// Whether a place of the left half lies on the arm: beyond a plane through the armpit.
fn on_arm(p: DVec3) -> bool {
    let axis = (ELBOW - SHOULDER).normalize_or_zero();
    let from = p - SHOULDER;
    let along = from.dot(axis);
    let across = (from - axis * along).length();
    let in_sleeve =
        across < 0.085 && along > -0.012 && p.x > SHOULDER.x - 0.02 + 0.25 * along.max(0.0);
    in_sleeve || p.x > 0.28
}

/// How far the border between joints is softened.
pub fn reach(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    if near.x > 0.26 && near.distance(hand::center()) < 0.6 {
        return if near.distance(ELBOW) < 0.15 {
            0.030
        } else {
            0.02
        };
    }
    if near.y < 0.3 {
        return 0.014;
    }
    if near.y < 0.7 {
        return 0.034;
    }
    // Wide over the trunk, closer at the neck.
    0.050 - 0.018 * smooth_step(1.46, 1.54, near.y)
}
