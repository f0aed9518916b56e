use super::encoding::in_utf8;
use super::scanner::{STRETCH, Scanner};
use super::{Diagnostic, Imported, Position};
use crate::character::{Attachments, Influence};
use crate::steps::{Pace, at_once};
use std::path::Path;

/// How far from 1 the weights of a vertex may sum up before a warning says so.
const SUM_TOLERANCE: f32 = 1e-2;

/// Reads an `.attach` file: a line of weights for each of `vertices`, in the order of the `v`
/// lines, with a number for each of `joints` but the first, the root, which weighs nothing
/// (course editor, "Formats"). Weights stay as the file has them; empty lines do not count.
///
/// Warns of negative weights, of vertices whose weights do not sum up to about 1, and of
/// vertices without any, which stay where they are.
///
/// # Errors
/// At the first line with another count of numbers, and if there are more or fewer lines than
/// vertices.
pub fn read_attach(
    path: &Path,
    bytes: &[u8],
    joints: usize,
    vertices: usize,
) -> Result<Imported<Attachments>, Diagnostic> {
    at_once(|pace| async move { read_attach_by(path, bytes, joints, vertices, &pace).await })
}

/// As [`read_attach`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_attach`].
pub(super) async fn read_attach_by(
    path: &Path,
    bytes: &[u8],
    joints: usize,
    vertices: usize,
    pace: &Pace,
) -> Result<Imported<Attachments>, Diagnostic> {
    let bytes = in_utf8(bytes);
    let mut scanner = Scanner::new(path, &bytes)?;
    let columns = joints.saturating_sub(1);
    let mut attachments = Attachments::new();
    let mut oddities = Oddities::default();
    let mut row = Vec::with_capacity(columns);
    let mut end = Position { line: 1, column: 1 };
    let mut rest_at = STRETCH;
    loop {
        row.clear();
        if columns == 0 {
            scanner.end_of_line()?;
        } else if read_row(&mut scanner, columns, &mut row)? {
            let here = scanner.position(None);
            if attachments.vertex_count() == vertices {
                let message = format!("expected {vertices} lines, one a vertex, found one more");
                return Err(scanner.error(Position { column: 1, ..here }, message));
            }
            oddities.look_at(&row, here.line);
            attachments.push_vertex(row.iter().copied());
            end = here;
        }
        if !scanner.next_line() {
            break;
        }
        if scanner.at() >= rest_at {
            rest_at = scanner.at() + STRETCH;
            pace.tell(scanner.part());
            pace.after(STRETCH).await;
        }
    }
    if columns == 0 {
        (0..vertices).for_each(|_| attachments.push_vertex([]));
    }
    let found = attachments.vertex_count();
    if found < vertices {
        let message = format!("expected {vertices} lines, one a vertex, found {found}");
        return Err(scanner.error(end, message));
    }
    Ok(Imported {
        value: attachments,
        warnings: oddities.warnings(&scanner),
    })
}

/// Reads the weights of one line into `row`, zeros left out; false for an empty line.
fn read_row(
    scanner: &mut Scanner,
    columns: usize,
    row: &mut Vec<Influence>,
) -> Result<bool, Diagnostic> {
    let mut read = 0;
    loop {
        read += scanner.skip_zeros(columns - read);
        let plain = (read < columns).then(|| scanner.plain_number()).flatten();
        let weight = match plain {
            Some(weight) => weight,
            None => {
                let word = scanner.word();
                let expected = || format!("{columns} weights, one for each joint but the root");
                match word {
                    None if read == 0 => return Ok(false),
                    None if read == columns => return Ok(true),
                    None => return Err(scanner.expected(&expected(), word)),
                    Some(_) if read == columns => {
                        let first_too_many = scanner.position(word);
                        let found = read + 1 + std::iter::from_fn(|| scanner.word()).count();
                        let message = format!("expected {}, found {found}", expected());
                        return Err(scanner.error(first_too_many, message));
                    }
                    word => scanner.number_of(word, "a weight")?,
                }
            }
        };
        read += 1;
        if weight != 0.0 {
            row.push(Influence {
                joint: read as u32,
                weight,
            });
        }
    }
}

/// Oddities of the weights: for each the number of vertices and the line of the first.
#[derive(Default)]
struct Oddities {
    negative: Seen,
    wrong_sum: Seen,
    without: Seen,
}

