//! `editor compare`: how far two pictures or meshes are apart, and what is wrong.

use super::output::{self, DiagnosticJson, json_text, picture_format, refuse_input};
use super::pipes::Ends;
use super::{CliError, arguments, print};
use crate::character::{Attachments, Character};
use crate::compare::{
    Allowance, Area, MeshOptions, MeshParts, Pair, PictureOptions, compare_meshes, side_by_side,
};
use crate::diagnose::{NoNumbers, hardly_any_triangles};
use crate::disk::{self, as_given, files};
use crate::geometry::{Mesh, Picture};
use crate::io::image;
use crate::io::{
    Diagnostic, Files, builtin, extension, has_vertices, has_vertices_alone, import_any, in_utf8,
    is_character, read_character_obj, read_posed_vertices,
};
use crate::scene::ShapeKind;
use serde::Serialize;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Compare B with the reference A: two pictures, or two .obj files vertex by vertex.
///
/// Prints the differences and what they come from, as far as it can be told. Ends with 0 if no more
/// than the allowed differ, and with 1 otherwise.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The reference: a picture (.png, .jpg, .gif) or a mesh (.obj or .txt)
    #[arg(value_name = "A")]
    a: PathBuf,
    /// The picture or mesh that is compared with it. Of one of two meshes the vertices (v lines) are enough, and those that are
    /// no numbers (nan) differ; A or B may be - for standard input
    #[arg(value_name = "B")]
    b: PathBuf,
    /// Largest difference that is ignored: for pictures of a channel, 0 to 255 [0]; for meshes a
    /// distance [0.00001 of the size of A]
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = arguments::number)]
    threshold: Option<f64>,
    /// Number of pixels or vertices that may differ; with a % a share of the drawn pixels (those
    /// that are not background) or of the vertices
    #[arg(
        long,
        value_name = "P",
        default_value = "0",
        allow_hyphen_values = true
    )]
    max_pixels: Allowance,
    /// Leave out this area of the pictures, in pixels from the upper left; may be repeated
    #[arg(long, value_name = "X,Y,W,H", allow_hyphen_values = true)]
    ignore: Vec<Area>,
    /// Of two pictures: write a third one with A, B and their differences side by side, lighter where
    /// they are larger (.png, .jpg, .gif)
    #[arg(short, long, value_name = "DIFF.png")]
    output: Option<PathBuf>,
    /// Tell where meshes differ by the joints of this character, whose vertices they have; of A if
    /// that is one
    #[arg(long, value_name = "MODEL")]
    character: Option<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// Output of `--json`.
#[derive(Serialize)]
struct Report<'a, C> {
    a: String,
    b: String,
    #[serde(flatten)]
    comparison: &'a C,
}

/// Output of `--json` if nothing could be compared.
#[derive(Serialize)]
struct Failure {
    passed: bool,
    error: DiagnosticJson,
}

impl Args {
    /// What may be standard input or output.
    pub(super) fn ends(&mut self) -> Ends<'_> {
        Ends {
            inputs: vec![&mut self.a, &mut self.b],
            output: self.output.as_mut().map(|output| (output, None)),
        }
    }
}

/// Carries the command out.
///
/// # Errors
/// If a file is wrong, the two cannot be compared, more differ than are allowed, or the output
/// cannot be written.
pub fn run(args: &Args) -> Result<(), CliError> {
    let done = compare(args);
    let error = match &done {
        Err(CliError::Failed(diagnostic)) => Some(DiagnosticJson::from(diagnostic)),
        Err(CliError::Other(message) | CliError::Usage(message)) => {
            Some(DiagnosticJson::without_file(message.clone()))
        }
        Ok(()) | Err(CliError::Reported) => None,
    };
    if let (true, Some(error)) = (args.json, error) {
        let failure = Failure {
            passed: false,
            error,
        };
        print_json(args, &failure)?;
    }
    done
}

fn compare(args: &Args) -> Result<(), CliError> {
    if let Some(output) = &args.output {
        refuse_input(output, &[args.a.clone(), args.b.clone()])?;
    }
    match [&args.a, &args.b].map(|path| is_mesh(path)) {
        [true, true] => meshes(args),
        [false, false] => pictures(args),
        [mesh, _] => {
            let (mesh, other) = if mesh {
                (&args.a, &args.b)
            } else {
                (&args.b, &args.a)
            };
            // What is not there is told first: its name may be wrong.
            files().read(mesh)?;
            let what = match image::is_picture(&files().read(other)?) {
                true => "the picture ",
                false => "what is no mesh, ",
            };
            Err(CliError::Usage(format!(
                "expected two pictures or two meshes, found the mesh {} and {what}{}",
                mesh.display(),
                other.display()
            )))
        }
    }
}

