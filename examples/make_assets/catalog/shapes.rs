//! Shapes to import: a gear of polygons, a cut gem, and a potted plant with materials and normals.
use super::text::number;
use glam::DVec3;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Faces with any number of corners, grouped by material.
#[derive(Default)]
struct Shape {
    positions: Vec<DVec3>,
    /// Material and corners; empty names mean none.
    faces: Vec<(&'static str, Vec<usize>)>,
    smooth: bool,
}

impl Shape {
    fn vertex(&mut self, p: DVec3) -> usize {
        self.positions.push(p);
        self.positions.len() - 1
    }

    fn face(&mut self, material: &'static str, corners: &[usize]) {
        self.faces.push((material, corners.to_vec()));
    }

    /// Quads between two closed rings of equal length; the first runs counter-clockwise seen from
    /// the side that the second lies on.
    fn band(&mut self, material: &'static str, below: &[usize], above: &[usize]) {
        let n = below.len();
        for i in 0..n {
            let j = (i + 1) % n;
            self.face(material, &[below[i], below[j], above[j], above[i]]);
        }
    }

    fn ring(&mut self, n: usize, at: impl Fn(f64) -> DVec3) -> Vec<usize> {
        (0..n)
            .map(|i| self.vertex(at(TAU * i as f64 / n as f64)))
            .collect()
    }

    /// The file's text; `library` names a material file.
    fn text(&self, title: &str, library: Option<&str>) -> String {
        let mut text = format!("# {title}\n");
        if let Some(library) = library {
            let _ = writeln!(text, "mtllib {library}");
        }
        let triple = |p: DVec3, n: usize| p.to_array().map(|c| number(c, n)).join(" ");
        for &p in &self.positions {
            let _ = writeln!(text, "v {}", triple(p, 5));
        }
        if self.smooth {
            for n in self.normals() {
                let _ = writeln!(text, "vn {}", triple(n, 4));
            }
        }
        let mut current = "";
        for (material, corners) in &self.faces {
            if *material != current {
                current = material;
                let _ = writeln!(text, "usemtl {material}");
            }
            text.push('f');
            for corner in corners {
                let i = corner + 1;
                let _ = if self.smooth {
                    write!(text, " {i}//{i}")
                } else {
                    write!(text, " {i}")
                };
            }
            text.push('\n');
        }
        text
    }

    /// Normals of the vertices: the mean of the faces around, by area.
    fn normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (_, corners) in &self.faces {
            let p = |i: usize| self.positions[corners[i]];
            let area: DVec3 = (1..corners.len() - 1)
                .map(|i| (p(i) - p(0)).cross(p(i + 1) - p(0)))
                .sum();
            corners.iter().for_each(|&c| sums[c] += area);
        }
        sums.into_iter().map(|n| n.normalize_or(DVec3::Y)).collect()
    }
}

/// A spur gear with a hub and a bore, its faces polygons of many corners.
pub fn gear() -> String {
    const TEETH: usize = 16;
    let mut shape = Shape::default();
    // A tooth: root, flank, tip, flank, as angle in shares of the pitch and radius.
    let tooth = [
        (0.0, 0.38),
        (0.18, 0.38),
        (0.26, 0.44),
        (0.36, 0.50),
        (0.64, 0.50),
        (0.74, 0.44),
        (0.82, 0.38),
    ];
    let n = TEETH * tooth.len();
    let outline = |scale: f64, z: f64| {
        move |i: usize| {
            let (share, radius) = tooth[i % tooth.len()];
            let angle = TAU * ((i / tooth.len()) as f64 + share) / TEETH as f64;
            DVec3::new(
                angle.cos() * (radius - scale),
                angle.sin() * (radius - scale),
                z,
            )
        }
    };
    let mut rim = |scale: f64, z: f64| -> Vec<usize> {
        let at = outline(scale, z);
        (0..n).map(|i| shape.vertex(at(i))).collect()
    };
    let (back, low, high, front) = (
        rim(0.012, -0.09),
        rim(0.0, -0.078),
        rim(0.0, 0.078),
        rim(0.012, 0.09),
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
        let at = |t: usize, corner: usize| outer[(t * tooth.len() + corner) % n];
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
            let ring = (0..TEETH).flat_map(|t| corners.map(|corner| t as f64 + tooth[corner].0));
            let ring = ring.map(|turn| {
                let angle = TAU * turn / TEETH as f64;
                shape.vertex(DVec3::new(
                    angle.cos() * radius,
                    angle.sin() * radius,
                    side * z,
                ))
            });
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

/// A gem in the round brilliant cut: table, star, bezel and girdle facets above, pavilion below.
pub fn gem() -> String {
    let mut shape = Shape::default();
    let ring = |shape: &mut Shape, radius: f64, y: f64, turn: f64| {
        shape.ring(8, |a| {
            let a = -a + turn * TAU / 8.0;
            DVec3::new(radius * a.cos(), y, radius * a.sin())
        })
    };
    let table = ring(&mut shape, 0.28, 0.20, 0.0);
    let middle = ring(&mut shape, 0.406, 0.133, 0.5);
    let upper: Vec<usize> = shape.ring(16, |a| DVec3::new(0.5 * a.cos(), 0.035, -0.5 * a.sin()));
    let lower: Vec<usize> = shape.ring(16, |a| DVec3::new(0.5 * a.cos(), 0.0, -0.5 * a.sin()));
    let culet = shape.vertex(DVec3::new(0.0, -0.43, 0.0));
    let (cos, fall) = ((TAU / 16.0).cos(), 0.43);
    // The pavilion's lower girdle facets end on the ridges between the mains.
    let ridge = ring(&mut shape, 0.5 * 0.28 / cos, -fall * 0.72, 0.5);
    shape.face("", &table);
    shape.band("", &lower, &upper);
    for i in 0..8 {
        // `middle` runs with a turn of half a step the other way: its i-th lies before table i.
        let (here, next) = (middle[i], middle[(i + 1) % 8]);
        let girdle = |k: usize| upper[k % 16];
        let g = 2 * i;
        shape.face("", &[table[(i + 7) % 8], here, table[i]]);
        shape.face("", &[table[i], here, girdle(g), next]);
        shape.face("", &[here, girdle(g + 15), girdle(g)]);
        shape.face("", &[next, girdle(g), girdle(g + 1)]);
        let low = |k: usize| lower[k % 16];
        shape.face("", &[culet, ridge[(i + 1) % 8], low(g), ridge[i]]);
        shape.face("", &[ridge[i], low(g), low(g + 15)]);
        shape.face("", &[ridge[(i + 1) % 8], low(g + 1), low(g)]);
    }
    shape.text("Gem: round brilliant cut", None)
}

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
