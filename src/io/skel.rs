use super::encoding::in_utf8;
use super::scanner::{Scanner, Word, quoted};
use super::{Diagnostic, Imported, Position};
use crate::character::{Joint, SkeletalModel, SkeletonError};
use glam::Vec3;
use std::collections::HashMap;
use std::path::Path;

/// A joint as its line has it.
struct Row<'a> {
    offset: Vec3,
    parent: Option<usize>,
    name: Option<&'a str>,
    /// Where its parent stands in the file.
    at: Position,
}

/// Reads a `.skel` file: a joint a line as `x y z parent`, where the offset is relative to the
/// parent and the parent is the number of its line without counting empty ones, from 0, or -1
/// for the one root (course editor, "Formats"). `# name` at the end of a line names the joint;
/// empty lines and lines that are a comment do not count. Parents may come after their children.
///
/// # Errors
/// At the first line that is not that, and where the joints are no tree with one root.
pub fn read_skel(path: &Path, bytes: &[u8]) -> Result<Imported<SkeletalModel>, Diagnostic> {
    let bytes = in_utf8(bytes);
    let mut scanner = Scanner::new(path, &bytes)?;
    let mut rows = Vec::new();
    loop {
        if let Some(word) = scanner.word() {
            rows.push(read_row(&mut scanner, word)?);
        }
        if !scanner.next_line() {
            break;
        }
    }
    check_roots(&scanner, &rows)?;

    let count = rows.len();
    let joints = rows
        .iter()
        .enumerate()
        .map(|(index, row)| Joint {
            name: row
                .name
                .map_or_else(|| Joint::default_name(index, count), str::to_owned),
            parent: row.parent,
            offset: row.offset,
            ..Joint::default()
        })
        .collect();
    let skeleton = SkeletalModel::new(joints).map_err(|error| {
        let at = error.joint().and_then(|joint| rows.get(joint));
        match at {
            Some(row) => scanner.error(row.at, explain(&error)),
            None => scanner.error(scanner.end(), explain(&error)),
        }
    })?;
    let far = skeleton
        .bind_positions()
        .iter()
        .position(|p| !p.is_finite());
    if let Some(row) = far.and_then(|joint| rows.get(joint)) {
        return Err(scanner.error(
            row.at,
            "expected offsets whose sum is a number, found one too large",
        ));
    }
    Ok(Imported {
        warnings: repeated_names(&scanner, &rows),
        value: skeleton,
    })
}

fn read_row<'a>(scanner: &mut Scanner<'a>, first: Word<'a>) -> Result<Row<'a>, Diagnostic> {
    let x = scanner.number_of(Some(first), "a number for the joint's x")?;
    let y = scanner.number("a number for the joint's y")?;
    let z = scanner.number("a number for the joint's z")?;
    let word = scanner.word();
    let at = scanner.position(word);
    let parent = match word.map(|word| word.text.parse::<i64>()) {
        Some(Ok(-1)) => None,
        Some(Ok(parent)) if parent >= 0 => Some(usize::try_from(parent).unwrap_or(usize::MAX)),
        _ => return Err(scanner.expected("the index of the parent, or -1 for the root", word)),
    };
    scanner.end_of_line()?;
    Ok(Row {
        offset: Vec3::new(x, y, z),
        parent,
        name: scanner.comment().filter(|name| !name.is_empty()),
        at,
    })
}

/// A character of the course has one root: `.attach` files have no column for its weights.
fn check_roots(scanner: &Scanner, rows: &[Row]) -> Result<(), Diagnostic> {
    let mut roots = rows.iter().filter(|row| row.parent.is_none());
    match (roots.next(), roots.next()) {
        (Some(first), Some(second)) => Err(scanner.error(
            second.at,
            format!(
                "expected the index of a parent, found -1: the root is on line {}",
                first.at.line
            ),
        )),
        _ => Ok(()),
    }
}

