//! Whether a character stands elsewhere, by its outline in both pictures.

use super::owned::Owned;
use crate::compare::{FigureOff, Finding, Pair};
use crate::geometry::Picture;
use crate::scene::ShapeId;
use glam::Vec2;

/// Most pixels that are looked at.
const MOST: usize = 12_000;

/// Whether the outline that a character has in a live view of `size` pixels is that of the other picture when it is moved,
/// scaled or turned, as where the character stands elsewhere. What is off is all told to be of the character; other shapes stand
/// still.
pub(super) fn is_elsewhere(owned: &Owned, character: ShapeId, off: &FigureOff, size: Vec2) -> bool {
    let count = off.ours.len() + off.theirs.len() + off.right.len();
    let more = count.div_ceil(MOST).isqrt() as u32;
    let apart = off.apart * more.max(1);
    let of_grid = |pixels: &[[u32; 2]]| -> Vec<[u32; 2]> {
        let on_grid = pixels
            .iter()
            .filter(|pixel| pixel.iter().all(|at| at % apart == 0));
        on_grid.copied().collect()
    };
    let is_own = |&[x, y]: &[u32; 2]| owned.is_seen_at([x, y], character);
    let [ours, theirs, mut right] = [&off.ours, &off.theirs, &off.right].map(|all| of_grid(all));
    right.retain(is_own);
    let grid = (
        (size.x as u32).div_ceil(apart),
        (size.y as u32).div_ceil(apart),
    );
    let painted = |off: &[[u32; 2]]| {
        let mut picture = Picture {
            width: grid.0,
            height: grid.1,
            rgba: [0, 0, 0, 255].repeat((grid.0 * grid.1) as usize),
        };
        for pixel in off.iter().chain(&right) {
            let [x, y] = pixel.map(|at| at / apart);
            // With those beside it, between which edges are left out.
            for y in y.saturating_sub(1)..(y + 2).min(grid.1) {
                for x in x.saturating_sub(1)..(x + 2).min(grid.0) {
                    let at = 4 * (y * grid.0 + x) as usize;
                    picture.rgba[at..at + 3].fill(255);
                }
            }
        }
        picture
    };
    let [theirs, ours] = [theirs, ours].map(|off| painted(&off));
    let Ok(pair) = Pair::new(&theirs, &ours, &[]) else {
        return false;
    };
    pair.findings()
        .iter()
        .any(|finding| Finding::placement(finding).is_some())
}
