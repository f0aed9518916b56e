//! A floating spirit whose hands hang in the air beside it: three trees of bones, each of which
//! moves for itself.
use super::super::field::{blend, carve, chain, ellipsoid, round_cone};
use super::super::polygonize::Grid;
use super::eye::eye;
use super::grown::{self, Seed, bone};
use super::model::{Bone, Rig, Skin, Up, plain};
use super::paint::Painted;
use glam::DVec3;

/// Where nothing else is painted the skin shows, material 0.
const PALE: usize = 1;
const TIP: usize = 2;
const MOUTH: usize = 3;
const TONGUE: usize = 4;
const GLOVE: usize = 5;
const WHITE: usize = 6;
const IRIS: usize = 7;
const PUPIL: usize = 8;

/// From the belly down and back: place and radius.
const TAIL: [(DVec3, f64); 7] = [
    (DVec3::new(0.0, 0.10, 0.00), 0.27),
    (DVec3::new(0.0, -0.18, 0.00), 0.235),
    (DVec3::new(0.0, -0.42, -0.03), 0.165),
    (DVec3::new(0.0, -0.63, -0.10), 0.105),
    (DVec3::new(0.0, -0.79, -0.22), 0.064),
    (DVec3::new(0.0, -0.87, -0.38), 0.036),
    (DVec3::new(0.0, -0.84, -0.54), 0.012),
];
const EAR: [(DVec3, f64); 3] = [
    (DVec3::new(0.20, 0.60, -0.03), 0.120),
    (DVec3::new(0.37, 0.80, -0.05), 0.066),
    (DVec3::new(0.52, 0.93, -0.10), 0.034),
];
const EYE: DVec3 = DVec3::new(0.150, 0.485, 0.262);
const HEAD: DVec3 = DVec3::new(0.0, 0.42, 0.0);
const PALM: DVec3 = DVec3::new(0.76, -0.12, 0.16);
/// Name, knuckle across the palm and along it, spread, length, radius.
const FINGERS: [(&str, f64, f64, f64, f64, f64); 4] = [
    ("Left index", 0.068, 0.070, 0.22, 0.175, 0.040),
    ("Left middle", 0.000, 0.086, 0.00, 0.190, 0.042),
    ("Left little", -0.066, 0.066, -0.24, 0.155, 0.037),
    ("Left thumb", 0.082, -0.030, 1.15, 0.150, 0.042),
];

pub fn rig() -> Rig {
    let materials = vec![
        plain("Sky", [0.16, 0.47, 0.78]),
        plain("Pale sky", [0.72, 0.88, 0.96]),
        plain("Midnight", [0.07, 0.16, 0.42]),
        plain("Mouth", [0.28, 0.05, 0.12]),
        plain("Tongue", [0.90, 0.38, 0.42]),
        plain("Glove", [0.98, 0.76, 0.18]),
        plain("Eye white", [0.97, 0.97, 0.95]),
        plain("Iris", [0.10, 0.50, 0.36]),
        plain("Pupil", [0.03, 0.03, 0.05]),
    ];
    let mut rig = Rig {
        up: Up::Z,
        unit: 0.01,
        ..Rig::new("Creature", materials)
    };
    bones(&mut rig);
    let body = grown::grow(&Seed {
        field: &surface,
        grid: Grid {
            low: DVec3::new(0.0, -0.96, -0.62),
            high: DVec3::new(1.02, 1.02, 0.52),
            step: 0.0125,
        },
        size: &size,
    });
    let owner = |p: DVec3| owner(&rig.bones, p);
    let reach = |p: DVec3| if p.x.abs() > 0.55 { 0.022 } else { 0.065 };
    let weights = grown::weights(&body, &rig.bones, &owner, &reach);
    let mut painted = Painted::new(body.mesh, weights);
    paint(&mut painted);
    let mut skin = Skin::new("Spirit");
    skin.add_painted(painted);
    for side in [1.0, -1.0] {
        let at = DVec3::new(EYE.x * side, EYE.y, EYE.z);
        let name = if side > 0.0 { "Left eye" } else { "Right eye" };
        let index = rig.bones.iter().position(|bone| bone.name == name);
        let weights = vec![(index.unwrap_or(0), 1.0)];
        let rings = [(PUPIL, 0.30), (IRIS, 0.62), (WHITE, 9.0)];
        let gaze = DVec3::new(0.10 * side, 0.02, 1.0);
        skin.add_painted(eye(at, 0.125, gaze, &rings, &weights));
    }
    rig.skins.push(skin);
    rig
}

