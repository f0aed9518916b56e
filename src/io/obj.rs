//! Lines of `.obj` files, as characters and shapes share them, and the mesh of a character.

use super::encoding::in_utf8;
use super::obj_face_reader::FaceReader;
use super::scanner::{STRETCH, Scanner};
use super::{Diagnostic, Imported};
use crate::geometry::{Mesh, Triangulator};
use crate::steps::{Pace, at_once};
use glam::Vec3;
use std::path::Path;

/// Reads the mesh of a character from an `.obj` file: `v` lines in their order, which the
/// weights depend on, and `f` lines of any number of corners written `a`, `a/b`, `a//c` or
/// `a/b/c`, of which only `a` counts. Other lines mean nothing for a character.
///
/// # Errors
/// At the first line that is not well formed or names a vertex that does not exist, and if there
/// are no vertices or no faces.
pub fn read_character_obj(path: &Path, bytes: &[u8]) -> Result<Imported<Mesh>, Diagnostic> {
    at_once(|pace| async move { read_character_obj_by(path, bytes, &pace).await })
}

/// As [`read_character_obj`], of a file that should have so many `vertices`, and may have no faces then: where faces name
/// vertices that are not there, the error says how many lack.
///
/// # Errors
/// As [`read_character_obj`].
pub fn read_posed_obj(
    path: &Path,
    bytes: &[u8],
    vertices: usize,
) -> Result<Imported<Mesh>, Diagnostic> {
    let faces = FaceReader::expecting(vertices);
    at_once(|pace| async move { read_mesh(path, bytes, faces, &pace).await })
}

/// As [`read_posed_obj`], of a mesh with the vertices of `model`, whose faces it gets if it has none.
///
/// # Errors
/// As [`read_character_obj`].
pub fn read_posed_vertices(
    path: &Path,
    bytes: &[u8],
    model: &Mesh,
) -> Result<Imported<Mesh>, Diagnostic> {
    let mut read = read_posed_obj(path, bytes, model.positions.len())?;
    let warning = take_faces_of(model, path, &mut read.value);
    read.warnings.extend(warning);
    Ok(read)
}

/// Whether the mesh in a file has vertices, and lacks nothing but faces.
pub fn has_vertices_alone(path: &Path, bytes: &[u8]) -> bool {
    let bytes = in_utf8(bytes);
    let Ok(mut scanner) = Scanner::new(path, &bytes) else {
        return false;
    };
    let (mut positions, mut faces) = (Vec::new(), FaceReader::default());
    loop {
        match read_lines(&mut scanner, &mut positions, &mut faces) {
            Ok(true) => {}
            Ok(false) => return !positions.is_empty() && faces.face_count() == 0,
            Err(_) => return false,
        }
    }
}

/// Gives a mesh that was read from `path` without faces those of `model`, and says so in a warning.
pub fn take_faces_of(model: &Mesh, path: &Path, read: &mut Mesh) -> Option<Diagnostic> {
    if !read.triangles.is_empty() {
        return None;
    }
    let vertices = read.positions.len();
    let is_there = |corners: &&[u32; 3]| corners.iter().all(|&corner| (corner as usize) < vertices);
    let triangles = model.triangles.iter().filter(is_there);
    read.triangles.extend(triangles);
    let message = "found no faces (lines `f a b c`): taken to be those of the model";
    Some(Diagnostic::new(path, message))
}

/// As [`read_character_obj`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_character_obj`].
pub(super) async fn read_character_obj_by(
    path: &Path,
    bytes: &[u8],
    pace: &Pace,
) -> Result<Imported<Mesh>, Diagnostic> {
    read_mesh(path, bytes, FaceReader::default(), pace).await
}

async fn read_mesh(
    path: &Path,
    bytes: &[u8],
    mut faces: FaceReader,
    pace: &Pace,
) -> Result<Imported<Mesh>, Diagnostic> {
    let bytes = in_utf8(bytes);
    let mut scanner = Scanner::new(path, &bytes)?;
    let mut positions = Vec::new();
    pace.begin(0.0..0.9);
    while read_lines(&mut scanner, &mut positions, &mut faces)? {
        pace.tell(scanner.part());
        pace.after(STRETCH).await;
    }
    let (faces, warnings) = faces.finish(&scanner)?;
    let mut cutter = Triangulator::default();
    let mut triangles = Vec::with_capacity(faces.count());
    pace.begin(0.9..1.0);
    for stretch in faces.stretches() {
        pace.tell(stretch.start as f32 / faces.count() as f32);
        faces.cut_all(stretch, &positions, &mut cutter, |corners| {
            triangles.push(corners.map(|corner| corner.position));
        });
        pace.after(STRETCH).await;
    }
    Ok(Imported {
        value: Mesh::new(positions, triangles),
        warnings: warnings.into_vec(path),
    })
}

