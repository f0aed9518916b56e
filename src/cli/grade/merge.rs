//! Parts of a class, graded by several machines, joined.

use super::kept::{KeptResults, KeptRun, Store};
use super::submissions::Part;
use crate::cli::CliError;
use crate::grade::{Graded, Name};
use crate::io::{Diagnostic, TestsFile};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Parts that are missing which are told.
const TOLD: usize = 8;

/// The run that the reports `parts` together are, with its results, which are kept in `store`.
///
/// # Errors
/// If one is no report, parts are of different tests, one lacks a result, two have different results
/// for one submission, or not all parts of the class are there.
pub(super) fn joined(
    parts: &[PathBuf],
    store: &Store,
) -> Result<(KeptRun, BTreeMap<String, Vec<Graded>>), CliError> {
    let mut joined: Option<KeptRun> = None;
    let mut results: BTreeMap<String, (KeptResults, &PathBuf)> = BTreeMap::new();
    let mut found_parts: Vec<(Part, &PathBuf)> = Vec::new();
    for folder in parts {
        let part = Store::new(folder);
        let run = part.run()?;
        let first = joined.get_or_insert_with(|| run.clone());
        if (&first.tests, &first.fingerprints) != (&run.tests, &run.fingerprints) {
            let message = format!(
                "expected the same tests as in {}, found others",
                parts[0].display()
            );
            return Err(Diagnostic::new(folder, message).into());
        }
        found_parts.extend(run.part.map(|part| (part, folder)));
        for name in run.submissions {
            let found = part.results(&name);
            if let Some((known, other)) = results.get(&name) {
                if *known != found {
                    let other = other.display();
                    let message =
                        format!("expected the same results for {name} as in {other}, found others");
                    return Err(Diagnostic::new(folder, message).into());
                }
            } else {
                results.insert(name, (found, folder));
            }
        }
    }
    let Some(mut run) = joined else {
        return Err(CliError::Usage(
            "expected the report of a part, found none".to_owned(),
        ));
    };
    check_parts(&found_parts)?;
    run.part = None;
    run.submissions = results.keys().cloned().collect();
    run.submissions
        .sort_by_cached_key(|name| Name::from(&**name));
    let tests = TestsFile::read(Path::new("TESTS.json"), run.tests.as_bytes())?;
    let mut graded = BTreeMap::new();
    for (name, (found, folder)) in &results {
        let of_test = |test: &str| {
            let missing = || {
                Diagnostic::new(
                    folder,
                    format!("expected a result of {name} for {test}, found none"),
                )
            };
            let result = found.0.get(test).ok_or_else(missing)?;
            Ok::<_, Diagnostic>(result.graded.clone())
        };
        let of_tests = tests.tests.iter().map(|test| of_test(&test.name));
        graded.insert(name.clone(), of_tests.collect::<Result<Vec<_>, _>>()?);
    }
    store.prepare()?;
    for (name, (found, _)) in &results {
        store.keep(name, found)?;
    }
    store.keep_run(&run)?;
    Ok((run, graded))
}

/// Makes sure that no part of the class is missing: its submissions would be without a word.
fn check_parts(found: &[(Part, &PathBuf)]) -> Result<(), Diagnostic> {
    let Some(&(Part { count, .. }, first)) = found.first() else {
        return Ok(());
    };
    if let Some((other, folder)) = found.iter().find(|(part, _)| part.count != count) {
        let first = first.display();
        let message = format!(
            "expected one of {count} parts as in {first}, found part {} of {}",
            other.index, other.count
        );
        return Err(Diagnostic::new(folder, message));
    }
    let is_there = |index: &usize| found.iter().any(|(part, _)| part.index == *index);
    // A report may say that there are any number of parts.
    let missing = (1..=count).filter(|index| !is_there(index)).take(TOLD + 1);
    let missing: Vec<String> = missing.map(|index| format!("{index}/{count}")).collect();
    let more = if missing.len() > TOLD {
        " and more"
    } else {
        ""
    };
    let told: Vec<&str> = missing.iter().map(String::as_str).take(TOLD).collect();
    if told.is_empty() {
        return Ok(());
    }
    let message = format!(
        "expected the reports of all {count} parts, found none of part {}{more}",
        told.join(", ")
    );
    Err(Diagnostic::new(first, message))
}