/// The frame of the left hand: toward the thumb, out of its back, along the fingers.
fn hand_axes() -> [DVec3; 3] {
    let along = DVec3::new(0.20, -0.42, 0.88).normalize_or(DVec3::Z);
    let thumb = (DVec3::NEG_X - along * along.dot(DVec3::NEG_X)).normalize_or(DVec3::X);
    let back = along.cross(thumb);
    // Turned, so that the palms look at each other a little.
    let (sin, cos) = 0.45f64.sin_cos();
    [thumb * cos - back * sin, back * cos + thumb * sin, along]
}

/// The spheres of a finger: knuckle, middle joint, end.
fn finger(
    (_, across, along, spread, length, radius): (&str, f64, f64, f64, f64, f64),
) -> [(DVec3, f64); 3] {
    let [thumb, back, ahead] = hand_axes();
    let knuckle = PALM + thumb * across + ahead * along;
    let first = (ahead + thumb * spread - back * 0.10).normalize_or(ahead);
    let second = (ahead + thumb * spread * 0.6 - back * 0.42).normalize_or(ahead);
    let middle = knuckle + first * length * 0.52;
    let end = middle + second * length * 0.48;
    [
        (knuckle, radius),
        (middle, radius * 0.98),
        (end, radius * 0.93),
    ]
}

fn bones(rig: &mut Rig) {
    bone(rig, "Body", "", TAIL[1].0, DVec3::Y * 0.14);
    bone(rig, "Head", "Body", DVec3::Y * 0.14, DVec3::Y * 0.76);
    bone(rig, "Left ear", "Head", EAR[0].0, EAR[1].0);
    bone(rig, "Left ear tip", "Left ear", EAR[1].0, EAR[2].0);
    bone(rig, "Left eye", "Head", EYE, EYE + DVec3::Z * 0.16);
    bone(rig, "Tail 1", "Body", TAIL[1].0, TAIL[2].0);
    for i in 2..6 {
        let (name, parent) = (format!("Tail {i}"), format!("Tail {}", i - 1));
        bone(rig, &name, &parent, TAIL[i].0, TAIL[i + 1].0);
    }
    let [_, _, along] = hand_axes();
    bone(
        rig,
        "Left hand",
        "",
        PALM - along * 0.09,
        PALM + along * 0.07,
    );
    for each in FINGERS {
        let [knuckle, middle, end] = finger(each).map(|sphere| sphere.0);
        let (first, second) = (format!("{} 1", each.0), format!("{} 2", each.0));
        let tip = end + (end - middle).normalize_or(along) * each.5;
        bone(rig, &first, "Left hand", knuckle, middle);
        bone(rig, &second, &first, middle, tip);
    }
}

/// The left half of the surface.
fn surface(p: DVec3) -> f64 {
    let body = smooth_chain(p, &TAIL);
    let skull = ellipsoid(p, HEAD, DVec3::new(0.375, 0.325, 0.315));
    let cheeks = ellipsoid(
        p,
        DVec3::new(0.10, 0.30, 0.07),
        DVec3::new(0.255, 0.19, 0.235),
    );
    let mut d = blend(skull, cheeks, 0.12);
    d = blend(d, smooth_chain(p, &EAR), 0.09);
    d = blend(d, body, 0.10);
    let mouth = smile(p).max(0.16 - p.z);
    d = carve(d, mouth.max(-d - 0.028), 0.012);
    d.min(hand(p))
}

/// A chain of cones without a waist at each joint.
fn smooth_chain(p: DVec3, spheres: &[(DVec3, f64)]) -> f64 {
    let cones = spheres.windows(2);
    cones.fold(f64::INFINITY, |d, pair| {
        let width = 0.9 * pair[0].1;
        let cone = round_cone(p, pair[0], pair[1]);
        if d.is_finite() {
            blend(d, cone, width)
        } else {
            cone
        }
    })
}

/// Negative inside the mouth as seen from the front: a crescent.
fn smile(p: DVec3) -> f64 {
    let from_below = 0.205 + 1.9 * p.x * p.x - p.y;
    let from_above = p.y - 0.270 - 0.30 * p.x * p.x;
    from_below.max(from_above) * 0.8
}

