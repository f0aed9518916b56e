//! The left shoe, in a frame whose first axis runs from heel to toe.
use super::super::field::{Loft, blend, clip, smooth_step};
use super::body::ANKLE;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Along the foot: place, center across, 0, half width, height of the upper, below (buried).
static UPPER: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [-0.070, 0.0, 0.0, 0.026, 0.066, 0.05],
            [-0.045, 0.0, 0.0, 0.036, 0.100, 0.05],
            [0.000, 0.0, 0.0, 0.040, 0.112, 0.05],
            [0.040, 0.002, 0.0, 0.041, 0.103, 0.05],
            [0.080, 0.003, 0.0, 0.044, 0.083, 0.05],
            [0.120, 0.002, 0.0, 0.048, 0.068, 0.05],
            [0.155, 0.0, 0.0, 0.048, 0.059, 0.05],
            [0.185, -0.003, 0.0, 0.041, 0.051, 0.05],
        ],
        2.4,
        (0.012, 0.024),
    )
});

/// The surface of the left shoe.
pub fn surface(p: DVec3) -> f64 {
    let rough = (p - DVec3::new(0.14, 0.05, 0.03)).length() - 0.20;
    if rough > 0.08 {
        return rough;
    }
    // The toes point outward a little.
    let (sin, cos) = (0.13, 0.9915);
    let q = DVec3::new(p.x - ANKLE.x, p.y, p.z - ANKLE.z);
    let along = q.z * cos + q.x * sin;
    let across = q.x * cos - q.z * sin;
    let upper = UPPER.distance(along, DVec2::new(across, p.y));
    // The sole stands out all round and rolls up under the toe.
    let ground = 0.012 * smooth_step(0.13, 0.215, along).powi(2);
    let outline = UPPER.distance(along, DVec2::new(across, 0.012)) - 0.005;
    let sole = clip(
        clip(outline, p.y - 0.027 - ground * 0.6, 0.005),
        ground - p.y,
        0.006,
    );
    let toe_cap =
        0.0025 * smooth_step(0.118, 0.126, along) * (1.0 - smooth_step(0.05, 0.06, p.y - 0.02));
    let laces = 0.0022
        * (along / 0.0065).sin().max(0.0)
        * smooth_step(0.045, 0.055, along)
        * (1.0 - smooth_step(0.100, 0.108, along))
        * (1.0 - smooth_step(0.014, 0.020, across.abs()));
    let leather = clip(upper - toe_cap - laces, 0.010 - p.y, 0.006);
    blend(leather, sole, 0.003)
}
