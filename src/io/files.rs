use super::Diagnostic;
use std::path::Path;

/// Where importers get bytes from. The program hands in the disk, tests a table in memory; the
/// importers themselves never touch the file system.
pub trait Files {
    /// The whole content of `path`.
    ///
    /// # Errors
    /// If there is no such file or it cannot be read; the message says which, in plain words.
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic>;

    /// Whether `path` is a file.
    fn exists(&self, path: &Path) -> bool;
}
