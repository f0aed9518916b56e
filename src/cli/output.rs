use super::CliError;
use crate::disk;
use crate::io::Diagnostic;
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
