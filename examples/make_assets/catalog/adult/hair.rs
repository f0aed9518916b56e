//! Short hair, combed up and back from the forehead.
use super::super::field::{blend, carve, clip, ellipsoid, smooth_step};
use glam::DVec3;

/// The left half of the hair.
pub fn surface(p: DVec3) -> f64 {
    let rough = (p - DVec3::new(0.0, 1.715, -0.005)).length() - 0.13;
    if rough > 0.06 {
        return rough;
    }
    let cap = ellipsoid(
        p,
        DVec3::new(0.0, 1.708, -0.012),
        DVec3::new(0.0835, 0.0935, 0.0995),
    );
    let top = ellipsoid(
        p,
        DVec3::new(0.0, 1.763, 0.020),
        DVec3::new(0.066, 0.038, 0.080),
    );
    let quiff = ellipsoid(
        p,
        DVec3::new(0.022, 1.770, 0.072),
        DVec3::new(0.042, 0.022, 0.030),
    );
    let nape = ellipsoid(
        p,
        DVec3::new(0.0, 1.640, -0.062),
        DVec3::new(0.058, 0.050, 0.034),
    );
    let volume = blend(blend(blend(cap, top, 0.03), quiff, 0.02), nape, 0.03);
    // Locks run from the forehead backward, deeper toward the front.
    let across = (p.x / 0.020 + 1.2 * (p.z - 0.02) / 0.1).sin();
    let lock = 0.0026 * across * smooth_step(1.72, 1.77, p.y) * smooth_step(0.004, 0.02, p.x);
    clip(volume - lock, -line(p), 0.006)
}

/// Positive where hair grows, about the distance to the hairline.
fn line(p: DVec3) -> f64 {
    // The face: a rounded block in front, below the forehead's hairline; sideburns reach down
    // before the ears, and behind the ears the line falls to the nape.
    let front = clip(
        p.z - 0.030 - 0.25 * (p.y - 1.70),
        p.y - 1.7440 + 1.2 * p.x * p.x,
        0.03,
    );
    let temple = clip(p.z - 0.012, p.y - 1.690, 0.01);
    let ear = ellipsoid(
        p,
        DVec3::new(0.085, 1.672, -0.010),
        DVec3::new(0.030, 0.036, 0.026),
    );
    let below = p.y - 1.612;
    let _ = &temple;
    let face = blend_max(-front, 0.0);
    let grown = carve(clip(-below, -ear, 0.01), face, 0.01);
    -grown
}

fn blend_max(a: f64, _b: f64) -> f64 {
    a
}