/// The picture in `bytes`, the file at `path`, which could have been a mesh as well.
///
/// # Errors
/// If it is neither, or only a part of a picture.
pub(super) fn picture_or_mesh(path: &Path, bytes: &[u8]) -> Result<Picture, Diagnostic> {
    if bytes.is_empty() || image::is_picture(bytes) {
        return image::decode(path, bytes);
    }
    let found = match std::str::from_utf8(&in_utf8(bytes)).is_ok_and(has_vertices) {
        true => "a mesh whose name does not end in .obj",
        false => "a file of another kind",
    };
    let message = format!("expected a mesh (.obj) or a PNG, JPEG or GIF picture, found {found}");
    Err(Diagnostic::new(path, message))
}

/// Whether a file is a mesh by its name; a plain text may have the vertices of one.
pub(super) fn is_mesh(path: &Path) -> bool {
    // A path that cannot be resolved is reported when the file is read.
    let path = builtin::resolve(path).unwrap_or_else(|_| path.to_owned());
    ["obj", "txt"].contains(&&*extension(&path))
}

fn pictures(args: &Args) -> Result<(), CliError> {
    let options = PictureOptions {
        threshold: picture_threshold(args.threshold)?,
        allowed: args.max_pixels,
    };
    if args.character.is_some() {
        return Err(CliError::Usage(
            "--character is for meshes, found two pictures".to_owned(),
        ));
    }
    let output = match &args.output {
        Some(path) => Some((path, picture_format(path)?)),
        None => None,
    };
    let files = files();
    let read = |path: &Path| picture_or_mesh(path, &files.read(path)?);
    let (a, b) = (read(&args.a)?, read(&args.b)?);
    let pair = Pair::new(&a, &b, &args.ignore).map_err(cannot_compare)?;
    let comparison = pair.compare(&options);
    if let Some((path, format)) = output {
        let picture = side_by_side(&[&a, &b, &pair.heat_map()]);
        let bytes =
            image::encode(&picture, format).map_err(|error| Diagnostic::new(path, error))?;
        disk::write_whole(path, &bytes)?;
    }
    let done = print_result(args, &comparison, comparison.passed);
    if comparison.differs_in_outline() && !args.json {
        print(&how_to_diagnose(args, "shows a character alone", None))?;
    }
    done
}

fn picture_threshold(threshold: Option<f64>) -> Result<u8, CliError> {
    let threshold = threshold.unwrap_or(0.0);
    if (0.0..=255.0).contains(&threshold) && threshold.fract() == 0.0 {
        Ok(threshold as u8)
    } else {
        Err(CliError::Usage(format!(
            "expected a whole number from 0 to 255 for --threshold of pictures, found {threshold}"
        )))
    }
}

fn meshes(args: &Args) -> Result<(), CliError> {
    let only_for_pictures = [
        ("--ignore", !args.ignore.is_empty()),
        ("--output", args.output.is_some()),
    ];
    if let Some((option, _)) = only_for_pictures.iter().find(|(_, given)| *given) {
        return Err(CliError::Usage(format!(
            "{option} is for pictures, found two meshes: render both with the same --camera to have a picture of what is off"
        )));
    }
    if let Some(threshold) = args.threshold.filter(|t| !t.is_finite() || *t < 0.0) {
        return Err(CliError::Usage(format!(
            "expected a distance of at least 0 for --threshold of meshes, found {threshold}"
        )));
    }
    let files = files();
    let read = |path: &Path, model: Option<&Mesh>| -> Result<_, CliError> {
        let bytes = files.read(path)?;
        let no_numbers = NoNumbers::among_numbers(&in_utf8(&bytes));
        let readable = no_numbers.as_ref().map_or(&bytes, |found| &found.without);
        let mut imported = match model {
            Some(model) => read_posed_vertices(path, readable, model)?,
            None => read_character_obj(path, readable)?,
        };
        for warning in &imported.warnings {
            output::eprint_line(format_args!("warning: {warning}"));
        }
        if let Some(no_numbers) = no_numbers {
            let told = no_numbers.told(&as_given(path).to_string());
            output::eprint_line(format_args!("warning: {told}"));
            no_numbers.put_back_among(&mut imported.value.positions);
        }
        Ok(imported.value)
    };
    let (a, b) = match read(&args.a, None) {
        Ok(a) => {
            let b = read(&args.b, Some(&a))?;
            (a, b)
        }
        // The vertices of A are enough if B has the faces.
        Err(error) => match read(&args.b, None) {
            Ok(b) => (read(&args.a, Some(&b))?, b),
            // If A has them, what is wrong in B is what to mend.
            Err(of_b) => {
                let has_vertices = has_vertices_alone(&args.a, &files.read(&args.a)?);
                return Err(if has_vertices { of_b } else { error });
            }
        },
    };
    let parts = parts(args, &files, &a)?;
    let options = MeshOptions {
        tolerance: args.threshold,
        allowed: args.max_pixels,
        parts: parts.as_ref(),
    };
    let comparison = compare_meshes(&a, &b, &options).map_err(cannot_compare)?;
    let done = print_result(args, &comparison, comparison.passed);
    if comparison.is_unexplained() && !args.json {
        let (what, model) = match &parts {
            Some(_) => {
                let model = args.character.as_ref().unwrap_or(&args.a);
                ("is this character", Some(model))
            }
            None => ("is a character", None),
        };
        print(&how_to_diagnose(args, what, model))?;
    }
    done
}

