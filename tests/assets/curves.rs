//! The swept curves: well-formed, and fit to be turned or swept.
use crate::assets::surface::float;
use crate::assets::{asset, paths};
use std::collections::HashMap;

/// Curves by name (control points, or none for a circle) and the names that surfaces use.
type Parsed = (HashMap<String, Vec<Vec<f64>>>, Vec<String>);

fn parse(path: &str) -> Parsed {
    let text = asset(path).replace(['[', ']'], " ");
    let mut words = text.split_whitespace();
    let mut next = || words.next().unwrap_or_default().to_owned();
    let (mut curves, mut used) = (HashMap::new(), Vec::new());
    loop {
        let kind = next();
        match kind.as_str() {
            "" => return (curves, used),
            "circ" => {
                let name = next();
                assert!(
                    float(&next()) >= 3.0 && float(&next()) > 0.0,
                    "{path}: {name}"
                );
                curves.insert(name, Vec::new());
            }
            "bsp2" | "bsp3" | "bez2" | "bez3" => {
                let name = next();
                assert!(float(&next()) >= 1.0, "{path}: steps of {name}");
                let (count, size) = (
                    float(&next()) as usize,
                    if kind.ends_with('3') { 3 } else { 2 },
                );
                assert!(
                    count >= 4 && (kind.starts_with("bsp") || count % 3 == 1),
                    "{path}: {name}"
                );
                let points: Vec<Vec<f64>> = (0..count)
                    .map(|_| (0..size).map(|_| float(&next())).collect())
                    .collect();
                assert!(
                    points.iter().flatten().all(|x| x.abs() < 2.0),
                    "{path}: {name}"
                );
                curves.insert(name, points);
            }
            "srev" | "gcyl" => {
                next();
                let first = if kind == "srev" { float(&next()) } else { 3.0 };
                assert!(first >= 3.0, "{path}: steps around");
                used.extend((0..if kind == "srev" { 1 } else { 2 }).map(|_| next()));
            }
            other => panic!("{path}: {other}"),
        }
    }
}

#[test]
fn every_surface_uses_curves_of_its_file() {
    assert!(paths("curves").count() >= 6);
    for path in paths("curves") {
        let (curves, used) = parse(&path);
        assert!(!used.is_empty(), "{path}");
        assert!(
            used.iter().all(|name| curves.contains_key(name)),
            "{path}: {used:?}"
        );
    }
}

#[test]
fn no_control_point_comes_twice_in_a_row() {
    for path in paths("curves") {
        for points in parse(&path).0.values() {
            assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "{path}");
        }
    }
}

#[test]
fn turned_profiles_start_and_end_on_the_axis() {
    for name in ["vase", "goblet", "pawn"] {
        let (curves, _) = parse(&format!("curves/{name}.swp"));
        let points = &curves["profile"];
        let last = points.len() - 1;
        // A B-spline passes the middle of three points whose outer two mirror each other.
        let (start, end) = if name == "goblet" {
            (0, last)
        } else {
            (1, last - 1)
        };
        assert!(points[start][0] == 0.0 && points[end][0] == 0.0, "{name}");
    }
}

#[test]
fn closed_sweeps_repeat_their_first_three_points() {
    for (file, curve) in [("knot", "trefoil"), ("seam", "line"), ("seam", "clover")] {
        let (curves, _) = parse(&format!("curves/{file}.swp"));
        let points = &curves[curve];
        assert_eq!(points[..3], points[points.len() - 3..], "{file}: {curve}");
    }
}
