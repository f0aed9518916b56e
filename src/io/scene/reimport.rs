//! Importing the file of a shape again: after it has changed, or from where it is now.

use super::character_data::CharacterData;
use super::curves::CurvesData;
use super::data::CurveDisplayData;
use super::version_2::part_of;
use crate::io::diagnostic::Warnings;
use crate::io::file_importer::import_with;
use crate::io::json::Json;
use crate::io::{Diagnostic, Files, Imported};
use crate::scene::{Scene, Shape, ShapeId, ShapeKind, Source};
use crate::steps::at_once;
use serde::de::DeserializeOwned;
use std::path::Path;

/// What a shape becomes when its file was read again; everything else about it stays.
#[derive(Clone, Debug)]
pub struct Reimported {
    /// Geometry, with pose, kept poses, settings of inverse kinematics and display as before.
    pub kind: ShapeKind,
    /// File that it was read from, with its fingerprint.
    pub source: Source,
}

/// Imports the part of a file that `shape` came from again: from the file at `at` if there is one,
/// else from the file that the shape remembers. A character is posed as before by the names of its
/// joints, with a warning for each joint that it does not have any more.
///
/// # Errors
/// If the shape does not exist or did not come from a file; if the file cannot be read, is not well
/// formed, lacks the part, or holds a shape where there was a character. Nothing changes then.
pub fn reimport(
    files: &dyn Files,
    scene: &Scene,
    shape: ShapeId,
    at: Option<&Path>,
) -> Result<Imported<Reimported>, Diagnostic> {
    let shape = scene.shape(shape);
    let Some((shape, source)) = shape.and_then(|shape| Some((shape, shape.source.as_ref()?)))
    else {
        let name = shape.map_or("shape", |shape| &shape.name);
        let message = "expected a shape that came from a file, found one that did not";
        return Err(Diagnostic::new(Path::new(name), message));
    };
    let path = at.unwrap_or(Path::new(&source.file));
    let read =
        at_once(|pace| async move { import_with(files, path, source.importer, &pace).await })?;
    let found = part_of(&read.value, source.part, path)?.clone();
    let mut kind = found.kind;
    let mut warnings = read.warnings;
    if let Some(character) = character_data(shape, path)? {
        let ShapeKind::Character(new) = &mut kind else {
            let message = "expected a character, for the shape was one, found a shape";
            return Err(Diagnostic::new(path, message));
        };
        let mut misfits = Warnings::default();
        for misfit in character.apply_to(new) {
            misfits.push_with(|| Diagnostic::new(path, misfit.message));
        }
        warnings.extend(misfits.into_vec(path));
    }
    if let (Some(display), ShapeKind::Curve(new)) = (curve_display(shape, path)?, &mut kind) {
        display.apply_to(new);
    }
    Ok(Imported {
        value: Reimported {
            kind,
            source: found.source.unwrap_or_else(|| source.clone()),
        },
        warnings,
    })
}

/// What the scene says of a character, or of one whose file was missing.
fn character_data(shape: &Shape, path: &Path) -> Result<Option<CharacterData>, Diagnostic> {
    match &shape.kind {
        ShapeKind::Character(character) => Ok(Some(CharacterData::of(character))),
        _ => kept(shape, "character", path),
    }
}

/// How curves are drawn, or would be if their file were not missing.
fn curve_display(shape: &Shape, path: &Path) -> Result<Option<CurveDisplayData>, Diagnostic> {
    match &shape.kind {
        ShapeKind::Curve(curve) => Ok(Some(CurveDisplayData::of(curve))),
        _ => Ok(kept::<CurvesData>(shape, "curves", path)?.map(|data| data.display)),
    }
}

/// The member of the scene that a stand-in has kept, if it is `name`.
fn kept<T: DeserializeOwned>(
    shape: &Shape,
    name: &str,
    path: &Path,
) -> Result<Option<T>, Diagnostic> {
    let ShapeKind::Missing(missing) = &shape.kind else {
        return Ok(None);
    };
    let member = missing.kept.as_ref();
    let member = member.filter(|(member, _)| member == name);
    member
        .map(|(_, text)| Json::parse(path, text.as_bytes())?.read())
        .transpose()
}
