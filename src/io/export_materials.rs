//! The geometry of a scene with its colors and pictures: an `.obj` file, its `.mtl` file and the
//! pictures that this names.

use super::export::{each_shape, write_curves, write_vertices};
use super::{TooFarOut, image};
use crate::geometry::{MaterialGroup, Picture};
use crate::math::cofactors;
use crate::scene::{Evaluated, EvaluatedShape, Scene, Shape};
use glam::{Mat3, Vec3};
use std::collections::HashMap;
use std::fmt::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// An `.obj` file and what belongs to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjWithMaterials {
    /// The `.obj` file.
    pub obj: String,
    /// Names and content of the files beside it: pictures, and the `.mtl` file that names them.
    pub beside: Vec<(String, Vec<u8>)>,
}

impl ObjWithMaterials {
    /// All files to write for an `.obj` file at `path`, which comes last: it must not be there
    /// without the others.
    pub fn into_files(self, path: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        let beside = self.beside.into_iter();
        let beside = beside.map(|(name, bytes)| (path.with_file_name(name), bytes));
        beside
            .chain([(path.to_owned(), self.obj.into_bytes())])
            .collect()
    }
}

/// The geometry of a scene as [`super::export_obj`] writes it, with the same vertices in the same
/// order, and with normals, texture coordinates and materials: `usemtl` before each run of triangles
/// of one color. `stem` is the name of the `.obj` file without its extension, from which those of
/// the other files follow: `STEM.mtl`, `STEM-1.png`, and so on.
///
/// A material has as `Kd` what is drawn: the color of the file times that of the shape, and the
/// shape's color alone where there is a picture.
///
/// `evaluated` must be the evaluation of `scene`.
///
/// # Errors
/// As [`super::export_obj`].
pub fn export_obj_with_materials(
    scene: &Scene,
    evaluated: &Evaluated,
    stem: &str,
) -> Result<ObjWithMaterials, TooFarOut> {
    let mut materials = Materials::default();
    let mut next = Next::default();
    let shapes = each_shape(scene, evaluated, |out, shape, evaluated| {
        write_shape(out, shape, evaluated, &mut materials, &mut next)
    })?;
    // A comment begins at a #, and a line ends at a line break, whatever stands round them.
    let stem = stem
        .trim()
        .replace(|c: char| c.is_control() || c == '#', "_");
    let picture_name = |index: usize| format!("{stem}-{}.png", index + 1);
    let pictures = materials.pictures.iter().enumerate();
    let pictures = pictures.filter_map(|(index, picture)| {
        // A picture that was read has as many bytes as it needs.
        let bytes = image::encode(picture, image::PictureFormat::Png).ok()?;
        Some((picture_name(index), bytes))
    });
    let mut beside: Vec<_> = pictures.collect();
    let mtl = format!("{stem}.mtl");
    let obj = format!("mtllib {mtl}\n{shapes}");
    beside.push((mtl, materials.text(picture_name).into_bytes()));
    Ok(ObjWithMaterials { obj, beside })
}

/// Numbers of vertices, texture coordinates and normals that have been written.
#[derive(Default)]
struct Next {
    vertices: usize,
    texture_coordinates: usize,
    normals: usize,
}

fn write_shape(
    out: &mut String,
    shape: &Shape,
    evaluated: &EvaluatedShape,
    materials: &mut Materials,
    next: &mut Next,
) -> Option<()> {
    let geometry = &evaluated.geometry;
    let mesh = &geometry.mesh;
    write_vertices(out, evaluated, geometry.positions().iter().copied())?;
    for at in &mesh.texture_coordinates {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "vt {} {}", at.x, at.y);
    }
    let normals = geometry.normals().unwrap_or_default();
    let mirrored = evaluated.world_from_model.determinant() < 0.0;
    let turned =
        cofactors(Mat3::from_mat4(evaluated.world_from_model)) * if mirrored { -1.0 } else { 1.0 };
    for &normal in normals {
        let normal = (turned * normal).normalize_or(normal);
        let _ = writeln!(out, "vn {} {} {}", normal.x, normal.y, normal.z);
    }

    let own = shape.placement.color.rgb();
    let has_coordinates = !mesh.texture_coordinates.is_empty();
    let corner = |triangle: usize, corner: usize| {
        let position = next.vertices + 1 + mesh.triangles[triangle][corner] as usize;
        let vertex = 1 + mesh.vertex_triangles()[triangle][corner] as usize;
        let (texture, normal) = (next.texture_coordinates + vertex, next.normals + vertex);
        match (has_coordinates, normals.is_empty()) {
            (false, true) => format!("{position}"),
            (true, true) => format!("{position}/{texture}"),
            (false, false) => format!("{position}//{normal}"),
            (true, false) => format!("{position}/{texture}/{normal}"),
        }
    };
    for (triangles, group) in runs(&mesh.groups, mesh.triangles.len()) {
        let _ = writeln!(out, "usemtl {}", materials.named(shape, group, own));
        for triangle in triangles {
            // A mirrored shape would be inside out if its triangles kept their order.
            let order = if mirrored { [0, 2, 1] } else { [0, 1, 2] };
            let [a, b, c] = order.map(|at| corner(triangle, at));
            let _ = writeln!(out, "f {a} {b} {c}");
        }
    }
    let has_curves = geometry.curves.iter().any(|all| !all.curves.is_empty());
    if has_curves {
        let _ = writeln!(out, "usemtl {}", materials.named(shape, None, own));
    }
    next.vertices += geometry.positions().len();
    next.vertices += write_curves(out, evaluated, next.vertices + 1)?;
    next.texture_coordinates += mesh.texture_coordinates.len();
    next.normals += normals.len();
    Some(())
}

