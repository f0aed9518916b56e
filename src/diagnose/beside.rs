//! Mistakes whose numbers come from the mesh, and those in single lines, columns and joints, each beside another mistake.

use super::MUCH_NEARER;
use super::formula::{Columns, Formula, LeftOnStack, Parents, Popped, Rows};
use super::found_otherwise::{ANGLES_SCALED, ONE_WRONG_OFFSET};
use super::made_alone::MadeAlone;
use super::not_turned::Lacking;
use super::search::{Explanation, Search};
use super::ways::{formula, ways, ways_of_whole_program};
use super::{one_joint, small_weights, whole_program};
use crate::steps::Pace;

/// Part of the mean distance that a mistake leaves at most which accounts for more than the other one.
const ACCOUNTS_FOR_MORE: f64 = 0.5;

/// Every mistake that gives the mesh of `search`, of this size, beside one of these. What is worked out from the mesh has to
/// bring it much nearer than it is to the exact one or the other mistake alone does, or as near as `rounding` tells.
pub(super) async fn find(
    search: &Search<'_>,
    size: f64,
    rounding: f64,
    pace: &Pace,
) -> Vec<Explanation> {
    let exact = Formula::default();
    let error = search.error_of_sample(&exact).unwrap_or(f64::INFINITY);
    let lacking = Lacking::new(search);
    let mut found = Vec::new();
    for other in ways().chain(ways_of_whole_program()) {
        let by_other = formula(&[other]);
        let Some(of_other) = search.error_of_sample(&by_other) else {
            continue;
        };
        let fits = search.within(rounding.max(error.min(of_other) / MUCH_NEARER));
        let Some(beside) = MadeAlone::beside(&fits, other) else {
            continue;
        };
        let mut explanations = Vec::new();
        if let Some(lacking) = &lacking {
            explanations.extend(lacking.beside(other, pace).await);
        }
        if by_other.weights.columns == Columns::Exact && by_other.weights.rows == Rows::Exact {
            explanations.extend(beside.exchanged_weights(pace).await);
            explanations.extend(beside.left_out(pace).await);
        }
        if by_other.weights == exact.weights {
            explanations.extend(small_weights::find(&beside, pace).await);
        }
        // A factor would undo other units.
        let has_units = by_other.joint.units == exact.joint.units;
        if has_units && !std::ptr::eq(other.mistake, &raw const ANGLES_SCALED) {
            explanations.extend(whole_program::scaled_angles_beside(&beside, pace).await);
        }
        if has_tree_of_file(&by_other) {
            explanations.extend(one_joint::find(&beside, size, pace).await);
        }
        let accounts_for_more =
            || search.mean(&by_other) <= ACCOUNTS_FOR_MORE * search.mean(&exact);
        if !explanations.is_empty() && !accounts_for_more() {
            explanations.iter_mut().for_each(|both| both.made.reverse());
        }
        found.extend(explanations);
        pace.after(search.sample.len()).await;
    }
    // Three unknown numbers are the last thing to be supposed.
    found.sort_by_key(|both| both.ids().contains(&ONE_WRONG_OFFSET.id));
    found
}

/// Whether each joint hangs on its parent in the file.
fn has_tree_of_file(formula: &Formula) -> bool {
    formula.parents == Parents::OfFile
        && !formula.offsets_are_places
        && formula.popped == [Popped::All; 2]
        && formula.left_on_stack == LeftOnStack::Nothing
}
