//! `editor grade`: a class graded by tests, with a report.

mod command;
mod interruption;
mod kept;
mod merge;
mod missing;
mod pages;
mod submissions;
mod warnings;
mod work;

use super::output::{eprint_line, json_text, visible};
use super::{CliError, diagnose, print};
use crate::disk::{self, files};
use crate::grade::{Graded, Report, Test};
use crate::io::{
    Diagnostic, Files, NamedFile, PoseFile, Position, TestData, TestsFile, builtin, pose_of_several,
};
use command::TestCommand;
use kept::{KeptRun, Store};
use pages::page_paths;
use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use submissions::{Part, Submission};
use work::Work;

/// Grade a class: what each submission gives for each test, why it is wrong, and its points.
///
/// FOLDER holds a folder for each submission, and each of these a file for each test: TEST.obj, a posed
/// mesh, or TEST.png, a picture. TESTS.json says which tests there are, how points are given, and which command
/// makes the files, if one does. Prints a row for each submission and writes grade.json, grade.csv and
/// grade.html into REPORT, and a page for each submission alone into REPORT/pages. What is graded is kept there: started
/// again, it resumes where it stopped, and only what has changed is graded anew.
///
/// Beside "tests" and "rubric", TESTS.json can have a "command" that makes the files, run in the folder of each
/// submission: {"run": ["./build/pose", "{character}", "{pose}", "{output}"], "seconds": 60, "memory": 1024}, with
/// {test} for the name of the test and memory in MiB.
///
/// In grade.csv, names that a spreadsheet would run as formulas, which start with =, +, - or @, have an apostrophe
/// before them; grade.json has them as they are.
///
/// A mistake costs points in its own section of the assignment, or, where the test has no points for that, in the one
/// with the nearest number, as the result then says. A mesh in the bind pose or another pose
/// than that of its test (pose-not-applied, other-pose) shows none of the sections and gets no points, unless the
/// rubric leaves a share for either; where more than half of the joints are as asked (right-but-for-joints), it costs
/// points in 3.4 alone.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor grade --example > tests.json\n  \
    editor grade submissions --tests tests.json\n  \
    editor grade submissions --tests tests.json --part 2/8 -o part-2\n  \
    editor grade --merge part-1 part-2 -o report")]
pub struct Args {
    /// Folder with a folder for each submission
    #[arg(value_name = "FOLDER", required_unless_present_any = ["merge", "example"])]
    folder: Option<PathBuf>,
    /// Tests, rubric and command
    #[arg(long, value_name = "TESTS.json", required_unless_present_any = ["merge", "example"])]
    tests: Option<PathBuf>,
    /// Folder for the report, which is made if it is not there
    #[arg(short, long, value_name = "REPORT", default_value = "grade-report")]
    output: PathBuf,
    /// Submissions that are graded at a time [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = jobs)]
    jobs: Option<NonZeroUsize>,
    /// Grade the I-th of N parts of the submissions alone, for several machines
    #[arg(long, value_name = "I/N")]
    part: Option<Part>,
    /// Join the reports of parts into one, instead of grading
    #[arg(
        long,
        value_name = "PART",
        num_args = 1..,
        conflicts_with_all = ["folder", "tests", "jobs", "part"]
    )]
    merge: Vec<PathBuf>,
    /// Print an example of TESTS.json, with everything that it can hold but for a command (above), instead of grading
    #[arg(long, conflicts_with_all = ["folder", "tests", "jobs", "part", "merge", "output"])]
    example: bool,
}

fn jobs(text: &str) -> Result<NonZeroUsize, String> {
    let number = text.parse();
    number.map_err(|_| format!("expected a whole number from 1 on, found {text}"))
}

/// What `--example` prints. It is in `docs/grading.md`, too.
const EXAMPLE: &str = include_str!("../../../docs/tests.json");

/// Names of the files of a report.
const JSON: &str = "grade.json";
const CSV: &str = "grade.csv";
const PAGE: &str = "grade.html";

