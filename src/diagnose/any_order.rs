//! Vertices that are in an order that no importer is known to leave.

use super::formula::VertexOrder;
use super::mistake::{IN_ANY_ORDER, Mistake};
use super::search::{AT_ONCE, Explanation, Search};
use super::ways::{Made, formula, ways, ways_of_whole_program};
use crate::compare::permutation;
use crate::steps::Pace;
use glam::DVec3;

/// The mesh `theirs` as the vertices `at`, within `tolerance` of them, in another order, and the mistake that gives these.
pub(super) fn of(
    (at, theirs): (&[DVec3], &[DVec3]),
    tolerance: f64,
    beside: Option<Made>,
) -> Option<Explanation> {
    let from_places = permutation(at, theirs, tolerance)?;
    let pairs = from_places.iter().zip(theirs);
    let distances = pairs.map(|(&index, theirs)| at[index as usize].distance(*theirs));
    let renumbered = Made {
        mistake: Mistake::find("vertices-renumbered")?,
        reading: &IN_ANY_ORDER,
    };
    Some(Explanation {
        made: beside.into_iter().chain([renumbered]).collect(),
        error: distances.fold(0.0, f64::max),
        how: None,
    })
}

/// Mistakes that give the mesh by themselves, but for the order of its vertices.
pub(super) async fn beside_mistakes(search: &Search<'_>, pace: &Pace) -> Vec<Explanation> {
    // Only few are tried: the middle of all vertices is the same in every order.
    let middle = |places: &[DVec3]| places.iter().sum::<DVec3>() / places.len() as f64;
    let theirs = middle(search.theirs);
    let mut found = Vec::new();
    for made in ways().chain(ways_of_whole_program()) {
        let formula = formula(&[made]);
        if formula.vertex_order != VertexOrder::File {
            continue;
        }
        let Some(mut skinner) = search.skinner(&formula) else {
            continue;
        };
        let mut places = Vec::with_capacity(search.theirs.len());
        for vertex in 0..search.theirs.len() {
            places.push(skinner.place(vertex).at);
            if vertex % AT_ONCE == AT_ONCE - 1 {
                pace.after(AT_ONCE).await;
            }
        }
        if middle(&places).distance(theirs) <= search.tolerance {
            found.extend(of((&places, search.theirs), search.tolerance, Some(made)));
            pace.after(places.len()).await;
        }
    }
    found
}
