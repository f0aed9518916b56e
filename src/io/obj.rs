use super::scanner::{Scanner, Word, finite, quoted};
use super::{Diagnostic, Imported, Position};
use crate::geometry::{Mesh, Triangulator};
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
    let mut scanner = Scanner::new(path, bytes)?;
    let mut positions = Vec::new();
    let mut faces = FaceReader::default();
    let (mut corners, mut arities) = (Vec::new(), Vec::new());
    loop {
        match scanner.word().map(|word| word.text) {
            Some("v") => {
                positions.push(read_position(&mut scanner)?);
                faces.counts[0] += 1;
            }
            Some("vt") => faces.counts[1] += 1,
            Some("vn") => faces.counts[2] += 1,
            Some("f") => {
                let first = corners.len();
                let arity = faces.read(&mut scanner, |corner| corners.push(corner.position))?;
                if arity < 3 {
                    corners.truncate(first);
                } else {
                    arities.push(arity);
                }
            }
            _ => {}
        }
        if !scanner.next_line() {
            break;
        }
    }
    faces.check(&scanner)?;
    check_not_empty(path, positions.len(), arities.len())?;
    let mut cutter = Triangulator::default();
    let triangles = triangles(&mut cutter, &positions, &corners, &arities);
    Ok(Imported {
        value: Mesh::new(positions, triangles),
        warnings: faces.warnings(&scanner),
    })
}

/// The faces whose corners, all in one row, are indices into `positions`, as triangles;
/// `arities` are the counts of their corners.
pub(super) fn triangles(
    cutter: &mut Triangulator,
    positions: &[Vec3],
    corners: &[u32],
    arities: &[u32],
) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(arities.len());
    let mut left = corners;
    for &arity in arities {
        let (face, after) = left.split_at(arity as usize);
        left = after;
        if let &[a, b, c] = face {
            triangles.push([a, b, c]);
        } else {
            let around: Vec<Vec3> = face.iter().map(|&i| positions[i as usize]).collect();
            triangles.extend(cutter.cut(&around).iter().map(|t| t.map(|i| face[i])));
        }
    }
    triangles
}

/// # Errors
/// If a file has nothing to draw.
pub(super) fn check_not_empty(
    path: &Path,
    vertices: usize,
    faces: usize,
) -> Result<(), Diagnostic> {
    let missing = match (vertices, faces) {
        (0, _) => "vertices (lines `v x y z`)",
        (_, 0) => "faces (lines `f a b c`)",
        _ => return Ok(()),
    };
    Err(Diagnostic::new(
        path,
        format!("expected {missing}, found none"),
    ))
}

/// What follows the `v` of a line: three coordinates, then either nothing, or a weight that
/// divides them, or a color, which is passed over.
pub(super) fn read_position(scanner: &mut Scanner) -> Result<Vec3, Diagnostic> {
    let position = read_vec3(scanner)?;
    let Some(fourth) = scanner.word() else {
        return Ok(position);
    };
    let weight = finite(fourth.text).ok_or_else(|| scanner.expected("a number", Some(fourth)))?;
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

/// One corner of a face, in indices from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub position: u32,
    pub texture: Option<u32>,
    pub normal: Option<u32>,
}

const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Reads `f` lines and remembers which of them name something that does not exist yet.
#[derive(Default)]
pub(super) struct FaceReader {
    /// How many vertices, texture coordinates and normals were read so far.
    pub counts: [usize; 3],
    ahead: Vec<Ahead>,
    too_small: usize,
    first_too_small: Option<Position>,
}

/// An index that was past the end when it was read.
struct Ahead {
    kind: usize,
    index: i64,
    at: Position,
}

