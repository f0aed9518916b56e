//! `editor submit`: everything that the course's assignment wants to be handed in, as one archive.

mod answers;
mod archive;
mod picture;
mod project;

use super::output::{eprint_line, refuse_input};
use super::pipes::{self, Ends};
use super::{CliError, print};
use crate::disk::{self, Disk, plain_name};
use crate::io::{Diagnostic, Files};
use crate::program::globals;
use answers::Answers;
use archive::{Entry, Format};
use std::collections::BTreeSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Make an archive of everything that the assignment wants to be handed in.
///
/// The project is one like this program's own, with Cargo.toml and Cargo.lock.
///
/// It holds the project's files, the program, README.txt with the answers to the assignment's
/// questions, a picture, and the data. What .gitignore names is left out, as are .git, target and
/// files of macOS (._*). Answers that are missing are asked for on a terminal, and kept in answers.md
/// where that ends before all are given.
#[derive(Debug, clap::Args)]
#[command(
    group = clap::ArgGroup::new("shown").required(true),
    after_help = "Examples:\n  \
    editor submit --name \"Ada Lovelace\" --scene two.scene\n  \
    editor submit --answers answers.md --picture two.png -o hw2.tar.gz\n  \
    editor submit --form > answers.md"
)]
pub struct Args {
    /// The archive to write, .zip or .tar.gz, or - for standard output; its folder must be there [default:
    /// submission-NAME.zip]
    #[arg(short, long, value_name = "ARCHIVE")]
    output: Option<PathBuf>,
    /// Your name [default: as in the answers, or in src/program/globals.rs]
    #[arg(long)]
    name: Option<String>,
    /// Answers to the questions, each below a heading as --form prints it [default: the README.txt
    /// of the project, if there is one]
    #[arg(long, value_name = "FILE")]
    answers: Option<PathBuf>,
    /// Scene with two posed characters to draw the picture of; it is put into the archive with its
    /// models
    #[arg(long, value_name = "FILE", group = "shown")]
    scene: Option<PathBuf>,
    /// Picture of two posed characters (.png, .jpg, .gif)
    #[arg(long, value_name = "PICTURE", group = "shown")]
    picture: Option<PathBuf>,
    /// Folder of the project
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    project: PathBuf,
    /// Program to hand in [default: this one, or of another project than the editor's its target/release/NAME]
    #[arg(long, value_name = "FILE")]
    executable: Option<PathBuf>,
    /// Print the questions, to be answered in a file, and do nothing else
    #[arg(long, group = "shown")]
    form: bool,
}

/// Name of the README in the archive and in the project.
const README: &str = "README.txt";
/// Name of the program in the archive.
const PROGRAM: &str = "editor";

impl Args {
    /// What may be standard input or output.
    pub(in crate::cli) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: Vec::new(),
            output: self.output.as_mut().map(|output| (output, Some("zip"))),
        }
    }
}

/// Carries the command out.
///
/// # Errors
/// If an answer, a file or a posed character is missing, or the archive cannot be written; then
/// there is none.
pub fn run(args: &Args) -> Result<(), CliError> {
    if args.form {
        return print(&Answers::default().readme(&[]));
    }
    if let Some(output) = &args.output {
        format_of(output)?;
    }
    project::check(&args.project)?;
    // The picture comes next, since nothing need be asked if that is refused.
    let shown = match (&args.scene, &args.picture) {
        (Some(scene), _) => picture::of_scene(scene)?,
        (_, Some(file)) => picture::of_file(file)?,
        // Ruled out by the group of the arguments.
        (None, None) => Vec::new(),
    };
    let own: Vec<PathBuf> = [&args.answers, &args.output]
        .into_iter()
        .flatten()
        .cloned()
        .collect();
    let mut entries = project::files(&args.project, &own)?;
    let package = project::package(&args.project).filter(|name| name != PROGRAM);
    let executable = executable(args, package.as_deref())?;
    warn_if_older(&executable, &entries);
    let answers = complete_answers(args)?;

    let submission = format!("submission-{}", plain_name(answers.name()));
    let output = match &args.output {
        Some(output) => output.clone(),
        None => PathBuf::from(format!("{submission}.zip")),
    };
    let (format, mut root) = format_of(&output)?;
    if disk::is_pipe(&output) {
        root = submission;
    }
    let inputs = [&args.scene, &args.picture, &args.answers];
    let inputs = inputs.into_iter().flatten().chain([&executable]);
    refuse_input(&output, &inputs.cloned().collect::<Vec<_>>())?;

    let name = program_name(package.as_deref());
    let program = Entry {
        is_executable: true,
        ..Entry::new(&name, Disk.read(&executable)?)
    };
    entries.retain(|entry| {
        let is_readme = entry.path == Path::new(README);
        let mut made = shown.iter().chain([&program]);
        !is_readme && made.all(|made| made.path != entry.path)
    });
    let readme = answers
        .readme(&contents(&entries, &name, &shown))
        .into_bytes();
    let mut made = vec![program, Entry::new(README, readme)];
    made.extend(shown);
    let parts = parts(&entries, &made);
    entries.extend(made);
    let archive = format.pack(&root, &entries);
    let archive = archive.map_err(|error| Diagnostic::new(&output, disk::in_words(&error)))?;
    let summary = summary(&output, archive.len(), &parts);
    let to_file = !disk::is_pipe(&output);
    pipes::write(&[(output, archive)])?;
    if to_file {
        return print(&summary);
    }
    summary.lines().for_each(eprint_line);
    Ok(())
}