/// Carries the command out. That solutions are wrong is no error.
///
/// # Errors
/// If the tests are wrong, there are no submissions, parts do not fit each other, or the report cannot
/// be written.
pub fn run(args: &Args) -> Result<(), CliError> {
    if args.example {
        return print(EXAMPLE);
    }
    if args.output == Path::new("-") {
        let message = "expected a folder for the report, found - for standard output";
        return Err(Diagnostic::new(&args.output, message).into());
    }
    match (&args.folder, &args.tests) {
        (Some(folder), Some(tests)) => grade(args, folder, tests),
        _ => {
            check_joined(&args.output, &args.merge)?;
            let (run, graded) = merge::joined(&args.merge, &Store::new(&args.output))?;
            report(&args.output, &run, graded)?;
            Ok(())
        }
    }
}

fn grade(args: &Args, folder: &Path, path: &Path) -> Result<(), CliError> {
    let bytes = files().read(path)?;
    let file = TestsFile::read(path, &bytes)?;
    let loaded = file.tests.iter().map(|test| load(test, path));
    let tests: Vec<Test> = loaded.collect::<Result<_, _>>()?;
    let command = file.command.as_ref();
    let command = command.map(|data| TestCommand::new(data, &file.tests, path));
    let command = command.transpose()?;
    let all = submissions::of(folder)?;
    check_output(&args.output, folder, &all)?;
    for warning in warnings::of(&file, &all) {
        eprint_line(format_args!("warning: {}: {warning}", path.display()));
    }
    for test in &tests {
        let unseen = test.unseen();
        if !unseen.is_empty() {
            let (name, unseen) = (visible(&test.data().name), unseen.join(", "));
            eprint_line(format_args!("note: {name} does not show {unseen}"));
        }
    }
    let mine: Vec<_> = match args.part {
        Some(part) => part.of(all),
        None => all,
    };
    let store = Store::new(&args.output);
    let before = store.run().ok();
    check_part(args, before.as_ref())?;
    store.prepare()?;
    let work = Work {
        tests: &tests,
        command,
        store: &store,
        program: work::fingerprint_of_program(),
    };
    let graded = work.all(&mine, args.jobs)?;
    let pictures = tests
        .iter()
        .filter_map(|test| Some((test.data().name.clone(), test.picture()?)));
    let run = KeptRun {
        version: kept::VERSION,
        // Reading it succeeded, so that it is UTF-8.
        tests: String::from_utf8_lossy(&bytes).into_owned(),
        fingerprints: tests
            .iter()
            .map(|test| (test.data().name.clone(), test.fingerprint()))
            .collect(),
        pictures: pictures.collect(),
        submissions: mine
            .iter()
            .map(|submission| submission.name.clone())
            .collect(),
        part: args.part,
    };
    store.keep_run(&run)?;
    let written = report(&args.output, &run, graded)?;
    if let Some(before) = before {
        remove_old_pages(&args.output, &before.submissions, &written);
    }
    Ok(())
}

/// Makes sure that the report of a part replaces none of the class or of another part.
fn check_part(args: &Args, before: Option<&KeptRun>) -> Result<(), Diagnostic> {
    match (args.part, before) {
        (Some(part), Some(before)) if before.part != args.part => {
            let found = match before.part {
                Some(other) => format!("that of part {other}"),
                None => "that of a whole class".to_owned(),
            };
            let message = format!("expected a folder for the report of part {part}, found {found}");
            Err(Diagnostic::new(&args.output, message))
        }
        _ => Ok(()),
    }
}

/// Removes the pages of submissions that were there `before`, so that they are not handed out with those that were
/// `written`.
fn remove_old_pages(folder: &Path, before: &[String], written: &BTreeSet<String>) {
    let before: Vec<&str> = before.iter().map(|name| &**name).collect();
    let old = page_paths(&before).into_iter();
    for page in old.filter(|page| !written.contains(page)) {
        // One that is gone already, or cannot be removed, does no harm.
        let _ = std::fs::remove_file(folder.join(page));
    }
}

