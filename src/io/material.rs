use super::scanner::{Scanner, quoted};
use super::{Diagnostic, Files, Imported, image, scanner};
use crate::geometry::{Material, Picture};
use glam::Vec3;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a material looks like before `Kd` says so.
const UNSAID: Vec3 = Vec3::splat(0.8);

/// The lines of an `.mtl` file that this program uses, and nothing else: `newmtl`, `Kd` with
/// three numbers, `map_Kd` with a path. `tobj` gives a whole file up, or stops the program, at
/// others, so it gets these.
pub(super) fn plain_mtl(path: &Path, bytes: &[u8]) -> Result<Imported<String>, Diagnostic> {
    let mut scanner = Scanner::new(path, bytes)?;
    let mut plain = String::new();
    let mut warnings = Vec::new();
    let mut named = false;
    loop {
        let word = scanner.word();
        match word.map(|word| word.text) {
            Some("newmtl") => match scanner.rest() {
                Some(name) => {
                    plain.push_str(&format!("newmtl {}\n", name.text));
                    named = true;
                }
                None => return Err(scanner.expected("the name of the material", None)),
            },
            Some("Kd") if named => match super::obj::read_vec3(&mut scanner) {
                Ok(color) => {
                    let [r, g, b] = color.clamp(Vec3::ZERO, Vec3::ONE).to_array();
                    plain.push_str(&format!("Kd {r} {g} {b}\n"));
                }
                Err(error) => warnings.push(error),
            },
            Some("map_Kd") if named => match scanner.rest() {
                Some(file) => plain.push_str(&format!("map_Kd {}\n", file.text)),
                None => warnings.push(scanner.expected("the name of a picture", None)),
            },
            Some("Kd" | "map_Kd") => warnings.push(scanner.expected("newmtl first", word)),
            _ => {}
        }
        if !scanner.next_line() {
            break;
        }
    }
    Ok(Imported {
        value: plain,
        warnings,
    })
}

/// The materials that `tobj` found, with their pictures, whose paths are relative to `folder`.
/// What goes wrong with a picture becomes a warning: the mesh stays.
pub(super) fn materials(
    files: &dyn Files,
    folder: &Path,
    found: Vec<tobj::Material>,
) -> Imported<Vec<Material>> {
    let mut warnings = Vec::new();
    let materials = found
        .into_iter()
        .map(|material| {
            let texture = material.diffuse_texture.and_then(|named| {
                match read_picture(files, folder, &named) {
                    Ok(picture) => Some(Arc::new(picture)),
                    Err(warning) => {
                        warnings.push(warning);
                        None
                    }
                }
            });
            let white = texture.as_ref().map(|_| Vec3::ONE);
            Material {
                color: material.diffuse.map(Vec3::from).or(white).unwrap_or(UNSAID),
                name: material.name,
                texture,
            }
        })
        .collect();
    Imported {
        value: materials,
        warnings,
    }
}

/// Reads the picture that a `map_Kd` line names: all of it as a path, or, where options come
/// before it, its last word.
fn read_picture(files: &dyn Files, folder: &Path, named: &str) -> Result<Picture, Diagnostic> {
    let whole = beside(folder, named);
    let path = if files.exists(&whole) {
        whole
    } else {
        let last = named.split_whitespace().next_back().unwrap_or(named);
        beside(folder, last)
    };
    image::decode(&path, &files.read(&path)?)
}

/// The file that another one in `folder` names; it may have been made on Windows.
pub(super) fn beside(folder: &Path, named: &str) -> PathBuf {
    folder.join(named.replace('\\', "/"))
}

/// The warning for a material that no `.mtl` file has.
pub(super) fn unknown(name: scanner::Word) -> String {
    format!(
        "expected a material of the .mtl file, found {}",
        quoted(name.text)
    )
}
