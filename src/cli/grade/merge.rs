//! Parts of a class, graded by several machines, joined.

use super::kept::{KeptResults, KeptRun, Store};
use crate::cli::CliError;
use crate::grade::Graded;
use crate::io::{Diagnostic, TestsFile};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The run that the reports `parts` together are, with its results, which are kept in `store`.
///
/// # Errors
/// If one is no report, parts are of different tests, one lacks a result, or two have different results
/// for one submission.
pub(super) fn joined(
    parts: &[PathBuf],
    store: &Store,
) -> Result<(KeptRun, BTreeMap<String, Vec<Graded>>), CliError> {
    let mut joined: Option<KeptRun> = None;
    let mut results: BTreeMap<String, (KeptResults, &PathBuf)> = BTreeMap::new();
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
    run.submissions = results.keys().cloned().collect();
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
