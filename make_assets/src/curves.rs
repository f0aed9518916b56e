//! Curves and the surfaces swept from them, as `.swp` files.
use super::text::number;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use std::fmt::Write;

/// A vase: a B-spline profile from the bottom's middle up the outside and down the inside, turned.
pub fn vase() -> String {
    let profile = [
        (0.30, -1.15),
        (0.40, -1.145),
        (0.43, -1.08),
        (0.60, -0.70),
        (0.80, -0.20),
        (0.70, 0.32),
        (0.38, 0.62),
        (0.27, 0.86),
        (0.36, 1.08),
        (0.52, 1.20),
        (0.545, 1.225),
        (0.515, 1.235),
        (0.44, 1.19),
        (0.29, 1.06),
        (0.205, 0.86),
        (0.32, 0.58),
        (0.63, 0.28),
        (0.73, -0.20),
        (0.54, -0.66),
        (0.37, -1.02),
        (0.20, -1.07),
    ];
    turned("vase", 48, "bsp2", 6, &on_axis(-1.15, &profile, -1.07))
}

/// A goblet: a Bézier profile, turned.
pub fn goblet() -> String {
    let profile = [
        (0.0, -1.2),
        (0.25, -1.2),
        (0.50, -1.2),
        (0.62, -1.19),
        (0.68, -1.185),
        (0.66, -1.13),
        (0.58, -1.12),
        (0.25, -1.08),
        (0.07, -1.02),
        (0.07, -0.6),
        (0.07, -0.2),
        (0.11, -0.12),
        (0.25, -0.02),
        (0.55, 0.18),
        (0.66, 0.55),
        (0.52, 1.18),
        (0.51, 1.215),
        (0.487, 1.215),
        (0.48, 1.18),
        (0.61, 0.56),
        (0.50, 0.25),
        (0.22, 0.07),
        (0.12, 0.01),
        (0.05, 0.0),
        (0.0, 0.0),
    ];
    turned(
        "goblet",
        48,
        "bez2",
        8,
        &profile.map(|(x, y)| DVec2::new(x, y)),
    )
}

/// A pawn as it comes from the lathe.
pub fn pawn() -> String {
    let profile = [
        (0.50, -1.20),
        (0.70, -1.20),
        (0.76, -1.18),
        (0.77, -1.08),
        (0.74, -0.98),
        (0.60, -0.92),
        (0.56, -0.90),
        (0.60, -0.82),
        (0.57, -0.74),
        (0.46, -0.66),
        (0.30, -0.40),
        (0.23, 0.00),
        (0.20, 0.28),
        (0.22, 0.32),
        (0.43, 0.34),
        (0.47, 0.39),
        (0.43, 0.44),
        (0.22, 0.47),
        (0.24, 0.50),
        (0.38, 0.62),
        (0.44, 0.82),
        (0.38, 1.03),
        (0.20, 1.20),
    ];
    turned("pawn", 48, "bsp2", 6, &on_axis(-1.20, &profile, 1.23))
}

/// A trefoil knot swept by a circle.
pub fn knot() -> String {
    let at = |t: f64| {
        let (x, y) = (
            t.sin() + 2.0 * (2.0 * t).sin(),
            t.cos() - 2.0 * (2.0 * t).cos(),
        );
        DVec3::new(x, y, -1.15 * (3.0 * t).sin()) * 0.42
    };
    let mut text = String::from("circ tube 20 0.17\n\n");
    space_curve(&mut text, "trefoil", 6, &closed(36, at));
    text + "\ngcyl knot tube trefoil\n"
}

/// The seam of a tennis ball, closed and in no plane, swept by a four-leaved clover.
pub fn seam() -> String {
    let (a, b) = (0.98, 0.32);
    let at = |t: f64| {
        let height = 2.0 * f64::sqrt(a * b) * (2.0 * t).sin();
        DVec3::new(
            a * t.cos() + b * (3.0 * t).cos(),
            height,
            a * t.sin() - b * (3.0 * t).sin(),
        )
    };
    let leaf = |i: usize| {
        let (angle, radius) = (TAU * i as f64 / 16.0, [0.10, 0.19, 0.26, 0.19][i % 4]);
        DVec2::new(angle.cos(), angle.sin()) * radius
    };
    let clover: Vec<DVec2> = (0..16 + 3).map(leaf).collect();
    let mut text = String::new();
    flat_curve(&mut text, "bsp2", "clover", 3, &clover);
    text.push('\n');
    space_curve(&mut text, "line", 6, &closed(32, at));
    text + "\ngcyl seam clover line\n"
}

/// A coil spring: six turns of wire.
pub fn spring() -> String {
    const A_TURN: usize = 12;
    let at = |i: usize| {
        let turns = i as f64 / A_TURN as f64;
        let (sin, cos) = (TAU * turns).sin_cos();
        DVec3::new(0.62 * cos, -1.05 + 0.35 * turns, -0.62 * sin)
    };
    let points: Vec<DVec3> = (0..=6 * A_TURN + 2).map(at).collect();
    let mut text = String::from("circ wire 14 0.09\n\n");
    space_curve(&mut text, "helix", 4, &points);
    text + "\ngcyl spring wire helix\n"
}

/// Control points of a B-spline that starts and ends on the axis, at right angles to it: the
/// profile is carried on, mirrored, past both ends.
fn on_axis(start: f64, profile: &[(f64, f64)], end: f64) -> Vec<DVec2> {
    let mut points = vec![DVec2::new(-profile[0].0, start), DVec2::new(0.0, start)];
    points.extend(profile.iter().map(|&(x, y)| DVec2::new(x, y)));
    let last = profile[profile.len() - 1];
    points.extend([DVec2::new(0.0, end), DVec2::new(-last.0, last.1)]);
    points
}

/// Control points of a closed B-spline: the first three come again at the end.
fn closed(count: usize, at: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..count + 3)
        .map(|i| at(TAU * (i % count) as f64 / count as f64))
        .collect()
}

fn turned(name: &str, around: usize, kind: &str, steps: usize, points: &[DVec2]) -> String {
    let mut text = String::new();
    flat_curve(&mut text, kind, "profile", steps, points);
    let _ = write!(text, "\nsrev {name} {around} profile\n");
    text
}

fn flat_curve(text: &mut String, kind: &str, name: &str, steps: usize, points: &[DVec2]) {
    let _ = writeln!(text, "{kind} {name} {steps} {}", points.len());
    for p in points {
        let _ = writeln!(text, "[{}]", p.to_array().map(|x| number(x, 4)).join(" "));
    }
}

fn space_curve(text: &mut String, name: &str, steps: usize, points: &[DVec3]) {
    let _ = writeln!(text, "bsp3 {name} {steps} {}", points.len());
    for p in points {
        let _ = writeln!(text, "[{}]", p.to_array().map(|x| number(x, 4)).join(" "));
    }
}
