//! Limits that keep memory and time in proportion to the file, whoever wrote it.

use crate::io::Diagnostic;
use std::path::Path;

/// Positions and triangles of one file, counted as often as they are instanced.
pub(super) const MOST_ELEMENTS: usize = 8_000_000;
/// Nodes of the scene, counted as often as they are instanced.
pub(super) const MOST_NODES: usize = 100_000;
/// Nodes inside one another.
pub(super) const MOST_DEPTH: usize = 1_000;
/// Cubes of the corners of large polygons, summed over a file.
pub(super) const MOST_EAR_WORK: usize = 2_000_000_000;
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
    let mut attributes = 0;
    let mut in_tag = false;
    let mut previous = b' ';
    for (at, &byte) in text.as_bytes().iter().enumerate() {
        match byte {
            b'<' => (in_tag, attributes) = (true, 0),
            // Comments and the like.
            b'!' | b'?' if previous == b'<' => in_tag = false,
            b'>' => in_tag = false,
            b'=' if in_tag => attributes += 1,
            _ => {}
        }
        if attributes > MOST_ATTRIBUTES {
            let line = text[..at].matches('\n').count() + 1;
            let message =
                format!("expected at most {MOST_ATTRIBUTES} attributes in an element, found more");
            return Err(Diagnostic::at(path, line, 1, message));
        }
        previous = byte;
    }
    Ok(())
}
