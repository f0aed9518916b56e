//! `f` lines of `.obj` files.

use super::diagnostic::Warnings;
use super::obj_faces::{Corner, Faces};
use super::scanner::{CUT_OFF, Scanner, Word, quoted};
use super::{Diagnostic, Position};

const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Reads `f` lines and remembers which of them name something that does not exist yet.
#[derive(Default)]
pub(super) struct FaceReader {
    /// How many vertices, texture coordinates and normals were read so far.
    pub counts: [usize; 3],
    /// How many vertices the file should have, if that is known. One that has them may have no faces.
    expected_vertices: Option<usize>,
    faces: Faces,
    ahead: Vec<Ahead>,
    warnings: Warnings,
    /// Corners with an index of 0 for texture coordinate or normal: how many, and the first.
    zeros: usize,
    first_zero: Option<Position>,
}

/// An index that was past the end when it was read, or [`NOWHERE`].
struct Ahead {
    kind: usize,
    index: i64,
    at: Position,
}

/// The index of 0, which counts from 1.
const NOWHERE: i64 = -1;

impl Ahead {
    /// Whether it names nothing in a file that has these many vertices, texture coordinates and normals.
    fn is_missing(&self, counts: &[usize; 3]) -> bool {
        self.index == NOWHERE || self.index >= counts[self.kind] as i64
    }
}

impl FaceReader {
    /// A reader for a file that should have so many vertices, and may have no faces then.
    pub fn expecting(vertices: usize) -> Self {
        Self {
            expected_vertices: Some(vertices),
            ..Self::default()
        }
    }

    /// Makes room for so many triangles.
    pub fn make_room(&mut self, triangles: usize) {
        self.faces.make_room(triangles);
    }

    /// How many faces were read so far.
    pub fn face_count(&self) -> usize {
        self.faces.count()
    }

    /// Reads the rest of an `f` line. A face of fewer than three corners is left out, with a warning.
    ///
    /// # Errors
    /// At the first corner that is not well formed.
    pub fn read(&mut self, scanner: &mut Scanner) -> Result<(), Diagnostic> {
        let first = self.faces.corner_count();
        while let Some(corner) = self.next_corner(scanner)? {
            self.faces.push(corner);
        }
        let found = self.faces.corner_count() - first;
        if scanner.is_at_open_end() && self.faces.is_broken_off(first) {
            let message =
                format!("expected the rest of a face, found the end of the file: {CUT_OFF}");
            let warning = scanner.error(scanner.end(), message);
            self.warnings.push_with(|| warning);
            if found < 3 {
                self.faces.truncate(first);
                return Ok(());
            }
        }
        if found < 3 {
            self.faces.truncate(first);
            let line = scanner.position(None).line;
            self.warnings.push_with(|| {
                let message =
                    format!("expected at least three corners, found {found}: the face is left out");
                scanner.error(Position { line, column: 1 }, message)
            });
        } else {
            self.faces.close(first);
        }
        Ok(())
    }

    #[inline]
    fn next_corner(&mut self, scanner: &mut Scanner) -> Result<Option<Corner>, Diagnostic> {
        if let Some([position, texture, normal]) = scanner.plain_corner(&self.counts) {
            return Ok(Some(Corner {
                position: position - 1,
                texture: texture.checked_sub(1),
                normal: normal.checked_sub(1),
            }));
        }
        let word = scanner.word();
        word.map(|word| self.corner(scanner, word)).transpose()
    }

    fn corner(&mut self, scanner: &Scanner, word: Word) -> Result<Corner, Diagnostic> {
        let mut parts = word.text.split('/');
        let mut indices = [None; 3];
        let mut has_zero = false;
        for (kind, index) in indices.iter_mut().enumerate() {
            *index = match parts.next() {
                None => None,
                Some("") if kind > 0 => None,
                // Exporters write this where a corner has none.
                Some("0") if kind > 0 => {
                    has_zero = true;
                    None
                }
                Some(part) => Some(self.index(scanner, word, part, kind)?),
            };
        }
        if has_zero {
            self.zeros += 1;
            self.first_zero
                .get_or_insert_with(|| scanner.position(Some(word)));
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
            0 if kind == 0 && self.expected_vertices.is_some() => NOWHERE,
            0 => return Err(wrong(&format!("a {name} counted from 1"))),
            1.. => number - 1,
            _ => count as i64 + number,
        };
        if index < 0 && number < 0 {
            return Err(wrong(&format!("one of the {count} {name} lines so far")));
        }
        if index == NOWHERE || index >= count as i64 {
            self.ahead.push(Ahead {
                kind,
                index,
                at: scanner.position(Some(word)),
            });
        }
        // What does not fit is too large for any file, and told when its end is reached.
        Ok(u32::try_from(index).unwrap_or(u32::MAX))
    }

