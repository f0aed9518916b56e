//! The trousers: hips, legs and turned-up hems.
use super::super::field::{Loft, blend, ellipsoid, smooth_step, sphere};
use super::body::KNEE;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Where the turn-up ends.
pub const TURN_UP: f64 = 0.116;

/// Height, center (0, z), half width, front, back.
static PELVIS: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.850, 0.0, 0.0, 0.120, 0.088, 0.085],
            [0.900, 0.0, 0.0, 0.161, 0.100, 0.117],
            [0.950, 0.0, 0.0, 0.155, 0.098, 0.106],
            [1.000, 0.0, 0.0, 0.146, 0.094, 0.092],
        ],
        2.2,
        (0.03, 0.02),
    )
});

/// Height, center (x, z), half width, front, back.
static LEG: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [0.072, 0.128, -0.014, 0.058, 0.062, 0.060],
            [0.130, 0.127, -0.016, 0.057, 0.058, 0.059],
            [0.220, 0.124, -0.014, 0.058, 0.055, 0.062],
            [0.330, 0.120, -0.010, 0.061, 0.056, 0.070],
            [0.420, 0.117, -0.004, 0.062, 0.060, 0.067],
            [0.500, 0.114, 0.004, 0.064, 0.068, 0.060],
            [0.600, 0.110, 0.006, 0.071, 0.075, 0.070],
            [0.710, 0.105, 0.004, 0.080, 0.085, 0.083],
            [0.820, 0.098, 0.0, 0.085, 0.091, 0.097],
            [0.900, 0.090, 0.0, 0.080, 0.090, 0.108],
            [0.960, 0.082, 0.0, 0.062, 0.084, 0.084],
        ],
        2.0,
        (0.012, 0.03),
    )
});

/// The trousers' surface at a place of the left half, given also the place mirrored.
pub fn surface(p: DVec3, mirrored: DVec3) -> f64 {
    if p.y > 1.1 {
        return p.y - 1.02;
    }
    let legs = blend(leg(p), leg(mirrored), 0.02);
    let mut pelvis = PELVIS.distance(p.y, DVec2::new(p.x, p.z));
    let seat = ellipsoid(
        p,
        DVec3::new(0.070, 0.905, -0.054),
        DVec3::new(0.082, 0.085, 0.068),
    );
    pelvis = blend(pelvis, seat, 0.03);
    blend(legs, pelvis, 0.05)
}

fn leg(p: DVec3) -> f64 {
    let d = LEG.distance(p.y, DVec2::new(p.x, p.z));
    let knee = sphere(p, KNEE + DVec3::new(0.0, 0.0, 0.012), 0.052);
    let d = blend(d, knee, 0.04);
    let turn_up = 0.007 * (1.0 - smooth_step(TURN_UP - 0.004, TURN_UP + 0.004, p.y));
    // The cloth breaks over the shoe and wrinkles behind the knee.
    let fall = smooth_step(TURN_UP, 0.145, p.y) * (1.0 - smooth_step(0.160, 0.260, p.y));
    let wave =
        |length: f64, at: f64| ((p.y - at + 0.35 * p.z) * std::f64::consts::TAU / length).cos();
    let behind =
        smooth_step(0.01, -0.04, p.z) * (1.0 - smooth_step(0.02, 0.09, (p.y - KNEE.y).abs()));
    let breaks = 0.004 * smooth_step(-0.02, 0.03, p.z) * fall * wave(0.050, 0.175);
    d - turn_up - 0.005 * fall - breaks - 0.003 * behind * wave(0.052, 0.5)
}