fn explain(error: &SkeletonError) -> String {
    match error {
        SkeletonError::Empty => "expected a line `x y z parent` for each joint, found none".into(),
        SkeletonError::BadParent { parent, count, .. } => {
            format!("expected a parent below {count}, the number of joints, found {parent}")
        }
        SkeletonError::Cycle { joint } => {
            format!("expected parents that lead to the root, found joint {joint} above itself")
        }
    }
}

/// Poses name joints, so a name that is used twice reaches only the first.
fn repeated_names(scanner: &Scanner, rows: &[Row]) -> Vec<Diagnostic> {
    let mut first_line = HashMap::new();
    let mut warnings = Vec::new();
    for row in rows {
        let Some(name) = row.name else { continue };
        if let Some(line) = first_line.get(name) {
            let message = format!(
                "expected a name of its own, found {} as on line {line}",
                quoted(name)
            );
            warnings.push(scanner.error(row.at, message));
        } else {
            first_line.insert(name, row.at.line);
        }
    }
    warnings
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Imported<SkeletalModel>, String> {
        read_skel(Path::new("a.skel"), text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_comment_at_the_end_of_a_line_names_the_joint() {
        let text = "# a snake\r\n\r\n0 0 1 1 # Tail tip\r\n0 2 0 -1\r\n\r\n";
        let joints = read(text).unwrap().value.joints().to_vec();
        assert_eq!(joints.len(), 2);
        assert_eq!((&*joints[0].name, joints[0].parent), ("Tail tip", Some(1)));
        assert_eq!((&*joints[1].name, joints[1].parent), ("Joint 1", None));
    }

    #[test]
    fn eighteen_joints_without_names_have_the_names_of_the_course() {
        let text = format!("0 0 0 -1\n{}", "0 1 0 0\n".repeat(17));
        let skeleton = read(&text).unwrap().value;
        assert_eq!(skeleton.joints()[14].name, "Right elbow");
    }

    #[test]
    fn each_fault_is_told_where_it_is() {
        for (text, error) in [
            (
                "",
                "a.skel:1:1: expected a line `x y z parent` for each joint, found none",
            ),
            (
                "\n \n# nothing\n",
                "a.skel:3:10: expected a line `x y z parent` for each joint, found none",
            ),
            (
                "0 0 0 -1\n0 0 one 0\n",
                "a.skel:2:5: expected a number for the joint's z, found “one”",
            ),
            (
                "0 0 0 -1\n  nan 0 0 0\n",
                "a.skel:2:3: expected a number for the joint's x, found “nan”",
            ),
            (
                "0 0 0 -1\n0 0 0\n",
                "a.skel:2:6: expected the index of the parent, or -1 for the root, found the end of the line",
            ),
            (
                "0 0 0 -1 7\n",
                "a.skel:1:10: expected the end of the line, found “7”",
            ),
            (
                "0 0 0 -2\n",
                "a.skel:1:7: expected the index of the parent, or -1 for the root, found “-2”",
            ),
            (
                "0 0 0 -1\n0 0 0 2\n",
                "a.skel:2:7: expected a parent below 2, the number of joints, found 2",
            ),
            (
                "0 0 0 -1\n0 0 0 0\n0 0 0 -1\n",
                "a.skel:3:7: expected the index of a parent, found -1: the root is on line 1",
            ),
            (
                "0 0 0 -1\n0 0 0 2\n0 0 0 3\n0 0 0 2\n",
                "a.skel:3:7: expected parents that lead to the root, found joint 2 above itself",
            ),
            (
                "0 0 0 0\n",
                "a.skel:1:7: expected parents that lead to the root, found joint 0 above itself",
            ),
            (
                "3e38 0 0 -1\n3e38 0 0 0\n",
                "a.skel:2:10: expected offsets whose sum is a number, found one too large",
            ),
        ] {
            assert_eq!(read(text).map(|_| ()), Err(error.to_owned()), "{text:?}");
        }
    }

    #[test]
    fn a_name_used_twice_is_a_warning() {
        let read = read("0 0 0 -1 # a\n0 0 0 0 # a\n").unwrap();
        assert_eq!(
            read.warnings[0].to_string(),
            "a.skel:2:7: expected a name of its own, found “a” as on line 1"
        );
    }
}