/// The command that finds mistakes in skinning, which no comparison can, if B is `what`: of the character `model`, if that
/// is known.
fn how_to_diagnose(args: &Args, what: &str, model: Option<&PathBuf>) -> String {
    let word = |path: &Path| shell_word(&as_given(path).to_string());
    let theirs = word(&args.b);
    let model = model.map_or("MODEL.obj".to_owned(), |model| word(model));
    format!(
        "If {theirs} {what} in a pose, a mistake in skinning is found by\n  \
         editor diagnose {theirs} --character {model} --pose POSE.json\n"
    )
}

/// `text` as one word for a shell.
fn shell_word(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./:,+@%=".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

/// What each joint moves of the character that is named, or else of A, whose mesh is `a`, if it is one; `None` without a
/// character. A vertex belongs to the joint with the most weight.
fn parts(args: &Args, files: &dyn Files, a: &Mesh) -> Result<Option<MeshParts>, CliError> {
    let vertices = a.positions.len();
    let character = match &args.character {
        Some(model) => {
            let character = character_of(files, model, vertices)?;
            let character = character.ok_or_else(|| {
                let expected = format!("expected a character with {vertices} vertices, found none");
                Diagnostic::new(model, expected)
            })?;
            // Joints would be named of another one without any sign of it: some characters have as many vertices.
            if let Some(same) = hardly_any_triangles(&character, a) {
                let a = as_given(&args.a);
                let expected = format!(
                    "expected the model of {a}, found another one, or its vertices in another order: only {same} of the triangles are the same"
                );
                return Err(Diagnostic::new(model, expected).into());
            }
            character
        }
        // A mesh can be compared whatever lies beside it.
        None if is_character(files, &builtin::resolve(&args.a)?) => {
            match character_of(files, &args.a, vertices) {
                Ok(Some(character)) => character,
                Ok(None) | Err(_) => return Ok(None),
            }
        }
        None => return Ok(None),
    };
    let rows = character.attachments().vertices();
    let joints = character.skeleton().joints().iter();
    Ok(Some(MeshParts {
        names: joints.map(|joint| joint.name.clone()).collect(),
        of_vertex: rows.map(Attachments::strongest).collect(),
    }))
}

/// The first character in a file that has so many vertices.
fn character_of(
    files: &dyn Files,
    model: &Path,
    vertices: usize,
) -> Result<Option<Arc<Character>>, Diagnostic> {
    let shapes = import_any(files, model)?.value.into_iter();
    let mut characters = shapes.filter_map(|shape| match shape.kind {
        ShapeKind::Character(character) => Some(character.character),
        _ => None,
    });
    Ok(characters.find(|character| character.attachments().vertex_count() == vertices))
}

/// Prints the result; a comparison that did not pass is an error that has been reported.
fn print_result<C: Serialize + Display>(
    args: &Args,
    comparison: &C,
    passed: bool,
) -> Result<(), CliError> {
    if args.json {
        print_json(args, comparison)?;
    } else {
        print(&format!("{comparison}\n"))?;
    }
    if passed {
        Ok(())
    } else {
        Err(CliError::Reported)
    }
}

fn print_json<C: Serialize>(args: &Args, comparison: &C) -> Result<(), CliError> {
    let report = Report {
        a: as_given(&args.a).to_string(),
        b: as_given(&args.b).to_string(),
        comparison,
    };
    print(&json_text(&report)?)
}

fn cannot_compare(error: impl Display) -> CliError {
    CliError::Other(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_for_a_shell_is_quoted_where_it_must_be() {
        for (text, expected) in [
            ("a/b-2.obj", "a/b-2.obj"),
            ("builtin:adult", "builtin:adult"),
            ("my mesh.obj", "'my mesh.obj'"),
            ("it's", r"'it'\''s'"),
            ("$HOME", "'$HOME'"),
            ("", "''"),
        ] {
            assert_eq!(shell_word(text), expected);
        }
    }
}
