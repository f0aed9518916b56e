//! Where an outline is in a picture that may show it elsewhere.

use super::Pair;
use super::diagnosis::Finding;
use crate::geometry::Picture;
use glam::DVec2;

/// How the outline A is placed in B, in words: two pictures of `width` columns, row by row, each of which has the pixels that its
/// outline covers. They stand for pixels that are `apart`, in which a movement is told. `None` if A is where it was, or not in B.
pub fn outline_placement(width: usize, [a, b]: [&[bool]; 2], apart: u32) -> Option<String> {
    let [a, b] = [a, b].map(|outline| painted(width, outline));
    let pair = Pair::new(&a, &b, &[]).ok()?;
    let findings = pair.findings().into_iter();
    let mut placements =
        findings.filter_map(|found| moved_farther(found, apart as i32).placement());
    placements.next()
}

/// How an outline A is placed in B which is all that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct WholePlaced {
    /// In words.
    pub words: String,
    /// The middle of A, in pixels from the top left.
    pub middle: DVec2,
    /// How far it is moved, in pixels.
    pub by: DVec2,
    /// How many times as large it is.
    pub factor: f64,
    /// How far it is turned, clockwise as it is seen.
    pub degrees: f64,
}

/// The same of outlines pixel by pixel, where they are of a figure alone, no part of which stands still if it is elsewhere.
pub fn whole_outline_placed(width: usize, [a, b]: [&[bool]; 2]) -> Option<WholePlaced> {
    let [a, b] = [a, b].map(|outline| painted(width, outline));
    let (middle, finding) = Pair::new(&a, &b, &[]).ok()?.whole_placed()?;
    match finding {
        Finding::Placed {
            dx,
            dy,
            factor,
            degrees,
            ..
        } => Some(WholePlaced {
            words: finding.placement()?,
            middle,
            by: DVec2::new(dx.into(), dy.into()),
            factor,
            degrees,
        }),
        _ => None,
    }
}

/// A picture of so many columns in which an outline is white on black.
fn painted(width: usize, outline: &[bool]) -> Picture {
    Picture {
        width: width as u32,
        height: (outline.len() / width.max(1)) as u32,
        rgba: outline.iter().copied().flat_map(white_on_black).collect(),
    }
}

/// The same finding where a movement is so many times as far.
fn moved_farther(mut finding: Finding, times: i32) -> Finding {
    if let Finding::Shifted { dx, dy } | Finding::Placed { dx, dy, .. } = &mut finding {
        (*dx, *dy) = (*dx * times, *dy * times);
    }
    finding
}

fn white_on_black(is_covered: bool) -> [u8; 4] {
    let value = if is_covered { 255 } else { 0 };
    [value, value, value, 255]
}
