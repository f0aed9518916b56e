//! A gear whose faces are polygons.
use super::Shape;
use glam::DVec3;
use std::f64::consts::TAU;

const TEETH: usize = 16;
/// A tooth and the gap before it: root, flank, tip, flank, as angle in shares of the pitch, and
/// radius.
const TOOTH: [(f64, f64); 7] = [
    (0.0, 0.38),
    (0.18, 0.38),
    (0.26, 0.44),
    (0.36, 0.50),
    (0.64, 0.50),
    (0.74, 0.44),
    (0.82, 0.38),
];

/// A point of the gear: its turn in teeth, its distance from the axis, its height along it.
fn point(turn: f64, radius: f64, z: f64) -> DVec3 {
    let (sin, cos) = (TAU * turn / TEETH as f64).sin_cos();
    DVec3::new(cos * radius, sin * radius, z)
}

/// The toothed outline, drawn in by a little.
fn outline(shape: &mut Shape, drawn_in: f64, z: f64) -> Vec<usize> {
    let teeth = (0..TEETH).flat_map(|t| TOOTH.map(|(share, radius)| (t as f64 + share, radius)));
    teeth
        .map(|(turn, radius)| shape.vertex(point(turn, radius - drawn_in, z)))
        .collect()
}

/// A spur gear with a hub and a bore, its faces polygons of four and six corners.
pub fn gear() -> String {
    let mut shape = Shape::default();
    let (back, low, high, front) = (
        outline(&mut shape, 0.012, -0.09),
        outline(&mut shape, 0.0, -0.078),
        outline(&mut shape, 0.0, 0.078),
        outline(&mut shape, 0.012, 0.09),
    );
    shape.band("", &back, &low);
    shape.band("", &low, &high);
    shape.band("", &high, &front);
    // Toward the middle: rim, web, hub and bore, the same on both sides.
    let steps = [
        (0.31, 0.09),
        (0.295, 0.045),
        (0.165, 0.045),
        (0.15, 0.12),
        (0.10, 0.12),
        (0.09, 0.11),
    ];
    // Their corners lie before the gap, before the tooth and behind it.
    let corners = [0, 1, 6];
    let mut inner = Vec::new();
    for side in [1.0, -1.0] {
        let outer = if side > 0.0 { &front } else { &back };
        let at = |t: usize, corner: usize| outer[(t * TOOTH.len() + corner) % outer.len()];
        let mut rings = vec![Vec::new()];
        for t in 0..TEETH {
            rings[0].extend(corners.map(|corner| at(t, corner)));
            let mut face: Vec<usize> = (1..=6).map(|corner| at(t, corner)).collect();
            if side < 0.0 {
                face.reverse();
            }
            shape.face("", &face);
        }
        for (radius, z) in steps {
            let ring = (0..TEETH).flat_map(|t| corners.map(|corner| t as f64 + TOOTH[corner].0));
            let ring = ring.map(|turn| shape.vertex(point(turn, radius, side * z)));
            rings.push(ring.collect());
        }
        for pair in rings.windows(2) {
            let (a, b) = if side > 0.0 {
                (&pair[0], &pair[1])
            } else {
                (&pair[1], &pair[0])
            };
            shape.band("", a, b);
        }
        inner.push(rings[steps.len()].clone());
    }
    shape.band("", &inner[0], &inner[1]);
    shape.text("Gear: 16 teeth, hub and bore", None)
}
