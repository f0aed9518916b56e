//! The left shoe, in a frame whose first axis runs from heel to toe.
use super::super::field::{Loft, blend, clip, smooth_step};
use super::body::ANKLE;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Along the foot: place, center across, 0, half width, height of the upper, below (buried).
static UPPER: LazyLock<Loft> = LazyLock::new(|| {
    Loft::new(
        &[
            [-0.070, 0.0, 0.0, 0.035, 0.076, 0.05],
            [-0.045, 0.0, 0.0, 0.039, 0.108, 0.05],
            [0.000, 0.0, 0.0, 0.041, 0.118, 0.05],
            [0.040, 0.002, 0.0, 0.042, 0.110, 0.05],
            [0.080, 0.003, 0.0, 0.046, 0.092, 0.05],
            [0.120, 0.002, 0.0, 0.050, 0.077, 0.05],
            [0.155, 0.0, 0.0, 0.050, 0.068, 0.05],
            [0.188, -0.004, 0.0, 0.042, 0.060, 0.05],
        ],
        2.5,
        (0.016, 0.028),
    )
});
/// How thick the sole is.
const SOLE: f64 = 0.030;

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
    let lift = 0.012 * smooth_step(0.13, 0.215, along).powi(2);
    let outline = UPPER.distance(along, DVec2::new(across, 0.012)) - 0.0085;
    let sole = clip(
        clip(outline, p.y - SOLE - 0.6 * lift, 0.010),
        lift - p.y,
        0.012,
    );
    let leather = clip(upper - laces(along, across), 0.010 - p.y, 0.006);
    blend(leather, sole, 0.017)
}

/// How far the laces stand out: four bars over the tongue.
fn laces(along: f64, across: f64) -> f64 {
    let row = ((along - 0.0515) * std::f64::consts::TAU / 0.021).cos();
    let field = smooth_step(0.040, 0.046, along) * (1.0 - smooth_step(0.120, 0.126, along));
    0.0045 * smooth_step(-0.4, 0.6, row) * field * (1.0 - smooth_step(0.020, 0.028, across.abs()))
}
