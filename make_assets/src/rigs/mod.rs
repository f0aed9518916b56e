//! Rigs in Collada files, as other programs write them.
mod chain;
mod collada;
mod column;
mod creature;
mod eye;
mod face;
mod grown;
mod humanoid;
mod model;
mod paint;
mod png;
mod tentacle;
mod textured_cube;
mod wood;

use super::mesh::Mirrored;

/// The files' contents, in the order of their paths; `body` is the adult's.
pub fn contents(body: &Mirrored) -> Vec<Vec<u8>> {
    let rigs = [
        column::rig(),
        chain::rig(),
        textured_cube::rig(),
        tentacle::rig(),
        creature::rig(),
        humanoid::rig(body),
        face::rig(),
    ];
    let mut all: Vec<Vec<u8>> = rigs
        .iter()
        .map(|rig| collada::text(rig).into_bytes())
        .collect();
    all.push(wood::png());
    all
}
