//! A grown person in a short jacket, trousers and shoes, 1.8 high, with the course's 18 joints.
//! Modeled in meters above the ground for a height of 1.8 m, left half (x ≥ 0) only.
mod binding;
mod body;
mod face;
mod hair;
mod hand;
mod shoe;

use super::mesh::mirror;
use super::polygonize::{Grid, polygonize};
use super::remesh::{Target, remesh};
use super::rig::Character;
use super::skin;
use glam::DVec3;

/// The ground lies this far below the origin.
const GROUND: f64 = 0.9;

/// The whole character, its middle at the origin, facing +Z.
pub fn character() -> Character {
    let grid = Grid {
        low: DVec3::new(0.0, -0.02, -0.2),
        high: DVec3::new(0.78, 1.84, 0.26),
        step: 0.005,
    };
    let field = |p: DVec3| body::surface(p);
    let rough = polygonize(&field, &grid);
    let target = Target {
        field: &field,
        size: &size,
        rounds: 14,
    };
    let mut body = mirror(&remesh(&rough, &target));
    let joints = binding::joints();
    let weights = skin::weights(&body, &joints, &binding::owner, &binding::reach);
    for p in &mut body.mesh.positions {
        p.y -= GROUND;
    }
    Character {
        joints,
        mesh: body.mesh,
        weights,
    }
}

/// The wanted edge length: fine where the face, the hands and the hems have something to show.
fn size(p: DVec3) -> f64 {
    let near = |center: DVec3, radius: f64, fine: f64| {
        fine + 0.16 * (p.distance(center) - radius).max(0.0)
    };
    let band = |at: f64, fine: f64| fine + 0.2 * ((p.y - at).abs() - 0.008).max(0.0);
    let mut size: f64 = 0.0185;
    size = size.min(near(DVec3::new(0.0, 1.68, 0.0), 0.11, 0.0105));
    size = size.min(near(DVec3::new(0.025, 1.645, 0.10), 0.045, 0.0058));
    size = size.min(near(DVec3::new(0.033, 1.69, 0.09), 0.018, 0.0036));
    size = size.min(near(DVec3::new(0.008, 1.615, 0.11), 0.022, 0.0042));
    size = size.min(near(DVec3::new(0.08, 1.675, -0.005), 0.025, 0.0055));
    size = size.min(near(hand::center(), 0.09, 0.0066));
    size = size.min(near(DVec3::new(0.14, 0.05, 0.06), 0.13, 0.0115));
    if p.x < 0.3 {
        size = size
            .min(band(0.962, 0.010))
            .min(band(1.01, 0.011))
            .min(band(0.08, 0.009));
    }
    size
}
