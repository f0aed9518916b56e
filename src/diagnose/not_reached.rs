//! Vertices that a program's loop does not come to.

use super::findings::Findings;
use super::found_otherwise::VERTICES_NOT_REACHED;
use super::nearest::NEARLY_ALL;
use super::search::Explanation;
use super::ways::Made;
use std::ops::Range;

/// That the vertices from one on, or those before one, are where they were, if the others are right. Where these are nearly
/// all, it is told otherwise that the mesh is nearly right.
pub(super) fn find(findings: &Findings<'_>) -> Option<Explanation> {
    let off = |index: &usize| findings.is_off(*index);
    let all = 0..findings.theirs.len();
    let (first, last) = (all.clone().find(off)?, all.clone().rfind(off)?);
    let end = last + 1;
    let ends = [
        (first..all.end, format!("those from {first} on")),
        (0..end, format!("those before {end}")),
    ];
    let are_few = |left: &Range<usize>| left.len() as f64 <= (1.0 - NEARLY_ALL) * all.len() as f64;
    let mut ends = ends.into_iter().filter(|(left, _)| !are_few(left));
    ends.find_map(|(left, which)| {
        let is_reached = |index: &usize| !left.contains(index);
        let reached = all
            .clone()
            .filter(is_reached)
            .map(|index| findings.distances[index]);
        let theirs = |index: usize| findings.theirs[index];
        let from_rest = |index| theirs(index).distance(findings.at_rest(index));
        let from_origin = |index| theirs(index).length();
        let largest =
            |distance: &dyn Fn(usize) -> f64| left.clone().map(distance).fold(0.0, f64::max);
        let mut places = [
            (largest(&from_rest), "at rest"),
            (largest(&from_origin), "at the origin"),
        ]
        .into_iter();
        let (error, place) = places.find(|(error, _)| *error <= findings.tolerance)?;
        Some(Explanation {
            made: vec![Made::by_numbers(&VERTICES_NOT_REACHED)],
            error: reached.fold(error, f64::max),
            how: Some(format!("{which}, counted from 0, are {place}")),
        })
    })
}
