//! A tentacle whose vertices follow many bones at once, so that it bends without a corner.
use super::super::field::smooth_step;
use super::super::mesh::Mesh;
use super::super::solids::turned;
use super::model::{Face, Rig, Skin, Weights, normalized, plain};
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

const BONES: usize = 10;
const LENGTH: f64 = 2.5;
const RINGS: usize = 84;
const SIDES: usize = 28;
/// Weights below this are left out.
const SMALLEST: f64 = 0.002;

const BACK: usize = 0;
const STRIPE: usize = 1;
const BELLY: usize = 2;
const SUCKER: usize = 3;
const CUP: usize = 4;

pub fn rig() -> Rig {
    let mut rig = Rig::new(
        "Tentacle",
        vec![
            plain("Back", [0.42, 0.10, 0.34]),
            plain("Stripe", [0.56, 0.17, 0.38]),
            plain("Belly", [0.88, 0.55, 0.47]),
            plain("Sucker", [0.97, 0.80, 0.70]),
            plain("Cup", [0.66, 0.32, 0.36]),
        ],
    );
    let spine = Spine::new();
    for bone in 0..BONES {
        let end = |i: usize| spine.at(i as f64 / BONES as f64).0;
        let parent = bone.checked_sub(1);
        rig.bone(
            format!("Segment {}", bone + 1),
            parent,
            end(bone),
            end(bone + 1),
        );
    }
    let mut skin = Skin::new("Tentacle skin");
    arm(&mut skin, &spine);
    for sucker in 0..22 {
        // Closer together where the arm is thinner.
        let t = f64::from(sucker) / 22.0;
        let at = 0.07 + 0.89 * (1.0 - (1.0 - t).powf(1.55));
        for side in [-1.0, 1.0] {
            let stagger = 0.5 * (1.0 + side) * 0.017 * (1.0 - t);
            suck(&mut skin, &spine, at + stagger, side);
        }
    }
    rig.skins.push(skin);
    rig
}

/// How thick the arm is at a share of its length.
fn radius(at: f64) -> f64 {
    let taper = 0.205 * (1.0 - at).powf(0.86) + 0.014;
    taper + 0.16 * (1.0 - smooth_step(0.0, 0.13, at)).powi(2)
}

/// Bell curves round the bones' middles.
fn weights(at: f64) -> Weights {
    let place = at * BONES as f64;
    let bell = |bone: usize| {
        let off = (place - bone as f64 - 0.5) / 1.15;
        (bone, (-off * off).exp())
    };
    let all = normalized((0..BONES).map(bell).collect());
    normalized(all.into_iter().filter(|w| w.1 > SMALLEST).collect())
}

/// The curve through the middle, in the plane z = 0.
struct Spine {
    places: Vec<(DVec3, f64)>,
}

impl Spine {
    const STEPS: usize = 800;

    fn new() -> Self {
        let mut at = DVec3::new(-0.20, -0.98, 0.0);
        let mut places = Vec::new();
        for step in 0..=Self::STEPS {
            let t = step as f64 / Self::STEPS as f64;
            // Leans one way, then the other, and curls in at the tip.
            let angle =
                0.62 * (TAU * 0.80 * t + 0.30).sin() - 0.25 + 5.6 * smooth_step(0.52, 1.16, t) * t;
            places.push((at, angle));
            at += DVec3::new(angle.sin(), angle.cos(), 0.0) * LENGTH / Self::STEPS as f64;
        }
        Self { places }
    }

    /// The place, and the directions across on the suckers' side, along, and sideways.
    fn at(&self, share: f64) -> (DVec3, DMat3) {
        let step = share.clamp(0.0, 1.0) * Self::STEPS as f64;
        let low = (step as usize).min(Self::STEPS - 1);
        let t = step - low as f64;
        let (a, b) = (self.places[low], self.places[low + 1]);
        let angle = a.1 + (b.1 - a.1) * t;
        let along = DVec3::new(angle.sin(), angle.cos(), 0.0);
        let across = DVec3::new(angle.cos(), -angle.sin(), 0.0);
        let turn = DMat3::from_cols(across, along, across.cross(along));
        (a.0.lerp(b.0, t), turn)
    }
}

