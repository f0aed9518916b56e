//! Rigs in Collada files, as other programs write them.
mod chain;
mod collada;
mod column;
mod model;
mod png;
mod tentacle;
mod textured_cube;
mod wood;

/// The files' contents, in the order of their paths in the list above.
pub fn contents() -> Vec<Vec<u8>> {
    let rigs = [
        column::rig(),
        chain::rig(),
        textured_cube::rig(),
        tentacle::rig(),
    ];
    let mut all: Vec<Vec<u8>> = rigs
        .iter()
        .map(|rig| collada::text(rig).into_bytes())
        .collect();
    all.push(wood::png());
    all
}
