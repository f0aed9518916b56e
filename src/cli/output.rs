use super::CliError;
use crate::disk;
use crate::io::image::PictureFormat;
use crate::io::{Diagnostic, expect_extension};
use std::fmt::Display;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Prints a result on standard output. A reader that has gone away, as `head` does, is none of
/// our business.
///
/// # Errors
/// If it cannot be written for any other reason.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(CliError::Other(format!(
            "the result cannot be printed: {error}"
        ))),
        _ => Ok(()),
    }
}

/// Says something on standard error, in one line. Where that cannot be written there is nobody to
/// tell.
pub fn tell(what: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{}", visible(&what.to_string()));
}

/// `text` in one line that says what it holds: names in files that were handed in, and names of
/// files, must neither steer the terminal nor look like lines of the program's own.
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

/// The format of the picture to write, by the extension of its name.
///
/// # Errors
/// If it is none that can be written: wrong usage, told before any work is done.
pub fn picture_format(output: &Path) -> Result<PictureFormat, CliError> {
    PictureFormat::of(output).map_err(|error| CliError::Usage(error.to_string()))
}

/// Checks that the name of the mesh to write ends in `.obj`.
///
/// # Errors
/// If it does not: wrong usage, told before any work is done.
pub fn expect_obj(output: &Path) -> Result<(), CliError> {
    expect_extension(output, "obj").map_err(|error| CliError::Usage(error.to_string()))
}

/// Refuses to write over one of the files that are read.
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
