//! A grown person in a short jacket, trousers and shoes, 1.8 high, with the course's 18 joints.
//! Modeled in meters above the ground for a height of 1.8 m, left half (x ≥ 0) only.
pub mod binding;
pub mod body;
pub mod face;
pub mod hair;
pub mod hand;
pub mod jacket;
pub mod shoe;
pub mod trousers;

use super::mesh::{Mirrored, mirror};
use super::polygonize::{Grid, polygonize};
use super::remesh::{Target, remesh};
use super::rig::Character;
use super::skin;
use glam::DVec3;

/// The ground lies this far below the origin.
pub const GROUND: f64 = 0.9;

/// The whole body, standing on the ground and facing +Z.
pub fn body() -> Mirrored {
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
        rounds: 10,
    };
    mirror(&remesh(&rough, &target))
}

/// The whole character, its middle at the origin, facing +Z.
pub fn character(body: &Mirrored) -> Character {
    let joints = binding::joints();
    let weights = skin::weights(body, &joints, &binding::owner, &binding::reach);
    let mut mesh = body.mesh.clone();
    for p in &mut mesh.positions {
        p.y -= GROUND;
    }
    Character {
        joints,
        mesh,
        weights,
    }
}

/// The wanted edge length: fine where the face, the hands and the hems have something to show.
fn size(p: DVec3) -> f64 {
    let near = |center: DVec3, radius: f64, fine: f64| {
        fine + 0.16 * (p.distance(center) - radius).max(0.0)
    };
    let band = |at: f64, fine: f64| fine + 0.2 * ((p.y - at).abs() - 0.008).max(0.0);
    let mut size: f64 = 0.0212;
    size = size.min(near(DVec3::new(0.0, 1.68, 0.0), 0.11, 0.0105));
    size = size.min(near(DVec3::new(0.0, 1.77, 0.02), 0.07, 0.0078));
    size = size.min(near(DVec3::new(0.020, 1.645, 0.10), 0.040, 0.0060));
    size = size.min(near(face::EYE, 0.018, 0.0028));
    size = size.min(near(DVec3::new(0.008, 1.615, 0.11), 0.022, 0.0040));
    size = size.min(near(DVec3::new(0.08, 1.675, -0.005), 0.025, 0.0050));
    size = size.min(near(hand::center(), 0.09, 0.0072));
    size = size.min(near(hand::tips(), 0.035, 0.0052));
    size = size.min(near(DVec3::new(0.145, 0.05, 0.065), 0.13, 0.0098));
    size = size.min(near(body::ELBOW, 0.05, 0.0125));
    if p.x < 0.3 {
        size = size
            .min(band(jacket::HEM, 0.0095))
            .min(band(jacket::RIB, 0.010));
        size = size.min(band(trousers::TURN_UP, 0.0105));
        size = size.min(near(DVec3::new(0.0, 1.52, -0.01), 0.07, 0.0074));
        size = size.min(near(DVec3::new(0.10, 1.10, 0.10), 0.05, 0.0100));
    }
    size
}
