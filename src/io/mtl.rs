//! Materials of `.mtl` files: `tobj` reads them, line by line as far as they are well formed.

use super::diagnostic::Warnings;
use super::encoding::in_utf8;
use super::pictures::{MissingPictures, Pictures};
use super::scanner::{Scanner, quoted};
use super::{Diagnostic, Files};
use crate::geometry::Material;
use glam::Vec3;
use std::collections::{HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// The diffuse color of a material that has none.
const DEFAULT_COLOR: Vec3 = Vec3::splat(0.8);

/// Reads the materials of the `.mtl` file at `path`: names, diffuse colors and pictures. `tobj`
/// gives a whole file up at the first line that it cannot read, so it gets the lines that matter
/// here (`newmtl`, `Kd`, `map_Kd`) and are well formed; others of these are warnings.
///
/// # Errors
/// If the file is no text, or a material has no name.
fn read_mtl(path: &Path, bytes: &[u8]) -> Result<ReadMtl, Diagnostic> {
    let bytes = in_utf8(bytes);
    let mut scanner = Scanner::new(path, &bytes)?;
    let mut lines = String::new();
    let mut warnings = Warnings::default();
    loop {
        let word = scanner.word();
        let keyword = word.map_or("", |word| word.text);
        let read = match keyword {
            "newmtl" => {
                let name = scanner.rest();
                name.ok_or_else(|| scanner.expected("the name of the material", None))?;
                Ok(())
            }
            "Kd" | "map_Kd" if lines.is_empty() => Err(scanner.expected("newmtl first", word)),
            "Kd" => check_color(&mut scanner),
            "map_Kd" => {
                let name = scanner.rest().map(|_| ());
                name.ok_or_else(|| scanner.expected("the name of a picture", None))
            }
            _ => Ok(()),
        };
        match read {
            Err(warning) => warnings.push_with(|| warning),
            Ok(()) if matches!(keyword, "newmtl" | "Kd" | "map_Kd") => {
                lines.push_str(scanner.read_of_line());
                lines.push('\n');
            }
            Ok(()) => {}
        }
        if !scanner.next_line() {
            break;
        }
    }
    let (materials, _) = tobj::load_mtl_buf(&mut lines.as_bytes())
        .map_err(|error| Diagnostic::new(path, error.to_string()))?;
    Ok(ReadMtl {
        materials,
        warnings,
    })
}

/// Content of an `.mtl` file.
struct ReadMtl {
    /// In the order of the file.
    materials: Vec<tobj::Material>,
    /// About lines that were left out.
    warnings: Warnings,
}

/// The material libraries of an `.obj` file, each read once however often it is named, and kept
/// once under however many names.
#[derive(Default)]
pub(super) struct Libraries {
    /// Hash of the content of each path; `None` for one that cannot be read.
    paths: HashMap<PathBuf, Option<u64>>,
    /// Materials by that hash, with the number of `mtllib` lines before the last that names them.
    read: HashMap<u64, (usize, Vec<tobj::Material>)>,
    lines: usize,
}

impl Libraries {
    /// Adds the library at `path`, after all others, and returns the warnings about its lines;
    /// none if it was read before.
    ///
    /// # Errors
    /// If it cannot be read, the first time that it is named.
    pub fn add(&mut self, files: &dyn Files, path: &Path) -> Result<Warnings, Diagnostic> {
        self.lines += 1;
        let mut warnings = Warnings::default();
        let content = match self.paths.get(path) {
            Some(known) => *known,
            None => {
                // Stays where reading fails.
                self.paths.insert(path.to_owned(), None);
                let bytes = files.read(path)?;
                let mut hasher = DefaultHasher::new();
                bytes.hash(&mut hasher);
                let content = hasher.finish();
                if !self.read.contains_key(&content) {
                    let library = read_mtl(path, &bytes)?;
                    self.read.insert(content, (self.lines, library.materials));
                    warnings = library.warnings;
                }
                self.paths.insert(path.to_owned(), Some(content));
                Some(content)
            }
        };
        if let Some(library) = content.and_then(|content| self.read.get_mut(&content)) {
            library.0 = self.lines;
        }
        Ok(warnings)
    }

    /// All materials, in the order in which their libraries were named last.
    pub fn into_materials(self) -> Vec<tobj::Material> {
        let mut libraries: Vec<_> = self.read.into_values().collect();
        libraries.sort_unstable_by_key(|(line, _)| *line);
        libraries.into_iter().flat_map(|(_, all)| all).collect()
    }
}

fn check_color(scanner: &mut Scanner) -> Result<(), Diagnostic> {
    for channel in ["red", "green", "blue"] {
        scanner.number(&format!("a number for {channel}"))?;
    }
    Ok(())
}

/// The materials that `tobj` read, by name, the last of several; with their pictures, whose paths
/// are relative to the folder of `path`, the file that has asked for them. A picture that cannot be
/// read is a warning, and the color stays.
pub(super) fn with_pictures(
    files: &dyn Files,
    path: &Path,
    read: Vec<tobj::Material>,
) -> (HashMap<String, Material>, Warnings) {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut warnings = Warnings::default();
    let mut told = HashSet::new();
    let mut missing = MissingPictures::default();
    let mut pictures = Pictures::new(files);
    let materials = read
        .into_iter()
        .map(|material| {
            let texture = material.diffuse_texture.and_then(|named| {
                let Some(path) = picture_path(&pictures, folder, &named) else {
                    missing.add(if named.starts_with('-') {
                        last_word(&named)
                    } else {
                        &named
                    });
                    return None;
                };
                let picture = pictures.get(&path);
                picture
                    .map_err(|warning| told.insert(path).then(|| warnings.push_with(|| warning)))
                    .ok()
            });
            let color = material.diffuse.map(Vec3::from);
            let white = texture.as_ref().map(|_| Vec3::ONE);
            let color = color.or(white).unwrap_or(DEFAULT_COLOR);
            let read = Material {
                color: color.clamp(Vec3::ZERO, Vec3::ONE),
                name: material.name,
                texture,
            };
            (read.name.clone(), read)
        })
        .collect();
    if let Some(message) = missing.warning() {
        warnings.push_with(|| Diagnostic::new(path, message));
    }
    (materials, warnings)
}

/// The picture that a `map_Kd` line names: all of it as a path; where options come before it, its
/// last word; and, for a path of the author's own machine, the file's name alone. `None` if there is
/// no such file.
fn picture_path(pictures: &Pictures, folder: &Path, named: &str) -> Option<PathBuf> {
    let last = last_word(named);
    let name = |path: &str| {
        let name = path.rsplit(['/', '\\']).next();
        name.unwrap_or_default().to_owned()
    };
    let candidates = [named.to_owned(), last.to_owned(), name(named), name(last)];
    let paths = candidates.iter().map(|candidate| beside(folder, candidate));
    paths.into_iter().find(|path| pictures.exists(path))
}

/// What is left of a `map_Kd` line after its options.
fn last_word(named: &str) -> &str {
    named.split_whitespace().next_back().unwrap_or(named)
}

/// The file that another one in `folder` names; it may have been made on Windows.
pub(super) fn beside(folder: &Path, named: &str) -> PathBuf {
    folder.join(named.replace('\\', "/"))
}

/// The warning for a material that no `.mtl` file has.
pub(super) fn unknown(name: &str) -> String {
    let found = quoted(name);
    format!("expected a material of the .mtl file, found {found}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Picture;
    use crate::io::{image, read_shape_obj};
    use std::collections::HashMap;
    use std::sync::Arc;

    #[test]
    fn materials_of_one_picture_share_it_and_what_is_wrong_with_it_is_told_once() {
        let picture = Picture {
            width: 2,
            height: 1,
            rgba: vec![7; 8],
        };
        let png = image::encode(&picture, image::PictureFormat::Png).unwrap();
        let named = |name: &str, file: &str| format!("newmtl {name}\nmap_Kd {file}\n");
        let mtl = [
            named("a", "a.png"),
            named("b", r"C:\Users\ann\My Pictures\a.png"),
            named("c", "gone.png"),
            named("d", "-s 2 2 2 gone.png") + &named("e", "lost.png"),
        ];
        let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned()
            + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\nusemtl d\nf 1 2 3\n";
        let files = HashMap::from([
            (PathBuf::from("a.mtl"), mtl.concat().into_bytes()),
            (PathBuf::from("a.png"), png),
        ]);
        let read = read_shape_obj(&files, Path::new("a.obj"), obj.as_bytes()).unwrap();
        let textures = read
            .value
            .groups
            .iter()
            .map(|group| &group.material.texture);
        let [Some(a), Some(b), None, None] = textures.collect::<Vec<_>>()[..] else {
            panic!("{:?}", read.value.groups);
        };
        assert!(Arc::ptr_eq(a, b));
        let colors = read.value.groups.iter().map(|group| group.material.color);
        let (white, gray) = (Vec3::ONE, Vec3::splat(0.8));
        let expected = [white, white, gray, gray];
        assert_eq!(
            colors.collect::<Vec<_>>(),
            expected,
            "white shows a picture as it is"
        );
        let told: Vec<String> = read.warnings.iter().map(|w| w.to_string()).collect();
        let expected = "a.obj: expected 2 pictures, found no files for “gone.png” and 1 other";
        // An option is no part of a name.
        assert_eq!(told, [expected]);
    }
}
