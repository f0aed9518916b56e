//! `-` as a FILE, for standard input, and as an output, for standard output. Commands say which of their arguments
//! may be that; all else is here.

use super::CliError;
use super::output::print_bytes;
use crate::disk::{self, PIPE, is_pipe, pipe_of, take_standard_input};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// The arguments of a command that are paths of files.
#[derive(Default)]
pub(super) struct Ends<'a> {
    /// Files that are read.
    pub inputs: Vec<&'a mut PathBuf>,
    /// The file that is written, and the extension of what standard output gets; `None` where that has the result.
    pub output: Option<(&'a mut PathBuf, Option<&'static str>)>,
}

/// Puts paths in the place of each `-`, which the command reads and writes as any other.
///
/// # Errors
/// If standard input is to be two files, or standard output has another use: wrong usage. If standard input cannot be
/// read, or the output not be written: its folder must be there.
pub(super) fn connect(ends: Ends) -> Result<(), CliError> {
    let is_named = |path: &Path| path.as_os_str() == PIPE;
    match ends.output {
        Some((output, Some(extension))) if is_named(output) => *output = pipe_of(extension),
        Some((output, None)) if is_named(output) => {
            let message =
                "expected the name of a file to write, found -: standard output has the result";
            return Err(CliError::Usage(message.to_owned()));
        }
        // Before any work is done. Where standard output has the result, it tells this, too.
        Some((output, Some(_))) => disk::expect_place_for(output)?,
        Some((_, None)) | None => {}
    }
    let mut piped = ends.inputs.into_iter().filter(|path| is_named(path));
    if let Some(first) = piped.next() {
        if piped.next().is_some() {
            let message = "expected - once, found it twice: standard input is one file";
            return Err(CliError::Usage(message.to_owned()));
        }
        *first = take_standard_input()?;
    }
    Ok(())
}

/// Writes files that belong together, all or none, or one to standard output.
///
/// # Errors
/// If one cannot be written, or standard output is to be several: then nothing is. And if it is a terminal, but for
/// text.
pub(super) fn write(files: &[(PathBuf, Vec<u8>)]) -> Result<(), CliError> {
    match files {
        [(path, bytes)] if is_pipe(path) => {
            if std::io::stdout().is_terminal() && std::str::from_utf8(bytes).is_err() {
                let message = "expected a pipe or a file for what is no text, found a terminal";
                return Err(CliError::Other(message.to_owned()));
            }
            print_bytes(bytes)
        }
        files if files.iter().any(|(path, _)| is_pipe(path)) => {
            let count = files.len();
            let message =
                format!("expected one file for standard output, found {count}: give -o a name");
            Err(CliError::Usage(message))
        }
        files => Ok(disk::write_all_whole(files)?),
    }
}
