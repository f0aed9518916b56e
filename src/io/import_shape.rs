use super::diagnostic::Warnings;
use super::encoding::in_utf8;
use super::mtl::{self, Libraries};
use super::obj;
use super::obj_counts::Counts;
use super::obj_face_reader::FaceReader;
use super::obj_shape::{Data, Name, Shape, Use};
use super::scanner::{STRETCH, Scanner, Word};
use super::{Diagnostic, Files, Imported};
use crate::geometry::Mesh;
use crate::steps::{Pace, at_once};
use glam::Vec2;
use std::collections::HashMap;
use std::path::Path;

/// Reads any `.obj` file as one mesh: all its objects together, polygons cut into triangles,
/// normals and texture coordinates where it has them, materials with color and picture. Its
/// positions are those of the file that faces use, in their order. A triangle with a corner that
/// has no normal is shaded flat; a missing `.mtl` file or picture is a warning.
///
/// # Errors
/// At the first line that is not well formed or names something that does not exist, and if
/// there are no vertices or no faces.
#[doc(alias = "ImportShape")]
pub fn read_shape_obj(
    files: &dyn Files,
    path: &Path,
    bytes: impl AsRef<[u8]>,
) -> Result<Imported<Mesh>, Diagnostic> {
    at_once(|pace| async move { read_shape_obj_by(files, path, bytes, &pace).await })
}

/// As [`read_shape_obj`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_shape_obj`].
pub(super) async fn read_shape_obj_by(
    files: &dyn Files,
    path: &Path,
    bytes: impl AsRef<[u8]>,
    pace: &Pace,
) -> Result<Imported<Mesh>, Diagnostic> {
    let bytes = in_utf8(bytes.as_ref());
    let mut reader = ShapeReader {
        files,
        folder: path.parent().unwrap_or(Path::new("")),
        scanner: Scanner::new(path, &bytes)?,
        data: Data::default(),
        faces: FaceReader::default(),
        libraries: Libraries::default(),
        materials_missing: false,
        uses: Vec::new(),
        names: Vec::new(),
        known: HashMap::new(),
        warnings: Warnings::default(),
    };
    pace.begin(0.0..0.1);
    reader.make_room(pace).await;
    pace.begin(0.1..0.7);
    while reader.lines()? {
        pace.tell(reader.scanner.part());
        pace.after(STRETCH).await;
    }
    let shape = reader.finish()?;
    // The mesh takes its place in memory.
    drop(bytes);
    pace.begin(0.7..1.0);
    Ok(shape.mesh(files, path, pace).await)
}

struct ShapeReader<'a> {
    files: &'a dyn Files,
    folder: &'a Path,
    scanner: Scanner<'a>,
    data: Data,
    faces: FaceReader,
    libraries: Libraries,
    materials_missing: bool,
    uses: Vec<Use>,
    names: Vec<Name>,
    /// Which of `names` each name is.
    known: HashMap<&'a str, usize>,
    warnings: Warnings,
}

impl<'a> ShapeReader<'a> {
    /// Makes room for as much as the file has: lists that grow leave gaps in memory, a quarter of all
    /// that a large file takes.
    async fn make_room(&mut self, pace: &Pace) {
        let mut lines = self.scanner.text().lines();
        let mut counts = Counts::default();
        while counts.add(&mut lines) {
            pace.after(STRETCH).await;
        }
        self.data.positions.reserve_exact(counts.positions);
        self.data.texture.reserve_exact(counts.texture);
        self.data.normals.reserve_exact(counts.normals);
        self.faces.make_room(counts.faces);
    }

    /// Reads some lines; whether there are more.
    fn lines(&mut self) -> Result<bool, Diagnostic> {
        let end = self.scanner.at() + STRETCH;
        loop {
            self.line()?;
            if !self.scanner.next_line() {
                return Ok(false);
            }
            if self.scanner.at() >= end {
                return Ok(true);
            }
        }
    }