#[derive(Default)]
struct Seen {
    count: usize,
    first_line: usize,
}

impl Seen {
    fn at(&mut self, line: usize) {
        if self.count == 0 {
            self.first_line = line;
        }
        self.count += 1;
    }
}

impl Oddities {
    fn look_at(&mut self, row: &[Influence], line: usize) {
        if row.is_empty() {
            self.without.at(line);
            return;
        }
        if row.iter().any(|influence| influence.weight < 0.0) {
            self.negative.at(line);
        }
        let sum: f32 = row.iter().map(|influence| influence.weight).sum();
        if sum.is_nan() || (sum - 1.0).abs() > SUM_TOLERANCE {
            self.wrong_sum.at(line);
        }
    }

    fn warnings(&self, scanner: &Scanner) -> Vec<Diagnostic> {
        [
            (&self.negative, "negative weights"),
            (&self.wrong_sum, "weights that do not sum up to 1"),
            (&self.without, "no weights, which stay where they are"),
        ]
        .into_iter()
        .filter(|(seen, _)| seen.count > 0)
        .map(|(seen, what)| {
            let plural = if seen.count == 1 {
                "vertex"
            } else {
                "vertices"
            };
            let position = Position {
                line: seen.first_line,
                column: 1,
            };
            scanner.error(position, format!("{} {plural} with {what}", seen.count))
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, joints: usize, vertices: usize) -> Result<Imported<Attachments>, String> {
        read_attach(Path::new("a.attach"), text.as_bytes(), joints, vertices)
            .map_err(|error| error.to_string())
    }

    fn runs(attachments: &Attachments) -> Vec<Vec<(u32, f32)>> {
        let pairs = |run: &[Influence]| run.iter().map(|i| (i.joint, i.weight)).collect();
        attachments.vertices().map(pairs).collect()
    }

    #[test]
    fn column_c_is_joint_c_plus_1() {
        let read = read("0 0.25 0.75 \n1 0 0\r\n\n 0 0 1\n\n", 4, 3).unwrap();
        let expected = vec![vec![(2, 0.25), (3, 0.75)], vec![(1, 1.0)], vec![(3, 1.0)]];
        assert_eq!(runs(&read.value), expected);
        assert_eq!(read.warnings, []);
    }

    #[test]
    fn a_single_joint_has_no_columns() {
        assert_eq!(runs(&read("\n\n", 1, 2).unwrap().value), [vec![], vec![]]);
        assert!(read("1\n", 1, 1).is_err());
    }

    #[test]
    fn each_fault_is_told_where_it_is() {
        let weights = "expected 2 weights, one for each joint but the root, found";
        for (text, error) in [
            (
                "",
                "a.attach:1:1: expected 2 lines, one a vertex, found 0".to_owned(),
            ),
            (
                "0 1\n\n",
                "a.attach:1:4: expected 2 lines, one a vertex, found 1".to_owned(),
            ),
            (
                "0 1\n0 1\n\n1 0\n",
                "a.attach:4:1: expected 2 lines, one a vertex, found one more".to_owned(),
            ),
            (
                "0 1\n0\n",
                format!("a.attach:2:2: {weights} the end of the line"),
            ),
            ("0 1\n0 1 0\n", format!("a.attach:2:5: {weights} 3")),
            ("0 0 0 0\n", format!("a.attach:1:5: {weights} 4")),
            (
                "0 1\n0 o\n",
                "a.attach:2:3: expected a weight, found “o”".to_owned(),
            ),
            (
                "0 inf\n",
                "a.attach:1:3: expected a weight, found “inf”".to_owned(),
            ),
        ] {
            assert_eq!(read(text, 3, 2).map(|_| ()), Err(error), "{text:?}");
        }
    }

    #[test]
    fn odd_weights_are_counted_in_one_warning_each() {
        let read = read("0 1\n0 0\n-1 2\n0.5 0.4\n0.5 0.505\n0 0\n", 3, 6).unwrap();
        let warnings: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
        let expected = [
            "a.attach:3:1: 1 vertex with negative weights",
            "a.attach:4:1: 1 vertex with weights that do not sum up to 1",
            "a.attach:2:1: 2 vertices with no weights, which stay where they are",
        ];
        assert_eq!(warnings, expected);
    }
}
