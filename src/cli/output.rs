use super::CliError;
use std::io::{ErrorKind, Write};

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
