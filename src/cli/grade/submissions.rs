//! The submissions of a class.

use super::kept::Store;
use crate::cli::CliError;
use crate::cli::output::eprint_line;
use crate::disk::in_words;
use crate::grade::Name;
use crate::io::Diagnostic;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A submission.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Submission {
    /// Name of its folder.
    pub name: String,
    /// Its folder.
    pub folder: PathBuf,
}

/// The I-th of N parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Part {
    /// I, from 1.
    pub index: usize,
    /// N.
    pub count: usize,
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(index, count)| {
            let (index, count): (usize, usize) = (index.parse().ok()?, count.parse().ok()?);
            (1..=count).contains(&index).then_some((index, count))
        });
        match numbers {
            Some((index, count)) => Ok(Self { index, count }),
            None => Err(format!(
                "expected I/N with I from 1 to N, such as 2/8, found {text}"
            )),
        }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl Part {
    /// Every N-th of `submissions`, so that parts take about as long as each other.
    pub fn of(self, submissions: Vec<Submission>) -> Vec<Submission> {
        submissions
            .into_iter()
            .skip(self.index - 1)
            .step_by(self.count)
            .collect()
    }
}

/// Name of the folder that macOS adds to archives.
const OF_MACOS: &str = "__MACOSX";

/// Endings of files that may be somebody's submission.
const HANDED_IN: [&str; 7] = ["obj", "png", "zip", "gz", "tgz", "7z", "rar"];

/// Whether a file beside the folders of submissions looks like one that somebody handed in.
fn may_be_handed_in(path: &Path) -> bool {
    let is_hidden = path
        .file_name()
        .is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    !is_hidden && ending.is_some_and(|ending| HANDED_IN.iter().any(|known| ending == *known))
}

/// The submissions in `folder`, in the order of their names: its folders but for hidden ones, that of macOS, symbolic
/// links and finished reports.
///
/// # Errors
/// If it cannot be read, has none, or a name is not in UTF-8.
pub(super) fn of(folder: &Path) -> Result<Vec<Submission>, CliError> {
    let failed = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => Diagnostic::new(folder, "there is no such folder"),
        std::io::ErrorKind::NotADirectory => {
            Diagnostic::new(folder, "expected a folder, found a file")
        }
        _ => Diagnostic::new(folder, in_words(&error)),
    };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        // It may be the folder of another submission, or lead nowhere.
        if path.is_symlink() && (path.is_dir() || !path.exists()) {
            let path = path.display();
            eprint_line(format_args!(
                "warning: {path}: left out, since it is a symbolic link"
            ));
            continue;
        }
        if !path.is_dir() {
            if may_be_handed_in(&path) {
                let path = path.display();
                eprint_line(format_args!(
                    "warning: {path}: left out, since it is in no folder of a submission"
                ));
            }
            continue;
        }
        if Store::new(&path).is_there() {
            let path = path.display();
            eprint_line(format_args!(
                "warning: {path}: left out, since it is a report"
            ));
            continue;
        }
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            return Err(Diagnostic::new(&path, "expected a name in UTF-8").into());
        };
        if !name.starts_with('.') && name != OF_MACOS {
            found.push(Submission {
                name: name.to_owned(),
                folder: path,
            });
        }
    }
    if found.is_empty() {
        return Err(
            Diagnostic::new(folder, "expected a folder for each submission, found none").into(),
        );
    }
    found.sort_by_cached_key(|submission| Name::from(&*submission.name));
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_hold_every_submission_once() {
        let all: Vec<Submission> = (0..10)
            .map(|index| Submission {
                name: format!("{index}"),
                folder: PathBuf::new(),
            })
            .collect();
        let mut parts: Vec<Submission> = Vec::new();
        for part in ["1/4", "2/4", "3/4", "4/4"] {
            parts.extend(part.parse::<Part>().unwrap().of(all.clone()));
        }
        parts.sort();
        assert_eq!(parts, all);
        for bad in ["0/4", "5/4", "4", "a/b", "-1/2", "1/0"] {
            assert!(bad.parse::<Part>().is_err(), "{bad}");
        }
    }
}
