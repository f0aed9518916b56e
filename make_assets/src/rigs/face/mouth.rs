//! Teeth and tongue.
use super::super::super::solids::{ball, rounded_box, shaped};
use super::super::model::{Rig, Skin, along_chain};
use super::bones::{TONGUE_END, TONGUE_MIDDLE, TONGUE_START, index};
use super::surface::LIPS_MEET;
use super::{TEETH, TONGUE};
use glam::{DMat3, DVec3};

/// Two rows of teeth on an arc: the upper on the head, the lower on the jaw.
pub fn teeth(skin: &mut Skin, rig: &Rig) {
    const EACH: i32 = 10;
    for (bone, side, wide, high) in [("Head", 1.0, 1.0, 0.0046), ("Jaw", -1.0, 0.86, 0.0042)] {
        for tooth in 0..EACH {
            let turn = (f64::from(tooth) + 0.5 - f64::from(EACH) / 2.0) * 0.225;
            let (sin, cos) = turn.sin_cos();
            let at = DVec3::new(
                0.0205 * wide * sin,
                LIPS_MEET.y + side * (high + 0.0004),
                0.0655 + 0.0215 * wide * cos,
            );
            // The front teeth are longer.
            let half = DVec3::new(0.00232 * wide, high + 0.0006 * cos, 0.0016);
            let shape = shaped(rounded_box(half, 0.0011, 2), |p| {
                DMat3::from_rotation_y(turn) * p + at
            });
            skin.add_rigid(&shape, TEETH, index(rig, bone));
        }
    }
}

/// The tongue: a flat ball with a furrow, which two bones bend.
pub fn tongue(skin: &mut Skin, rig: &Rig) {
    let bones = [index(rig, "Tongue"), index(rig, "Tongue tip")];
    let (start, end) = (TONGUE_START.z, TONGUE_END.z);
    let shape = shaped(ball(1.0, 22), |p| {
        let furrow = 0.25 * (1.0 - (p.x * 3.5).powi(2)).max(0.0) * p.y.max(0.0);
        let q = DVec3::new(
            0.0145 * p.x,
            0.0042 * (p.y - furrow),
            0.5 * (end - start) * p.z,
        );
        q + DVec3::new(0.0, TONGUE_START.y - 0.0006, 0.5 * (start + end))
    });
    skin.add(&shape, TONGUE, |p| {
        along_chain(p.z, &bones, &[start, TONGUE_MIDDLE.z], 0.009)
    });
}
