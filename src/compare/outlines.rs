//! Where an outline is in a picture that may show it elsewhere.

use super::Pair;
use super::diagnosis::Finding;
use crate::geometry::Picture;

/// How the outline A is placed in B, in words: two pictures of `width` columns, row by row, each of which has the pixels that its
/// outline covers. `None` if A is where it was, or not in B.
pub fn outline_placement(width: usize, a: &[bool], b: &[bool]) -> Option<String> {
    let painted = |outline: &[bool]| Picture {
        width: width as u32,
        height: (outline.len() / width.max(1)) as u32,
        rgba: outline.iter().copied().flat_map(white_on_black).collect(),
    };
    let [a, b] = [a, b].map(painted);
    let pair = Pair::new(&a, &b, &[]).ok()?;
    pair.findings().iter().find_map(Finding::placement)
}

fn white_on_black(is_covered: bool) -> [u8; 4] {
    let value = if is_covered { 255 } else { 0 };
    [value, value, value, 255]
}
