//! The mistake that comes nearest to a mesh that none gives.

use super::diagnosis::ToldMistake;
use super::formula::{Formula, VertexOrder};
use super::not_turned::Lacking;
use super::search::{Alone, Search};
use super::skin::Skinner;
use super::ways::formula;
use crate::steps::Pace;
use serde::Serialize;

/// What the nearest mistake must explain to be named.
const EXPLAINS_MUCH: f64 = 0.5;
/// Share of the vertices that are nearly all.
pub(super) const NEARLY_ALL: f64 = 0.99;

/// A mistake that explains much, but not all.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Nearest {
    /// The mistake.
    pub mistake: ToldMistake,
    /// By which part the mean distance is less than from the exact mesh, or from the middle of the mesh where that is less,
    /// 0 to 1. What shrinks to a point is near to all that shrinks to a point.
    pub explains: f64,
    /// Share of the vertices that agree with the mesh that it gives, 0 to 1.
    pub agrees: f64,
    /// How many do not.
    pub off: usize,
}

impl Nearest {
    /// Whether it gives all vertices but a few.
    pub fn is_nearly_all(&self) -> bool {
        self.agrees >= NEARLY_ALL
    }
}

/// The mistake that gives nearly all vertices, if there is one and the exact formula does not, or else the one that
/// leaves the least, if it explains much.
pub(super) async fn find(
    search: &Search<'_>,
    order: VertexOrder,
    alone: &[Alone],
    pace: &Pace,
) -> Option<Nearest> {
    let exact = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let mut skinner = Skinner::new(search.model, search.pose, &exact);
    let exact = search.nearness(&mut skinner);
    let off = exact.mean.min(search.distance_from_middle());
    let told = |mistake: ToldMistake, mean: f64, vertices: usize| Nearest {
        mistake,
        explains: 1.0 - mean / off,
        agrees: 1.0 - vertices as f64 / search.theirs.len() as f64,
        off: vertices,
    };
    let of = |one: &Alone| {
        let vertices = search.off(&formula(&[one.made]))?;
        let mistake = ToldMistake::new(one.made);
        Some(told(mistake, one.nearness.mean, vertices))
    };
    let most = alone.iter().rev().max_by_key(|one| one.nearness.agreeing)?;
    if most.nearness.agreeing > exact.agreeing
        && let Some(nearest) = of(most).filter(Nearest::is_nearly_all)
    {
        return Some(nearest);
    }
    if order == VertexOrder::File
        && let Some((mistake, mean, vertices)) = joint_not_turned(search, pace).await
    {
        return Some(told(mistake, mean, vertices));
    }
    let best = alone
        .iter()
        .min_by(|a, b| a.nearness.mean.total_cmp(&b.nearness.mean))?;
    of(best).filter(|nearest| nearest.explains >= EXPLAINS_MUCH)
}

/// A joint that, not turned, gives nearly all vertices, and more than the exact formula does, if there is one, with the mean
/// distance that it leaves and how many vertices it does not give.
async fn joint_not_turned(search: &Search<'_>, pace: &Pace) -> Option<(ToldMistake, f64, usize)> {
    let most = ((1.0 - NEARLY_ALL) * search.theirs.len() as f64) as usize;
    let found = Lacking::new(search)?.giving_all_but(most, pace).await?;
    let (.., vertices) = found;
    let exact = search.off(&Formula::default())?;
    (exact > vertices).then_some(found)
}
