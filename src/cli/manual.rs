//! `editor completions` and `editor man`: made from the same source as `--help`.

use super::{Cli, CliError, print};
use clap::CommandFactory;

/// Print the completions of a shell.
///
/// Where they belong differs from system to system; for bash on Debian, for example:
/// editor completions bash > ~/.local/share/bash-completion/completions/editor
#[derive(Debug, clap::Args)]
pub struct CompletionsArgs {
    /// The shell that completes
    shell: clap_complete::Shell,
}

/// Print the manual page, or that of one command, in the format of man.
///
/// To read it: editor man > editor.1 && man ./editor.1
#[derive(Debug, clap::Args)]
pub struct ManArgs {
    /// Command whose page is printed instead of that of the whole program
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

/// Prints the completions.
///
/// # Errors
/// If they cannot be printed.
pub fn completions(args: &CompletionsArgs) -> Result<(), CliError> {
    let mut command = Cli::command();
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, name, &mut script);
    print(&String::from_utf8_lossy(&script))
}

/// Prints the page.
///
/// # Errors
/// If there is no such command, or the page cannot be printed.
pub fn man(args: &ManArgs) -> Result<(), CliError> {
    let mut program = Cli::command();
    program.build();
    let described = match &args.command {
        None => &program,
        Some(name) => program.find_subcommand(name).ok_or_else(|| {
            let known = program
                .get_subcommands()
                .filter(|known| !known.is_hide_set());
            let names: Vec<&str> = known.map(clap::Command::get_name).collect();
            let names = names.join(", ");
            CliError::Usage(format!(
                "expected one of the commands {names}, found {name}"
            ))
        })?,
    };
    let mut page = Vec::new();
    let made = clap_mangen::Man::new(for_manual(described.clone())).render(&mut page);
    made.map_err(|error| CliError::Other(error.to_string()))?;
    // What follows the help of a command are its examples, which a page of man has in a section of that name.
    let page = String::from_utf8_lossy(&page).replace(".SH EXTRA\n", ".SH EXAMPLES\n");
    print(&page)
}

/// A command with the usage of its help, which has the names of values, and examples without their title.
fn for_manual(mut described: clap::Command) -> clap::Command {
    if described.get_overridden_usage().is_none() {
        let usage = described.render_usage().to_string();
        let usage = usage.strip_prefix("Usage: ").unwrap_or(&usage).to_owned();
        described = described.override_usage(usage);
    }
    let examples = described.get_after_help().map(ToString::to_string);
    match examples
        .as_deref()
        .and_then(|all| all.strip_prefix("Examples:\n"))
    {
        Some(examples) => {
            let examples = examples.to_owned();
            described.after_help(examples)
        }
        None => described,
    }
}
