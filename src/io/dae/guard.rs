//! Limits that keep memory and time in proportion to the file, whoever wrote it.

use crate::io::Diagnostic;
use std::path::Path;

/// Positions and triangles of one file, counted as often as they are instanced.
pub(super) const MOST_ELEMENTS: usize = 8_000_000;
/// Nodes of the scene, counted as often as they are instanced.
pub(super) const MOST_NODES: usize = 100_000;
/// Meshes in nodes of the scene, counted alike.
pub(super) const MOST_INSTANCES: usize = 100_000;
/// Elements and texts in nodes of the scene, counted alike: as many as a whole file may have.
pub(super) const MOST_CHILDREN: usize = MOST_XML_NODES as usize;
/// Joints and weights of skins, and elements that bind materials, counted alike.
pub(super) const MOST_BOUND: usize = 32_000_000;
/// Elements and texts of a file: enough for two million triangles written as `<polygons>`; memory
/// for others.
pub(super) const MOST_XML_NODES: u32 = 4_000_000;
/// Nodes inside one another.
pub(super) const MOST_DEPTH: usize = 1_000;
/// A coordinate beyond this is a fault: its square must stay finite.
pub(super) const FARTHEST: f64 = 1e15;

/// The XML reader compares each attribute of an element with all others.
const MOST_ATTRIBUTES: usize = 256;
/// It copies the name spaces in force to every element that declares one.
const MOST_NAME_SPACES: usize = 2_000;

/// Refuses text on which the XML reader's time or memory would grow with the square of its
/// length.
pub(super) fn check(path: &Path, text: &str) -> Result<(), Diagnostic> {
    if text.matches("xmlns").nth(MOST_NAME_SPACES).is_some() {
        let message = format!("expected at most {MOST_NAME_SPACES} name spaces, found more");
        return Err(Diagnostic::new(path, message));
    }
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        rest = &rest[start..];
        let after = match markup_without_attributes(rest) {
            Some(end) => rest.find(end).map(|at| at + end.len()),
            None => {
                let (attributes, length) = count_attributes(rest);
                if attributes > MOST_ATTRIBUTES {
                    let before = &text[..text.len() - rest.len()];
                    let line = before.matches('\n').count() + 1;
                    let message = format!(
                        "expected at most {MOST_ATTRIBUTES} attributes in an element, found more"
                    );
                    return Err(Diagnostic::at(path, line, 1, message));
                }
                Some(length)
            }
        };
        // What has no end is told by the XML reader.
        let Some(after) = after else { break };
        rest = &rest[after..];
    }
    Ok(())
}

/// What ends the comment, text as it stands, or instruction at the start of `rest`; `None` for a
/// tag. A document type is none of these: the reader refuses it.
fn markup_without_attributes(rest: &str) -> Option<&'static str> {
    let kinds = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
    let found = kinds.iter().find(|(start, _)| rest.starts_with(start));
    found.map(|(_, end)| *end)
}

/// The attributes of the tag at the start of `rest`, and its length in bytes. What stands in
/// quotes is a value, `>` included.
fn count_attributes(rest: &str) -> (usize, usize) {
    let mut attributes = 0;
    let mut quote = None;
    for (at, &byte) in rest.as_bytes().iter().enumerate() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (Some(_), _) => {}
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => attributes += 1,
            (None, b'>') => return (attributes, at + 1),
            (None, _) => {}
        }
    }
    (attributes, rest.len())
}
