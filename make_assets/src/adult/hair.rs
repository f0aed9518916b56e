//! Short hair, combed up and back from the forehead.
use super::super::field::{blend, clip, ellipsoid, smooth_step};
use glam::DVec3;

/// The left half of the hair.
pub fn surface(p: DVec3) -> f64 {
    let rough = (p - DVec3::new(0.0, 1.720, -0.005)).length() - 0.145;
    if rough > 0.06 {
        return rough;
    }
    let cap = ellipsoid(
        p,
        DVec3::new(0.0, 1.712, -0.014),
        DVec3::new(0.0845, 0.0950, 0.1010),
    );
    let top = ellipsoid(
        p,
        DVec3::new(0.0, 1.766, 0.008),
        DVec3::new(0.074, 0.046, 0.096),
    );
    let quiff = ellipsoid(
        p,
        DVec3::new(0.0, 1.777, 0.060),
        DVec3::new(0.064, 0.036, 0.050),
    );
    let nape = ellipsoid(
        p,
        DVec3::new(0.0, 1.640, -0.060),
        DVec3::new(0.058, 0.050, 0.034),
    );
    let volume = blend(blend(blend(cap, top, 0.02), quiff, 0.02), nape, 0.03);
    // Locks are combed from the forehead back over the top and the sides.
    let turn = p.x.atan2(p.y - 1.690) + 0.10 * (p.z / 0.035).sin();
    let wave = 1.0 - (17.0 * turn).cos();
    let crown = smooth_step(1.70, 1.76, p.y) * smooth_step(-0.112, -0.05, p.z);
    let front = smooth_step(0.02, 0.08, p.z);
    clip(
        volume + (0.0014 + 0.0016 * front) * wave * crown - 0.002 * crown,
        hairless(p),
        0.005,
    )
}

/// Negative where hair grows; about the distance to the hairline.
fn hairless(p: DVec3) -> f64 {
    // Bare are the face, a block below the hairline and before the sideburns, the ears, and
    // what lies below the nape.
    let hairline = p.y - 1.7480 + 2.2 * p.x * p.x;
    let sideburn = 0.030 - p.z + 0.35 * (p.y - 1.70);
    let face = clip(hairline, sideburn, 0.02);
    let ear = ellipsoid(
        p,
        DVec3::new(0.085, 1.668, -0.012),
        DVec3::new(0.040, 0.038, 0.027),
    );
    let end = p.y - 1.618 - 0.05 * smooth_step(-0.03, -0.005, p.z);
    -blend(blend(face, ear, 0.008), end, 0.008)
}
