//! A potted plant with materials and smooth normals.
use super::Shape;
use glam::DVec3;
use std::f64::consts::TAU;
use std::fmt::Write;

/// A plant in a pot: four materials, smooth normals.
pub fn plant() -> String {
    let mut shape = Shape {
        smooth: true,
        ..Shape::default()
    };
    pot(&mut shape);
    let stems: [(f64, f64, f64); 9] = [
        (0.0, 0.10, 1.00),
        (0.70, 0.32, 0.86),
        (1.45, 0.20, 0.96),
        (2.10, 0.38, 0.80),
        (2.85, 0.24, 0.92),
        (3.50, 0.36, 0.84),
        (4.20, 0.18, 1.00),
        (4.95, 0.40, 0.78),
        (5.60, 0.26, 0.90),
    ];
    for (turn, lean, size) in stems {
        leaf(&mut shape, turn, lean, size);
    }
    shape.text(
        "Potted plant: terracotta, soil, stems and leaves",
        Some("plant.mtl"),
    )
}

/// The materials of the plant.
pub fn plant_materials() -> String {
    let mut text = String::from("# Materials of plant.obj\n");
    for (name, color, shine) in [
        ("terracotta", "0.72 0.34 0.2", "0.15 0.15 0.15"),
        ("soil", "0.2 0.13 0.09", "0 0 0"),
        ("stem", "0.3 0.42 0.15", "0.1 0.1 0.1"),
        ("leaf", "0.2 0.52 0.2", "0.3 0.3 0.3"),
    ] {
        let _ = writeln!(text, "\nnewmtl {name}\nKd {color}\nKs {shine}\nNs 32");
    }
    text
}

fn pot(shape: &mut Shape) {
    const SIDES: usize = 32;
    // Outside from the bottom's rim up, over the lip and down to the soil. A doubled ring makes
    // a crease, since each of its two carries a normal of its own.
    let outside = [
        (0.185, -0.50),
        (0.200, -0.50),
        (0.207, -0.492),
        (0.268, -0.165),
        (0.270, -0.16),
    ];
    let lip = [
        (0.272, -0.165),
        (0.302, -0.165),
        (0.308, -0.158),
        (0.308, -0.052),
        (0.300, -0.045),
        (0.268, -0.045),
        (0.262, -0.051),
        (0.258, -0.085),
    ];
    let soil = [(0.258, -0.085), (0.17, -0.070), (0.06, -0.062)];
    let mut lathe = |profile: &[(f64, f64)], material: &'static str| {
        let rings: Vec<Vec<usize>> = profile
            .iter()
            .map(|&(r, y)| shape.ring(SIDES, |a| DVec3::new(r * a.sin(), y, r * a.cos())))
            .collect();
        for pair in rings.windows(2) {
            shape.band(material, &pair[0], &pair[1]);
        }
        rings
    };
    let walls = lathe(&outside, "terracotta");
    lathe(&lip, "terracotta");
    let earth = lathe(&soil, "soil");
    let bottom: Vec<usize> = walls[0].iter().rev().copied().collect();
    shape.face("terracotta", &bottom);
    shape.face("soil", &earth[2].clone());
}

/// A stem and its leaf, that leans out and droops, folded along its rib; `turn` in radians.
fn leaf(shape: &mut Shape, turn: f64, lean: f64, size: f64) {
    const ROWS: usize = 14;
    let (sin, cos) = turn.sin_cos();
    let (out, side) = (DVec3::new(sin, 0.0, cos), DVec3::new(cos, 0.0, -sin));
    let start = out * 0.05 - DVec3::Y * 0.07;
    // The line of the rib: up, out, and over.
    let rib = |t: f64| {
        let reach = lean * (0.5 * t + 0.9 * t * t);
        start + out * reach * size + DVec3::Y * size * (0.66 * t - lean * 0.75 * t * t * t)
    };
    let ahead = |t: f64| (rib(t + 0.01) - rib(t - 0.01)).normalize_or(DVec3::Y);
    let stem: Vec<Vec<usize>> = (0..=6)
        .map(|i| {
            let t = 0.5 * f64::from(i) / 6.0;
            let normal = side.cross(ahead(t));
            let radius = 0.013 - 0.014 * t;
            shape.ring(8, |a| rib(t) + (side * a.cos() - normal * a.sin()) * radius)
        })
        .collect();
    for pair in stem.windows(2) {
        shape.band("stem", &pair[0], &pair[1]);
    }
    // The blade has a face of its own on either side, so that both are lit.
    for upper in [true, false] {
        let mut rows: Vec<Vec<usize>> = Vec::new();
        for i in 0..=ROWS {
            let s = i as f64 / ROWS as f64;
            let t = 0.34 + 0.66 * s;
            let width = 0.115 * size * (TAU / 2.0 * s.powf(0.75)).sin().max(0.0).powf(0.8) + 0.0008;
            let normal = side.cross(ahead(t));
            let row = [-1.0, -0.6, 0.0, 0.6, 1.0].map(|k: f64| {
                let lift =
                    0.34 * k.abs() - 0.16 * k * k + 0.03 * (9.0 * s + 2.0 * k).sin() * k.abs();
                let thick = if upper { 0.0012 } else { -0.0012 };
                shape.vertex(rib(t) + side * k * width - normal * (lift * width + thick))
            });
            rows.push(row.to_vec());
        }
        for pair in rows.windows(2) {
            for k in 0..4 {
                let (a, b, c, d) = (pair[0][k], pair[0][k + 1], pair[1][k + 1], pair[1][k]);
                let corners = if upper { [b, a, d, c] } else { [a, b, c, d] };
                shape.face("leaf", &corners);
            }
        }
    }
}
