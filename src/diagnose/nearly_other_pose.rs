//! Meshes of another pose that are off by less than anybody sees besides.

use super::diagnosis::ToldMistake;
use super::findings::Findings;
use super::formula::{Formula, VertexOrder};
use super::other_pose::{self, OtherPose};
use super::search::Search;
use super::skin::Skinner;
use super::ways::{formula, ways};
use super::{MUCH_NEARER, UNSEEN};
use crate::character::Pose;
use crate::steps::Pace;
use glam::DVec3;

/// Part of the mean distance from the exact mesh that a mistake leaves at most which may be the one besides.
const LEFT: f64 = 0.5;

/// The pose in which the exact formula nearly gives the mesh of `search`, much more nearly than in the given one, with the
/// mistake that moves vertices a little, where that gives all of the rest.
pub(super) async fn find(
    search: &Search<'_>,
    findings: &Findings<'_>,
    pace: &Pace,
) -> Option<OtherPose> {
    let Findings { order, size, .. } = *findings;
    let (model, expected) = (search.model, search.pose);
    let nearly = (UNSEEN * size).min(findings.error() / MUCH_NEARER);
    if nearly <= findings.tolerance {
        return None;
    }
    let posed = async |theirs: &[DVec3], tolerance: f64| {
        other_pose::find(model, expected, order, theirs, (tolerance, size), pace).await
    };
    let near = posed(search.theirs, nearly).await?;
    let exact = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let in_pose = search.in_pose(&near.pose);
    let left = LEFT * in_pose.mean(&exact);
    for made in ways() {
        let mut by = formula(&[made]);
        if by.vertex_order != VertexOrder::File {
            continue;
        }
        by.vertex_order = order;
        if in_pose.mean(&by) > left {
            continue;
        }
        // Without what the mistake moves, which hardly depends on the last digits of the angles.
        let theirs = without_moves(search, &near.pose, [&exact, &by]);
        if let Some(other) = posed(&theirs, findings.tolerance).await {
            return Some(OtherPose {
                besides: Some(ToldMistake::new(made)),
                ..other
            });
        }
    }
    Some(near)
}

/// The vertices of `search` without what the second formula moves them by more than the first in a pose.
fn without_moves(search: &Search<'_>, pose: &Pose, formulas: [&Formula; 2]) -> Vec<DVec3> {
    let [mut exact, mut by] = formulas.map(|it| Skinner::new(search.model, pose, it));
    let all = search.theirs.iter().enumerate();
    all.map(|(index, theirs)| *theirs + exact.place(index).at - by.place(index).at)
        .collect()
}
