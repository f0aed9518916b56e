//! The command line, one file per command. Results go to standard output, everything else to
//! standard error; the exit code is 0 when all is done, 1 when an input or a comparison failed, 2
//! when the command was used wrongly.

mod arguments;
pub mod check;
mod colors;
pub mod compare;
pub mod diagnose;
pub mod doctor;
pub mod export;
pub mod grade;
pub mod manual;
mod output;
mod pipes;
pub mod render;
mod render_ui;
pub mod submit;
mod turntable;

pub use arguments::SkinningName;
pub use output::{CliError, print};

use crate::io::builtin;
use clap::{CommandFactory, Parser, Subcommand};
use pipes::Ends;
use std::path::PathBuf;
use std::process::ExitCode;

/// Pose and skin characters, beside the course's editor: hierarchical modeling, skeletal subspace
/// deformation, shapes.
///
/// Of commands one FILE, or POSE.json, may be - for standard input; what it is follows from its content. -o - writes to
/// standard output, which then has nothing else: a PNG (with --turntable a GIF), an .obj, a .zip. A folder that a file
/// is to be written into must be there; the one of a report is made.
#[derive(Debug, Parser)]
#[command(
    name = "editor",
    version,
    about,
    args_conflicts_with_subcommands = true,
    override_usage = "editor [FILE]... [--title TEXT] [--skinning cpu|gpu]\n       editor COMMAND ..."
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    window: WindowArgs,
}

/// Arguments of the window.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct WindowArgs {
    /// Scenes to open (.scene, .zip), files to import (.obj, .dae, .swp), or builtin:NAME
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Text in the window's title after the names of the document and the program, such as your name
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Processor that deforms characters, for this time [default: as in View ▸ Skinning]
    #[arg(long)]
    pub skinning: Option<SkinningName>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Args),
    Compare(compare::Args),
    Diagnose(diagnose::Args),
    Export(export::Args),
    Grade(grade::Args),
    Render(render::Args),
    Submit(submit::Args),
    Doctor(doctor::Args),
    Completions(manual::CompletionsArgs),
    Man(manual::ManArgs),
}

impl Command {
    /// Carries the command out.
    fn run(mut self) -> Result<(), CliError> {
        pipes::connect(self.ends())?;
        match &self {
            Self::Check(args) => check::run(args),
            Self::Compare(args) => compare::run(args),
            Self::Diagnose(args) => diagnose::run(args),
            Self::Export(args) => export::run(args),
            Self::Grade(args) => grade::run(args),
            Self::Render(args) => render::run(args),
            Self::Submit(args) => submit::run(args),
            Self::Doctor(args) => doctor::run(args),
            Self::Completions(args) => manual::completions(args),
            Self::Man(args) => manual::man(args),
        }
    }

    /// Its arguments that may be standard input or output.
    fn ends(&mut self) -> Ends<'_> {
        match self {
            Self::Check(args) => args.ends(),
            Self::Compare(args) => args.ends(),
            Self::Diagnose(args) => args.ends(),
            Self::Export(args) => args.ends(),
            Self::Render(args) => args.ends(),
            Self::Submit(args) => args.ends(),
            Self::Grade(_) | Self::Doctor(_) | Self::Completions(_) | Self::Man(_) => {
                Ends::default()
            }
        }
    }
}

/// Runs the program with the arguments that it was started with. Without a command it calls
/// `open_window`, which returns a message if it fails.
pub fn run(open_window: impl FnOnce(WindowArgs) -> Result<(), String>) -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // What options are wrong of a command that is none is not worth telling.
            let first = std::env::args_os().nth(1).map(PathBuf::from);
            if let Some(error) = unknown(first.as_slice()) {
                error.report();
                return error.exit_code();
            }
            // Help that was asked for is a result, all else an error; if even that cannot be
            // printed, there is nowhere left to report it.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let done = match cli.command {
        Some(command) => command.run(),
        None => match unknown(&cli.window.files) {
            Some(error) => Err(error),
            None => open_window(cli.window).map_err(CliError::Other),
        },
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error.report();
            error.exit_code()
        }
    }
}

/// Error for a word that does not look like a file, and does not exist: it was meant as a command.
fn unknown(files: &[PathBuf]) -> Option<CliError> {
    let commands = Cli::command();
    let word = files.iter().find(|file| {
        let text = file.to_string_lossy();
        let is_command = text == "help" || commands.find_subcommand(&*text).is_some();
        file.components().count() == 1
            && file.extension().is_none()
            && !text.starts_with(builtin::PREFIX)
            && !text.starts_with('-')
            && !is_command
            && !file.exists()
    })?;
    let text = word.to_string_lossy();
    let names = commands.get_subcommands().map(clap::Command::get_name);
    let distances = names.map(|name| (strsim::osa_distance(name, &text), name));
    let meant = match distances.min() {
        Some((distance, name)) if distance * 3 <= name.len() => format!("; did you mean {name}?"),
        _ => String::new(),
    };
    Some(CliError::Usage(format!(
        "there is neither a command nor a file called {text}{meant}"
    )))
}
