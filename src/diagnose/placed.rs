//! A mistake in skinning beside which the mesh is moved or scaled as a whole, or has other axes.

use super::formula::Formula;
use super::found_otherwise::MOVED_AS_A_WHOLE;
use super::search::{Explanation, Search};
use super::skin::{Placed, Skinner};
use super::ways::{Made, formula, ways, ways_of_whole_program};
use crate::compare::{MeshFinding, placement};
use crate::steps::Pace;
use glam::DVec3;

/// How far a vertex may be from where it is placed and agree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// In the size before.
    pub(super) tolerance: f64,
    /// What rounding moves a vertex by, in the size after, …
    pub(super) rounding: f64,
    /// … as far as it is no more than this in the size before.
    pub(super) most: f64,
}

impl Limits {
    /// How far `theirs` are at most from the places before, in the size before, if all agree where they are `placed`.
    pub(super) fn error(
        self,
        placed: &MeshFinding,
        mut before: impl FnMut(usize) -> DVec3,
        theirs: &[DVec3],
    ) -> Option<f64> {
        let mut largest = 0.0_f64;
        for (vertex, theirs) in theirs.iter().enumerate() {
            let (at, factor) = placed.placed(before(vertex))?;
            let distance = at.distance(*theirs) / factor;
            let rounded = (self.rounding / factor).min(self.most);
            if distance.is_nan() || distance > self.tolerance.max(rounded) {
                return None;
            }
            largest = largest.max(distance);
        }
        Some(largest)
    }
}

/// Mistakes that give the mesh of `search` by themselves, but for where it is, its size and its axes. General turns are
/// not sought: one that is not about an axis by a right angle is another pose of the root.
pub(super) async fn find(search: &Search<'_>, limits: Limits, pace: &Pace) -> Vec<Explanation> {
    let sampled = |skinner: &mut Skinner<'_>| -> Vec<Placed> {
        let sample = search.sample.iter();
        sample.map(|&vertex| skinner.place(vertex)).collect()
    };
    let sample = search.sample.iter();
    let theirs: Vec<DVec3> = sample.map(|&vertex| search.theirs[vertex]).collect();
    let exact = search.skinner(&Formula::default());
    let exact = exact.map(|mut skinner| sampled(&mut skinner));
    // A mistake that does nothing else is not one besides.
    let only_places = |mistaken: &[Placed]| {
        let pairs = exact.iter().flatten().zip(mistaken);
        let weighted = pairs.filter(|(exact, _)| !exact.is_unweighted);
        let (exact, mistaken): (Vec<DVec3>, Vec<DVec3>) = weighted
            .map(|(exact, mistaken)| (exact.at, mistaken.at))
            .unzip();
        placement(&exact, &mistaken, search.tolerance).is_some()
    };
    let mut found = Vec::new();
    for made in ways().chain(ways_of_whole_program()) {
        let Some(mut skinner) = search.skinner(&formula(&[made])) else {
            continue;
        };
        let mistaken = sampled(&mut skinner);
        pace.after(mistaken.len()).await;
        let places: Vec<DVec3> = mistaken.iter().map(|placed| placed.at).collect();
        let Some(placed) = placement(&places, &theirs, search.tolerance) else {
            continue;
        };
        if only_places(&mistaken) {
            continue;
        }
        pace.after(search.theirs.len()).await;
        if let Some(error) = limits.error(&placed, |vertex| skinner.place(vertex).at, search.theirs)
        {
            found.push(Explanation {
                made: vec![made, Made::by_numbers(&MOVED_AS_A_WHOLE)],
                error,
                how: placed.how(),
            });
        }
    }
    found
}
