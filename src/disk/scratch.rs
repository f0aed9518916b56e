//! Folders for files that are needed for a moment.

use super::in_words;
use crate::io::Diagnostic;
use std::path::Path;
use tempfile::TempDir;

/// A new folder of the system's for temporary files. It goes with all that is in it when this is
/// dropped.
#[derive(Debug)]
pub struct ScratchFolder(TempDir);

impl ScratchFolder {
    /// # Errors
    /// If the system refuses.
    pub fn new() -> Result<Self, Diagnostic> {
        let made = tempfile::tempdir();
        let failed = |error| Diagnostic::new(&std::env::temp_dir(), in_words(&error));
        made.map(Self).map_err(failed)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}
