//! The dog's head: skull, muzzle, jaw, eyes, nose and ears.
use super::super::field::{Loft, blend, carve, clip, ellipsoid, round_cone, smooth_step, sphere};
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

pub const EYE: DVec3 = DVec3::new(0.0385, 0.7700, 0.5150);
pub const NOSE: DVec3 = DVec3::new(0.0, 0.7290, 0.6720);
pub const JAW: DVec3 = DVec3::new(0.0, 0.700, 0.470);
pub const EAR: DVec3 = DVec3::new(0.050, 0.805, 0.435);
const EAR_TIP: DVec3 = DVec3::new(0.080, 0.915, 0.440);

/// Along the muzzle: place, 0, height of the middle, half width, up, down.
static MUZZLE: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.480, 0.0, 0.735, 0.062, 0.050, 0.040],
            [0.530, 0.0, 0.732, 0.046, 0.032, 0.036],
            [0.580, 0.0, 0.728, 0.036, 0.024, 0.030],
            [0.630, 0.0, 0.724, 0.032, 0.021, 0.026],
            [0.660, 0.0, 0.722, 0.025, 0.017, 0.020],
        ],
        2.3,
        (0.03, 0.014),
    )
});

/// The left half of the head.
pub fn surface(p: DVec3) -> f64 {
    let rough = sphere(p, DVec3::new(0.0, 0.775, 0.53), 0.20);
    if rough > 0.08 {
        return rough;
    }
    let mut d = ellipsoid(
        p,
        DVec3::new(0.0, 0.757, 0.450),
        DVec3::new(0.073, 0.066, 0.080),
    );
    d = blend(d, MUZZLE.distance(p.z, DVec2::new(p.x, p.y)), 0.028);
    let cheek = ellipsoid(
        p,
        DVec3::new(0.046, 0.730, 0.470),
        DVec3::new(0.030, 0.036, 0.045),
    );
    d = blend(d, cheek, 0.03);
    d = blend(d, jaw(p), 0.006);
    d = blend(d, ear(p), 0.016);
    d = eye(p, d);
    nose(p, d)
}

/// The lower jaw, parted from the lips by a groove.
fn jaw(p: DVec3) -> f64 {
    round_cone(
        p,
        (DVec3::new(0.0, 0.702, 0.490), 0.034),
        (DVec3::new(0.0, 0.695, 0.628), 0.0185),
    )
}

fn eye(p: DVec3, d: f64) -> f64 {
    let brow = ellipsoid(
        p,
        EYE + DVec3::new(-0.004, 0.013, -0.004),
        DVec3::new(0.020, 0.010, 0.018),
    );
    let d = blend(d, brow, 0.014);
    let look = DVec3::new(0.62, 0.22, 0.76).normalize_or_zero();
    let socket = sphere(p, EYE + look * 0.013, 0.0125);
    let d = carve(d, socket, 0.008);
    let ball = sphere(p, EYE, 0.0125);
    let pupil = sphere(p, EYE + look * 0.0150, 0.0045);
    blend(d, carve(ball, pupil, 0.002), 0.0015)
}

fn nose(p: DVec3, d: f64) -> f64 {
    let leather = ellipsoid(p, NOSE, DVec3::new(0.0205, 0.0150, 0.0150));
    let d = blend(d, leather, 0.004);
    let nostril = ellipsoid(
        p,
        NOSE + DVec3::new(0.0105, -0.001, 0.0125),
        DVec3::new(0.0050, 0.0040, 0.0060),
    );
    let split = ellipsoid(
        p,
        NOSE + DVec3::new(0.0, -0.014, 0.012),
        DVec3::new(0.0016, 0.0130, 0.0060),
    );
    carve(carve(d, nostril, 0.003), split, 0.003)
}

/// A pointed ear, hollow in front.
fn ear(p: DVec3) -> f64 {
    let axis = EAR_TIP - EAR;
    let t = ((p - EAR).dot(axis) / axis.length_squared()).clamp(-0.2, 1.0);
    let up = axis.normalize_or_zero();
    let out = DVec3::new(0.80, 0.0, 0.35);
    let side = (out - up * out.dot(up)).normalize_or_zero();
    let front = side.cross(up);
    let q = p - EAR;
    let q = DVec3::new(q.dot(side), q.dot(up), q.dot(front));
    let width = 0.040 * (1.0 - t.max(0.0).powf(1.6)) + 0.004;
    let depth = 0.020 * (1.0 - 0.75 * t.max(0.0)) + 0.002;
    let along = (q.y - axis.length() * t).abs();
    let k = DVec2::new(q.x / width, q.z / depth).length();
    let shell = ((k - 1.0) * depth).max(-depth) + along;
    let hollow = ellipsoid(
        q,
        DVec3::new(0.0, 0.050, depth * 0.75 + 0.004),
        DVec3::new(0.022, 0.050, 0.016),
    );
    let open = carve(shell, hollow, 0.006);
    clip(open, -q.y - 0.02 * smooth_step(0.0, 1.0, 0.5), 0.01)
}
