use super::Missing;
use crate::io::{Diagnostic, Files, Position};
use crate::scene::{MissingShape, ShapeKind};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// What the readers of both versions share: where files come from, and how faults are reported.
pub(super) struct Reading<'a> {
    pub files: &'a dyn Files,
    /// Path of the scene.
    pub path: &'a Path,
    /// Text of the scene.
    pub text: &'a str,
    pub missing: Missing,
    pub warnings: Vec<Diagnostic>,
}

/// A shape of the list.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    /// Counted from 1, as messages have it.
    pub number: usize,
    /// The byte of the text where it starts.
    pub at: usize,
}

/// The share that the shape at `index` has in reading `count` of them.
pub(super) fn share_of(index: usize, count: usize) -> Range<f32> {
    let at = |index: usize| index as f32 / count as f32;
    at(index)..at(index + 1)
}

impl Reading<'_> {
    /// An error about a shape.
    pub fn wrong(&self, entry: Entry, message: &str) -> Diagnostic {
        self.wrong_at(entry.at, entry, message)
    }

    /// An error about a shape, at a byte of the text.
    pub fn wrong_at(&self, at: usize, entry: Entry, message: &str) -> Diagnostic {
        Diagnostic {
            position: Some(Position::in_text(self.text, at)),
            ..Diagnostic::new(self.path, format!("shape {}: {message}", entry.number))
        }
    }

    /// `error` at its place in a file; one about a file as a whole where the scene names the file.
    pub fn named_by(&self, entry: Entry, error: Diagnostic) -> Diagnostic {
        if error.position.is_some() {
            return error;
        }
        self.wrong(entry, &error.to_string())
    }

    /// A stand-in for a shape whose file could not be read because of `error`, which becomes a
    /// warning. `kept` is the member of the scene that only means something with the file.
    ///
    /// # Errors
    /// `error` itself where files must not be missing.
    pub fn stand_in(
        &mut self,
        entry: Entry,
        error: Diagnostic,
        kept: Option<(&str, String)>,
    ) -> Result<ShapeKind, Diagnostic> {
        match self.missing {
            Missing::Refuse => Err(self.named_by(entry, error)),
            Missing::StandIn => {
                let missing = MissingShape {
                    reason: error.to_string(),
                    kept: kept.map(|(name, text)| (name.to_owned(), text)),
                };
                self.warnings.push(self.named_by(entry, error));
                Ok(ShapeKind::Missing(Arc::new(missing)))
            }
        }
    }
}