/// Reads some lines of a character; whether there are more.
fn read_lines(
    scanner: &mut Scanner,
    positions: &mut Vec<Vec3>,
    faces: &mut FaceReader,
) -> Result<bool, Diagnostic> {
    let end = scanner.at() + STRETCH;
    loop {
        match scanner.word().map(|word| word.text) {
            Some("v") => {
                positions.push(read_position(scanner)?);
                faces.counts[0] += 1;
            }
            Some("vt") => faces.counts[1] += 1,
            Some("vn") => faces.counts[2] += 1,
            Some("f") => faces.read(scanner)?,
            _ => {}
        }
        if !scanner.next_line() {
            return Ok(false);
        }
        if scanner.at() >= end {
            return Ok(true);
        }
    }
}

/// Reads the rest of a `v` line: three coordinates, then either nothing, or a weight that
/// divides them, or a color, which is passed over.
pub(super) fn read_position(scanner: &mut Scanner) -> Result<Vec3, Diagnostic> {
    let position = read_vec3(scanner)?;
    let Some(fourth) = scanner.word() else {
        return Ok(position);
    };
    let weight = scanner.number_of(Some(fourth), "a number")?;
    if scanner.word().is_some() {
        return Ok(position);
    }
    let divided = position / weight;
    if !divided.is_finite() {
        return Err(scanner.expected("a weight to divide by", Some(fourth)));
    }
    Ok(divided)
}

