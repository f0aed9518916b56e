//! Which weights a program may have kept by the same formula: of equal ones a sort leaves any first, and which way halves
//! are rounded differs.

use super::formula::{Halves, Kept, Rounded, WeightFormula};
use super::skin::keep;
use crate::character::Influence;

/// Equal weights of which more are not exchanged for one another: there are too many ways.
const MOST_EQUALS: usize = 12;

/// The weights of a vertex that may count, each with the index of its joint: more than one choice where they are rounded,
/// and where some of those that are kept are as large as some that are not.
pub(super) fn choices(influences: &[Influence], formula: WeightFormula) -> Vec<Vec<(usize, f64)>> {
    let Rounded::ToDigits(digits, _) = formula.rounded else {
        return of_equals(influences, formula);
    };
    let ways = Halves::ALL.map(|halves| WeightFormula {
        rounded: Rounded::ToDigits(digits, halves),
        ..formula
    });
    let of_each = ways.into_iter();
    of_each
        .flat_map(|formula| of_equals(influences, formula))
        .collect()
}

/// The same where it is known which way halves go.
fn of_equals(influences: &[Influence], formula: WeightFormula) -> Vec<Vec<(usize, f64)>> {
    let kept = |influences: &[Influence]| {
        let mut kept = Vec::new();
        keep(influences, formula, &mut kept);
        kept
    };
    let mut sorted = influences.to_vec();
    sorted.sort_by(|a, b| b.weight.total_cmp(&a.weight));
    let (most, least) = match formula.kept {
        Kept::Largest(most) if most > 0 && most < sorted.len() => (most, sorted[most - 1].weight),
        _ => return vec![kept(influences)],
    };
    let (larger, rest): (Vec<Influence>, Vec<Influence>) =
        sorted.into_iter().partition(|one| one.weight > least);
    let (equals, smaller): (Vec<Influence>, Vec<Influence>) =
        rest.into_iter().partition(|one| one.weight == least);
    let (exchanged, others) = equals.split_at(equals.len().min(MOST_EQUALS));
    // As many of the equals come first as there is room for.
    let room = most - larger.len();
    let all = (0_u32..1 << exchanged.len()).filter(|set| set.count_ones() as usize == room);
    let orders = all.map(|set| {
        let is_first = |&at: &usize| set >> at & 1 == 1;
        let (first, last): (Vec<usize>, Vec<usize>) = (0..exchanged.len()).partition(is_first);
        let equals = first.into_iter().chain(last).map(|at| exchanged[at]);
        let order = larger.iter().copied().chain(equals);
        let order = order
            .chain(others.iter().copied())
            .chain(smaller.iter().copied());
        order.collect::<Vec<Influence>>()
    });
    orders.map(|order| kept(&order)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::Formula;

    #[test]
    fn of_equal_weights_any_may_be_kept_and_larger_ones_always_are() {
        let weights = [0.1, 0.3, 0.2, 0.1, 0.2, 0.1];
        let influences: Vec<Influence> = (0..)
            .zip(weights)
            .map(|(joint, weight)| Influence { joint, weight })
            .collect();
        let joints = |most: usize| {
            let formula = WeightFormula {
                kept: Kept::Largest(most),
                ..Formula::default().weights
            };
            let choices = choices(&influences, formula).into_iter();
            let joints = choices.map(|kept| kept.into_iter().map(|(joint, _)| joint).collect());
            joints.collect::<Vec<Vec<usize>>>()
        };
        assert_eq!(joints(1), [[1]]);
        assert_eq!(joints(2), [[1, 2], [1, 4]]);
        assert_eq!(joints(3), [[1, 2, 4]]);
        assert_eq!(joints(4), [[1, 2, 4, 0], [1, 2, 4, 3], [1, 2, 4, 5]]);
        assert_eq!(joints(6).len(), 1);
    }
}
