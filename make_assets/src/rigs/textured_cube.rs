//! A crate: a cube with a picture on it, and a lid to open.
use super::model::{Face, Material, Rig, Skin};
use super::wood;
use glam::{DVec2, DVec3};

/// The cube reaches this far to all sides.
const HALF: f64 = 0.7;
const WALL: f64 = 0.075;
/// Where the lid begins: at the edge of the frame in the picture.
const SEAM: f64 = 0.511;

pub fn rig() -> Rig {
    let mut rig = Rig::new(
        "Crate",
        vec![Material {
            name: "Wood",
            color: [1.0; 3],
            texture: Some("crate.png"),
        }],
    );
    let box_bone = rig.bone("Box", None, DVec3::Y * -HALF, DVec3::Y * SEAM);
    let hinge = DVec3::new(0.0, SEAM, -HALF);
    let front = DVec3::new(0.0, SEAM, HALF);
    let lid = rig.bone("Lid", Some(box_bone), hinge, front);
    let mut skin = Skin::new("Crate boards");
    let (low, high) = (DVec3::splat(-HALF), DVec3::splat(HALF));
    hollow(&mut skin, low, DVec3::new(HALF, SEAM, HALF), 1.0, box_bone);
    hollow(&mut skin, DVec3::new(-HALF, SEAM, -HALF), high, -1.0, lid);
    rig.skins.push(skin);
    rig
}

/// A box without its top, or, turned over (`up` = −1), without its bottom.
fn hollow(skin: &mut Skin, low: DVec3, high: DVec3, up: f64, bone: usize) {
    let inset = DVec3::new(WALL, 0.0, WALL);
    let lift = DVec3::Y * WALL * up;
    let [floor, rim] = if up > 0.0 {
        [low.y, high.y]
    } else {
        [high.y, low.y]
    };
    let at = |y: f64| move |p: DVec3| DVec3::new(p.x, y, p.z);
    let square = |low: DVec3, high: DVec3| {
        let corner = |x: f64, z: f64| DVec3::new(x, 0.0, z);
        [
            corner(low.x, high.z),
            corner(high.x, high.z),
            corner(high.x, low.z),
            corner(low.x, low.z),
        ]
    };
    let (outer, inner) = (square(low, high), square(low + inset, high - inset));
    let mut quad = |corners: [DVec3; 4], part: wood::Part| {
        let picture = corners.map(|p| part.place(p, normal(corners, up), HALF));
        add_quad(skin, corners, picture, up, bone);
    };
    for side in 0..4 {
        let next = (side + 1) % 4;
        let wall = |ring: &[DVec3; 4], y0: f64, y1: f64| {
            [
                at(y0)(ring[side]),
                at(y0)(ring[next]),
                at(y1)(ring[next]),
                at(y1)(ring[side]),
            ]
        };
        quad(wall(&outer, floor, rim), wood::Part::Side);
        let [a, b, c, d] = wall(&inner, floor + lift.y, rim);
        quad([b, a, d, c], wood::Part::Planks);
        let edge = [at(rim)(outer[side]), at(rim)(outer[next])];
        quad(
            [edge[0], edge[1], at(rim)(inner[next]), at(rim)(inner[side])],
            wood::Part::Planks,
        );
    }
    let [a, b, c, d] = outer.map(at(floor));
    quad([d, c, b, a], wood::Part::Side);
    quad(inner.map(at(floor + lift.y)), wood::Part::Planks);
}

/// Out of a quad whose corners are counter-clockwise if `up` is 1, clockwise if it is −1.
fn normal(corners: [DVec3; 4], up: f64) -> DVec3 {
    let [a, b, _, d] = corners;
    (b - a).cross(d - a).normalize_or(DVec3::Y) * up
}

fn add_quad(skin: &mut Skin, corners: [DVec3; 4], picture: [DVec2; 4], up: f64, bone: usize) {
    let base = skin.positions.len() as u32;
    skin.positions.extend(corners);
    skin.weights.extend((0..4).map(|_| vec![(bone, 1.0)]));
    for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
        let [a, b, c] = if up > 0.0 { [a, b, c] } else { [a, c, b] };
        skin.faces.push(Face {
            corners: [a, b, c].map(|i| base + i as u32),
            material: 0,
            picture: Some([a, b, c].map(|i| picture[i])),
        });
    }
}
