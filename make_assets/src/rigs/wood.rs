//! The picture on the crate, drawn by arithmetic: on the left a framed side with a stencil, on
//! the right bare planks.
use super::super::field::smooth_step;
use super::png::Indexed;
use glam::{DVec2, DVec3};

/// Pixels along the edge of a side, and across the strip of planks beside it.
const EDGE: usize = 400;
const STRIP: usize = 112;
/// Shades of each color of the palette.
const SHADES: usize = 48;
/// Dark and light ends: planks, frame, iron, paint.
const RAMPS: [[[f64; 3]; 2]; 4] = [
    [[0.16, 0.09, 0.05], [0.80, 0.58, 0.36]],
    [[0.22, 0.13, 0.07], [0.93, 0.73, 0.48]],
    [[0.10, 0.10, 0.11], [0.62, 0.62, 0.64]],
    [[0.06, 0.12, 0.16], [0.20, 0.36, 0.42]],
];
/// Planks from the bottom to the top.
const PLANKS: f64 = 5.0;
/// The share of a side that its frame takes at each edge.
const FRAME: f64 = 0.135;

/// A part of the picture.
#[derive(Clone, Copy)]
pub enum Part {
    Side,
    Planks,
}

impl Part {
    /// Where a place on the cube, of half the edge `half`, lies in the picture, (0, 0) at the
    /// lower left. `out` is the direction that its face looks in.
    pub fn place(self, p: DVec3, out: DVec3, half: f64) -> DVec2 {
        let q = p / (2.0 * half) + DVec3::splat(0.5);
        let axis = out.abs();
        let on_face = if axis.y > 0.5 {
            DVec2::new(q.x, 1.0 - q.z)
        } else if axis.x > 0.5 {
            DVec2::new(if out.x > 0.0 { 1.0 - q.z } else { q.z }, q.y)
        } else {
            DVec2::new(if out.z > 0.0 { q.x } else { 1.0 - q.x }, q.y)
        };
        let width = (EDGE + STRIP) as f64;
        let pixel = match self {
            Self::Side => on_face.x * EDGE as f64,
            Self::Planks => EDGE as f64 + 4.0 + on_face.x * (STRIP as f64 - 8.0),
        };
        DVec2::new(pixel / width, on_face.y)
    }
}

/// The whole picture as a file.
pub fn png() -> Vec<u8> {
    let width = EDGE + STRIP;
    let mut palette = Vec::new();
    for [dark, light] in RAMPS {
        for shade in 0..SHADES {
            let t = shade as f64 / (SHADES - 1) as f64;
            let mix = |i: usize| dark[i] + (light[i] - dark[i]) * t;
            palette.push([0, 1, 2].map(|i| (mix(i) * 255.0).round() as u8));
        }
    }
    let mut pixels = Vec::new();
    for row in 0..EDGE {
        for column in 0..width {
            let x = (column as f64 + 0.5) / EDGE as f64;
            let y = 1.0 - (row as f64 + 0.5) / EDGE as f64;
            let (ramp, light) = if column < EDGE {
                side(x, y)
            } else {
                planks(x, y)
            };
            let grit = noise(column as f64 * 1.7, row as f64 * 1.7, 91) - 0.5;
            let shade = (light + 0.03 * grit).clamp(0.0, 1.0) * (SHADES - 1) as f64;
            pixels.push((ramp * SHADES + shade.round() as usize) as u8);
        }
    }
    Indexed {
        width,
        palette,
        pixels,
    }
    .png()
}

/// The color of a side: which ramp, and how light.
fn side(x: f64, y: f64) -> (usize, f64) {
    let edge = x.min(1.0 - x).min(y.min(1.0 - y));
    // Stiles run from bottom to top, the rails fit between them.
    let in_stile = x.min(1.0 - x) < FRAME;
    if in_stile || y.min(1.0 - y) < FRAME {
        return frame(x, y, in_stile, edge);
    }
    let (ramp, light) = planks(x, y);
    let depth = x.min(1.0 - x).min(y.min(1.0 - y)) - FRAME;
    // The frame stands out and shades what lies below it and to its right.
    let shaded = (x - FRAME).min(1.0 - FRAME - y);
    let shade = 0.20 * (1.0 - smooth_step(0.0, 0.022, shaded))
        + 0.09 * (1.0 - smooth_step(0.0, 0.03, depth));
    let worn = noise(x * 60.0, y * 60.0, 7) + 0.5 * noise(x * 170.0, y * 170.0, 8);
    if stencil(x, y) > 0.0 && worn > 0.36 {
        return (3, (light - shade) * 1.1);
    }
    (ramp, light - shade)
}