/// All triangles in runs of one material; `None` for those that have the shape's color.
fn runs(
    groups: &[MaterialGroup],
    triangles: usize,
) -> impl Iterator<Item = (Range<usize>, Option<&MaterialGroup>)> {
    let mut all = Vec::with_capacity(2 * groups.len() + 1);
    let mut done = 0;
    for group in groups {
        all.push((done..group.triangles.start, None));
        all.push((group.triangles.clone(), Some(group)));
        done = group.triangles.end;
    }
    all.push((done..triangles, None));
    all.into_iter().filter(|(run, _)| !run.is_empty())
}

/// Material as it is written.
struct Written {
    name: String,
    color: Vec3,
    /// Index of its picture.
    picture: Option<usize>,
}

/// What tells materials apart: name in the file, bits of the color, index of the picture.
type Key = (String, [u32; 3], Option<usize>);

/// Materials of the `.mtl` file, each once.
#[derive(Default)]
struct Materials {
    written: Vec<Written>,
    /// Indices into `written`.
    known: HashMap<Key, usize>,
    /// Names in use, each with the number that the next material of that name may have.
    names: HashMap<String, usize>,
    pictures: Vec<Arc<Picture>>,
}

impl Materials {
    /// Name of the material of a group of triangles of `shape`, whose color is `own`.
    fn named(&mut self, shape: &Shape, group: Option<&MaterialGroup>, own: Vec3) -> &str {
        let material = group.map(|group| &group.material);
        let texture = material.and_then(|material| material.texture.as_ref());
        let picture = texture.map(|texture| self.picture(texture));
        let color = match (material, picture) {
            (Some(material), None) => material.color * own,
            _ => own,
        };
        let base = word(material.map_or(&shape.name, |material| &material.name));
        let key = (base, color.to_array().map(f32::to_bits), picture);
        let index = match self.known.get(&key) {
            Some(&index) => index,
            None => {
                let name = self.free_name(&key.0);
                self.written.push(Written {
                    name,
                    color,
                    picture,
                });
                let index = self.written.len() - 1;
                self.known.insert(key, index);
                index
            }
        };
        &self.written[index].name
    }

    /// `base`, or `base` with a number if another material has that name.
    fn free_name(&mut self, base: &str) -> String {
        let Some(first) = self.names.get(base).copied() else {
            self.names.insert(base.to_owned(), 2);
            return base.to_owned();
        };
        let mut number = first;
        let mut name = format!("{base}.{number}");
        while self.names.contains_key(&name) {
            number += 1;
            name = format!("{base}.{number}");
        }
        self.names.insert(base.to_owned(), number + 1);
        self.names.insert(name.clone(), 2);
        name
    }

    fn picture(&mut self, picture: &Arc<Picture>) -> usize {
        let known = self
            .pictures
            .iter()
            .position(|known| Arc::ptr_eq(known, picture) || known == picture);
        known.unwrap_or_else(|| {
            self.pictures.push(picture.clone());
            self.pictures.len() - 1
        })
    }

    fn text(&self, picture_name: impl Fn(usize) -> String) -> String {
        let mut out = String::new();
        for material in &self.written {
            let color = material.color;
            // Writing to a string cannot fail.
            let _ = writeln!(out, "newmtl {}", material.name);
            let _ = writeln!(out, "Kd {} {} {}", color.x, color.y, color.z);
            if let Some(picture) = material.picture {
                let _ = writeln!(out, "map_Kd {}", picture_name(picture));
            }
        }
        out
    }
}

/// A name that programs read as one word.
fn word(name: &str) -> String {
    let fits = |c: char| !(c.is_whitespace() || c.is_control() || c == '#');
    let word: String = name
        .chars()
        .map(|c| if fits(c) { c } else { '_' })
        .collect();
    if word.is_empty() {
        "material".to_owned()
    } else {
        word
    }
}
