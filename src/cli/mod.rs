//! The command line, one file a command. Results go to standard output, everything else to
//! standard error; the exit code is 0 when all is done, 1 when an input or a comparison failed,
//! 2 when the command was used wrongly.

pub mod check;
mod error;
pub mod export;
mod load;
mod output;

pub use error::CliError;
pub use load::{files, load};
pub use output::print;

use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;

/// Pose and skin characters, beside the course's editor: hierarchical modeling, skeletal subspace
/// deformation, shapes.
#[derive(Debug, Parser)]
#[command(name = "editor", version, about)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Args),
    Export(export::Args),
}

/// Runs the program with the arguments that it was started with.
pub fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Help that was asked for is a result, all else a mistake; where even that cannot be
            // printed there is nobody to tell.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let done = match cli.command {
        Some(Command::Check(args)) => check::run(&args),
        Some(Command::Export(args)) => export::run(&args),
        None => print(&Cli::command().render_help().to_string()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error.tell();
            error.exit_code()
        }
    }
}
