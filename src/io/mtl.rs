use super::image::Pictures;
use super::scanner::{Scanner, quoted};
use super::{Diagnostic, Files, Imported, scanner};
use crate::geometry::Material;
use glam::Vec3;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

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
            Some("Kd") if named => match read_color(&mut scanner) {
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

fn read_color(scanner: &mut Scanner) -> Result<Vec3, Diagnostic> {
    Ok(Vec3::new(
        scanner.number("a number for red")?,
        scanner.number("a number for green")?,
        scanner.number("a number for blue")?,
    ))
}

/// The materials that `tobj` found, with their pictures, whose paths are relative to `folder`.
/// What goes wrong with a picture becomes a warning: the mesh stays.
pub(super) fn materials(
    files: &dyn Files,
    folder: &Path,
    found: Vec<tobj::Material>,
) -> Imported<Vec<Material>> {
    let mut warnings: Vec<Diagnostic> = Vec::new();
    let mut told = HashSet::new();
    let mut pictures = Pictures::new(files);
    let materials = found
        .into_iter()
        .map(|material| {
            let texture = material.diffuse_texture.and_then(|named| {
                let path = picture_path(&pictures, folder, &named);
                let picture = pictures.get(&path);
                picture
                    .map_err(|warning| told.insert(path).then(|| warnings.push(warning)))
                    .ok()
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

/// The picture that a `map_Kd` line names: all of it as a path, or, where options come before
/// it, its last word.
fn picture_path(pictures: &Pictures, folder: &Path, named: &str) -> PathBuf {
    let whole = beside(folder, named);
    if pictures.exists(&whole) {
        whole
    } else {
        let last = named.split_whitespace().next_back().unwrap_or(named);
        beside(folder, last)
    }
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
            named("b", "a.png"),
            named("c", "gone.png"),
            named("d", "gone.png"),
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
        let told: Vec<String> = read.warnings.iter().map(|w| w.to_string()).collect();
        assert_eq!(told, ["gone.png: there is no such file"]);
    }
}
