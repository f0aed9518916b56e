//! Output of the commands: results, errors and warnings, and the files they write.

use crate::disk;
use crate::gpu::GpuError;
use crate::io::Diagnostic;
use crate::io::image::PictureFormat;
use crate::program::ProgramError;
use crate::render::{OffscreenError, RenderError};
use serde::Serialize;
use std::fmt::Display;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Reason why a command failed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CliError {
    /// An input is wrong, or an output cannot be written.
    #[error("{0}")]
    Failed(#[from] Diagnostic),
    /// The same, without a file to name.
    #[error("{0}")]
    Other(String),
    /// The command was used wrongly.
    #[error("{0}")]
    Usage(String),
    /// The command failed, and the reason has been printed.
    #[error("")]
    Reported,
}

impl From<OffscreenError> for CliError {
    fn from(error: OffscreenError) -> Self {
        Self::Other(error.to_string())
    }
}

impl From<GpuError> for CliError {
    fn from(error: GpuError) -> Self {
        Self::Other(error.to_string())
    }
}

impl From<RenderError> for CliError {
    fn from(error: RenderError) -> Self {
        Self::Other(error.to_string())
    }
}

impl From<String> for CliError {
    fn from(message: String) -> Self {
        Self::Other(message)
    }
}

impl From<ProgramError> for CliError {
    fn from(error: ProgramError) -> Self {
        Self::Other(error.to_string())
    }
}

impl CliError {
    /// Prints the error on standard error.
    pub fn report(&self) {
        match self {
            Self::Reported => {}
            Self::Usage(message) => {
                eprint_line(format_args!("error: {message}"));
                eprint_line("");
                eprint_line("For more information, try '--help'.");
            }
            Self::Failed(_) => eprint_line(format_args!("error: {self}")),
            // Messages of the system may have several lines.
            Self::Other(_) => format!("error: {self}").lines().for_each(eprint_line),
        }
    }

    /// Exit code of the program.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Failed(_) | Self::Other(_) | Self::Reported => 1,
            Self::Usage(_) => 2,
        })
    }
}

/// Error or warning as `--json` prints it: the position in fields of its own, so that scripts need
/// not parse a sentence.
#[derive(Debug, Serialize)]
pub struct DiagnosticJson {
    /// Path of the file; `None` if no single file is at fault.
    pub file: Option<String>,
    /// Line, counted from 1; `None` for the file as a whole.
    pub line: Option<usize>,
    /// Column, counted from 1; `None` for the file as a whole.
    pub column: Option<usize>,
    /// Message without the position.
    pub message: String,
    /// Path, position and message in one line, for people.
    #[serde(skip)]
    pub in_words: String,
}

impl DiagnosticJson {
    /// An error without a file to name.
    pub fn without_file(message: String) -> Self {
        Self {
            file: None,
            line: None,
            column: None,
            in_words: message.clone(),
            message,
        }
    }
}

impl From<&Diagnostic> for DiagnosticJson {
    fn from(diagnostic: &Diagnostic) -> Self {
        Self {
            file: Some(diagnostic.path.display().to_string()),
            line: diagnostic.position.map(|position| position.line),
            column: diagnostic.position.map(|position| position.column),
            message: diagnostic.message.clone(),
            in_words: diagnostic.to_string(),
        }
    }
}

/// Prints a result on standard output. It is no error if the reader has closed the pipe, as `head`
/// does.
///
/// # Errors
/// If it cannot be written for any other reason.
pub fn print(text: &str) -> Result<(), CliError> {
    print_bytes(text.as_bytes())
}

/// As [`print`], of what need not be text.
///
/// # Errors
/// As [`print`].
pub(super) fn print_bytes(bytes: &[u8]) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(CliError::Other(format!(
            "the result cannot be printed: {}",
            disk::in_words(&error)
        ))),
        _ => Ok(()),
    }
}

/// `value` as JSON, over several lines.
///
/// # Errors
/// If it has no form in JSON.
pub fn json_text(value: &impl Serialize) -> Result<String, CliError> {
    let json = serde_json::to_string_pretty(value);
    Ok(json.map_err(|error| CliError::Other(error.to_string()))? + "\n")
}

/// Prints one line on standard error. If that fails, there is nowhere left to report it.
pub fn eprint_line(what: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{}", visible(&what.to_string()));
}

/// Progress of long work in one line on standard error, if that is a terminal. The line goes when
/// this is dropped.
#[derive(Debug)]
pub struct Progress {
    is_shown: bool,
}

impl Progress {
    pub fn new() -> Self {
        Self {
            is_shown: std::io::stderr().is_terminal(),
        }
    }

    /// Shows `what` in place of what was shown before.
    pub fn show(&self, what: impl Display) {
        if self.is_shown {
            // If that fails, there is nowhere left to report it.
            let _ = write!(std::io::stderr().lock(), "\r\x1b[K{what}");
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.show("");
    }
}

/// `text` in one line, with control characters escaped: names from files, and of files, must
/// neither control the terminal nor look like lines of the program.
pub fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        let turns_writing_round = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        let ends_a_line = matches!(c, '\u{2028}' | '\u{2029}');
        if c.is_control() || turns_writing_round || ends_a_line {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    shown
}

/// Format of the picture to write, by the extension of its path.
///
/// # Errors
/// If it is none that can be written: wrong usage, reported before any work is done.
pub fn picture_format(output: &Path) -> Result<PictureFormat, CliError> {
    PictureFormat::of(output).map_err(|error| CliError::Usage(error.to_string()))
}

/// Refuses to overwrite one of the files that are read.
///
/// # Errors
/// If `output` is one of `inputs`.
pub fn refuse_input(output: &Path, inputs: &[PathBuf]) -> Result<(), CliError> {
    if inputs.iter().any(|input| disk::is_same_file(input, output)) {
        let message = "expected another file to write than the one that is read";
        return Err(Diagnostic::new(output, message).into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_ends_a_line_or_turns_writing_round_is_shown_as_its_number() {
        assert_eq!(visible("a\u{2028}b\u{202e}"), "a\\u{2028}b\\u{202e}");
    }
}
