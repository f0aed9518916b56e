//! Causes as an ordered table of rules, and the sentences of what they find.

use serde::{Serialize, Serializer};
use std::fmt::Display;

/// A cause that may be found in some evidence. Tables of rules are ordered, the most telling
/// first: a rule is asked only if it may stand beside all that the rules before it found.
pub(super) struct Rule<A> {
    /// Name of the cause, unique in its table.
    pub(super) name: &'static str,
    /// Rules beside whose findings this one still says something.
    pub(super) beside: Beside,
    /// What gives the finding, if the evidence bears it out.
    pub(super) applies: A,
}

/// Rules beside whose findings another rule is asked.
#[derive(Clone, Copy, Debug)]
pub(super) enum Beside {
    /// None: the rule is asked only while nothing has been found.
    Nothing,
    /// Those of these names.
    Only(&'static [&'static str]),
    /// Any.
    Everything,
}

impl Beside {
    fn allows(self, name: &str) -> bool {
        match self {
            Self::Nothing => false,
            Self::Only(names) => names.contains(&name),
            Self::Everything => true,
        }
    }
}

/// Findings of the rules that apply, in the order of the table, each with its rule's name. Rules are
/// asked by `ask`, with their number in the table.
pub(super) async fn found_by<A, F>(
    rules: &[Rule<A>],
    ask: impl AsyncFn(usize, &A) -> Option<F>,
) -> Vec<(&'static str, F)> {
    let mut found: Vec<(&'static str, F)> = Vec::new();
    for (index, rule) in rules.iter().enumerate() {
        if found.iter().all(|(name, _)| rule.beside.allows(name)) {
            let finding = ask(index, &rule.applies).await;
            found.extend(finding.map(|finding| (rule.name, finding)));
        }
    }
    found
}

/// The findings without the names of their rules.
pub(super) fn without_names<F>(found: Vec<(&'static str, F)>) -> Vec<F> {
    found.into_iter().map(|(_, finding)| finding).collect()
}

/// A finding with its text.
#[derive(Serialize)]
struct WithMessage<'a, F> {
    #[serde(flatten)]
    finding: &'a F,
    message: String,
}

/// Serializes findings with the text of each as `message`.
pub(super) fn with_messages<F: Serialize + Display, S: Serializer>(
    findings: &[F],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(findings.iter().map(|finding| WithMessage {
        finding,
        message: finding.to_string(),
    }))
}

/// A text as a sentence: with a capital letter and a full stop.
pub fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    let first: String = first.into_iter().flatten().collect();
    format!("{first}{}.", letters.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::steps::at_once;

    /// A rule that applies to numbers from `least` on.
    const fn rule(name: &'static str, beside: Beside, least: i32) -> Rule<i32> {
        Rule {
            name,
            beside,
            applies: least,
        }
    }

    fn found_in(rules: &[Rule<i32>], number: i32) -> Vec<(&'static str, i32)> {
        at_once(|_| found_by(rules, async |_, &least| (number >= least).then_some(least)))
    }

    #[test]
    fn of_rules_that_stand_alone_the_first_that_applies_wins() {
        let mut rules = [
            rule("three", Beside::Nothing, 3),
            rule("two", Beside::Nothing, 2),
            rule("one", Beside::Nothing, 1),
        ];
        assert_eq!(found_in(&rules, 3), [("three", 3)]);
        assert_eq!(found_in(&rules, 2), [("two", 2)]);
        assert_eq!(found_in(&rules, 1), [("one", 1)]);
        assert_eq!(found_in(&rules, 0), []);
        rules.swap(0, 2);
        assert_eq!(found_in(&rules, 3), [("one", 1)]);
    }

    #[test]
    fn a_rule_is_asked_beside_those_that_it_names_alone() {
        let rules = |beside| {
            [
                rule("one", Beside::Nothing, 1),
                rule("two", Beside::Everything, 2),
                rule("three", beside, 3),
            ]
        };
        let names = |beside| {
            let found = found_in(&rules(beside), 3).into_iter();
            found.map(|(name, _)| name).collect::<Vec<_>>()
        };
        assert_eq!(
            names(Beside::Only(&["one", "two"])),
            ["one", "two", "three"]
        );
        assert_eq!(names(Beside::Only(&["two"])), ["one", "two"]);
        assert_eq!(names(Beside::Nothing), ["one", "two"]);
    }

    #[test]
    fn a_text_becomes_a_sentence() {
        assert_eq!(sentence("a thing differs"), "A thing differs.");
        assert_eq!(sentence("B is blank"), "B is blank.");
        assert_eq!(sentence(""), ".");
    }
}
