use super::attach::read_attach_by;
use super::obj::read_character_obj_by;
use super::{Diagnostic, Files, Imported, read_skel};
use crate::character::Character;
use crate::steps::{Pace, at_once};
use std::path::{Path, PathBuf};

/// The three files of a character, which differ in their extension only.
struct Parts {
    skel: PathBuf,
    attach: PathBuf,
}

impl Parts {
    fn beside(obj: &Path) -> Self {
        Self {
            skel: obj.with_extension("skel"),
            attach: obj.with_extension("attach"),
        }
    }
}

/// Whether the `.obj` file `path` has a skeleton or weights beside it and so is meant to be a
/// character.
pub fn is_character(files: &dyn Files, path: &Path) -> bool {
    let parts = Parts::beside(path);
    files.exists(&parts.skel) || files.exists(&parts.attach)
}

/// Reads a character from the `.obj` file `path` and the `.skel` and `.attach` files beside it.
///
/// # Errors
/// If one of the three is missing or wrong, or they do not fit each other.
#[doc(alias = "ImportCharacter")]
pub fn read_character(files: &dyn Files, path: &Path) -> Result<Imported<Character>, Diagnostic> {
    at_once(|pace| async move { read_character_by(files, path, &pace).await })
}

/// As [`read_character`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_character`].
pub(super) async fn read_character_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<Character>, Diagnostic> {
    let parts = Parts::beside(path);
    let name = |path: &Path| match path.file_name() {
        Some(name) => name.to_string_lossy().into_owned(),
        None => path.display().to_string(),
    };
    let missing = match (files.exists(&parts.skel), files.exists(&parts.attach)) {
        (true, true) => None,
        (true, false) => Some(format!(
            "expected {} beside {}, found only the skeleton",
            name(&parts.attach),
            name(&parts.skel)
        )),
        (false, true) => Some(format!(
            "expected {} beside {}, found only the weights",
            name(&parts.skel),
            name(&parts.attach)
        )),
        (false, false) => Some(format!(
            "expected {} and {} beside it, found neither: without them it is a shape, which Import Shape reads",
            name(&parts.skel),
            name(&parts.attach)
        )),
    };
    if let Some(missing) = missing {
        return Err(Diagnostic::new(path, missing));
    }
    let obj = files.read(path)?;
    pace.after(obj.len() / 8).await;
    let mesh = pace
        .within(0.0..0.5, read_character_obj_by(path, &obj, pace))
        .await?;
    let skeleton = read_skel(&parts.skel, &files.read(&parts.skel)?)?;
    let attach = files.read(&parts.attach)?;
    let (joints, vertices) = (skeleton.value.joints().len(), mesh.value.positions.len());
    let attachments = read_attach_by(&parts.attach, &attach, joints, vertices, pace);
    let attachments = pace.within(0.5..1.0, attachments).await?;
    let warnings = [mesh.warnings, skeleton.warnings, attachments.warnings].concat();
    let character = Character::new(skeleton.value, attachments.value, mesh.value)
        .map_err(|error| Diagnostic::new(&parts.attach, error.to_string()))?;
    Ok(Imported {
        value: character,
        warnings,
    })
}