    fn line(&mut self) -> Result<(), Diagnostic> {
        match self.scanner.word().map(|word| word.text) {
            Some("v") => {
                self.data
                    .positions
                    .push(obj::read_position(&mut self.scanner)?);
                self.faces.counts[0] += 1;
            }
            Some("vt") => {
                let u = self.scanner.number("a number for u")?;
                let word = self.scanner.word();
                let v = match word {
                    None => 0.0,
                    word => self.scanner.number_of(word, "a number for v")?,
                };
                self.data.texture.push(Vec2::new(u, v));
                self.faces.counts[1] += 1;
            }
            Some("vn") => {
                let normal = obj::read_vec3(&mut self.scanner)?;
                self.data.normals.push(normal.normalize_or_zero());
                self.faces.counts[2] += 1;
            }
            Some("f") => self.faces.read(&mut self.scanner)?,
            Some("mtllib") => self.material_library(),
            Some("usemtl") => self.use_material()?,
            _ => {}
        }
        Ok(())
    }

    fn material_library(&mut self) {
        let name = self.scanner.rest();
        let Some(word) = name else {
            let scanner = &self.scanner;
            self.warnings
                .push_with(|| scanner.expected("the name of an .mtl file", None));
            return;
        };
        let path = mtl::beside(self.folder, word.text);
        match self.libraries.add(self.files, &path) {
            Ok(warnings) => self.warnings.append(warnings),
            Err(error) => {
                let scanner = &self.scanner;
                self.warnings.push_with(|| {
                    let message = format!("materials left out: {error}");
                    scanner.error(scanner.position(name), message)
                });
                self.materials_missing = true;
            }
        }
    }

    fn use_material(&mut self) -> Result<(), Diagnostic> {
        let name: Option<Word<'a>> = self.scanner.rest();
        let word = name.ok_or_else(|| self.scanner.expected("the name of a material", None))?;
        let name = *self.known.entry(word.text).or_insert_with(|| {
            self.names.push(Name {
                text: word.text.to_owned(),
                at: self.scanner.position(name),
            });
            self.names.len() - 1
        });
        self.uses.push(Use {
            name,
            faces_before: self.faces.face_count(),
        });
        Ok(())
    }

