//! Landmarks of the adult, and the whole body's surface put together.
use super::super::field::{blend, carve, clip, round_cone, sphere};
use super::{face, hair, jacket, shoe, trousers};
use glam::DVec3;

/// Joints of the left side.
pub const SHOULDER: DVec3 = DVec3::new(0.176, 1.415, -0.012);
pub const ELBOW: DVec3 = DVec3::new(0.374, 1.205, -0.022);
pub const WRIST: DVec3 = DVec3::new(0.548, 1.024, 0.030);
pub const HIP: DVec3 = DVec3::new(0.094, 0.925, 0.0);
pub const KNEE: DVec3 = DVec3::new(0.114, 0.500, 0.012);
pub const ANKLE: DVec3 = DVec3::new(0.128, 0.085, -0.022);

/// The surface of the whole body.
pub fn surface(p: DVec3) -> f64 {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let far = DVec3::new(-near.x, p.y, p.z);
    let mut d = blend(
        jacket::surface(near, far),
        trousers::surface(near, far),
        0.012,
    );
    d = blend(d, neck_and_head(near), 0.005);
    blend(d, shoe::surface(near), 0.014)
}

/// Neck, collar, head and hair.
fn neck_and_head(p: DVec3) -> f64 {
    let rough = sphere(p, DVec3::new(0.0, 1.66, 0.0), 0.18);
    if rough > 0.12 {
        return rough;
    }
    let neck = neck(p);
    let mut d = blend(neck, face::surface(p), 0.022);
    d = blend(d, hair::surface(p), 0.003);
    blend(d, collar(p, neck), 0.009)
}

/// The neck alone.
pub fn neck(p: DVec3) -> f64 {
    round_cone(
        p,
        (DVec3::new(0.0, 1.46, -0.030), 0.058),
        (DVec3::new(0.0, 1.63, -0.002), 0.050),
    )
}

/// A stand-up collar round a neck at this distance, higher at the nape, open in a V at the throat;
/// its rim falls toward the neck like a funnel.
pub fn collar(p: DVec3, neck: f64) -> f64 {
    let ring = neck - 0.026;
    let rim = p.y - 1.549 + 0.42 * p.z - 0.45 * ring.clamp(-0.03, 0.01);
    let opening = (p.x - 0.006 - 0.60 * (p.y - 1.478)).max(0.01 - p.z);
    carve(clip(ring, rim, 0.020), opening, 0.016)
}
