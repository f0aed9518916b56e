use super::Diagnostic;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Where importers get bytes from. The program hands in the disk, tests a table in memory; the
/// importers themselves never touch the file system. A job may take them to another thread.
pub trait Files: Send + Sync {
    /// The whole content of `path`.
    ///
    /// # Errors
    /// If there is no such file or it cannot be read; the message says which, in plain words.
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic>;

    /// Whether `path` is a file.
    fn exists(&self, path: &Path) -> bool;

    /// The path that means the same file whatever the current folder is, for shapes to remember
    /// where they came from.
    fn absolute(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    /// The one path for all ways that lead to a file, by links as well, whether it is there or not.
    fn real(&self, path: &Path) -> PathBuf {
        super::normal(&self.absolute(path))
    }
}

/// Files in memory, by path.
impl Files for HashMap<PathBuf, Vec<u8>> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        self.get(path)
            .cloned()
            .ok_or_else(|| Diagnostic::new(path, "there is no such file"))
    }

    fn exists(&self, path: &Path) -> bool {
        self.contains_key(path)
    }
}

/// The extension of `path` in lower case, empty if there is none.
pub fn extension(path: &Path) -> String {
    path.extension()
        .map(|extension| extension.to_string_lossy().to_lowercase())
        .unwrap_or_default()
}

/// Whether the name of a file is that of a scene.
pub fn is_scene(path: &Path) -> bool {
    extension(path) == "scene"
}

/// Whether the name of a file is that of an archive, in which a scene or models have their files with them.
pub fn is_archive(path: &Path) -> bool {
    extension(path) == "zip"
}

/// Whether a file of this name holds what macOS notes about the file of the same name without `._`.
pub(super) fn is_note_of_macos(name: &std::ffi::OsStr) -> bool {
    name.to_string_lossy().starts_with("._")
}

/// A relative path with forward slashes.
pub(super) fn with_slashes(path: &Path) -> String {
    let parts = path.iter().map(|part| part.to_string_lossy());
    parts.collect::<Vec<_>>().join("/")
}

/// Checks that the name of a file to write ends in `.extension`, so that it can be read again.
///
/// # Errors
/// If it does not.
pub fn expect_extension(path: &Path, expected: &str) -> Result<(), Diagnostic> {
    if extension(path) == expected {
        Ok(())
    } else {
        let message = format!("expected a name that ends in .{expected}");
        Err(Diagnostic::new(path, message))
    }
}

/// An extension as a message shows it.
pub(super) fn shown_extension(extension: &str) -> String {
    if extension.is_empty() {
        "none".to_owned()
    } else {
        format!(".{extension}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_name_that_can_be_read_again_is_written_to() {
        assert!(expect_extension(Path::new("a.SWP"), "swp").is_ok());
        for name in ["a", "a.obj", ".swp"] {
            let error = expect_extension(Path::new(name), "swp").unwrap_err();
            assert_eq!(error.message, "expected a name that ends in .swp");
        }
    }
}