fn format_of(output: &Path) -> Result<(Format, String), CliError> {
    Format::of(output).ok_or_else(|| {
        let output = output.display();
        CliError::Usage(format!(
            "expected a name that ends in .zip or .tar.gz, found {output}"
        ))
    })
}

/// Name of the program in the archive, of a project that is another `package`.
fn program_name(package: Option<&str>) -> String {
    let name = package.unwrap_or(PROGRAM);
    format!("{name}{}", std::env::consts::EXE_SUFFIX)
}

/// The program to hand in: this one, or of a project that is another `package` the one that is built there.
fn executable(args: &Args, package: Option<&str>) -> Result<PathBuf, CliError> {
    match (&args.executable, package) {
        (Some(executable), _) => Ok(executable.clone()),
        (None, Some(package)) => {
            let built = Path::new("target/release").join(program_name(Some(package)));
            let built = args.project.join(built);
            if built.is_file() {
                return Ok(built);
            }
            let message = "expected the program of the project, found none: build it with cargo build --release, or \
                           name another with --executable";
            Err(Diagnostic::new(&built, message).into())
        }
        (None, None) => std::env::current_exe().map_err(|error| {
            let reason = disk::in_words(&error);
            CliError::Other(format!("the program does not find its own file: {reason}"))
        }),
    }
}

/// Says so if a source has changed since the program was built.
fn warn_if_older(executable: &Path, entries: &[Entry]) {
    let Ok(built) = std::fs::metadata(executable).and_then(|found| found.modified()) else {
        return;
    };
    let is_built_in = |entry: &&Entry| {
        let folders = ["src", "shaders", "assets"];
        folders.iter().any(|folder| entry.path.starts_with(folder))
    };
    let mut sources = entries.iter().filter(is_built_in);
    if let Some(newer) = sources.find(|entry| entry.modified > built) {
        let (newer, executable) = (newer.path.display(), executable.display());
        let has_makefile = entries
            .iter()
            .any(|entry| entry.path == Path::new("Makefile"));
        let build = if has_makefile {
            "make"
        } else {
            "cargo build --release"
        };
        eprint_line(format_args!(
            "warning: {newer} is newer than the program {executable}: build it anew with {build}"
        ));
    }
}

