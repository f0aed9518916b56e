//! Every mistake by itself, on several characters and poses.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, WRONG, Wrong};
use editor_core::diagnose::{MISTAKES, Verdict};
use glam::Vec3;
use std::collections::BTreeSet;

/// How far apart two meshes are, by the size of the first.
fn apart(exact: &[Vec3], other: &[Vec3]) -> f32 {
    let low = exact.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = exact.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let pairs = exact.iter().zip(other);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max) / low.distance(high)
}

/// Checks that what `wrong` gives is told to be that; returns its name if it gives anything else than
/// what is right.
fn told(figure: &Figure, wrong: &Wrong, digits: usize) -> Option<&'static str> {
    let mut student = RIGHT;
    (wrong.make)(&mut student);
    let theirs = written(&student.skin(figure), digits);
    let found = figure.diagnose(&theirs);
    let exact = RIGHT.skin(figure);
    let id = wrong.id;
    let case = format!("{id} with {digits} digits on {}: {found}", figure.name);
    if exact.len() == theirs.len() {
        let apart = apart(&exact, &theirs);
        // What is lost in rounding cannot be told.
        let is_lost = if digits > 4 {
            apart < 1e-5
        } else {
            apart < 1e-4
        };
        if is_lost {
            assert_eq!(found.verdict, Verdict::Right, "{case}");
            return None;
        }
    }
    assert_eq!(found.verdict, Verdict::Explained, "{case}");
    assert!(named(&found).contains(&vec![id]), "{case}");
    assert!(found.error < 2e-4, "{case}");
    Some(id)
}

#[test]
fn every_mistake_is_told_by_its_name_on_several_characters_and_poses() {
    let mut seen = BTreeSet::new();
    let figures = [("adult", 1), ("adult", 2), ("dog", 3), ("robot", 4)]
        .map(|(name, seed)| Figure::builtin(name, turned(seed)));
    let coarse = [("adult", 5, 2), ("dog", 6, 3)]
        .map(|(name, seed, digits)| Figure::builtin(name, turned(seed)).with_weights_of(digits));
    for figure in figures.into_iter().chain(coarse) {
        for wrong in WRONG {
            seen.extend(told(&figure, wrong, 6));
            seen.extend(told(&figure, wrong, 4));
        }
    }
    let all = MISTAKES.iter().map(|mistake| mistake.id).collect();
    assert_eq!(seen, all, "these make a difference on no character");
}
