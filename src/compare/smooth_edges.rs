//! Whether a picture was drawn with smooth edges.

use super::differences::difference;
use crate::geometry::Picture;

/// Difference of a channel from one side of an edge to the other, at least.
const EDGE: u8 = 48;
/// Difference of a channel between pixels on one side, at most.
const FLAT: u8 = 10;
/// Part of the difference by which the pixel at a smooth edge is away from either side, at least.
const BETWEEN: f32 = 0.2;
/// How far a channel of it may be outside of those of both sides, at most: further there is a thin line, as along bones.
const OUTSIDE: u8 = 10;
/// Share of the edges at which there is such a pixel from which on all are smooth: in pictures of this program with four samples
/// a pixel that was 0.63 to 0.69, …
const SMOOTH: f32 = 0.4;
/// … and up to which none is: in pictures of the course's program it was 0. Between, as with 0.1 where many thin lines are drawn,
/// and with 0.11 to 0.19 on the Virtual Mannequin's page, it tells nothing.
const HARD: f32 = 0.05;
/// Fewest edges that tell something.
const FEWEST: u32 = 50;

/// Whether at many edges along the rows of a picture there is a pixel whose color is between those of both sides; `None` where
/// that is not clear.
pub fn has_smooth_edges(picture: &Picture) -> Option<bool> {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let (mut edges, mut smooth) = (0, 0);
    for row in pixels.chunks(picture.width.max(1) as usize) {
        for window in row.windows(5) {
            let &[before, left, middle, right, after] = window else {
                continue;
            };
            let across = difference(left, right);
            let is_edge = across >= EDGE
                && difference(before, left) <= FLAT
                && difference(right, after) <= FLAT;
            if is_edge {
                let least = BETWEEN * f32::from(across);
                let away = [left, right].map(|side| f32::from(difference(middle, side)));
                edges += 1;
                let is_away = away.iter().all(|away| *away >= least);
                smooth += u32::from(is_away && is_between(middle, left, right));
            }
        }
    }
    match smooth as f32 / edges.max(FEWEST) as f32 {
        _ if edges < FEWEST => None,
        ..=HARD => Some(false),
        SMOOTH.. => Some(true),
        _ => None,
    }
}

/// Whether every channel of a pixel is between those of two others, or hardly outside.
fn is_between(pixel: [u8; 4], left: [u8; 4], right: [u8; 4]) -> bool {
    (0..3).all(|channel| {
        let least = left[channel].min(right[channel]).saturating_sub(OUTSIDE);
        let most = left[channel].max(right[channel]).saturating_add(OUTSIDE);
        (least..=most).contains(&pixel[channel])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk before a gradient, whose edge is `soft` pixels wide.
    fn disk(soft: f32) -> Picture {
        let pixels = (0..60 * 60).flat_map(|at| {
            let (x, y) = ((at % 60) as f32, (at / 60) as f32);
            let inside = 20.5 - (x - 30.0).hypot(y - 30.0);
            let share = (0.5 + inside / soft).clamp(0.0, 1.0);
            let value = (share * 200.0 + (1.0 - share) * (40.0 + y)) as u8;
            [value, value, value, 255]
        });
        Picture {
            width: 60,
            height: 60,
            rgba: pixels.collect(),
        }
    }

    #[test]
    fn edges_are_smooth_where_there_are_pixels_between() {
        assert_eq!(has_smooth_edges(&disk(1.0)), Some(true));
        assert_eq!(has_smooth_edges(&disk(1e-3)), Some(false));
        // A dark line along a hard edge is nothing between.
        let mut lined = disk(1e-3);
        for row in lined.rgba.chunks_mut(60 * 4) {
            if let Some(at) = row.windows(8).position(|it| it[4].abs_diff(it[0]) >= EDGE) {
                row[at / 4 * 4 + 4..][..3].fill(0);
            }
        }
        assert_eq!(has_smooth_edges(&lined), Some(false));
        // Nothing is known of a picture without edges.
        let empty = Picture {
            rgba: [40, 40, 40, 255].repeat(60 * 60),
            ..disk(1.0)
        };
        assert_eq!(has_smooth_edges(&empty), None);
    }
}
