//! Two mistakes at once.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, Student, WRONG};
use editor_core::diagnose::Verdict;
use proptest::prelude::*;
use std::sync::LazyLock;

static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    let figures = [("adult", 11), ("adult", 12), ("dog", 13)];
    figures
        .map(|(name, seed)| Figure::builtin(name, turned(seed)))
        .into()
});

fn with(mistakes: &[usize]) -> Student {
    let mut student = RIGHT;
    for &mistake in mistakes {
        (WRONG[mistake].make)(&mut student);
    }
    student
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 48,
        failure_persistence: None,
        rng_seed: prop::test_runner::RngSeed::Fixed(13),
        ..ProptestConfig::default()
    })]

    #[test]
    fn two_mistakes_in_different_parts_are_both_named(
        figure in 0..3_usize,
        a in 0..WRONG.len(),
        b in 0..WRONG.len(),
        digits in 4..8_usize,
    ) {
        prop_assume!(WRONG[a].part != WRONG[b].part && WRONG[a].id != WRONG[b].id);
        let figure = &FIGURES[figure];
        let theirs = written(&with(&[a, b]).skin(figure), digits);
        let found = figure.diagnose(&theirs);
        let (first, second) = (WRONG[a].id, WRONG[b].id);
        let case = format!("{first} and {second} with {digits} digits on {}: {found}", figure.name);
        prop_assert_eq!(found.verdict, Verdict::Explained, "{}", case);
        let named = named(&found);
        let is_both = |ids: &Vec<&str>| ids.len() == 2 && ids.contains(&first) && ids.contains(&second);
        // One of the two may make no difference beside the other, and both may be what one other is.
        let is_one = |mistake: usize| {
            let alone = with(&[mistake]).skin(figure);
            let pairs = || alone.iter().zip(&theirs);
            let is_same = alone.len() == theirs.len() && pairs().all(|(a, b)| a.distance(*b) < 4e-4);
            is_same && named.contains(&vec![WRONG[mistake].id])
        };
        prop_assert!(named.iter().any(is_both) || (0..WRONG.len()).any(is_one), "{}", case);
    }
}
