//! What is found out about a mesh that no mistakes give in the order of its vertices, alone or by two.

use super::diagnosis::{Diagnosis, NearlyRight, Verdict};
use super::findings::Findings;
use super::formula::VertexOrder;
use super::not_reached::NotReached;
use super::precision::{Coarse, Written};
use super::search::{Alone, Search};
use super::{any_order, nearest, nearly_other_pose, not_reached, other_pose, placed};
use crate::steps::Pace;

/// The diagnosis of the mesh of `search`, which single mistakes are as near to as `alone` says and whose numbers may be
/// `coarse`: what explains all of it, the simplest first, or else what is known of it.
pub(super) async fn find(
    search: &Search<'_>,
    findings: &Findings<'_>,
    (mut alone, coarse): (Vec<Alone>, Option<Coarse>),
    written: &Written,
    pace: &Pace,
) -> Diagnosis {
    let Findings {
        model, order, size, ..
    } = *findings;
    let (pose, tolerance) = (search.pose, findings.tolerance);
    let mut found = findings.diagnosis(Verdict::Unexplained);
    if coarse.is_some_and(|coarse| coarse.may_be_right) {
        return found;
    }
    pace.after(findings.exact.len()).await;
    found.regions = findings.regions();
    if !written.has_outliers {
        let limits = written.limits(size);
        found.findings = findings.of_the_whole(limits);
        if found.findings.is_empty() {
            let placed = placed::find(search, limits, pace).await;
            if !placed.is_empty() {
                return findings.explained(&placed);
            }
        }
    }
    // What is explained whole has nothing that is only near it.
    if !found.findings.is_empty() {
        return found;
    }
    let limits = (tolerance, size);
    let other = other_pose::find(model, pose, order, findings.theirs, limits, pace).await;
    let other = match other {
        Some(other) => Some(other),
        None => nearly_other_pose::find(search, findings, pace).await,
    };
    if let Some(other) = other {
        return findings.of_other_pose(other);
    }
    let mut few_left = None;
    if order == VertexOrder::File {
        for left in not_reached::find(findings) {
            if left.are_few() {
                few_left.get_or_insert(left);
                continue;
            }
            let explained = match left.explained(findings, pose, pace).await {
                None => left.beside_joint(search, findings, pace).await,
                explained => explained,
            };
            if let Some(explained) = explained {
                return explained;
            }
        }
        let reordered = any_order::beside_mistakes(search, pace).await;
        if !reordered.is_empty() {
            return findings.simplest(reordered, pose);
        }
    }
    alone.extend(search.near_whole_program(pace).await);
    found.nearest = nearest::find(search, order, &alone, pace).await;
    // Of a mesh that is off elsewhere, too, what is at rest or at the origin says nothing.
    let is_told = |left: &NotReached| match found.nearly_right() {
        Some(NearlyRight::ButForFew) => left.are_all_off(findings),
        nearly => matches!(nearly, Some(NearlyRight::ButForFewWith(_))),
    };
    found.not_reached = few_left.filter(is_told).map(|left| left.told);
    found
}
