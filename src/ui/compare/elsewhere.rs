//! Where a figure stands, by its outline in both pictures.

use super::owned::{Owned, seen_at};
use crate::compare::{FigureOff, outline_placement};
use crate::editor::Session;
use crate::scene::ShapeId;
use glam::Vec2;

/// Most pixels that are looked at.
const MOST: usize = 12_000;

/// Whether the outline that a character has in a live view of `size` pixels is that of the other picture when it is moved,
/// scaled or turned, as where the character stands elsewhere. What is off is all told to be of the character; other shapes stand
/// still.
pub(super) fn is_elsewhere(owned: &Owned, character: ShapeId, off: &FigureOff, size: Vec2) -> bool {
    let is_own = |&pixel: &[u32; 2]| owned.is_seen_at(pixel, character);
    placement(off, size, is_own).is_some()
}

/// How the outline of all shapes in the other picture is placed in a live view of `size` pixels, in words, with how many pixels
/// a movement may be off; `None` if it is where it should be, or not there.
pub(super) fn placement_of_all(
    session: &Session,
    off: &FigureOff,
    size: (u32, u32),
) -> Option<(String, u32)> {
    if !off.has_outline {
        return None;
    }
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    // What is right may be lines of the ground as well.
    let is_of_shape =
        |&[x, y]: &[u32; 2]| seen_at(session, Vec2::new(x as f32, y as f32), size).is_some();
    placement(off, size, is_of_shape)
}

/// The same of what is off and, of what is right, what `is_own`, with how many pixels a movement may be off.
fn placement(
    off: &FigureOff,
    size: Vec2,
    is_own: impl Fn(&[u32; 2]) -> bool,
) -> Option<(String, u32)> {
    let count = off.ours.len() + off.theirs.len() + off.right.len();
    let more = count.div_ceil(MOST).isqrt() as u32;
    let apart = off.apart * more.max(1);
    let of_grid = |pixels: &[[u32; 2]]| -> Vec<[u32; 2]> {
        let on_grid = pixels
            .iter()
            .filter(|pixel| pixel.iter().all(|at| at % apart == 0));
        on_grid.copied().collect()
    };
    let [ours, theirs, mut right] = [&off.ours, &off.theirs, &off.right].map(|all| of_grid(all));
    right.retain(is_own);
    let [columns, rows] = [size.x, size.y].map(|along| (along as u32).div_ceil(apart));
    let covered = |off: &[[u32; 2]]| {
        let mut covered = vec![false; (columns * rows) as usize];
        for pixel in off.iter().chain(&right) {
            let [x, y] = pixel.map(|at| at / apart);
            // With those beside it, between which edges are left out.
            for y in y.saturating_sub(1)..(y + 2).min(rows) {
                for x in x.saturating_sub(1)..(x + 2).min(columns) {
                    covered[(y * columns + x) as usize] = true;
                }
            }
        }
        covered
    };
    outline_placement(
        columns as usize,
        [&covered(&theirs), &covered(&ours)],
        apart,
    )
    .map(|words| (words, apart))
}
