//! `editor diagnose`: which mistake in skinning gives a posed mesh, or a picture of it.

use super::compare::{is_mesh, picture_or_mesh};
use super::output::{self, DiagnosticJson, json_text};
use super::pipes::Ends;
use super::{CliError, arguments, print};
use crate::character::{Character, Pose};
use crate::diagnose::{
    Diagnosis, NoNumbers, PictureDiagnosis, ToldFor, Verdict, diagnose, diagnose_picture, may_be_of,
};
use crate::disk::{as_given, files};
use crate::io::{
    Diagnostic, Files, Imported, PoseFile, import_character, in_utf8, read_posed_vertices,
};
use crate::scene::ShapeKind;
use serde::Serialize;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Tell which mistake in skinning another program makes, by a mesh that it posed or a picture of it.
///
/// THEIRS is held against the exact result, then against what each known mistake gives, and then
/// against what each two of them give together. Prints that it is right, or the mistakes that explain
/// it with what to look at in the code, or where it is off. Of a picture silhouettes decide: it shows
/// the character alone, before a background of one color, seen with the window's first camera unless
/// another is given.
///
/// The verdict of --json is one of right, triangles (the exact vertices with triangles that are missing, others or
/// turned), explained (by known mistakes), other-pose (the exact result of another pose) and unexplained; of a picture
/// right, explained or unexplained.
///
/// Ends with 0 if it is right, and with 1 otherwise; so it does where a file is wrong or missing, as by a misspelled
/// name. Then nothing is on standard output and "error:" on standard error, or with --json the verdict is null.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor diagnose mine.obj --character Model1.obj --pose walk.json\n  \
    editor diagnose mine.obj --character rig.dae --pose bend.json --json\n  \
    editor diagnose mine.png --character Model1.obj --pose walk.json --view +x")]
pub struct Args {
    /// What the other program gives: the posed mesh (.obj, or .txt), of which the vertices (v lines) are enough, or a
    /// picture of it (.png, .jpg, .gif); - for standard input
    #[arg(value_name = "THEIRS")]
    theirs: PathBuf,
    /// The character at rest: .obj with .skel and .attach beside it, .skel, .dae, or builtin:NAME
    #[arg(long, value_name = "MODEL")]
    character: PathBuf,
    /// The pose: builtin:NAME, a file such as {"joints": {"Left elbow": [0, 0, 50]}}, or POSES.json#NAME of a file
    /// with several
    #[arg(long, value_name = "POSE.json")]
    pose: PathBuf,
    #[command(flatten)]
    camera: arguments::CameraArgs,
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

impl Args {
    /// What may be standard input or output.
    pub(super) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: vec![&mut self.theirs, &mut self.pose],
            output: None,
        }
    }
}

/// Carries the command out.
///
/// # Errors
/// If a file is wrong, they do not fit each other, or the mesh is not right.
pub fn run(args: &Args) -> Result<(), CliError> {
    let program = ToldFor::of_file(Some(&args.character.to_string_lossy()));
    if is_mesh(&args.theirs) {
        if args.camera.chosen().is_some() {
            let message = "--camera and --view are for pictures, found a mesh";
            return Err(CliError::Usage(message.to_owned()));
        }
        let found = of_mesh(args).map(|found| found.told_for(program));
        report(args, found, Diagnosis::is_right)
    } else {
        let found = of_picture(args).map(|found| found.told_for(program));
        report(args, found, |found| found.verdict == Verdict::Right)
    }
}

/// Prints the result; of a mesh or picture that is not right it is an error that has been reported.
fn report<R: Serialize + Display>(
    args: &Args,
    found: Result<R, Diagnostic>,
    is_right: impl Fn(&R) -> bool,
) -> Result<(), CliError> {
    let found = match found {
        Ok(found) => found,
        Err(diagnostic) => {
            if args.json {
                let failure = DiagnosticJson::from(&diagnostic);
                let verdict = None;
                print_json(args, &Failure { verdict, failure })?;
            }
            return Err(diagnostic.into());
        }
    };
    if args.json {
        print_json(args, &found)?;
    } else {
        print(&format!("{found}\n"))?;
    }
    match is_right(&found) {
        true => Ok(()),
        false => Err(CliError::Reported),
    }
}