fn frame(x: f64, y: f64, in_stile: bool, edge: f64) -> (usize, f64) {
    let (along, across) = if in_stile { (y, x) } else { (x, y) };
    let light = 0.60 + grain(along, across, 40 + u32::from(in_stile)) - bevel(edge, 0.010);
    let inner = FRAME - across.min(1.0 - across);
    let joint = if in_stile {
        f64::INFINITY
    } else {
        x.min(1.0 - x) - FRAME
    };
    let light = light - bevel(inner, 0.007) - bevel(joint, 0.007);
    // A nail in each corner and one in the middle of each piece.
    let near = |at: f64| [0.5 * FRAME, 0.5, 1.0 - 0.5 * FRAME].map(|c| (at - c).abs());
    let nearest = |all: [f64; 3]| all[0].min(all[1]).min(all[2]);
    let from_nail = DVec2::new(nearest(near(x)), nearest(near(y))).length();
    if from_nail < 0.013 {
        let shine = noise(x * 90.0, y * 90.0, 3) * 0.3 + 0.55 - 22.0 * from_nail;
        return (2, shine);
    }
    (
        1,
        light - 0.22 * (1.0 - smooth_step(0.013, 0.022, from_nail)),
    )
}

/// Bare planks.
fn planks(x: f64, y: f64) -> (usize, f64) {
    let row = (y * PLANKS).floor();
    let within = y * PLANKS - row;
    let gap = within.min(1.0 - within) / PLANKS;
    let tone = 0.12 * (noise(row * 3.3, 0.5, 21) - 0.5);
    let light = 0.56 + tone + grain(x + 0.37 * row, within / PLANKS, 60 + row as u32);
    (0, light - 2.6 * bevel(gap, 0.006))
}

/// Darker toward an edge.
fn bevel(from_edge: f64, width: f64) -> f64 {
    0.24 * (1.0 - smooth_step(0.0, width, from_edge))
}

/// The lines of wood that grows `along`.
fn grain(along: f64, across: f64, seed: u32) -> f64 {
    let bend =
        noise(along * 3.0, across * 9.0, seed) + 0.5 * noise(along * 7.0, across * 20.0, seed);
    let rings = (across * 95.0 + bend * 9.0).sin();
    let fine = noise(along * 9.0, across * 210.0, seed + 1) - 0.5;
    0.075 * rings + 0.16 * fine + 0.10 * (bend - 0.75)
}

/// Positive inside the painted sign: two arrows up on a bar.
fn stencil(x: f64, y: f64) -> f64 {
    let bar = (0.20 - (x - 0.5).abs()).min(0.017 - (y - 0.285).abs());
    let from = ((x - 0.5).abs() - 0.105).abs();
    let shaft = (0.026 - from).min(0.135 - (y - 0.475).abs());
    let head = (0.72 - y) * 0.56 - from;
    let head = head.min(y - 0.585);
    bar.max(shaft).max(head)
}

/// Smooth noise in 0..1.
fn noise(x: f64, y: f64, seed: u32) -> f64 {
    let (column, row) = (x.floor(), y.floor());
    let (s, t) = (
        smooth_step(0.0, 1.0, x - column),
        smooth_step(0.0, 1.0, y - row),
    );
    let at = |dx: f64, dy: f64| hash((column + dx) as i64, (row + dy) as i64, seed);
    let low = at(0.0, 0.0) + (at(1.0, 0.0) - at(0.0, 0.0)) * s;
    let high = at(0.0, 1.0) + (at(1.0, 1.0) - at(0.0, 1.0)) * s;
    low + (high - low) * t
}

/// A number in 0..1 that looks random.
fn hash(x: i64, y: i64, seed: u32) -> f64 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    h ^= seed.wrapping_mul(0xc2b2_ae3d);
    for _ in 0..2 {
        h ^= h >> 15;
        h = h.wrapping_mul(0x2c1b_3c6d);
        h ^= h >> 12;
        h = h.wrapping_mul(0x297a_2d39);
    }
    f64::from(h ^ h >> 15) / f64::from(u32::MAX)
}