    fn finish(self) -> Result<Shape, Diagnostic> {
        let (faces, face_warnings) = self.faces.finish(&self.scanner)?;
        Ok(Shape {
            data: self.data,
            faces,
            libraries: self.libraries,
            materials_missing: self.materials_missing,
            uses: self.uses,
            names: self.names,
            warnings: self.warnings,
            face_warnings,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Normals;
    use glam::Vec3;
    use std::path::PathBuf;

    const MTL: &str = "newmtl red\nKd 1 0 0 # red\nNs nonsense\nnewmtl green\nKd 0 2 0\n";

    fn read(obj: &str) -> Result<Imported<Mesh>, String> {
        let files = HashMap::from([(PathBuf::from("a.mtl"), MTL.as_bytes().to_vec())]);
        read_shape_obj(&files, Path::new("a.obj"), obj.as_bytes())
            .map_err(|error| error.to_string())
    }

    fn told(warnings: &[Diagnostic]) -> Vec<String> {
        warnings.iter().map(ToString::to_string).collect()
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn positions_keep_the_order_of_the_file_without_those_that_no_face_uses() {
        let mesh = read("v 9 9 9\nv 0 0 1\nv 0 0 2\nv 9 9 9\nv 0 0 3\nf 5 3 2\n");
        let mesh = mesh.unwrap().value;
        assert_eq!(mesh.positions, [1.0, 2.0, 3.0].map(|z| Vec3::Z * z));
        assert_eq!(mesh.triangles, [[2, 1, 0]]);
        assert_eq!(mesh.normals, Normals::Flat);
        assert_eq!(mesh.seams, None);
    }

    #[test]
    fn corners_that_disagree_in_texture_coordinates_share_their_position() {
        let obj = format!("{SQUARE}vt 0 0\nvt 0.5 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4\n");
        let mesh = read(&obj).unwrap().value;
        assert_eq!(mesh.positions.len(), 4);
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        let seams = mesh.seams.clone().unwrap();
        assert_eq!(seams.copies, [0, 2]);
        let of_second = mesh.vertex_triangles()[1].map(|i| mesh.texture_coordinates[i as usize]);
        let half = Vec2::new(0.5, 1.0);
        assert_eq!(of_second, [half, half, Vec2::ZERO]);
    }

    #[test]
    fn polygons_and_texture_coordinates_may_begin_anywhere_among_triangles_without() {
        let obj = format!("{SQUARE}vt 0.5 1\nf 1 2 3\nf 2/1 3/1 4/1 1/1\nf 1 2\nf 3 4 1\n");
        let mesh = read(&obj).unwrap().value;
        assert_eq!(mesh.triangles, [[0, 1, 2], [1, 2, 3], [1, 3, 0], [2, 3, 0]]);
        let texture = mesh.vertex_triangles().iter().map(|triangle| {
            let [a, b, c] = triangle.map(|corner| mesh.texture_coordinates[corner as usize]);
            assert!(a == b && b == c);
            a
        });
        let half = Vec2::new(0.5, 1.0);
        let expected = [Vec2::ZERO, half, half, Vec2::ZERO];
        assert_eq!(texture.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn a_triangle_with_a_corner_without_normal_is_flat_as_a_whole() {
        let normals = "vn 3 0 0\nvn 0 0 0\n";
        let obj = format!("{SQUARE}{normals}f 1//1 2//1 3//1\nf 1//1 3//1 4//2\n");
        let mesh = read(&obj).unwrap().value;
        let Normals::PerVertex(normals) = &mesh.normals else {
            panic!("{mesh:?}");
        };
        let of_triangle = |triangle: usize| {
            let corners = mesh.vertex_triangles()[triangle];
            corners.map(|corner| normals[corner as usize])
        };
        assert_eq!(of_triangle(0), [Vec3::X; 3]);
        assert_eq!(of_triangle(1), [Vec3::Z; 3]);
    }

    #[test]
    fn materials_are_runs_of_triangles_wherever_their_file_is_named() {
        let obj = format!(
            "{SQUARE}f 1 2 3\nusemtl red\nf 1 2 3 4\nusemtl gone\nusemtl red\nf 1 2 3\n\
             usemtl green\nf 1 2 3\nusemtl gone\nf 1 2 3\nusemtl gone\nmtllib a.mtl\n"
        );
        let read = read(&obj).unwrap();
        let groups: Vec<_> = read.value.groups.iter().collect();
        let runs = groups
            .iter()
            .map(|group| (&*group.material.name, group.triangles.clone()));
        assert_eq!(runs.collect::<Vec<_>>(), [("red", 1..4), ("green", 4..5)]);
        assert_eq!(groups[0].material.color, Vec3::X);
        assert_eq!(groups[1].material.color, Vec3::Y, "no channel is above 1");
        let gone = "a.obj:8:8: expected a material of the .mtl file, found “gone”";
        assert_eq!(told(&read.warnings), [gone]);
    }

    #[test]
    fn an_index_of_0_means_none_with_one_warning_for_the_file() {
        let obj = format!("{SQUARE}vn 1 0 0\nf 1/0/1 2/0/1 3/0/1\nf 1/0/1 3/0/1 4/0/1\n");
        let read = read(&obj).unwrap();
        assert!(read.value.texture_coordinates.is_empty());
        assert_eq!(read.value.normals, Normals::PerVertex(vec![Vec3::X; 4]));
        assert_eq!(
            told(&read.warnings),
            [
                "a.obj:6:3: expected texture coordinates and normals counted from 1, found 0 in 6 \
              corners: taken as none"
            ]
        );
    }

    #[test]
    fn lines_that_cannot_be_read_are_left_out_of_a_library_and_no_others() {
        let files = |mtl: &str| HashMap::from([(PathBuf::from("a.mtl"), mtl.as_bytes().to_vec())]);
        let obj = format!("mtllib a.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n");
        let mtl = "Kd 1 1 1\nnewmtl a\nKd 0 1 0\nKd 1 0\nmap_Kd\nillum\n";
        let read = read_shape_obj(&files(mtl), Path::new("a.obj"), obj.as_bytes()).unwrap();
        assert_eq!(read.value.groups[0].material.color, Vec3::Y);
        assert_eq!(
            told(&read.warnings),
            [
                "a.mtl:1:1: expected newmtl first, found “Kd”",
                "a.mtl:4:7: expected a number for blue, found the end of the line",
                "a.mtl:5:7: expected the name of a picture, found the end of the line",
            ]
        );
    }

    /// Files in memory, with a record of those that were read.
    struct Counted(HashMap<PathBuf, Vec<u8>>, std::sync::Mutex<Vec<PathBuf>>);

    impl Files for Counted {
        fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
            self.1.lock().unwrap().push(path.to_owned());
            self.0.read(path)
        }

        fn exists(&self, path: &Path) -> bool {
            self.0.exists(path)
        }
    }

    #[test]
    fn a_library_that_is_named_a_hundred_times_is_read_once_and_told_about_once() {
        let table = HashMap::from([(PathBuf::from("a.mtl"), MTL.as_bytes().to_vec())]);
        let files = Counted(table, Default::default());
        let libraries = ["mtllib a.mtl\n", "mtllib gone.mtl\n"].map(|line| line.repeat(100));
        let obj = libraries.concat() + SQUARE + "usemtl red\nf 1 2 3 4\n";
        let read = read_shape_obj(&files, Path::new("a.obj"), obj.as_bytes()).unwrap();
        assert_eq!(
            files.1.into_inner().unwrap(),
            ["a.mtl", "gone.mtl"].map(PathBuf::from)
        );
        assert_eq!(read.value.groups[0].material.color, Vec3::X);
        let gone = "a.obj:101:8: materials left out: gone.mtl: there is no such file";
        assert_eq!(told(&read.warnings), [gone]);
    }

    #[test]
    fn of_libraries_with_one_material_the_last_that_is_named_counts_though_named_before() {
        let color = |color: &str| format!("newmtl a\nKd {color}\nKd oops\n").into_bytes();
        let files = [("a.mtl", color("1 0 0")), ("b.mtl", color("0 1 0"))];
        let copy = ("copy.mtl", color("1 0 0"));
        let files = files.into_iter().chain([copy]);
        let files = HashMap::from_iter(files.map(|(name, text)| (PathBuf::from(name), text)));
        for (names, expected) in [
            (&["a", "b"][..], Vec3::Y),
            (&["b", "a"], Vec3::X),
            (&["a", "b", "a"], Vec3::X),
            (&["a", "b", "copy"], Vec3::X),
            (&["a", "copy", "a", "b", "b"], Vec3::Y),
        ] {
            let lines = names.iter().map(|name| format!("mtllib {name}.mtl\n"));
            let obj = lines.collect::<String>() + SQUARE + "usemtl a\nf 1 2 3 4\n";
            let read = read_shape_obj(&files, Path::new("a.obj"), obj.as_bytes()).unwrap();
            assert_eq!(read.value.groups[0].material.color, expected, "{names:?}");
            assert_eq!(read.warnings.len(), 2, "one for each content: {names:?}");
        }
    }

    #[test]
    fn vertices_that_no_face_uses_are_left_out_and_counted() {
        let read = |faces: &str| {
            let obj = SQUARE.to_owned() + faces;
            let files = HashMap::<PathBuf, Vec<u8>>::new();
            let read = read_shape_obj(&files, Path::new("a.obj"), obj.as_bytes()).unwrap();
            (read.value.positions.len(), told(&read.warnings))
        };
        let left_out = "a.obj: 1 of its 4 vertices is in no face, and left out";
        assert_eq!(read("f 1 2 3\n"), (3, vec![left_out.to_owned()]));
        assert_eq!(read("f 1 2 3 4\n"), (4, Vec::new()));
    }

    #[test]
    fn each_fault_is_told_where_it_is() {
        for (line, error) in [
            ("vt x", "1:4: expected a number for u, found “x”"),
            ("vt 0 nan", "1:6: expected a number for v, found “nan”"),
            (
                "vn 0 1",
                "1:7: expected a number for z, found the end of the line",
            ),
            (
                "usemtl",
                "1:7: expected the name of a material, found the end of the line",
            ),
        ] {
            let obj = format!("{line}\n{SQUARE}f 1 2 3\n");
            assert_eq!(
                read(&obj).map(|_| ()),
                Err(format!("a.obj:{error}")),
                "{line}"
            );
        }
        let faces = read(SQUARE).unwrap_err();
        let message = "a.obj:4:8: expected faces (lines `f a b c`), found none";
        assert_eq!(faces, message);
    }
}
