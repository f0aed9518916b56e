//! Pictures with different backgrounds, which are compared as if they had the same one.

use super::pair::{DRAWN_THRESHOLD, Pair, Pixel, distance};
use crate::steps::Pace;

/// What is as large as a corner, 2×2 pixels, is no line.
const SMALLEST_PATCH: usize = 4;
/// Rounding of the share of a background that shines through, of 255.
const SHINING_ROUNDING: f32 = 2.0;

impl Pair<'_> {
    /// The same with B over A's background instead of its own; `None` where the backgrounds are
    /// equal or not known. What is left to differ does not come from the background.
    pub(super) async fn over_background_of_a(&self, pace: &Pace) -> Option<Pair<'_>> {
        let [Some(in_a), Some(in_b)] = self.backgrounds() else {
            return None;
        };
        if in_a == in_b {
            return None;
        }
        let slack = self.background_slack(in_b);
        let is_behind = |pixel: Pixel| distance(pixel, in_b) <= slack;
        // Shades of gray take on the color of a gray background too, but in no more than a line.
        let is_patch = |index| {
            let behind = self.around(index).filter(|&near| is_behind(self.b()[near]));
            behind.count() >= SMALLEST_PATCH
        };
        let changed = |index: usize| {
            let (a, b) = (self.a()[index], self.b()[index]);
            if !self.kept()[index] {
                return b;
            }
            let in_neither = !self.is_drawn(a, Some(in_a)) && !self.is_drawn(b, Some(in_b));
            if in_neither || is_behind(b) && is_patch(index) {
                return moved_by(b, in_b, in_a);
            }
            let at_rim = || self.around(index).any(|near| is_behind(self.b()[near]));
            // At a smooth rim the background shines through.
            if shines_through(a, b, in_a, in_b) && at_rim() {
                a
            } else {
                b
            }
        };
        let mut b = Vec::with_capacity(self.b().len());
        pace.bands(self.b().len(), |band| b.extend(band.map(changed)))
            .await;
        Some(self.with_b(b, in_a))
    }

    /// How far B's pixels may be from its background and still belong to it: programs fill it
    /// evenly, so that only noise along the border asks for more than nothing.
    fn background_slack(&self, background: [u8; 3]) -> u8 {
        let noisy = self.border().any(|index| {
            let distance = distance(self.b()[index], background);
            distance > 0 && distance <= DRAWN_THRESHOLD
        });
        if noisy { DRAWN_THRESHOLD } else { 0 }
    }
}

/// The pixel as far from the color `to` as it is from `from`.
fn moved_by([r, g, b, alpha]: Pixel, from: [u8; 3], to: [u8; 3]) -> Pixel {
    let moved = |channel: u8, from: u8, to: u8| {
        (i16::from(channel) - i16::from(from) + i16::from(to)).clamp(0, 255) as u8
    };
    [
        moved(r, from[0], to[0]),
        moved(g, from[1], to[1]),
        moved(b, from[2], to[2]),
        alpha,
    ]
}

/// Whether `b` is `a` with a share of the background `in_b` in it instead of the same share of
/// `in_a`.
fn shines_through(a: Pixel, b: Pixel, in_a: [u8; 3], in_b: [u8; 3]) -> bool {
    let by: [f32; 3] = std::array::from_fn(|c| f32::from(in_b[c]) - f32::from(in_a[c]));
    let found: [f32; 3] = std::array::from_fn(|c| f32::from(b[c]) - f32::from(a[c]));
    let dot = |x: [f32; 3], y: [f32; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    let share = dot(by, found) / dot(by, by);
    let even = |c: usize| (found[c] - share * by[c]).abs() <= SHINING_ROUNDING;
    a[3] == b[3] && (0.0..=1.0).contains(&share) && (0..3).all(even)
}
