//! A dog with pointed ears, standing, 28 joints. Modeled above the ground, left half (x ≥ 0) only.
mod binding;
mod body;
mod head;

use super::mesh::mirror;
use super::polygonize::{Grid, polygonize};
use super::remesh::{Target, remesh};
use super::rig::Character;
use super::skin;
use glam::DVec3;

/// The ground lies this far below the origin.
const GROUND: f64 = 0.45;

/// The whole animal, its middle near the origin, facing +Z.
pub fn character() -> Character {
    let grid = Grid {
        low: DVec3::new(0.0, -0.03, -0.72),
        high: DVec3::new(0.24, 0.98, 0.76),
        step: 0.006,
    };
    let rough = polygonize(&body::surface, &grid);
    let target = Target {
        field: &body::surface,
        size: &size,
        rounds: 13,
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

/// The wanted edge length.
fn size(p: DVec3) -> f64 {
    let near = |center: DVec3, radius: f64, fine: f64| {
        fine + 0.16 * (p.distance(center) - radius).max(0.0)
    };
    let mut size: f64 = 0.020;
    size = size.min(near(DVec3::new(0.0, 0.715, 0.535), 0.13, 0.0100));
    size = size.min(near(head::EYE, 0.018, 0.0030));
    size = size.min(near(head::NOSE, 0.025, 0.0050));
    size = size.min(near(DVec3::new(0.070, 0.850, 0.425), 0.05, 0.0068));
    for paw in [body::FRONT_PAW, body::HIND_PAW] {
        size = size.min(near(paw, 0.05, 0.0078));
    }
    size
}