/// From the middle to the skin, at an angle from the side of the suckers.
fn outline(at: f64, angle: f64) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    // Flat below, and lightly ringed above.
    let flat = 1.0 - 0.17 * smooth_step(0.35, 1.0, cos);
    let rings = 1.0 + 0.012 * smooth_step(0.2, -0.4, cos) * (TAU * 36.0 * at.powf(0.8)).sin();
    DVec3::new(cos * flat, 0.0, sin) * rings * radius(at)
}

fn arm(skin: &mut Skin, spine: &Spine) {
    let vertex = |skin: &mut Skin, at: f64, p: DVec3| {
        let (middle, turn) = spine.at(at);
        skin.positions.push(middle + turn * p);
        skin.weights.push(weights(at));
        skin.positions.len() as u32 - 1
    };
    let mut face = Vec::new();
    let mut rings: Vec<Vec<u32>> = Vec::new();
    for ring in 0..=RINGS {
        let at = ring as f64 / RINGS as f64;
        let angles = (0..SIDES).map(|side| TAU * side as f64 / SIDES as f64);
        rings.push(
            angles
                .map(|angle| vertex(skin, at, outline(at, angle)))
                .collect(),
        );
    }
    for pair in rings.windows(2) {
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            let from_belly = side.min(SIDES - 1 - side);
            let material = match from_belly {
                0..5 => BELLY,
                5..7 => STRIPE,
                _ => BACK,
            };
            let [a, b, c, d] = [pair[0][side], pair[0][next], pair[1][next], pair[1][side]];
            face.extend([([a, c, b], material), ([a, d, c], material)]);
        }
    }
    let bottom = vertex(skin, 0.0, DVec3::ZERO);
    let (tip, turn) = spine.at(1.0);
    skin.positions.push(tip + turn.y_axis * radius(1.0));
    skin.weights.push(weights(1.0));
    let top = skin.positions.len() as u32 - 1;
    for side in 0..SIDES {
        let next = (side + 1) % SIDES;
        face.push(([bottom, rings[0][side], rings[0][next]], BACK));
        face.push(([top, rings[RINGS][next], rings[RINGS][side]], BACK));
    }
    skin.faces
        .extend(face.into_iter().map(|(corners, material)| Face {
            corners,
            material,
            picture: None,
        }));
}

/// A sucker: a ring with a cup in it, which keeps its shape when the arm bends.
fn suck(skin: &mut Skin, spine: &Spine, at: f64, side: f64) {
    let angle = side * 0.52;
    let size = 0.40 * radius(at).min(0.20);
    let (middle, turn) = spine.at(at);
    let foot = outline(at, angle);
    let out = DVec3::new(angle.cos(), 0.0, 0.75 * angle.sin()).normalize_or(DVec3::X);
    let frame = DMat3::from_cols(out.cross(DVec3::Y), out, DVec3::Y);
    let place = |mut mesh: Mesh| {
        for p in &mut mesh.positions {
            *p = middle + turn * (foot + frame * (*p * size));
        }
        mesh
    };
    let ring = [
        (0.0, -0.5),
        (0.74, -0.5),
        (0.96, 0.08),
        (1.00, 0.26),
        (0.90, 0.38),
        (0.74, 0.38),
        (0.62, 0.26),
        (0.0, 0.26),
    ];
    let cup = [
        (0.0, 0.0),
        (0.60, 0.0),
        (0.645, 0.285),
        (0.36, 0.18),
        (0.0, 0.13),
    ];
    skin.add(&place(turned(&ring, 12)), SUCKER, |_| weights(at));
    skin.add(&place(turned(&cup, 12)), CUP, |_| weights(at));
}
