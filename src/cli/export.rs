//! `editor export`: the current geometry as an `.obj` file, or a character in the course's format.

use super::CliError;
use super::arguments::{self, edit, load};
use super::output::{eprint_line, refuse_input};
use super::pipes::{self, Ends};
use crate::disk;
use crate::editor::Session;
use crate::io::{self, Diagnostic};
use crate::scene::{CharacterShape, Shape, ShapeKind};
use std::path::{Path, PathBuf};

/// Write the current geometry of all FILEs into one .obj file, or a character with its skeleton.
///
/// -o OUT.obj: vertices keep the order of their file, are posed, and stand where the scene has them;
/// numbers have as many digits as it takes to read back the same ones. Polygons become triangles, as
/// do surfaces; curves become lines. With --materials, OUT.mtl has the colors, and OUT-1.png and so
/// on the pictures.
///
/// -o OUT.skel: the one character, or the one that --shape names, as OUT.skel, OUT.attach and OUT.obj
/// at rest, with its pose as OUT.json. Several roots come under one that is added.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  \
    editor export Model1.obj --pose walk.json -o walk.obj\n  \
    editor export party.scene --materials -o party.obj\n  \
    editor export rig.dae -o rig.skel")]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), builtin:NAME, or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The file to write: OUT.obj for geometry, OUT.skel for a character; - for geometry on standard output.
    /// The folder must be there
    #[arg(short, long, value_name = "OUT.obj|OUT.skel")]
    output: PathBuf,
    /// Pose the characters first: builtin:NAME, a file such as {"joints": {"Left elbow": [0, 0, 50]}}, or
    /// POSES.json#NAME of a file with several
    #[arg(long, value_name = "POSE.json")]
    pose: Option<PathBuf>,
    /// Influences per vertex: all of the file, or the four largest
    #[arg(long, default_value = "all")]
    influences: arguments::Influences,
    /// How meshes follow their joints: linear blending, or dual quaternions, which keep the volume of
    /// what is twisted [default: lbs, or as the scene has it]
    #[arg(long, value_name = "lbs|dqs")]
    skinning_method: Option<arguments::SkinningMethodName>,
    #[command(flatten)]
    curves: arguments::CurveOptions,
    /// Write colors, pictures and normals too: OUT.mtl, and OUT-1.png and so on
    #[arg(long, conflicts_with = "shape")]
    materials: bool,
    /// Name of the character to write as OUT.skel, if there are several
    #[arg(long, value_name = "NAME")]
    shape: Option<String>,
}

/// What is written, by the extension of the output.
enum Format {
    Geometry,
    Character,
}

/// Files to write, in this order.
type Files = Vec<(PathBuf, Vec<u8>)>;

impl Args {
    /// What may be standard input or output.
    pub(super) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: self.files.iter_mut().chain(&mut self.pose).collect(),
            output: Some((&mut self.output, Some("obj"))),
        }
    }
}

/// Carries the command out.
///
/// # Errors
/// If an input is wrong, or the output cannot be written; then there is none.
pub fn run(args: &Args) -> Result<(), CliError> {
    let format = format(args)?;
    let mut session = load(&args.files, args.pose.as_deref())?;
    let mut edits = args.influences.edits(&session);
    if let Some(method) = args.skinning_method {
        edits.extend(method.edits(&session));
    }
    edits.extend(args.curves.edits(&session));
    edit(&mut session, edits)?;
    let files = match format {
        Format::Geometry => geometry(args, &session)?,
        Format::Character => character(args, &session)?,
    };
    // Scenes name their models, and models the files that are read with them.
    let read = io::needed_files(&disk::files(), std::iter::once(session.scene()));
    let named = args.files.iter().chain(&args.pose).cloned();
    let inputs: Vec<PathBuf> = named.chain(read).collect();
    for (path, _) in &files {
        refuse_input(path, &inputs)?;
    }
    pipes::write(&files)
}

/// # Errors
/// If the output has another extension, or options do not go with it: wrong usage.
fn format(args: &Args) -> Result<Format, CliError> {
    let usage = |message: &str| {
        let diagnostic = Diagnostic::new(&args.output, message);
        Err(CliError::Usage(diagnostic.to_string()))
    };
    let is = |extension| io::expect_extension(&args.output, extension).is_ok();
    match (is("obj"), is("skel")) {
        (true, _) if args.shape.is_some() => {
            usage("expected a name that ends in .skel with --shape, found one that ends in .obj")
        }
        (true, _) => Ok(Format::Geometry),
        (_, true) if args.materials => usage(
            "expected a name that ends in .obj with --materials, found one that ends in .skel",
        ),
        (_, true) => Ok(Format::Character),
        _ => usage("expected a name that ends in .obj or .skel"),
    }
}

fn geometry(args: &Args, session: &Session) -> Result<Files, CliError> {
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let failed = |error: io::TooFarOut| Diagnostic::new(&args.output, error.to_string());
    if !args.materials {
        let text = io::export_obj(scene, evaluated).map_err(failed)?;
        return Ok(vec![(args.output.clone(), text.into_bytes())]);
    }
    let stem = args.output.file_stem().unwrap_or_default();
    let written = io::export_obj_with_materials(scene, evaluated, &stem.to_string_lossy());
    Ok(written.map_err(failed)?.into_files(&args.output))
}

fn character(args: &Args, session: &Session) -> Result<Files, CliError> {
    let (shape, character) = chosen(args, session)?;
    let written = io::export_character(shape, character)
        .map_err(|error| Diagnostic::new(&args.output, error.to_string()))?;
    if let Some(text) = io::left_out_of_course(character) {
        eprint_line(format_args!("warning: {text}"));
    }
    Ok(written.into_files(&args.output))
}

/// The character to write.
///
/// # Errors
/// If there is none, or not exactly one of the name that was given.
fn chosen<'a>(
    args: &Args,
    session: &'a Session,
) -> Result<(&'a Shape, &'a CharacterShape), CliError> {
    let shapes = session.scene().shapes().iter();
    let all: Vec<_> = shapes
        .filter_map(|shape| match &shape.kind {
            ShapeKind::Character(character) => Some((shape, character)),
            _ => None,
        })
        .collect();
    let names = || {
        let names: Vec<_> = all
            .iter()
            .map(|(shape, _)| format!("“{}”", shape.name))
            .collect();
        names.join(", ")
    };
    let mut fitting = all.iter().filter(|(shape, _)| {
        let asked = args.shape.as_ref();
        asked.is_none_or(|asked| *asked == shape.name)
    });
    let message = match (fitting.next(), fitting.next(), &args.shape) {
        (Some(&only), None, _) => return Ok(only),
        (None, _, None) => "expected a character to write, found none".to_owned(),
        (None, _, Some(asked)) if all.is_empty() => {
            format!("expected the character “{asked}”, found none")
        }
        (None, _, Some(asked)) => {
            format!(
                "expected the name of a character, such as {}, found “{asked}”",
                names()
            )
        }
        (Some(_), Some(_), None) => {
            format!(
                "expected one character, found {}: choose one with --shape NAME",
                names()
            )
        }
        (Some(_), Some(_), Some(asked)) => {
            format!("expected one character called “{asked}”, found several")
        }
    };
    Err(Diagnostic::new(first_input(args), message).into())
}

/// The file that an error about what was read names.
fn first_input(args: &Args) -> &Path {
    args.files.first().unwrap_or(&args.output)
}