fn print_json<R: Serialize>(args: &Args, result: &R) -> Result<(), CliError> {
    let report = Report {
        theirs: as_given(&args.theirs).to_string(),
        character: as_given(&args.character).to_string(),
        pose: as_given(&args.pose).to_string(),
        result,
    };
    print(&json_text(&report)?)
}

fn of_mesh(args: &Args) -> Result<Diagnosis, Diagnostic> {
    let files = files();
    let bytes = files.read(&args.theirs)?;
    let characters = characters(&files, &args.character)?;
    let no_numbers = NoNumbers::among_numbers(&in_utf8(&bytes));
    let readable = no_numbers.as_ref().map_or(&bytes, |found| &found.without);
    let as_of = |character: &Arc<Character>| {
        read_posed_vertices(&args.theirs, readable, character.bind_mesh())
    };
    let read = characters
        .iter()
        .find_map(|character| as_of(character).ok());
    let theirs = with_warnings(read.map_or_else(|| as_of(&characters[0]), Ok)?);
    let fits = |character: &&Arc<Character>| may_be_of(character, theirs.positions.len());
    // If none fits, the numbers of the first are told.
    let character = characters.iter().find(fits).unwrap_or(&characters[0]);
    let pose = pose(args, &files, character)?;
    let found = diagnose(character, &pose, &theirs)
        .map_err(|error| Diagnostic::new(&args.theirs, error.to_string()))?;
    let Some(no_numbers) = no_numbers else {
        return Ok(found);
    };
    let told = no_numbers.told(&as_given(&args.theirs).to_string());
    output::eprint_line(format_args!("warning: {told}"));
    Ok(no_numbers.put_back_into(&found))
}

fn of_picture(args: &Args) -> Result<PictureDiagnosis, Diagnostic> {
    let files = files();
    let picture = picture_or_mesh(&args.theirs, &files.read(&args.theirs)?)?;
    let characters = characters(&files, &args.character)?;
    let [character] = &characters[..] else {
        let message = format!("expected one character, found {}", characters.len());
        return Err(Diagnostic::new(&args.character, message));
    };
    let pose = pose(args, &files, character)?;
    let camera = args.camera.chosen().unwrap_or_default();
    let seen = camera.clip_from_world(picture.width as f32 / picture.height as f32);
    let diagnosed = diagnose_picture(character, &pose, &picture, seen);
    diagnosed.map_err(|error| Diagnostic::new(&args.theirs, error.to_string()))
}

fn pose(args: &Args, files: &dyn Files, character: &Character) -> Result<Pose, Diagnostic> {
    PoseFile::open(files, &args.pose)?.pose_of(character.skeleton())
}

/// The characters in a file, of which there is at least one. Warnings are printed.
///
/// # Errors
/// If there is none, or the file cannot be read.
pub(super) fn characters(
    files: &dyn Files,
    model: &Path,
) -> Result<Vec<Arc<Character>>, Diagnostic> {
    let shapes = with_warnings(import_character(files, model)?).into_iter();
    let characters = shapes.filter_map(|shape| match shape.kind {
        ShapeKind::Character(character) => Some(character.character),
        _ => None,
    });
    let characters: Vec<_> = characters.collect();
    if characters.is_empty() {
        return Err(Diagnostic::new(model, "expected a character, found none"));
    }
    Ok(characters)
}

/// What was read, after its warnings have been printed.
fn with_warnings<T>(imported: Imported<T>) -> T {
    for warning in &imported.warnings {
        output::eprint_line(format_args!("warning: {warning}"));
    }
    imported.value
}
