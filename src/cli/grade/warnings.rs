//! What is likely to be wrong in a file of tests, though it can be graded by.

use super::submissions::Submission;
use crate::grade::{is_numbered, without_mistakes};
use crate::io::TestsFile;
use std::collections::BTreeSet;

/// What to look at before the points are used.
pub(super) fn of(file: &TestsFile, submissions: &[Submission]) -> Vec<String> {
    let mut told = given_to_none(file, submissions);
    told.extend(empty_sections(file));
    told.extend(misspelled_sections(file));
    let untouched = without_mistakes(&file.tests).into_iter();
    told.extend(untouched.map(|section| {
        format!(
            "no mistake costs points of {section}, which are lost only with all others of a test"
        )
    }));
    told
}

/// Points in `given` that no one gets: of submissions that are not there, and in sections that are none.
fn given_to_none(file: &TestsFile, submissions: &[Submission]) -> Vec<String> {
    let points = file.tests.iter().flat_map(|test| test.points.keys());
    let sections: BTreeSet<&String> = points.chain(file.rubric.sections.keys()).collect();
    let mut told = Vec::new();
    for (name, given) in &file.rubric.given {
        if submissions
            .iter()
            .all(|submission| submission.name != *name)
        {
            let is_alike = |one: &&Submission| one.name.to_lowercase() == name.to_lowercase();
            let alike = submissions
                .iter()
                .find(is_alike)
                .map_or(String::new(), |one| {
                    format!(", but {}: the names differ in capitals", one.name)
                });
            told.push(format!(
                "points are given to {name}, but there is no such submission{alike}"
            ));
        }
        for section in given.keys().filter(|section| !sections.contains(section)) {
            told.push(format!(
                "{name} is given points for {section}, which is no section"
            ));
        }
    }
    told
}

/// Sections of the rubric in which nobody gets points, by a test or by hand.
fn empty_sections(file: &TestsFile) -> Vec<String> {
    let has_test = |section: &String| {
        let mut tests = file.tests.iter();
        tests.any(|test| test.points.contains_key(section))
    };
    let is_given = |section: &String| {
        let mut given = file.rubric.given.values();
        given.any(|given| given.contains_key(section))
    };
    let sections = file.rubric.sections.keys();
    let empty = sections.filter(|section| !has_test(section) && !is_given(section));
    empty
        .map(|section| format!("no test has points for {section}, and nobody is given any by hand"))
        .collect()
}

/// Sections of tests that have no number, and the name of which is that of another one but for a letter.
fn misspelled_sections(file: &TestsFile) -> Vec<String> {
    let of_tests: BTreeSet<&String> = file
        .tests
        .iter()
        .flat_map(|test| test.points.keys())
        .collect();
    let of_rubric = file.rubric.sections.keys();
    let all: BTreeSet<&String> = of_tests.iter().copied().chain(of_rubric).collect();
    let without_number = of_tests.into_iter().filter(|section| !is_numbered(section));
    let alike = without_number.filter_map(|section| {
        let mut others = all.iter();
        let other = others.find(|other| strsim::levenshtein(other, section) == 1)?;
        Some(format!(
            "tests have points for {section}, which is a section of its own beside {other}"
        ))
    });
    alike.collect()
}