/// Three coordinates.
pub(super) fn read_vec3(scanner: &mut Scanner) -> Result<Vec3, Diagnostic> {
    Ok(Vec3::new(
        scanner.number("a number for x")?,
        scanner.number("a number for y")?,
        scanner.number("a number for z")?,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Imported<Mesh>, String> {
        read_character_obj(Path::new("a.obj"), text.as_bytes()).map_err(|error| error.to_string())
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn vertices_keep_the_order_of_their_lines() {
        let mesh = read(&format!("{SQUARE}f 3 4 1\nf 3 1 2\n")).unwrap().value;
        assert_eq!(
            mesh.positions,
            [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Y, Vec3::Y]
        );
        assert_eq!(mesh.triangles, [[2, 3, 0], [2, 0, 1]]);
    }

    #[test]
    fn corners_are_read_in_every_spelling() {
        let data = format!("# c\no x\n{SQUARE}vt 0 0\nvn 0 0 1\nusemtl m # n\n");
        for face in [
            "f 1 2 3 4",
            "f\t1/1 2/1 3/1 4/1",
            "f 1//1 2//1 3//1 4//1 \r",
            "  f 1/1/1 2/1/1 3/1/1 4/1/1 # round",
            "f -4 -3 -2 -1",
            "f -4/-1/-1 2/1 3//-1 4",
        ] {
            let mesh = read(&format!("{data}{face}\n")).unwrap().value;
            assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]], "{face}");
        }
    }

    #[test]
    fn a_weight_divides_and_a_color_is_passed_over() {
        let mesh = read("v 2 4 6 2\nv 1 2 3 0.5 0.5 0.5\nv 0 0 0\nf 1 2 3\n")
            .unwrap()
            .value;
        assert_eq!(mesh.positions[0], mesh.positions[1]);
    }

    #[test]
    fn a_face_may_come_before_its_vertices() {
        let mesh = read(&format!("f 1 2 3 4\n{SQUARE}")).unwrap().value;
        assert_eq!(mesh.triangles.len(), 2);
    }

    #[test]
    fn each_fault_is_told_where_it_is() {
        for (text, error) in [
            (
                "",
                "a.obj:1:1: expected vertices (lines `v x y z`), found none",
            ),
            (
                "0 0 0\n0 1 0",
                "a.obj:2:6: expected vertices (lines `v x y z`), found none: 2 lines with three numbers begin without \
                 the v of v x y z",
            ),
            (
                "0 0 0 1 1 1",
                "a.obj:1:12: expected vertices (lines `v x y z`), found none: 1 line with three or more numbers begins \
                 without the v of v x y z",
            ),
            (
                "v 0 0 0\n",
                "a.obj:1:8: expected faces (lines `f a b c`), found none",
            ),
            (
                "v 0 0\n",
                "a.obj:1:6: expected a number for z, found the end of the line",
            ),
            (
                "v 0 0 0\nv 1 1",
                "a.obj:2:6: expected a number for z, found the end of the file: it seems to be cut off",
            ),
            (
                "v 0 0 0\nv 1 1 1",
                "a.obj:2:8: expected faces (lines `f a b c`), found none before the end of the file: it seems \
                 to be cut off",
            ),
            (
                "v 0 0 1..2\n",
                "a.obj:1:7: expected a number for z, found “1..2”",
            ),
            (
                "v 0 0 0 0\n",
                "a.obj:1:9: expected a weight to divide by, found “0”",
            ),
            (
                "v 0 0 0\nf 1 1 2\n",
                "a.obj:2:7: expected a vertex from 1 to 1, found 2",
            ),
            (
                "v 0 0 0\nf 1 1 0\n",
                "a.obj:2:7: expected a vertex counted from 1, found “0”",
            ),
            (
                "v 0 0 0\nf 0/1 1 1\n",
                "a.obj:2:3: expected a vertex counted from 1, found “0”",
            ),
            (
                "v 0 0 0\nf 1 1 1/00\n",
                "a.obj:2:7: expected a texture coordinate counted from 1, found “00”",
            ),
            (
                "v 0 0 0\nf 1 -2 1\n",
                "a.obj:2:5: expected one of the 1 vertex lines so far, found “-2”",
            ),
            (
                "v 0 0 0\nf 1 1 1/2\n",
                "a.obj:2:7: expected no texture coordinate, for the file has none, found 2",
            ),
            (
                "v 0 0 0\nf 1 1 a\n",
                "a.obj:2:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found “a”",
            ),
            (
                "v 0 0 0\nf 1 1 /1\n",
                "a.obj:2:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found “”",
            ),
            (
                "v 0 0 0\nf 1 1 1/1/1/1\n",
                "a.obj:2:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found “1/1/1/1”",
            ),
            (
                "v 0 0 0\nf 1 1 99999999999999999999\n",
                "a.obj:2:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found “99999999999999999999”",
            ),
            (
                "v 0 0 0\nf 1 1 9999999999\n",
                "a.obj:2:7: expected a vertex from 1 to 1, found 9999999999",
            ),
        ] {
            assert_eq!(read(text).map(|_| ()), Err(error.to_owned()), "{text:?}");
        }
    }

    #[test]
    fn a_face_of_fewer_than_three_corners_is_left_out_with_a_warning_that_names_its_line() {
        let read = read(&format!("{SQUARE}f 1 2\nf 1 2 3\n\n  f\n")).unwrap();
        assert_eq!(read.value.triangles, [[0, 1, 2]]);
        assert_eq!(
            told(&read.warnings),
            [
                "a.obj:5:1: expected at least three corners, found 2: the face is left out",
                "a.obj:8:1: expected at least three corners, found 0: the face is left out",
            ]
        );
    }

    #[test]
    fn a_file_that_ends_within_a_face_is_said_to_be_cut_off() {
        let data = format!("{SQUARE}vt 0 0\nvn 0 0 1\n");
        for (cut, column, triangles) in [
            ("f 1 2", 6, 1),
            ("f", 2, 1),
            ("f 1/1 2/1 3/", 13, 2),
            ("f 1/1/1 2/1/1 3/1", 18, 2),
            ("f 1//1 2//1 4", 14, 2),
        ] {
            let read = read(&format!("{data}f 2 3 4\n{cut}")).unwrap();
            assert_eq!(read.value.triangles.len(), triangles, "{cut}");
            let warning = format!(
                "a.obj:8:{column}: expected the rest of a face, found the end of the file: it seems to be \
                 cut off"
            );
            assert_eq!(told(&read.warnings), [warning], "{cut}");
        }
        for whole in ["f 1 2 3", "f 1/1 2/1 3/1 ", "f 1/1 2 3/1\n", "f 1 2 3\n#"] {
            let read = read(&format!("{data}{whole}")).unwrap();
            assert_eq!(told(&read.warnings), [""; 0], "{whole:?}");
        }
    }

    #[test]
    fn many_faces_that_are_left_out_are_counted() {
        let read = read(&format!("{SQUARE}{}f 1 2 3\n", "f 1 2\n".repeat(250))).unwrap();
        assert_eq!(read.warnings.len(), 101);
        let last = read.warnings[100].to_string();
        assert_eq!(last, "a.obj: 150 more warnings are not shown");
    }

    #[test]
    fn an_index_of_0_for_texture_coordinate_or_normal_means_none_with_one_warning() {
        let data = format!("{SQUARE}vn 0 0 1\n");
        let read = read(&format!("{data}f 1/0/1 2/0/1 3/0/1\n  f 1 3//0 4/0/0\n")).unwrap();
        assert_eq!(read.value.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(
            told(&read.warnings),
            [
                "a.obj:6:3: expected texture coordinates and normals counted from 1, found 0 in 5 \
              corners: taken as none"
            ]
        );
    }

    fn told(warnings: &[Diagnostic]) -> Vec<String> {
        warnings.iter().map(ToString::to_string).collect()
    }
}