/// The left glove.
fn hand(p: DVec3) -> f64 {
    let rough = p.distance(PALM) - 0.34;
    if rough > 0.08 {
        return rough;
    }
    let [thumb, back, along] = hand_axes();
    let q = p - PALM;
    let q = DVec3::new(q.dot(thumb), q.dot(back), q.dot(along));
    let mut d = ellipsoid(q, DVec3::ZERO, DVec3::new(0.118, 0.066, 0.122));
    for each in FINGERS {
        d = blend(d, chain(p, &finger(each)), 0.028);
    }
    // A cuff with a rounded rim.
    let rim = ellipsoid(
        q,
        DVec3::new(0.0, 0.0, -0.098),
        DVec3::new(0.094, 0.070, 0.034),
    );
    blend(d, rim, 0.012)
}

fn size(p: DVec3) -> f64 {
    if p.x > 0.56 && p.y < 0.4 {
        return 0.0165;
    }
    let mouth = DVec3::new(0.09, 0.24, 0.29);
    let face = 0.0125 + 0.14 * (p.distance(mouth) - 0.11).max(0.0);
    let tip = 0.012 + 0.10 * p.distance(TAIL[6].0);
    let ear = 0.020 + 0.16 * (p.distance(DVec3::new(0.40, 0.82, 0.0)) - 0.14).max(0.0);
    0.036f64.min(face).min(tip).min(ear)
}

/// The bone whose line is nearest, among those of the same piece.
fn owner(bones: &[Bone], p: DVec3) -> usize {
    let is_hand = |bone: &Bone| {
        ["hand", "index", "middle", "little", "thumb"]
            .iter()
            .any(|part| bone.name.contains(part))
    };
    let at_hand = p.x.abs() > 0.55 && hand(DVec3::new(p.x.abs(), p.y, p.z)) < 0.02;
    let distance = |bone: &Bone| {
        let axis = bone.tail - bone.head;
        let t = ((p - bone.head).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
        let off = (p - bone.head - axis * t).length();
        match bone.name.as_str() {
            "Head" => off - 0.20,
            "Body" => off - 0.06,
            "Left hand" | "Right hand" => off - 0.03,
            _ => off,
        }
    };
    let candidates = bones.iter().enumerate().filter(|(_, bone)| {
        let other_side = (bone.head.x * p.x) < 0.0;
        is_hand(bone) == at_hand && !other_side && !bone.name.contains("eye")
    });
    candidates
        .min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))
        .map_or(0, |(index, _)| index)
}

fn paint(painted: &mut Painted) {
    // The belly, and the insides of the ears.
    painted.paint(PALE, &|p| {
        let belly = ellipsoid(
            p,
            DVec3::new(0.0, -0.14, 0.26),
            DVec3::new(0.175, 0.245, 0.20),
        );
        let near = DVec3::new(p.x.abs(), p.y, p.z);
        let ear = ellipsoid(
            near,
            DVec3::new(0.335, 0.755, 0.075),
            DVec3::new(0.075, 0.085, 0.085),
        );
        belly.min(ear)
    });
    painted.paint(TIP, &|p| {
        let near = DVec3::new(p.x.abs(), p.y, p.z);
        let ear = 0.125 - (near - EAR[0].0).dot(DVec3::new(0.60, 0.75, -0.2)) + 0.14;
        let tail = p.z + 0.30 - 0.25 * (p.y + 0.85);
        let far_from_ear = if p.y < 0.5 || near.x > 0.6 { 1.0 } else { ear };
        far_from_ear.min(if p.y > -0.3 { 1.0 } else { tail })
    });
    painted.paint(MOUTH, &|p| smile(p).max(0.16 - p.z));
    painted.paint(TONGUE, &|p| {
        let q = DVec3::new(p.x / 0.085, (p.y - 0.200) / 0.036, 0.0);
        ((q.length() - 1.0) * 0.04).max(smile(p)).max(0.16 - p.z)
    });
    painted.paint(GLOVE, &|p| {
        let near = DVec3::new(p.x.abs(), p.y, p.z);
        if near.x > 0.55 && p.y < 0.45 {
            hand(near) - 0.02
        } else {
            1.0
        }
    });
}
