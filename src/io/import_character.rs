use super::{Diagnostic, Files, Imported, read_attach, read_character_obj, read_skel};
use crate::character::Character;
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
            "expected {} and {} beside it, found neither: as it is, this is a shape",
            name(&parts.skel),
            name(&parts.attach)
        )),
    };
    if let Some(missing) = missing {
        return Err(Diagnostic::new(path, missing));
    }
    let mesh = read_character_obj(path, &files.read(path)?)?;
    let skeleton = read_skel(&parts.skel, &files.read(&parts.skel)?)?;
    let attachments = read_attach(
        &parts.attach,
        &files.read(&parts.attach)?,
        skeleton.value.joints().len(),
        mesh.value.positions.len(),
    )?;
    let warnings = [mesh.warnings, skeleton.warnings, attachments.warnings].concat();
    let character = Character::new(skeleton.value, attachments.value, mesh.value)
        .map_err(|error| Diagnostic::new(&parts.attach, error.to_string()))?;
    Ok(Imported {
        value: character,
        warnings,
    })
}
