//! The dog's head: skull, muzzle, jaw, eyes, nose and ears.
use super::super::field::{Loft, blend, carve, clip, ellipsoid, round_cone, sphere};
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

pub const EYE: DVec3 = DVec3::new(0.0378, 0.7440, 0.4895);
pub const NOSE: DVec3 = DVec3::new(0.0, 0.7110, 0.6165);
pub const JAW: DVec3 = DVec3::new(0.0, 0.6680, 0.4580);
pub const EAR: DVec3 = DVec3::new(0.050, 0.7750, 0.4200);
const EAR_TIP: DVec3 = DVec3::new(0.083, 0.8880, 0.4240);

/// Along the muzzle: place, 0, height of the middle, half width, up, down.
static MUZZLE: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.4480, 0.0, 0.7050, 0.066, 0.050, 0.045],
            [0.4930, 0.0, 0.7020, 0.051, 0.040, 0.040],
            [0.5330, 0.0, 0.6990, 0.042, 0.031, 0.034],
            [0.5780, 0.0, 0.6960, 0.038, 0.027, 0.028],
            [0.6060, 0.0, 0.6940, 0.0270, 0.0185, 0.0210],
        ],
        2.3,
        (0.03, 0.014),
    )
});

/// Up the ear: place, 0, 0, half width, front, back.
static LEAF: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [-0.020, 0.0, 0.0, 0.033, 0.019, 0.019],
            [0.020, 0.0, 0.0, 0.037, 0.019, 0.018],
            [0.055, 0.0, 0.0, 0.031, 0.016, 0.014],
            [0.085, 0.0, 0.0, 0.020, 0.012, 0.010],
            [0.106, 0.0, 0.0, 0.010, 0.008, 0.007],
        ],
        2.0,
        (0.02, 0.012),
    )
});

/// The left half of the head.
pub fn surface(p: DVec3) -> f64 {
    let rough = sphere(p, DVec3::new(0.0, 0.7450, 0.4980), 0.20);
    if rough > 0.08 {
        return rough;
    }
    let mut d = ellipsoid(
        p,
        DVec3::new(0.0, 0.7270, 0.4360),
        DVec3::new(0.075, 0.068, 0.080),
    );
    d = blend(d, MUZZLE.distance(p.z, DVec2::new(p.x, p.y)), 0.030);
    let cheek = ellipsoid(
        p,
        DVec3::new(0.050, 0.6920, 0.4400),
        DVec3::new(0.034, 0.042, 0.052),
    );
    d = blend(d, cheek, 0.03);
    d = blend(d, jaw(p), 0.005);
    d = blend(d, ear(p), 0.020);
    d = eye(p, d);
    nose(p, d)
}

/// The lower jaw, parted from the lips by a groove.
fn jaw(p: DVec3) -> f64 {
    let flat = |v: DVec3| DVec3::new(v.x / 1.25, v.y, v.z);
    let (back, tip) = (
        DVec3::new(0.0, 0.6730, 0.4680),
        DVec3::new(0.0, 0.6670, 0.5730),
    );
    round_cone(flat(p), (back, 0.034), (tip, 0.0200))
}

fn eye(p: DVec3, d: f64) -> f64 {
    let look = DVec3::new(0.55, 0.16, 0.82).normalize_or_zero();
    let brow = ellipsoid(
        p,
        EYE + DVec3::new(-0.005, 0.017, -0.008),
        DVec3::new(0.019, 0.008, 0.016),
    );
    let d = blend(d, brow, 0.014);
    // Lids round an almond opening that slants down to the nose.
    let lid = sphere(p, EYE, 0.0165);
    let from = p - EYE;
    let across = DVec3::new(0.82, 0.10, -0.55).normalize_or_zero();
    let (s, h) = (from.dot(across), from.y - 0.12 * from.dot(across));
    let arc = 1.0 - (s / 0.0150).powi(2);
    let open = clip(
        clip(h - 0.0062 * arc, -h - 0.0062 * arc, 0.001),
        0.004 - from.dot(look),
        0.001,
    );
    let d = carve(blend(d, lid, 0.008), open, 0.0014);
    let iris = sphere(p, EYE + look * 0.0157, 0.0052);
    blend(d, carve(sphere(p, EYE, 0.0140), iris, 0.001), 0.0008)
}

fn nose(p: DVec3, d: f64) -> f64 {
    let leather = ellipsoid(p, NOSE, DVec3::new(0.0165, 0.0120, 0.0105));
    let d = blend(d, leather, 0.004);
    let nostril = ellipsoid(
        p,
        NOSE + DVec3::new(0.0085, -0.001, 0.0090),
        DVec3::new(0.0050, 0.0042, 0.0055),
    );
    carve(d, nostril, 0.003)
}

/// A pointed ear, hollow in front.
fn ear(p: DVec3) -> f64 {
    let up = (EAR_TIP - EAR).normalize_or_zero();
    let out = DVec3::new(0.85, 0.0, -0.10);
    let side = (out - up * out.dot(up)).normalize_or_zero();
    let front = side.cross(up);
    let from = p - EAR;
    let q = DVec3::new(from.dot(side), from.dot(up), from.dot(front));
    let leaf = LEAF.distance(q.y, DVec2::new(q.x, q.z));
    let hollow = ellipsoid(
        q,
        DVec3::new(0.0, 0.046, 0.021),
        DVec3::new(0.023, 0.052, 0.015),
    );
    carve(leaf, hollow, 0.008)
}
