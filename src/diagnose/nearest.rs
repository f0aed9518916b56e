//! The mistake that comes nearest to a mesh that none gives.

use super::diagnosis::ToldMistake;
use super::formula::{Formula, VertexOrder};
use super::model::Model;
use super::not_turned::Lacking;
use super::search::{Alone, Search};
use super::skin::Skinner;
use crate::character::Pose;
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
    model: &Model<'_>,
    pose: &Pose,
    order: VertexOrder,
    alone: &[Alone],
    pace: &Pace,
) -> Option<Nearest> {
    let exact = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let exact = search.nearness(&mut Skinner::new(model, pose, &exact));
    let off = exact.mean.min(search.distance_from_middle());
    let told = |one: &Alone, vertices: usize| {
        let agrees = 1.0 - vertices as f64 / search.theirs.len() as f64;
        Nearest {
            mistake: ToldMistake::new(one.made),
            explains: 1.0 - one.nearness.mean / off,
            agrees,
            off: vertices,
        }
    };
    let most = alone.iter().rev().max_by_key(|one| one.nearness.agreeing)?;
    if most.nearness.agreeing > exact.agreeing
        && let Some(nearest) = search.off(most.made).map(|vertices| told(most, vertices))
        && nearest.is_nearly_all()
    {
        return Some(nearest);
    }
    if order == VertexOrder::File
        && let Some(nearest) = joint_not_turned(search, off, pace).await
    {
        return Some(nearest);
    }
    let best = alone
        .iter()
        .min_by(|a, b| a.nearness.mean.total_cmp(&b.nearness.mean))?;
    let nearest = told(best, search.off(best.made)?);
    (nearest.explains >= EXPLAINS_MUCH).then_some(nearest)
}

/// A joint that, not turned, gives nearly all vertices, and more than the exact formula does, if there is one. The mean distance
/// that it leaves is told as a part of `off`.
async fn joint_not_turned(search: &Search<'_>, off: f64, pace: &Pace) -> Option<Nearest> {
    let all = search.theirs.len();
    let most = ((1.0 - NEARLY_ALL) * all as f64) as usize;
    let (mistake, vertices, mean) = Lacking::new(search)?.giving_all_but(most, pace).await?;
    let mut exact = Skinner::new(search.model, search.pose, &Formula::default());
    let is_off = |it: &usize| search.distance(&mut exact, *it) > search.tolerance;
    let is_nearer = (0..all).filter(is_off).count() > vertices;
    is_nearer.then(|| Nearest {
        mistake,
        explains: 1.0 - mean / off,
        agrees: 1.0 - vertices as f64 / all as f64,
        off: vertices,
    })
}