    /// The faces and the warnings about them, at the end of the file.
    ///
    /// # Errors
    /// At the first corner that names something that does not exist, and if there are no vertices
    /// or no faces.
    pub fn finish(mut self, scanner: &Scanner) -> Result<(Faces, Warnings), Diagnostic> {
        let found = self.counts[0];
        // One that is missing or too many is a mistake with a name, beside which the others can be told to be right.
        let has_all = |expected: usize| found > 0 && found.abs_diff(expected) <= 1;
        let has_all = self.expected_vertices.is_some_and(has_all);
        let missing = || self.ahead.iter().filter(|a| a.is_missing(&self.counts));
        if let Some(first) = missing().next().filter(|_| !has_all) {
            return Err(self.does_not_exist(scanner, first));
        }
        // The vertices of the mesh are known to be all: they can be told to be right though faces are wrong, of which
        // texture coordinates and normals do not count.
        if let Some(first) = missing().find(|a| a.kind > 0) {
            let mut warning = self.does_not_exist(scanner, first);
            warning.message += ": taken as none";
            self.warnings.push_with(|| warning);
        }
        if let Some(first) = missing().find(|a| a.kind == 0) {
            let wrong = self.does_not_exist(scanner, first);
            let left_out = self.faces.outside(self.counts[0]);
            if left_out == self.faces.count() {
                return Err(wrong);
            }
            let plural = if left_out == 1 { " is" } else { "s are" };
            let mut warning = wrong;
            warning.message += &format!(": {left_out} face{plural} left out");
            self.warnings.push_with(|| warning);
        }
        let nothing = match (self.counts[0], self.faces.count()) {
            (0, _) => Some("vertices (lines `v x y z`)"),
            (_, 0) if has_all => None,
            (_, 0) => Some("faces (lines `f a b c`)"),
            _ => None,
        };
        let expected = self.expected_vertices.filter(|_| self.counts[0] > 0);
        if let (Some(_), Some(expected)) = (nothing, expected) {
            let found = self.counts[0];
            let vertices = if found == 1 { "vertex" } else { "vertices" };
            let hint = match found < expected {
                true => ": the file may be cut off",
                false => "",
            };
            let message = format!(
                "expected {expected} vertices, or faces, found {found} {vertices} alone{hint}"
            );
            return Err(scanner.error(scanner.end(), message));
        }
        if let Some(nothing) = nothing {
            let meant = (self.counts[0] == 0).then(|| without_v(scanner.text()));
            let why = match meant.flatten() {
                Some(meant) => format!(": {meant}"),
                None if scanner.is_at_open_end() => {
                    format!(" before the end of the file: {CUT_OFF}")
                }
                None => String::new(),
            };
            let message = format!("expected {nothing}, found none{why}");
            return Err(scanner.error(scanner.end(), message));
        }
        if let Some(first) = self.first_zero {
            let (zeros, plural) = (self.zeros, if self.zeros == 1 { "" } else { "s" });
            self.warnings.push_with(|| {
                let message = format!(
                    "expected texture coordinates and normals counted from 1, found 0 in {zeros} \
                     corner{plural}: taken as none"
                );
                scanner.error(first, message)
            });
        }
        Ok((self.faces, self.warnings))
    }

    fn does_not_exist(&self, scanner: &Scanner, missing: &Ahead) -> Diagnostic {
        let (count, name) = (self.counts[missing.kind], KINDS[missing.kind]);
        if missing.index == NOWHERE {
            let message = format!("expected a {name} counted from 1, found 0");
            return scanner.error(missing.at, message);
        }
        let found = missing.index + 1;
        let mut message = if count == 0 {
            format!("expected no {name}, for the file has none, found {found}")
        } else {
            format!("expected a {name} from 1 to {count}, found {found}")
        };
        let expected = self.expected_vertices.filter(|_| missing.kind == 0);
        if let Some(expected) = expected.filter(|expected| *expected > count) {
            let lacking = expected - count;
            message += &format!(": the file lacks {lacking} of {expected} vertices");
        }
        scanner.error(missing.at, message)
    }
}

/// Whether any line of an `.obj` file, by its text, is one of a vertex.
pub fn has_vertices(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_ascii_start);
    lines.any(|line| line.starts_with("v ") || line.starts_with("v\t"))
}

/// How many lines of a file without vertices may be meant for some, in words; `None` if none may be.
pub fn without_v(text: &str) -> Option<String> {
    let numbers = |line: &str| {
        let words = line.split(|c: char| c.is_whitespace() || c == ',');
        let words = words.filter(|word| !word.is_empty() && *word != "V");
        words.take_while(|word| word.parse::<f64>().is_ok()).count()
    };
    let counts = text.lines().map(numbers).filter(|&numbers| numbers >= 3);
    let (lines, most) = counts.fold((0, 3), |(lines, most), count| (lines + 1, most.max(count)));
    let or_more = if most > 3 { " or more" } else { "" };
    let begin = match lines {
        0 => return None,
        1 => format!("1 line with three{or_more} numbers begins"),
        lines => format!("{lines} lines with three{or_more} numbers begin"),
    };
    Some(format!("{begin} without the v of v x y z"))
}
