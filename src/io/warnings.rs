use super::Diagnostic;
use std::path::Path;

/// More warnings than anyone reads are counted instead of kept.
const MOST_WARNINGS: usize = 100;

/// The warnings about a file: the first of them, and how many there are.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kept: Vec<Diagnostic>,
    unshown: usize,
}

impl Warnings {
    /// Keeps a warning; one that is only counted is not even made.
    pub fn push_with(&mut self, warning: impl FnOnce() -> Diagnostic) {
        if self.kept.len() < MOST_WARNINGS {
            self.kept.push(warning());
        } else {
            self.unshown += 1;
        }
    }

    /// Those about the file at `path`; a last one says how many are not shown.
    pub fn into_vec(mut self, path: &Path) -> Vec<Diagnostic> {
        if self.unshown > 0 {
            let message = format!("{} more warnings are not shown", self.unshown);
            self.kept.push(Diagnostic::new(path, message));
        }
        self.kept
    }
}