/// Makes sure that the report does not come to be a submission, or a submission the folder of a report.
fn check_output(
    output: &Path,
    folder: &Path,
    submissions: &[Submission],
) -> Result<(), Diagnostic> {
    // One that is not there yet is none of them.
    let Ok(output_on_disk) = output.canonicalize() else {
        return Ok(());
    };
    let is_output = |folder: &Path| folder.canonicalize().is_ok_and(|it| it == output_on_disk);
    let wrong = |found: &str| {
        Err(Diagnostic::new(
            output,
            format!("expected a folder for the report, found {found}"),
        ))
    };
    if is_output(folder) {
        return wrong("that of the submissions");
    }
    match submissions
        .iter()
        .find(|submission| is_output(&submission.folder))
    {
        Some(_) => wrong("a submission"),
        None => Ok(()),
    }
}

/// Makes sure that the report that joins `parts` replaces none of them.
fn check_joined(output: &Path, parts: &[PathBuf]) -> Result<(), Diagnostic> {
    if parts.iter().any(|part| disk::is_same_file(part, output)) {
        let message = "expected another folder for the report than those of parts";
        return Err(Diagnostic::new(output, message));
    }
    Ok(())
}

/// The test with its character and pose, whose paths start at the folder of the file of tests.
fn load(test: &TestData, tests: &Path) -> Result<Test, CliError> {
    let files = files();
    let character = found_beside(tests, &test.character, "a character")?;
    let characters = diagnose::characters(&files, &character)?;
    let [only] = &characters[..] else {
        let message = format!("expected one character, found {}", characters.len());
        return Err(Diagnostic::new(&character, message).into());
    };
    let pose = PoseFile::open(&files, &found_beside(tests, &test.pose, "a pose")?)?;
    let pose = pose.pose_of(only.skeleton())?;
    Ok(Test::new(test.clone(), only.clone(), pose))
}

/// The path of a file that a test names, which is `what`.
///
/// # Errors
/// If it is not there, at its place in the file of tests.
fn found_beside(tests: &Path, named: &NamedFile, what: &str) -> Result<PathBuf, Diagnostic> {
    let path = beside(tests, &named.path);
    let is_builtin = path.to_string_lossy().starts_with(builtin::PREFIX);
    let files = files();
    if is_builtin || files.exists(&path) || pose_of_several(&files, &path).is_some() {
        return Ok(path);
    }
    let found = path.display();
    let message = format!("expected the file of {what}, found none at {found}");
    let Position { line, column } = named.at;
    Err(Diagnostic::at(tests, line, column, message))
}

/// `path` as seen from the folder of `file`, unless it is built in.
fn beside(file: &Path, path: &Path) -> PathBuf {
    if path.to_string_lossy().starts_with(builtin::PREFIX) {
        path.to_owned()
    } else {
        file.parent().unwrap_or(Path::new("")).join(path)
    }
}

/// Writes the report and prints its rows; the paths of the pages of single submissions.
fn report(
    folder: &Path,
    run: &KeptRun,
    graded: BTreeMap<String, Vec<Graded>>,
) -> Result<BTreeSet<String>, CliError> {
    let file = TestsFile::read(Path::new("TESTS.json"), run.tests.as_bytes())?;
    let graded = graded.into_iter().collect();
    let report = Report::new(&file, &run.pictures, graded, page_paths);
    let mut written = vec![
        (folder.join(JSON), json_text(&report)?.into_bytes()),
        (folder.join(CSV), report.to_csv().into_bytes()),
        (folder.join(PAGE), report.to_html().into_bytes()),
    ];
    let mut pages = BTreeSet::new();
    for (path, page) in report.to_pages() {
        written.push((folder.join(path), page.into_bytes()));
        pages.insert(path.to_owned());
    }
    let paths = written.iter().map(|(path, _)| path.as_path());
    disk::in_new_folders(paths, || disk::write_all_whole(&written))?;
    let rows = report
        .to_lines()
        .iter()
        .map(|line| visible(line) + "\n")
        .collect::<String>();
    print(&rows)?;
    eprint_line(format_args!(
        "the report is in {}",
        folder.join(PAGE).display()
    ));
    Ok(pages)
}