impl FaceReader {
    /// Reads what follows the `f`, and hands each corner to `corner`. The number of corners is
    /// returned; faces of fewer than three are counted for [`FaceReader::warnings`].
    pub fn read(
        &mut self,
        scanner: &mut Scanner,
        mut corner: impl FnMut(Corner),
    ) -> Result<u32, Diagnostic> {
        let mut arity = 0;
        while let Some(word) = scanner.word() {
            corner(self.corner(scanner, word)?);
            arity += 1;
        }
        if arity < 3 {
            self.too_small += 1;
            let here = scanner.position(None);
            self.first_too_small.get_or_insert(here);
        }
        Ok(arity)
    }

    fn corner(&mut self, scanner: &Scanner, word: Word) -> Result<Corner, Diagnostic> {
        let mut parts = word.text.split('/');
        let mut indices = [None; 3];
        for (kind, index) in indices.iter_mut().enumerate() {
            *index = match parts.next() {
                Some("") if kind > 0 => None,
                Some(part) => Some(self.index(scanner, word, part, kind)?),
                None => None,
            };
        }
        match (indices, parts.next()) {
            ([Some(position), texture, normal], None) => Ok(Corner {
                position,
                texture,
                normal,
            }),
            _ => Err(scanner.expected("a corner such as 1, 1/2, 1//3 or 1/2/3", Some(word))),
        }
    }

    /// An index counted from 1, or from the end if it is negative.
    fn index(
        &mut self,
        scanner: &Scanner,
        word: Word,
        part: &str,
        kind: usize,
    ) -> Result<u32, Diagnostic> {
        let count = self.counts[kind];
        let name = KINDS[kind];
        let wrong = |what: &str| {
            let found = quoted(part);
            scanner.error(
                scanner.position(Some(word)),
                format!("expected {what}, found {found}"),
            )
        };
        let number: i64 = part
            .parse()
            .map_err(|_| wrong("a corner such as 1, 1/2, 1//3 or 1/2/3"))?;
        let index = match number {
            0 => return Err(wrong(&format!("a {name} counted from 1"))),
            1.. => number - 1,
            _ => count as i64 + number,
        };
        if index < 0 {
            return Err(wrong(&format!("one of the {count} {name} lines so far")));
        }
        if index >= count as i64 {
            self.ahead.push(Ahead {
                kind,
                index,
                at: scanner.position(Some(word)),
            });
        }
        // What does not fit is too large for any file, and told when its end is reached.
        Ok(u32::try_from(index).unwrap_or(u32::MAX))
    }

    /// To be called at the end of the file.
    ///
    /// # Errors
    /// At the first corner that names something that does not exist.
    pub fn check(&self, scanner: &Scanner) -> Result<(), Diagnostic> {
        let bad = self
            .ahead
            .iter()
            .find(|a| a.index >= self.counts[a.kind] as i64);
        bad.map_or(Ok(()), |bad| {
            let (count, name, found) = (self.counts[bad.kind], KINDS[bad.kind], bad.index + 1);
            let message = if count == 0 {
                format!("expected no {name}, for the file has none, found {found}")
            } else {
                format!("expected a {name} from 1 to {count}, found {found}")
            };
            Err(scanner.error(bad.at, message))
        })
    }

    /// What was odd about the faces.
    pub fn warnings(&self, scanner: &Scanner) -> Vec<Diagnostic> {
        let count = self.too_small;
        let message = format!("{count} faces with fewer than three corners, which are left out");
        let at = self.first_too_small.map(|at| Position { column: 1, ..at });
        at.map(|at| scanner.error(at, message))
            .into_iter()
            .collect()
    }
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
            ("", "a.obj: expected vertices (lines `v x y z`), found none"),
            (
                "v 0 0 0\n",
                "a.obj: expected faces (lines `f a b c`), found none",
            ),
            (
                "v 0 0\n",
                "a.obj:1:6: expected a number for z, found the end of the line",
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
    fn faces_too_small_are_left_out_with_a_warning() {
        let read = read(&format!("{SQUARE}f 1 2\nf 1 2 3\nf\n")).unwrap();
        assert_eq!(read.value.triangles.len(), 1);
        assert_eq!(
            read.warnings[0].to_string(),
            "a.obj:5:1: 2 faces with fewer than three corners, which are left out"
        );
    }
}
