//! The jacket: trunk, sleeves, ribbed hem and cuffs, zip and pockets; and the hands.
use super::super::field::{Loft, blend, chain, clip, ellipsoid, round_cone, smooth_step};
use super::body::{ELBOW, SHOULDER, WRIST};
use super::hand;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Heights of the hem and of the rib's upper edge.
pub const HEM: f64 = 0.962;
pub const RIB: f64 = 1.012;

/// Height, center (0, z), half width, front, back.
static TORSO: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [HEM, 0.0, 0.0, 0.163, 0.108, 0.112],
            [1.005, 0.0, 0.0, 0.159, 0.107, 0.105],
            [1.050, 0.0, 0.0, 0.161, 0.114, 0.104],
            [1.120, 0.0, 0.0, 0.158, 0.114, 0.100],
            [1.200, 0.0, 0.0, 0.164, 0.121, 0.112],
            [1.300, 0.0, 0.0, 0.178, 0.130, 0.130],
            [1.370, 0.0, 0.0, 0.176, 0.120, 0.132],
            [1.430, 0.0, 0.0, 0.150, 0.094, 0.116],
            [1.470, 0.0, -0.01, 0.105, 0.066, 0.084],
            [1.500, 0.0, -0.015, 0.066, 0.052, 0.058],
        ],
        2.3,
        (0.010, 0.012),
    )
});

/// The jacket's surface at a place of the left half, given also the place mirrored.
pub fn surface(p: DVec3, mirrored: DVec3) -> f64 {
    if p.y < 0.76 {
        return HEM - 0.1 - p.y;
    }
    let mut d = TORSO.distance(p.y, DVec2::new(p.x, p.z));
    let chest = ellipsoid(
        p,
        DVec3::new(0.080, 1.320, 0.060),
        DVec3::new(0.080, 0.075, 0.058),
    );
    let blade = ellipsoid(
        p,
        DVec3::new(0.085, 1.345, -0.076),
        DVec3::new(0.066, 0.090, 0.050),
    );
    let yoke = [
        (DVec3::new(0.02, 1.468, -0.03), 0.046),
        (SHOULDER + DVec3::new(-0.012, 0.004, 0.0), 0.050),
    ];
    d = blend(blend(d, chest, 0.05), blade, 0.05);
    d = blend(d, chain(p, &yoke), 0.05);
    d = blend(d, blend(sleeve(p), sleeve(mirrored), 0.02), 0.050);
    if p.x < 0.26 {
        d -= details(p);
    }
    blend(d, hand::surface(p), 0.004)
}

/// How far the cloth of the trunk stands out: the fall over the rib, zip and pockets.
fn details(p: DVec3) -> f64 {
    let fall =
        0.013 * smooth_step(RIB - 0.011, RIB + 0.009, p.y) * (1.0 - smooth_step(1.025, 1.13, p.y));
    let groove = (p.x - 0.003)
        .max(p.y - 1.50)
        .max(RIB + 0.014 - p.y)
        .max(-p.z);
    let zip = -0.0035 * (1.0 - smooth_step(0.0, 0.006, groove));
    // A slanted pocket with a welt.
    let (from, to) = (DVec2::new(0.118, 1.055), DVec2::new(0.086, 1.150));
    let axis = to - from;
    let q = DVec2::new(p.x, p.y) - from;
    let t = (q.dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
    let off = q - axis * t;
    let welt =
        0.0052 * (1.0 - smooth_step(0.0065, 0.0115, off.length())) * smooth_step(0.0, 0.05, p.z);
    fall + zip + welt
}

/// The sleeve with its cuff.
pub fn sleeve(p: DVec3) -> f64 {
    let upper = round_cone(p, (SHOULDER, 0.058), (ELBOW, 0.049));
    let lower = round_cone(p, (ELBOW, 0.049), (WRIST.lerp(ELBOW, 0.12), 0.0365));
    let mut d = blend(upper, lower, 0.03);
    let deltoid = ellipsoid(
        p,
        SHOULDER + DVec3::new(0.030, -0.026, 0.0),
        DVec3::new(0.056, 0.066, 0.064),
    );
    d = blend(d, deltoid, 0.04);
    let axis = (WRIST - ELBOW).normalize_or_zero();
    let along = (p - WRIST).dot(axis);
    // The cloth gathers before the cuff, which ends just short of the wrist.
    let gather =
        0.009 * smooth_step(-0.15, -0.075, along) * (1.0 - smooth_step(-0.060, -0.049, along));
    clip(d - gather - folds(p), along + 0.010, 0.006)
}

/// Folds of the sleeve in the bend of the elbow.
fn folds(p: DVec3) -> f64 {
    let axis = (WRIST - SHOULDER).normalize_or_zero();
    let from = p - ELBOW;
    let along = from.dot(axis);
    let inner = smooth_step(-0.02, 0.05, from.z + 0.3 * from.x);
    let near = 1.0 - smooth_step(0.02, 0.085, along.abs());
    0.0042 * inner * near * ((along + 0.25 * from.y) * std::f64::consts::TAU / 0.042).cos()
}
