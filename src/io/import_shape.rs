use super::obj::{self, Corner, FaceReader};
use super::scanner::Scanner;
use super::{Diagnostic, Files, Imported, mtl as material};
use crate::geometry::{Material, MaterialGroup, Mesh, Normals, Triangulator, face_normal};
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// Reads any `.obj` file as one mesh: all its objects together, polygons cut into triangles,
/// normals and texture coordinates where it has them, materials with color and picture. Where
/// only some corners have a normal the others are shaded flat; a missing `.mtl` file or picture
/// is a warning.
///
/// `tobj` puts positions, texture coordinates and normals under one index, and so renumbers the
/// vertices: for characters use [`super::read_character_obj`]. What it gets to read is not the
/// file but what `plain_obj` makes of it.
///
/// # Errors
/// At the first line that is not well formed or names something that does not exist, and if
/// there are no vertices or no faces.
#[doc(alias = "ImportShape")]
pub fn read_shape_obj(
    files: &dyn Files,
    path: &Path,
    bytes: &[u8],
) -> Result<Imported<Mesh>, Diagnostic> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut plain = plain_obj(files, path, bytes)?;
    let options = tobj::LoadOptions {
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let (models, materials) = tobj::load_obj_buf(&mut plain.obj.as_bytes(), &options, |_| {
        tobj::load_mtl_buf(&mut plain.mtl.as_bytes())
    })
    .map_err(|error| Diagnostic::new(path, error.to_string()))?;
    let materials = materials.map_err(|error| Diagnostic::new(path, error.to_string()))?;
    let materials = material::materials(files, folder, materials);
    plain.warnings.extend(materials.warnings);

    let mut parts = Parts::default();
    for model in &models {
        let material = model
            .mesh
            .material_id
            .and_then(|id| materials.value.get(id));
        parts.add(&model.mesh, material);
    }
    if !plain.has_texture_coordinates {
        parts.texture_coordinates.clear();
    }
    Ok(Imported {
        value: parts.into_mesh(),
        warnings: plain.warnings,
    })
}

/// An `.obj` file and its materials in a form that `tobj` cannot misread.
struct Plain {
    obj: String,
    mtl: String,
    has_texture_coordinates: bool,
    warnings: Vec<Diagnostic>,
}

/// Checks every line that matters and writes it again for `tobj`: comments, colors of vertices
/// and lines without faces gone; materials first, then data, then faces; indices positive and
/// every corner with all three, where the first texture coordinate and the first normal, all
/// zero, stand for none.
///
/// Left to itself `tobj` tells no line, takes a comment after a face for a corner, mixes up
/// vertices with and without normals, and overflows on an index 0.
fn plain_obj(files: &dyn Files, path: &Path, bytes: &[u8]) -> Result<Plain, Diagnostic> {
    let mut reader = PlainReader {
        files,
        path,
        scanner: Scanner::new(path, bytes)?,
        faces: FaceReader::default(),
        data: "vt 0 0\nvn 0 0 0\n".to_owned(),
        face_lines: String::new(),
        mtl: String::new(),
        mtl_missing: false,
        used_materials: BTreeMap::new(),
        face_count: 0,
        has_texture_coordinates: false,
        warnings: Vec::new(),
    };
    loop {
        reader.line()?;
        if !reader.scanner.next_line() {
            break;
        }
    }
    reader.faces.check(&reader.scanner)?;
    obj::check_not_empty(path, reader.faces.counts[0], reader.face_count)?;
    reader.warn_of_unknown_materials();
    reader
        .warnings
        .extend(reader.faces.warnings(&reader.scanner));
    Ok(Plain {
        obj: format!("mtllib all\n{}{}", reader.data, reader.face_lines),
        mtl: reader.mtl,
        has_texture_coordinates: reader.has_texture_coordinates,
        warnings: reader.warnings,
    })
}

struct PlainReader<'a> {
    files: &'a dyn Files,
    path: &'a Path,
    scanner: Scanner<'a>,
    faces: FaceReader,
    data: String,
    face_lines: String,
    mtl: String,
    mtl_missing: bool,
    /// Each with the warning, should no file have it.
    used_materials: BTreeMap<&'a str, Diagnostic>,
    face_count: usize,
    has_texture_coordinates: bool,
    warnings: Vec<Diagnostic>,
}