/// The answers of the file and the options, and of the terminal where that is one.
fn complete_answers(args: &Args) -> Result<Answers, CliError> {
    let of_project = || Some(args.project.join(README)).filter(|readme| readme.is_file());
    let file = args.answers.clone().or_else(of_project);
    let mut answers = match &file {
        Some(file) => Answers::read(file, &Disk.read(file)?)?,
        None => Answers::default(),
    };
    let of_program = globals::student_name();
    if of_program.is_none() && args.project.join("src/program/globals.rs").is_file() {
        eprint_line(
            "note: the title of the window shows no name yet: put yours into \
             src/program/globals.rs and build the program anew",
        );
    }
    match (&args.name, of_program) {
        (Some(name), _) => answers.set_name(name),
        (None, Some(name)) if answers.name().is_empty() => answers.set_name(name),
        _ => {}
    }
    let missing = answers.missing();
    if missing.is_empty() {
        return Ok(answers);
    }
    if std::io::stdin().is_terminal() && std::io::stderr().is_terminal() {
        let asked = answers.ask(&mut std::io::stdin().lock(), &mut std::io::stderr().lock());
        return match asked {
            Ok(()) => Ok(answers),
            Err(_) => Err(CliError::Other(ended(&answers, Path::new("")))),
        };
    }
    let keys: Vec<&str> = missing.iter().map(|question| question.key).collect();
    let keys = keys.join(", ");
    Err(match file {
        Some(file) => {
            let headings = missing
                .iter()
                .map(|question| format!(" {}: {}", question.key, question.text));
            let headings: String = headings.collect();
            let message =
                format!("expected an answer below each heading, found none below:{headings}");
            Diagnostic::new(&file, message).into()
        }
        None => CliError::Other(format!(
            "there is no answer for: {keys}; write the answers into a form (editor submit --form \
             > answers.md) and name it with --answers, or start the command on a terminal"
        )),
    })
}

/// What is said where the questions are left before all are answered. What was answered is kept in `folder`.
fn ended(answers: &Answers, folder: &Path) -> String {
    const ENDED: &str = "not all questions were answered";
    if *answers == Answers::default() {
        return ENDED.to_owned();
    }
    match answers.keep(folder) {
        Ok(name) => format!("{ENDED}; those that were are in {name}: go on with --answers {name}"),
        Err(error) => format!("{ENDED}, and those that were are lost: {error}"),
    }
}

/// Lines of the README about what is in the archive: the files of the `project`, the program and what is `shown`.
fn contents(project: &[Entry], program: &str, shown: &[Entry]) -> Vec<String> {
    let first = |entry: &Entry| {
        let first = entry.path.components().next()?;
        Some(first.as_os_str().to_string_lossy().into_owned())
    };
    let code: BTreeSet<String> = project.iter().filter_map(first).collect();
    let more = match code.contains("README.md") {
        true => "; README.md says more about it",
        false => "",
    };
    let code = code.into_iter().filter(|name| !name.starts_with('.'));
    let code: Vec<String> = code.collect();
    let mut lines = vec![
        format!("{}: the code{more}", code.join(", ")),
        format!("{program}: the program"),
    ];
    lines.extend(shown.iter().map(|entry| {
        let path = entry.path.to_string_lossy().replace('\\', "/");
        match entry.path.starts_with("data") {
            true => format!("{path}: the scene of the picture and its models, to be opened"),
            false => format!("{path}: two posed characters"),
        }
    }));
    lines
}

/// Parts of the archive and their sizes in bytes: the files of the project together, what was
/// `made` one by one.
fn parts(project: &[Entry], made: &[Entry]) -> Vec<(String, usize)> {
    let sizes = project.iter().map(|entry| entry.bytes.len());
    let project = (
        format!("{} files of the project", project.len()),
        sizes.sum(),
    );
    let made = made.iter();
    let made = made.map(|entry| (entry.path.display().to_string(), entry.bytes.len()));
    std::iter::once(project).chain(made).collect()
}

/// What was written, part by part.
fn summary(output: &Path, bytes: usize, parts: &[(String, usize)]) -> String {
    let mib = |bytes: usize| format!("{:8.2} MiB", bytes as f64 / f64::from(1 << 20));
    let mut text = format!("{}  {}\n", mib(bytes), output.display());
    for (part, bytes) in parts {
        text.push_str(&format!("{}    {part}\n", mib(*bytes)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_that_are_not_complete_are_kept_in_a_new_file() {
        let folder = tempfile::tempdir().unwrap();
        let mut answers = Answers::default();
        let nothing = "not all questions were answered";
        assert_eq!(ended(&answers, folder.path()), nothing);
        answers.set_name("Ada");
        for name in ["answers.md", "answers-2.md"] {
            let expected =
                format!("{nothing}; those that were are in {name}: go on with --answers {name}");
            assert_eq!(ended(&answers, folder.path()), expected);
            let path = folder.path().join(name);
            let kept = std::fs::read(&path).unwrap();
            assert_eq!(Answers::read(&path, &kept), Ok(answers.clone()));
        }
        let lost = ended(&answers, &folder.path().join("none"));
        assert!(
            lost.starts_with(&format!("{nothing}, and those that were are lost: ")),
            "{lost}"
        );
    }
}
