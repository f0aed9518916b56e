//! Points by the rubric.

use super::graded::{Graded, Outcome};
use crate::diagnose::Mistake;
use crate::io::{RubricData, TestData};
use std::collections::BTreeMap;

/// Name of the mistake that all of a result rests on, for which another pose counts, too: a mesh that is not in the
/// pose of its test shows nothing of what the test asks for, whatever the section.
const POSE_NOT_APPLIED: &str = "pose-not-applied";
/// What that leaves unless the rubric says otherwise.
const LEFT_WITHOUT_POSE: f64 = 0.0;

/// The points of a test by section. A mistake costs its share of the points of its own section alone,
/// where the test has points for that, for all else is right once it is set aside; one whose section
/// has no points in the test costs them in each, and so does a pose that was not applied. Of explanations that give the
/// same file the one counts that costs least, unless the first is that the pose was not applied.
pub(super) fn points(
    test: &TestData,
    graded: &Graded,
    rubric: &RubricData,
) -> BTreeMap<String, f64> {
    let possible = || {
        test.points
            .iter()
            .map(|(section, points)| (section.clone(), points.0))
    };
    let of_all = |share: f64| {
        possible()
            .map(|(section, points)| (section, points * share))
            .collect()
    };
    let left_by = |mistakes: &[String]| {
        let left = possible().map(|(section, points)| {
            let left = points * share_left(test, &section, mistakes, rubric);
            (section, left)
        });
        left.collect::<BTreeMap<String, f64>>()
    };
    match graded.outcome {
        Outcome::Right => of_all(1.0),
        Outcome::Unexplained => of_all(rubric.unexplained.0 * graded.agrees),
        // The pose that was asked for is as little in it as in one that is not posed at all.
        Outcome::OtherPose => left_by(&[POSE_NOT_APPLIED.to_owned()]),
        Outcome::Explained => {
            let explained = graded.causes.iter().map(|mistakes| left_by(mistakes));
            let total = |points: &BTreeMap<String, f64>| points.values().sum::<f64>();
            // Of equals the first, which is the one that is told.
            let first = graded.causes.first();
            let is_at_rest = first.is_some_and(|first| *first == [POSE_NOT_APPLIED]);
            let best = explained.reduce(|best, other| {
                if !is_at_rest && total(&other) > total(&best) + 1e-9 {
                    other
                } else {
                    best
                }
            });
            best.unwrap_or_else(|| of_all(0.0))
        }
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => of_all(0.0),
    }
}

/// What `mistakes` leave of the points of a section.
fn share_left(test: &TestData, section: &str, mistakes: &[String], rubric: &RubricData) -> f64 {
    let left = mistakes.iter().map(|id| {
        let is_of_all = id == POSE_NOT_APPLIED;
        let own = Mistake::find(id).map_or("", |mistake| number(mistake.section));
        if is_of_all || own == section || !test.points.contains_key(own) {
            let without = if is_of_all {
                LEFT_WITHOUT_POSE
            } else {
                rubric.mistake.0
            };
            let own = rubric.mistakes.get(id.as_str());
            own.map_or(without, |share| share.0)
        } else {
            1.0
        }
    });
    left.product()
}

/// The number of a section such as `4.2 SSD`.
pub(super) fn number(section: &str) -> &str {
    section.split(' ').next().unwrap_or(section)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{NamedFile, Points, Position, Share, TestKind};

    fn named(path: &str) -> NamedFile {
        NamedFile {
            path: path.into(),
            at: Position { line: 1, column: 1 },
        }
    }

    fn test(sections: &[(&str, f64)]) -> TestData {
        let points = sections
            .iter()
            .map(|&(section, points)| (section.to_owned(), Points(points)));
        TestData {
            name: "walk".to_owned(),
            character: named("a.obj"),
            pose: named("b.json"),
            kind: TestKind::Mesh,
            points: points.collect(),
        }
    }

    fn explained(causes: &[&[&str]]) -> Graded {
        let owned = |ids: &&[&str]| ids.iter().map(|&id| id.to_owned()).collect();
        Graded {
            causes: causes.iter().map(owned).collect(),
            ..Graded::without(Outcome::Explained, "")
        }
    }

    fn given(sections: &[(&str, f64)], graded: &Graded, rubric: &RubricData) -> Vec<f64> {
        points(&test(sections), graded, rubric)
            .into_values()
            .collect()
    }

    const TWO: &[(&str, f64)] = &[("3.4", 6.0), ("4.2", 10.0)];

    #[test]
    fn a_mistake_costs_points_in_its_own_section_and_two_in_one_cost_twice() {
        let rubric = RubricData::default();
        for (causes, expected) in [
            (&["euler-zyx"][..], [3.0, 10.0]),
            (&["no-inverse-bind"], [6.0, 5.0]),
            (&["euler-zyx", "no-inverse-bind"], [3.0, 5.0]),
            (&["euler-zyx", "one-axis-ignored-x"], [1.5, 10.0]),
            // Section 3.2 has no points in this test.
            (&["parent-missing"], [3.0, 5.0]),
        ] {
            assert_eq!(
                given(TWO, &explained(&[causes]), &rubric),
                expected,
                "{causes:?}"
            );
        }
    }

    #[test]
    fn of_mistakes_that_give_the_same_the_one_counts_that_costs_least() {
        let causes = explained(&[&["no-inverse-bind"], &["euler-zyx"]]);
        assert_eq!(given(TWO, &causes, &RubricData::default()), [3.0, 10.0]);
    }

    #[test]
    fn a_test_whose_pose_was_not_applied_shows_none_of_its_sections() {
        let mut rubric = RubricData::default();
        let at_rest = explained(&[&["pose-not-applied"], &["one-axis-ignored-z"]]);
        let other_pose = Graded::without(Outcome::OtherPose, "");
        assert_eq!(given(TWO, &at_rest, &rubric), [0.0, 0.0]);
        assert_eq!(given(TWO, &other_pose, &rubric), [0.0, 0.0]);
        let name = POSE_NOT_APPLIED.to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.25));
        assert_eq!(given(TWO, &at_rest, &rubric), [1.5, 2.5]);
        assert_eq!(given(TWO, &other_pose, &rubric), [1.5, 2.5]);
    }

    #[test]
    fn a_mistake_may_cost_less_than_others() {
        let mut rubric = RubricData::default();
        let name = "euler-zyx".to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.75));
        assert_eq!(
            given(TWO, &explained(&[&["euler-zyx"]]), &rubric),
            [4.5, 10.0]
        );
    }

    #[test]
    fn what_is_unexplained_counts_by_what_agrees_and_what_is_not_there_counts_nothing() {
        let rubric = RubricData::default();
        let unexplained = Graded {
            agrees: 0.8,
            ..Graded::without(Outcome::Unexplained, "")
        };
        assert_eq!(given(&[("4.2", 10.0)], &unexplained, &rubric), [4.0]);
        for outcome in [
            Outcome::Blank,
            Outcome::Missing,
            Outcome::Unreadable,
            Outcome::Failed,
        ] {
            let none = Graded::without(outcome, "");
            assert_eq!(given(TWO, &none, &rubric), [0.0, 0.0]);
        }
    }
}
