//! The fewest joints by whose angles alone a mesh is explained.

use super::fit::{Fit, Posed};
use crate::steps::Pace;

/// Joints of which more are not sought one by one.
const MOST: usize = 8;
/// Fits that are tried at most to put joints back.
const MOST_TRIES: usize = 16;

/// A fit of fewer than `fewer_than` joints, from the expected pose on, that `agrees` with the mesh, if one is
/// found: the joint that promises most is set free, then the one that promises most of what is left, and those that
/// proved to be needless are put back. The vertices that a joint moves by itself may be few, and its children can make
/// up for it: a fit of all joints at once has all of them turned.
pub(super) async fn fewest(
    fit: &Fit<'_>,
    tolerance: f64,
    fewer_than: usize,
    agrees: impl Fn(&Posed) -> bool,
    pace: &Pace,
) -> Option<Posed> {
    let mut free: Vec<usize> = Vec::new();
    let mut found = None;
    let mut so_far = fit.expected();
    while found.is_none() && free.len() + 1 < fewer_than.min(MOST + 1) {
        free.push(fit.most_promising(&so_far, &free)?);
        so_far = fit.of(&free, so_far).improve(tolerance, pace).await;
        found = Some(so_far.clone()).filter(&agrees);
    }
    let mut found = found?;
    for joint in free.clone() {
        let others: Vec<usize> = free
            .iter()
            .copied()
            .filter(|&other| other != joint)
            .collect();
        if others.is_empty() {
            break;
        }
        let without = fit
            .of(&others, fit.expected())
            .improve(tolerance, pace)
            .await;
        if agrees(&without) {
            (free, found) = (others, without);
        }
    }
    Some(found)
}

/// A fit like `posed`, which agrees with the mesh, in which fewer of the joints `turned` differ from the expected pose,
/// if one is found. These are given from the one that differs least on: what one joint is turned too far its children
/// can make up for, so that a fit of all of them has small turns that none of them needs. They are put back by halves,
/// then by quarters and so on.
pub(super) async fn with_small_turns_put_back(
    fit: &Fit<'_>,
    tolerance: f64,
    (posed, turned): (&Posed, Vec<usize>),
    agrees: impl Fn(&Posed) -> bool,
    pace: &Pace,
) -> Option<Posed> {
    let mut found: Option<Posed> = None;
    let (mut free, mut needed, mut tries) = (turned, 0, 0);
    let mut batch = free.len() / 2;
    while batch > 0 && tries < MOST_TRIES {
        let end = needed + batch;
        if end >= free.len() {
            batch /= 2;
            continue;
        }
        let back = &free[needed..end];
        let others: Vec<usize> = free
            .iter()
            .copied()
            .filter(|joint| !back.contains(joint))
            .collect();
        let start = fit.put_back(found.as_ref().unwrap_or(posed), back);
        let without = fit.of(&others, start).improve(tolerance, pace).await;
        tries += 1;
        if agrees(&without) {
            (free, found) = (others, Some(without));
        } else if batch == 1 {
            needed += 1;
        } else {
            batch /= 2;
        }
    }
    found
}
