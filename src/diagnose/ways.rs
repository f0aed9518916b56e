//! The ways to make mistakes, one at a time and two together.

use super::formula::Formula;
use super::found_otherwise::{ANGLES_SCALED, JOINT_LEFT_OUT, SUM_NOT_RESET};
use super::mistake::{Mistake, Reading, reading};
use super::mistakes::MISTAKES;
use super::of_whole_program::OF_WHOLE_PROGRAM;

/// A mistake, and a way to make it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Made {
    pub(super) mistake: &'static Mistake,
    pub(super) reading: &'static Reading,
}

/// The way to make a mistake that is told in words of its own.
static BY_NUMBERS: Reading = reading("", |_| {});

impl Made {
    /// A mistake with numbers from the mesh, which no reading makes.
    pub(super) fn by_numbers(mistake: &'static Mistake) -> Self {
        Self {
            mistake,
            reading: &BY_NUMBERS,
        }
    }

    pub(super) fn is_by_numbers(self) -> bool {
        std::ptr::eq(self.reading, &raw const BY_NUMBERS)
    }
}

/// Every way to make every mistake.
pub(super) fn ways() -> impl Iterator<Item = Made> {
    MISTAKES.iter().flat_map(|mistake| {
        let readings = mistake.readings.iter();
        readings.map(move |reading| Made { mistake, reading })
    })
}

/// Every two ways to make different mistakes that can be made together, with the formula that has both.
pub(super) fn pairs_of_ways() -> impl Iterator<Item = (Made, Made, Formula)> {
    let firsts = ways().enumerate();
    firsts.flat_map(|(index, first)| {
        let seconds = ways().skip(index + 1);
        seconds.flat_map(move |second| made_together(first, second))
    })
}

/// Two mistakes with the formulas that have both: none if they are one, or cannot be made together; two where weights that no
/// joint takes may be left out before others are, or after.
fn made_together(first: Made, second: Made) -> impl Iterator<Item = (Made, Made, Formula)> {
    let both = formula_of_both(first, second);
    let unused_first = both.as_ref().and_then(|both| {
        let weights = both.weights.with_unused_first()?;
        Some(Formula {
            weights,
            ..both.clone()
        })
    });
    let formulas = both.into_iter().chain(unused_first);
    formulas.map(move |both| (first, second, both))
}

/// The formula that has both mistakes; `None` if they are one, or cannot be made together.
fn formula_of_both(first: Made, second: Made) -> Option<Formula> {
    if std::ptr::eq(first.mistake, second.mistake) {
        return None;
    }
    let both = formula(&[first, second]);
    // All three signs and one of them once more are told as the two that are wrong then.
    let negated = both
        .joint
        .angles
        .iter()
        .filter(|factor| **factor < 0.0)
        .count();
    let negates_all = |made: Made| made.mistake.id == "angles-negated";
    if negated == 2 && (negates_all(first) || negates_all(second)) {
        return None;
    }
    // Both change the same part, or one of them has nothing left to change.
    let is_one = both != formula(&[second, first])
        || both == formula(&[first])
        || both == formula(&[second]);
    (!is_one).then_some(both)
}

/// Every way to make a mistake that is sought alone first.
pub(super) fn ways_of_whole_program() -> impl Iterator<Item = Made> {
    let of_whole =
        OF_WHOLE_PROGRAM
            .into_iter()
            .chain([&JOINT_LEFT_OUT, &ANGLES_SCALED, &SUM_NOT_RESET]);
    of_whole.flat_map(|mistake| {
        let readings = mistake.readings.iter();
        readings.map(move |reading| Made { mistake, reading })
    })
}

/// Every two ways of which one or both are those of mistakes that are sought alone first, with the formula that has both.
pub(super) fn pairs_with_whole_program() -> impl Iterator<Item = (Made, Made, Formula)> {
    let firsts = ways_of_whole_program().enumerate();
    firsts.flat_map(|(index, first)| {
        let seconds = ways().chain(ways_of_whole_program().skip(index + 1));
        seconds.flat_map(move |second| made_together(first, second))
    })
}

/// The exact formula with mistakes, made in this order.
pub(super) fn formula(mistakes: &[Made]) -> Formula {
    let mut formula = Formula::default();
    for made in mistakes {
        (made.reading.make)(&mut formula);
    }
    formula
}
