//! Standard input as a file, which all that reads files can read by its path, and as often as it likes.

use super::{LARGEST, in_words};
use crate::io::{Diagnostic, extension_of};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Name of standard input and standard output on the command line.
pub const PIPE: &str = "-";

/// What came, and the path that it is called by.
static PIPED: OnceLock<(PathBuf, Vec<u8>)> = OnceLock::new();

/// Reads standard input to its end. Returns the path that is its own from now on: `-` with the extension of a file of
/// such content, by which all that opens files knows what it is.
///
/// # Errors
/// If it cannot be read, is empty, or has more than 1 GiB.
pub fn take_standard_input() -> Result<PathBuf, Diagnostic> {
    let mut bytes = Vec::new();
    let mut bounded = std::io::stdin().lock().take(LARGEST + 1);
    let read = bounded.read_to_end(&mut bytes);
    read.map_err(|error| Diagnostic::new(Path::new(PIPE), in_words(&error)))?;
    if bytes.len() as u64 > LARGEST {
        let message = format!("expected at most {} MiB, found more", LARGEST >> 20);
        return Err(Diagnostic::new(Path::new(PIPE), message));
    }
    if bytes.is_empty() {
        let message = "expected a file on standard input, found nothing";
        return Err(Diagnostic::new(Path::new(PIPE), message));
    }
    let (path, _) = PIPED.get_or_init(|| (pipe_of(extension_of(&bytes)), bytes));
    Ok(path.clone())
}

/// The path of standard input or output for a content that has this extension elsewhere.
pub fn pipe_of(extension: &str) -> PathBuf {
    Path::new(PIPE).with_extension(extension)
}

/// Whether `path` is one of [`pipe_of`].
pub fn is_pipe(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| path == pipe_of(&extension.to_string_lossy()))
}

/// The path as the command line has it: `-` for standard input or output.
pub fn as_given(path: &Path) -> std::path::Display<'_> {
    let given = if is_pipe(path) { Path::new(PIPE) } else { path };
    given.display()
}

/// What came through standard input, if that is what `path` is called by.
pub(super) fn piped(path: &Path) -> Option<&'static [u8]> {
    let (known, bytes) = PIPED.get()?;
    (known == path).then_some(bytes)
}
