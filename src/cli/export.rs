//! `editor export`: the current geometry as an `.obj` file.

use super::CliError;
use super::arguments::{self, edit, load};
use super::output::{expect_obj, refuse_input};
use crate::disk;
use crate::io;
use std::path::PathBuf;

/// Write the current geometry of all FILEs into one .obj file.
///
/// Vertices keep the order of their file, are posed, and stand where the scene has them; numbers
/// have as many digits as it takes to read back the same ones. Polygons become triangles, as do
/// surfaces; curves become lines.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Scenes (.scene, .zip), characters (.obj with .skel and .attach beside it, .dae), shapes
    /// (.obj, .dae), curves (.swp), or builtin:NAME
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The .obj file to write
    #[arg(short, long, value_name = "OUT.obj")]
    output: PathBuf,
    /// Pose the characters first: a file such as {"joints": {"Left elbow": [0, 0, 50]}}
    #[arg(long, value_name = "POSE.json")]
    pose: Option<PathBuf>,
    /// Influences per vertex: all of the file, or the four largest
    #[arg(long, default_value = "all")]
    influences: arguments::Influences,
    #[command(flatten)]
    curves: arguments::CurveOptions,
}

/// Carries the command out.
///
/// # Errors
/// If an input is wrong, or the output cannot be written; then there is none.
pub fn run(args: &Args) -> Result<(), CliError> {
    expect_obj(&args.output)?;
    refuse_input(&args.output, &args.files)?;
    let mut session = load(&args.files, args.pose.as_deref())?;
    let mut edits = args.influences.edits(&session);
    edits.extend(args.curves.edits(&session));
    edit(&mut session, edits)?;
    let text = io::export_obj(session.scene(), session.evaluated())
        .map_err(|error| io::Diagnostic::new(&args.output, error.to_string()))?;
    Ok(disk::write_whole(&args.output, text.as_bytes())?)
}
