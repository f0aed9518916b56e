//! Errors and warnings about files, with their places.

use std::fmt;
use std::path::{Path, PathBuf};

/// An error or a warning about a file, printed as `path:line:column: message`.
///
/// Messages read `expected …, found …`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct Diagnostic {
    /// The file at fault.
    pub path: PathBuf,
    /// Where in the file, if the fault has a place.
    pub position: Option<Position>,
    /// The message: what was expected and what was found.
    pub message: String,
}

/// A place in a text file, both counted from 1; the column counts characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// Line.
    pub line: usize,
    /// Column.
    pub column: usize,
}

impl Position {
    /// The place of the byte `offset` of `text`, the whole file.
    pub(super) fn in_text(text: &str, offset: usize) -> Self {
        let before = text.get(..offset).unwrap_or(text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Self {
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        }
    }
}

impl Diagnostic {
    /// About the file as a whole.
    pub fn new(path: &Path, message: impl Into<String>) -> Self {
        Self {
            path: path.to_owned(),
            position: None,
            message: message.into(),
        }
    }

    /// The same with what follows from it.
    pub(super) fn followed_by(mut self, what: &str) -> Self {
        self.message += ": ";
        self.message += what;
        self
    }

    /// About one place in the file.
    pub fn at(path: &Path, line: usize, column: usize, message: impl Into<String>) -> Self {
        Self {
            position: Some(Position { line, column }),
            ..Self::new(path, message)
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some(Position { line, column }) = self.position {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}", self.message)
    }
}

/// Result of an importer: the value and its warnings.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported<T> {
    /// The value.
    pub value: T,
    /// Faults that did not keep the value from being read.
    pub warnings: Vec<Diagnostic>,
}

impl<T> Imported<T> {
    /// A value without warnings.
    pub fn clean(value: T) -> Self {
        Self {
            value,
            warnings: Vec::new(),
        }
    }

    /// Changes the value and keeps the warnings.
    pub fn map<U>(self, change: impl FnOnce(T) -> U) -> Imported<U> {
        Imported {
            value: change(self.value),
            warnings: self.warnings,
        }
    }
}

/// More warnings than anyone reads are counted instead of kept.
const MOST_WARNINGS: usize = 100;

/// The warnings about a file: the first of them, and how many there are.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kept: Vec<Diagnostic>,
    unshown: usize,
}

impl Warnings {
    /// Keeps a warning, or counts it when enough are kept; then `warning` is not called.
    pub fn push_with(&mut self, warning: impl FnOnce() -> Diagnostic) {
        if self.kept.len() < MOST_WARNINGS {
            self.kept.push(warning());
        } else {
            self.unshown += 1;
        }
    }

    /// Adds `others` after these.
    pub fn append(&mut self, others: Self) {
        for warning in others.kept {
            self.push_with(|| warning);
        }
        self.unshown += others.unshown;
    }

    /// The warnings about the file at `path`; a last one says how many are not shown.
    pub fn into_vec(mut self, path: &Path) -> Vec<Diagnostic> {
        if self.unshown > 0 {
            let message = format!("{} more warnings are not shown", self.unshown);
            self.kept.push(Diagnostic::new(path, message));
        }
        self.kept
    }
}
