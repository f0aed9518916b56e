//! Sections of the assignment, and the points that submissions have in them.

use super::mistake_section::number;
use super::report::GradedTest;
use crate::diagnose::MISTAKES;
use crate::io::TestsFile;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// A section of the assignment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Section {
    /// Its number or name.
    pub section: String,
    /// What it is called beside its number; may be empty.
    pub title: String,
    /// Points that are possible.
    pub possible: f64,
    /// Whether they come on top of what is possible in all.
    pub extra: bool,
    /// Whether no test has points for it, so that a person gives them.
    pub by_hand: bool,
}

impl Section {
    /// Number and title; of a section without a number its title, or else its name.
    pub fn name(&self) -> String {
        let Self { section, title, .. } = self;
        let is_number = section.starts_with(|first: char| first.is_ascii_digit());
        match (title.is_empty(), is_number) {
            (true, _) => section.clone(),
            (false, true) => format!("{section} {title}"),
            (false, false) => title.clone(),
        }
    }
}

/// A number of points with two digits after the point.
pub(super) fn in_cents(points: f64) -> f64 {
    // Halves that are not exact in binary are rounded up, as by hand.
    (points * 100.0 + 1e-6).round() / 100.0
}

pub(super) fn cents(points: BTreeMap<String, f64>) -> BTreeMap<String, f64> {
    points
        .into_iter()
        .map(|(section, points)| (section, in_cents(points)))
        .collect()
}

pub(super) fn sections(file: &TestsFile) -> Vec<Section> {
    let of_rubric = file.rubric.sections.keys();
    let of_tests_too = of_rubric.chain(file.tests.iter().flat_map(|test| test.points.keys()));
    let names: BTreeSet<&String> = of_tests_too.collect();
    let sections = names.into_iter().map(|name| {
        let data = file.rubric.sections.get(name).cloned().unwrap_or_default();
        let of_course = || {
            let mut sections = MISTAKES.iter().map(|mistake| mistake.section);
            let section = sections.find(|section| number(section) == name);
            section
                .and_then(|section| section.split_once(' '))
                .map_or("", |(_, title)| title)
        };
        Section {
            section: name.clone(),
            title: match &*data.title {
                "" => of_course().to_owned(),
                title => title.to_owned(),
            },
            possible: in_cents(file.worth(name).unwrap_or(0.0)),
            extra: data.extra,
            by_hand: file.points_of_tests(name).is_none(),
        }
    });
    sections.collect()
}

/// The points of a submission: those that a person gives, or else those of the tests, scaled to what
/// the section is worth.
pub(super) fn points_by_section(
    file: &TestsFile,
    sections: &[Section],
    name: &str,
    tests: &[GradedTest],
) -> BTreeMap<String, Option<f64>> {
    let given = file.rubric.given.get(name);
    let points = sections.iter().map(|section| {
        let key = &section.section;
        let by_tests = || {
            let possible = file.points_of_tests(key)?;
            let reached: f64 = tests.iter().filter_map(|test| test.points.get(key)).sum();
            let share = if possible > 0.0 {
                reached / possible
            } else {
                0.0
            };
            Some(in_cents(share * section.possible))
        };
        let by_hand = given
            .and_then(|given| given.get(key))
            .map(|points| in_cents(points.get_ref().0));
        (key.clone(), by_hand.or_else(by_tests))
    });
    points.collect()
}

/// What a submission has in each section, and why it is not what its tests add up to, if so.
pub(super) fn notes(
    file: &TestsFile,
    sections: &[Section],
    name: &str,
    tests: &[GradedTest],
    points: &BTreeMap<String, Option<f64>>,
) -> Vec<String> {
    let given = file.rubric.given.get(name);
    let told = sections.iter().map(|section| {
        let (key, name, worth) = (&section.section, section.name(), section.possible);
        let Some(points) = points.get(key).copied().flatten() else {
            return match section.extra {
                true => format!("{name}: none of {worth}"),
                false => format!("{name}: not graded yet, of {worth}"),
            };
        };
        let told = format!("{name}: {points} of {worth}");
        if given.is_some_and(|given| given.contains_key(key)) {
            return format!("{told}, given by hand");
        }
        let of_tests = file.points_of_tests(key).map(in_cents);
        match of_tests.filter(|possible| *possible != worth) {
            Some(possible) => {
                let reached: f64 = tests.iter().filter_map(|test| test.points.get(key)).sum();
                let reached = in_cents(reached);
                format!("{told}, for {reached} of {possible} in the tests")
            }
            None => told,
        }
    });
    told.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_of_cents_are_rounded_up() {
        assert_eq!(
            [in_cents(1.005), in_cents(2.675), in_cents(1.0 / 3.0)],
            [1.01, 2.68, 0.33]
        );
    }
}
