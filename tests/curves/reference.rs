//! Against curves and frames that the course's own program made.

use crate::curves::support::{evaluate, read};
use crate::reference_data::reference;
use editor_core::geometry::{CurvePoint, Normals};
use editor_core::scene::{CurveItemKind, CurveSet};
use glam::Vec3;

const FILES: [&str; 7] = [
    "circles",
    "core",
    "flircle",
    "gentorus",
    "norm",
    "tor",
    "wineglass",
];

fn course_file(path: &str) -> Option<String> {
    let path = reference(&format!("course/{path}"))?;
    Some(std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}")))
}

/// V, T, N and B of each point of each curve.
fn golden(text: &str) -> Vec<Vec<[Vec3; 4]>> {
    let mut curves: Vec<Vec<[Vec3; 4]>> = Vec::new();
    for line in text.lines() {
        if line.starts_with("curve") {
            curves.push(Vec::new());
            continue;
        }
        let numbers: Vec<f32> = line
            .split_whitespace()
            .filter_map(|word| word.parse().ok())
            .collect();
        if numbers.len() == 12 {
            let vector = |i: usize| Vec3::from_slice(&numbers[3 * i..]);
            curves
                .last_mut()
                .unwrap()
                .push([vector(0), vector(1), vector(2), vector(3)]);
        }
    }
    curves
}

fn agrees(ours: &CurvePoint, golden: &[Vec3; 4]) -> bool {
    let frame = ours.frame;
    let ours = [ours.position, frame.tangent, frame.normal, frame.binormal];
    ours.iter()
        .zip(golden)
        .all(|(a, b)| (*a - *b).abs().max_element() < 1e-4)
}

/// Theirs has the point that two pieces share twice, ours once: both of its copies are held
/// against our one.
fn compare(name: &str, ours: &[CurvePoint], theirs: &[[Vec3; 4]]) {
    let mut next = 0;
    for (index, golden) in theirs.iter().enumerate() {
        if ours.get(next).is_some_and(|point| agrees(point, golden)) {
            next += 1;
            continue;
        }
        if name == "wineglass" && index + 1 == theirs.len() {
            // The last control points lie a millionth apart on the axis, so the tangent is
            // straight down; rounding turned theirs by 2.7°.
            let ours = ours[next];
            assert!(ours.position.distance(golden[0]) < 1e-6);
            assert_eq!(ours.frame.tangent, -Vec3::Y);
            assert!(ours.frame.tangent.distance(golden[1]) < 0.05);
            next += 1;
            continue;
        }
        let repeated = index > 0 && theirs[index - 1][0].distance(golden[0]) < 1e-5;
        assert!(
            repeated && agrees(&ours[next - 1], golden),
            "{name}: point {index} is {golden:?}, ours {:?}",
            ours.get(next)
        );
    }
    assert_eq!(next, ours.len(), "{name}: we have more points");
}

fn sets() -> Vec<(&'static str, CurveSet)> {
    FILES
        .iter()
        .filter_map(|&name| {
            let text = course_file(&format!("swp/{name}.swp"))?;
            Some((name, read(&text).unwrap()))
        })
        .collect()
}

#[test]
fn points_and_frames_are_those_of_the_course_whether_frames_are_closed_or_not() {
    for (name, set) in sets() {
        let golden = golden(&course_file(&format!("curves/{name}.curves.txt")).unwrap());
        for closing in [true, false] {
            let evaluated = evaluate(set.clone(), closing);
            let curves = &evaluated.curves.as_ref().unwrap().curves;
            assert_eq!(curves.len(), golden.len(), "{name}");
            for (curve, golden) in curves.iter().zip(&golden) {
                compare(name, &curve.points, golden);
            }
        }
    }
}

#[test]
fn surfaces_of_the_course_keep_the_side_that_their_profile_gives_them() {
    for (name, set) in sets() {
        let evaluated = evaluate(set.clone(), true);
        let curves = evaluated.curves.as_ref().unwrap();
        let points = |item| {
            let curve = curves.curves.iter().find(|curve| curve.item == item);
            &curve.unwrap().points
        };
        for surface in &curves.surfaces {
            let Normals::PerVertex(normals) = &evaluated.mesh.normals else {
                panic!("{name} has no normals");
            };
            let (profile, right, up) = match set.items()[surface.item].kind {
                CurveItemKind::Curve(_) => panic!("{name}: a curve is no surface"),
                CurveItemKind::Revolution { profile, .. } => (profile, Vec3::X, Vec3::Y),
                CurveItemKind::Sweep { profile, sweep } => {
                    let frame = points(sweep)[0].frame;
                    (profile, frame.normal, frame.binormal)
                }
            };
            for (point, normal) in points(profile).iter().zip(normals) {
                let flat = -point.frame.normal;
                assert!(
                    normal.distance(right * flat.x + up * flat.y) < 1e-5,
                    "{name}"
                );
            }
        }
    }
}
