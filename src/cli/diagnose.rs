//! `editor diagnose`: which mistake in skinning gives a posed mesh.

use super::output::{self, DiagnosticJson, json_text};
use super::{CliError, print};
use crate::character::Character;
use crate::diagnose::{Diagnosis, Verdict, diagnose, may_be_of};
use crate::disk::files;
use crate::io::{
    Diagnostic, Files, Imported, PoseFile, builtin, import_character, read_character_obj,
};
use crate::scene::ShapeKind;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Tell which mistake in skinning another program makes, by a mesh that it posed.
///
/// THEIRS is held against the exact result, and against what each known mistake gives, and each two
/// of them. Prints that it is right, or the mistake that explains it with what to look at in the
/// code, or where it is off.
///
/// Ends with 0 if THEIRS is right, and with 1 otherwise.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor diagnose mine.obj --character Model1.obj --pose walk.json\n  \
    editor diagnose mine.obj --character rig.dae --pose bend.json --json")]
pub struct Args {
    /// The posed mesh that the other program wrote (.obj)
    #[arg(value_name = "THEIRS.obj")]
    theirs: PathBuf,
    /// The character at rest: .obj with .skel and .attach beside it, .skel, .dae, or builtin:NAME
    #[arg(long, value_name = "MODEL")]
    character: PathBuf,
    /// The pose: a file such as {"joints": {"Left elbow": [0, 0, 50]}}
    #[arg(long, value_name = "POSE.json")]
    pose: PathBuf,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// Output of `--json`.
#[derive(Serialize)]
struct Report<'a, R> {
    theirs: String,
    character: String,
    pose: String,
    #[serde(flatten)]
    result: &'a R,
}

/// Output of `--json` if nothing could be diagnosed.
#[derive(Serialize)]
struct Failure {
    verdict: Option<Verdict>,
    failure: DiagnosticJson,
}

/// Carries the command out.
///
/// # Errors
/// If a file is wrong, they do not fit each other, or the mesh is not right.
pub fn run(args: &Args) -> Result<(), CliError> {
    let diagnosis = match diagnosis(args) {
        Ok(diagnosis) => diagnosis,
        Err(diagnostic) => {
            if args.json {
                let failure = Failure {
                    verdict: None,
                    failure: DiagnosticJson::from(&diagnostic),
                };
                print_json(args, &failure)?;
            }
            return Err(diagnostic.into());
        }
    };
    if args.json {
        print_json(args, &diagnosis)?;
    } else {
        print(&format!("{diagnosis}\n"))?;
    }
    if diagnosis.verdict == Verdict::Right {
        Ok(())
    } else {
        Err(CliError::Reported)
    }
}

fn print_json<R: Serialize>(args: &Args, result: &R) -> Result<(), CliError> {
    let report = Report {
        theirs: args.theirs.display().to_string(),
        character: args.character.display().to_string(),
        pose: args.pose.display().to_string(),
        result,
    };
    print(&json_text(&report)?)
}

fn diagnosis(args: &Args) -> Result<Diagnosis, Diagnostic> {
    let files = files();
    let read = read_character_obj(&args.theirs, &files.read(&args.theirs)?)?;
    let theirs = with_warnings(read).positions;
    let character = character_of(&files, &args.character, theirs.len())?;
    let pose = builtin::resolve(&args.pose)?;
    let pose = PoseFile::read(&pose, &files.read(&pose)?)?.pose_of(character.skeleton())?;
    let diagnosed = diagnose(&character, &pose, &theirs);
    diagnosed.map_err(|error| Diagnostic::new(&args.theirs, error.to_string()))
}

/// The character in a file that may have so many vertices, or else the first.
fn character_of(
    files: &dyn Files,
    model: &Path,
    vertices: usize,
) -> Result<Arc<Character>, Diagnostic> {
    let is_part = ["skel", "attach"].map(|part| has_extension(model, part));
    let file = match is_part.contains(&true) {
        true => model.with_extension("obj"),
        false => model.to_owned(),
    };
    let shapes = with_warnings(import_character(files, &file)?).into_iter();
    let mut characters = shapes.filter_map(|shape| match shape.kind {
        ShapeKind::Character(character) => Some(character.character),
        _ => None,
    });
    let no_character = || Diagnostic::new(model, "expected a character, found none");
    let first = characters.next().ok_or_else(no_character)?;
    let fits = |character: &Arc<Character>| may_be_of(character, vertices);
    if fits(&first) {
        return Ok(first);
    }
    Ok(characters.find(fits).unwrap_or(first))
}

fn has_extension(path: &Path, extension: &str) -> bool {
    let own = path.extension();
    own.is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

/// What was read, after its warnings have been printed.
fn with_warnings<T>(imported: Imported<T>) -> T {
    for warning in &imported.warnings {
        output::eprint_line(format_args!("warning: {warning}"));
    }
    imported.value
}