impl PlainReader<'_> {
    fn line(&mut self) -> Result<(), Diagnostic> {
        match self.scanner.word().map(|word| word.text) {
            Some("v") => {
                let position = obj::read_position(&mut self.scanner)?;
                self.push_data("v", position);
                self.faces.counts[0] += 1;
            }
            Some("vt") => {
                let u = self.scanner.number("a number for u")?;
                let word = self.scanner.word();
                let v = word.map_or(Some(0.0), |word| super::scanner::finite(word.text));
                let v = v.ok_or_else(|| self.scanner.expected("a number for v", word))?;
                self.data.push_str(&format!("vt {u} {v}\n"));
                self.faces.counts[1] += 1;
            }
            Some("vn") => {
                let normal = obj::read_vec3(&mut self.scanner)?;
                self.push_data("vn", normal);
                self.faces.counts[2] += 1;
            }
            Some("f") => self.face()?,
            Some("mtllib") => self.material_library(),
            Some("usemtl") => self.use_material()?,
            _ => {}
        }
        Ok(())
    }

    fn push_data(&mut self, key: &str, Vec3 { x, y, z }: Vec3) {
        self.data.push_str(&format!("{key} {x} {y} {z}\n"));
    }

    fn face(&mut self) -> Result<(), Diagnostic> {
        let start = self.face_lines.len();
        self.face_lines.push('f');
        let (lines, textured) = (&mut self.face_lines, &mut self.has_texture_coordinates);
        let arity = self.faces.read(&mut self.scanner, |corner: Corner| {
            // From 1 in the file, and one more for the zeros that were put first.
            let after_zeros = |index: Option<u32>| index.map_or(1, |index| u64::from(index) + 2);
            let texture = after_zeros(corner.texture);
            let normal = after_zeros(corner.normal);
            *textured |= corner.texture.is_some();
            // Writing to a string cannot fail.
            let _ = write!(
                lines,
                " {}/{texture}/{normal}",
                u64::from(corner.position) + 1
            );
        })?;
        if arity < 3 {
            self.face_lines.truncate(start);
        } else {
            self.face_lines.push('\n');
            self.face_count += 1;
        }
        Ok(())
    }

    fn material_library(&mut self) {
        let name = self.scanner.rest();
        let Some(word) = name else {
            let warning = self.scanner.expected("the name of an .mtl file", None);
            self.warnings.push(warning);
            return;
        };
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let mtl_path = material::beside(folder, word.text);
        let read = self.files.read(&mtl_path);
        match read.and_then(|bytes| material::plain_mtl(&mtl_path, &bytes)) {
            Ok(plain) => {
                self.mtl.push_str(&plain.value);
                self.warnings.extend(plain.warnings);
            }
            Err(error) => {
                let at = self.scanner.position(name);
                self.warnings.push(
                    self.scanner
                        .error(at, format!("materials left out: {error}")),
                );
                self.mtl_missing = true;
            }
        }
    }

    fn use_material(&mut self) -> Result<(), Diagnostic> {
        let name = self.scanner.rest();
        let word = name.ok_or_else(|| self.scanner.expected("the name of a material", None))?;
        self.face_lines.push_str(&format!("usemtl {}\n", word.text));
        let (scanner, at) = (&self.scanner, self.scanner.position(name));
        self.used_materials
            .entry(word.text)
            .or_insert_with(|| scanner.error(at, material::unknown(word)));
        Ok(())
    }

    /// Each unknown material once, and none if their file is missing, which was told.
    fn warn_of_unknown_materials(&mut self) {
        if self.mtl_missing {
            return;
        }
        for name in self.mtl.lines().filter_map(|l| l.strip_prefix("newmtl ")) {
            self.used_materials.remove(name);
        }
        let unknown = std::mem::take(&mut self.used_materials);
        self.warnings.extend(unknown.into_values());
    }
}

/// The mesh as it comes together from `tobj`'s models, one a run of faces of one material.
#[derive(Default)]
struct Parts {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    texture_coordinates: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
    groups: Vec<MaterialGroup>,
    cutter: Triangulator,
}

impl Parts {
    fn add(&mut self, mesh: &tobj::Mesh, material: Option<&Material>) {
        let first = self.positions.len() as u32;
        let vec3s = |flat: &[f32]| {
            flat.chunks_exact(3)
                .map(Vec3::from_slice)
                .collect::<Vec<_>>()
        };
        let positions = vec3s(&mesh.positions);
        let all_triangles = vec![3; mesh.indices.len() / 3];
        let arities = if mesh.face_arities.is_empty() {
            &all_triangles
        } else {
            &mesh.face_arities
        };
        let triangles = obj::triangles(&mut self.cutter, &positions, &mesh.indices, arities);
        let start = self.triangles.len();
        self.triangles
            .extend(triangles.iter().map(|t| t.map(|index| first + index)));
        self.positions.extend(positions);
        let normals = vec3s(&mesh.normals).into_iter();
        self.normals.extend(normals.map(Vec3::normalize_or_zero));
        let uvs = mesh.texcoords.chunks_exact(2).map(Vec2::from_slice);
        self.texture_coordinates.extend(uvs);

        let range = start..self.triangles.len();
        match (material, self.groups.last_mut()) {
            (None, _) => {}
            (Some(material), Some(last))
                if last.triangles.end == start && last.material == *material =>
            {
                last.triangles.end = range.end;
            }
            (Some(material), _) => self.groups.push(MaterialGroup {
                triangles: range,
                material: material.clone(),
            }),
        }
    }

    fn into_mesh(mut self) -> Mesh {
        let normals = if self.normals.iter().all(|&normal| normal == Vec3::ZERO) {
            Normals::Flat
        } else {
            self.flatten_where_normals_are_missing();
            Normals::PerVertex(self.normals)
        };
        Mesh {
            normals,
            texture_coordinates: self.texture_coordinates,
            groups: self.groups,
            ..Mesh::new(self.positions, self.triangles)
        }
    }

    /// Gives each triangle with a corner that has no normal corners of its own, with the face's.
    fn flatten_where_normals_are_missing(&mut self) {
        for triangle in &mut self.triangles {
            let corners = triangle.map(|index| index as usize);
            if corners
                .iter()
                .all(|&corner| self.normals[corner] != Vec3::ZERO)
            {
                continue;
            }
            let normal = face_normal(corners.map(|corner| self.positions[corner]));
            for (index, corner) in triangle.iter_mut().zip(corners) {
                *index = self.positions.len() as u32;
                self.positions.push(self.positions[corner]);
                self.normals.push(normal);
                if let Some(&uv) = self.texture_coordinates.get(corner) {
                    self.texture_coordinates.push(uv);
                }
            }
        }
    }
}
