//! The fewest joints by whose angles alone a mesh is explained.

use super::fit::{Fit, Posed};
use crate::steps::Pace;

/// Joints of which more are not sought one by one.
const MOST: usize = 8;

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
