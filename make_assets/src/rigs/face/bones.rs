//! The bones of the face, and which of them each place follows.
use super::super::super::adult::face;
use super::super::grown::bone;
use super::super::model::Rig;
use super::surface::{LIPS_MEET, eyebrow, lip_line};
use glam::DVec3;

pub const TONGUE_START: DVec3 = DVec3::new(0.0, 1.6085, 0.0400);
pub const TONGUE_MIDDLE: DVec3 = DVec3::new(0.0, 1.6085, 0.0610);
pub const TONGUE_END: DVec3 = DVec3::new(0.0, 1.6085, 0.0815);
/// The axis on which the jaw turns passes in front of the ears.
const JAW: DVec3 = DVec3::new(0.0, 1.648, 0.010);
const CHIN: DVec3 = DVec3::new(0.0, 1.578, 0.088);
const CORNER: DVec3 = DVec3::new(0.0232, 1.6165, 0.0900);

/// Adds all bones, parents first.
pub fn add(rig: &mut Rig) {
    let middle = |y: f64, z: f64| DVec3::new(0.0, y, z);
    let eye = face::EYE;
    bone(
        rig,
        "Shoulders",
        "",
        middle(1.455, -0.025),
        middle(1.500, -0.022),
    );
    bone(
        rig,
        "Neck",
        "Shoulders",
        middle(1.500, -0.022),
        middle(1.600, -0.005),
    );
    bone(
        rig,
        "Head",
        "Neck",
        middle(1.600, -0.005),
        middle(1.810, -0.005),
    );
    bone(rig, "Jaw", "Head", JAW, CHIN);
    bone(rig, "Tongue", "Jaw", TONGUE_START, TONGUE_MIDDLE);
    bone(rig, "Tongue tip", "Tongue", TONGUE_MIDDLE, TONGUE_END);
    bone(rig, "Left eye", "Head", eye, eye + DVec3::Z * 0.024);
    let lid = DVec3::new(0.0, 0.0105, 0.0140);
    bone(rig, "Left upper lid", "Head", eye, eye + lid);
    let lower = DVec3::new(0.0, -0.0085, 0.0150);
    bone(rig, "Left lower lid", "Head", eye, eye + lower);
    let (inner, outer) = (
        DVec3::new(0.015, 1.7085, 0.092),
        DVec3::new(0.052, 1.7095, 0.074),
    );
    bone(rig, "Left brow", "Head", inner, outer);
    bone(
        rig,
        "Left mouth corner",
        "Head",
        CORNER,
        CORNER + DVec3::new(0.012, 0.002, -0.006),
    );
}

/// The index of the bone called `name`.
pub fn index(rig: &Rig, name: &str) -> usize {
    let found = rig.bones.iter().position(|bone| bone.name == name);
    found.unwrap_or_default()
}

/// The bone that a place on the skin belongs to.
pub fn owner(rig: &Rig, p: DVec3) -> usize {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let side = if p.x < 0.0 { "Right" } else { "Left" };
    let own = |part: &str| index(rig, &format!("{side} {part}"));
    let from_eye = near - face::EYE;
    if from_eye.length() < 0.0192 && from_eye.z > 0.003 && from_eye.x.abs() < 0.0155 {
        return own(if from_eye.y > 0.0010 {
            "upper lid"
        } else {
            "lower lid"
        });
    }
    if eyebrow(near) < 0.0022 {
        return own("brow");
    }
    if near.distance(CORNER) < 0.0058 {
        return own("mouth corner");
    }
    // The jaw ends below the lips, and along a line from the corner of the mouth to the ear;
    // behind, the throat begins.
    let to_ear = lip_line(near.x.min(0.024)) + 0.30 * (0.080 - p.z).clamp(0.0, 0.06);
    let hinge = 0.016 + 0.25 * (p.y - 1.60).max(0.0);
    let throat = 0.030 + 0.55 * (1.575 - p.y).max(0.0);
    if p.y < to_ear && p.z > hinge.max(throat * smooth_below(p.y)) && p.y > 1.545 {
        return index(rig, "Jaw");
    }
    let skull = 1.595 - 0.35 * p.z.clamp(-0.03, 0.03);
    match p.y {
        y if y > skull => index(rig, "Head"),
        y if y > 1.520 => index(rig, "Neck"),
        _ => index(rig, "Shoulders"),
    }
}

/// 1 under the chin, 0 above it.
fn smooth_below(y: f64) -> f64 {
    ((1.590 - y) / 0.01).clamp(0.0, 1.0)
}

/// How far borders are softened.
pub fn reach(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let from_eye = near.distance(face::EYE);
    if from_eye < 0.030 {
        return 0.0022 + 0.25 * (from_eye - 0.017).max(0.0);
    }
    if near.distance(LIPS_MEET) < 0.030 {
        return 0.0055;
    }
    if p.y < 1.56 { 0.020 } else { 0.011 }
}
