use std::fmt;
use std::path::{Path, PathBuf};

/// An error or a warning about a file, printed as `path:line:column: message`.
///
/// Messages say what was expected and what was found.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct Diagnostic {
    /// The file at fault.
    pub path: PathBuf,
    /// Where in the file, if the fault has a place.
    pub position: Option<Position>,
    /// What is wrong.
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

impl Diagnostic {
    /// About the file as a whole.
    pub fn new(path: &Path, message: impl Into<String>) -> Self {
        Self {
            path: path.to_owned(),
            position: None,
            message: message.into(),
        }
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

/// What an importer returns: the value, and what it noticed on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported<T> {
    /// What was read.
    pub value: T,
    /// What was odd but not wrong enough to stop.
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

    /// The same warnings about what `change` makes of the value.
    pub fn map<U>(self, change: impl FnOnce(T) -> U) -> Imported<U> {
        Imported {
            value: change(self.value),
            warnings: self.warnings,
        }
    }
}
