use super::output::tell;
use crate::gpu::GpuError;
use crate::io::Diagnostic;
use crate::program::ProgramError;
use crate::render::{OffscreenError, RenderError};
use std::process::ExitCode;

/// Why a command did not do what it was asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CliError {
    /// An input is wrong or an output cannot be written.
    #[error("{0}")]
    Failed(#[from] Diagnostic),
    /// As before, without a file to name.
    #[error("{0}")]
    Other(String),
    /// The command was used wrongly.
    #[error("{0}")]
    Usage(String),
    /// The command failed and has said why.
    #[error("")]
    Told,
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

impl From<ProgramError> for CliError {
    fn from(error: ProgramError) -> Self {
        Self::Other(error.to_string())
    }
}

impl CliError {
    /// Says on standard error what is wrong.
    pub fn tell(&self) {
        match self {
            Self::Told => {}
            Self::Usage(message) => {
                tell(format_args!("error: {message}"));
                tell("");
                tell("For more information, try '--help'.");
            }
            Self::Failed(_) => tell(format_args!("error: {self}")),
            // What the system says may have several lines.
            Self::Other(_) => format!("error: {self}").lines().for_each(tell),
        }
    }

    /// What the program ends with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Failed(_) | Self::Other(_) | Self::Told => 1,
            Self::Usage(_) => 2,
        })
    }
}
