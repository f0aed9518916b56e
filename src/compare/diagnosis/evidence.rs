//! What the searches for a cause have in common.

use crate::compare::Area;
use crate::compare::differences::difference;
use crate::compare::pair::{DRAWN_THRESHOLD, Pair, Pixel, is_drawn};

/// Colors that differ by more than this (of 255) are another color; less may be rounding.
pub(super) const OTHER_COLOR: u8 = 8;
/// Rounding in a chain of color changes, of 255.
pub(super) const ROUNDING: u8 = 3;
/// A cause must do away with all but one in so many of the pixels of another color.
pub(super) const UNEXPLAINED_ONE_IN: u64 = 20;
/// Below so many pixels any pattern may be chance.
pub(super) const FEWEST_PIXELS: u64 = 16;

const _: () = assert!(OTHER_COLOR == DRAWN_THRESHOLD);

impl Pair<'_> {
    /// Whether all compared pixels have one color.
    pub(super) fn is_even(&self, pixels: &[Pixel]) -> bool {
        let mut compared = pixels.iter().zip(self.kept()).filter(|(_, kept)| **kept);
        let first = compared.next();
        compared.all(|(pixel, _)| Some(pixel) == first.map(|(pixel, _)| pixel))
    }

    /// Compared pixels that have another color in B than in A.
    pub(super) fn pixels_of_other_color(&self) -> u64 {
        let pixels = self.a().iter().zip(self.b());
        pixels
            .filter(|&(&a, &b)| difference(a, b) > OTHER_COLOR)
            .count() as u64
    }

    /// Whether each pixel has another color in B than in A.
    pub(super) fn other_colors(&self) -> Vec<bool> {
        let pixels = self.a().iter().zip(self.b());
        pixels
            .map(|(&a, &b)| difference(a, b) > OTHER_COLOR)
            .collect()
    }

    /// Whether each pixel of A, and of B, shows something else than its background. Ignored
    /// pixels do not. `None` unless both pictures have a background.
    pub(super) fn drawn_masks(&self) -> Option<[Vec<bool>; 2]> {
        let [Some(background_a), Some(background_b)] = self.backgrounds() else {
            return None;
        };
        let mask = |pixels: &[Pixel], background| -> Vec<bool> {
            let compared = pixels.iter().zip(self.kept());
            compared
                .map(|(&pixel, &kept)| kept && is_drawn(pixel, Some(background)))
                .collect()
        };
        Some([mask(self.a(), background_a), mask(self.b(), background_b)])
    }

    /// The area around the pixels that are true in `mask`.
    pub(super) fn area_of(&self, mask: &[bool]) -> Option<Area> {
        let rows = mask.chunks_exact(self.width() as usize);
        let ends = rows.enumerate().filter_map(|(y, row)| {
            let first = row.iter().position(|&inside| inside)?;
            let last = row.iter().rposition(|&inside| inside)?;
            Some([(first as u32, y as u32), (last as u32, y as u32)])
        });
        Area::around(ends.flatten())
    }

    /// A and B at the compared pixels where both show something else than their backgrounds.
    pub(super) fn pixels_drawn_in_both(&self) -> impl Iterator<Item = (Pixel, Pixel)> {
        let [background_a, background_b] = self.backgrounds();
        self.drawn_pixels()
            .filter(move |&(a, b)| is_drawn(a, background_a) && is_drawn(b, background_b))
    }

    /// A and B at the compared pixels where either shows something else than its background.
    pub(super) fn drawn_pixels(&self) -> impl Iterator<Item = (Pixel, Pixel)> {
        let [background_a, background_b] = self.backgrounds();
        let pixels = self.a().iter().zip(self.b()).zip(self.kept());
        pixels
            .filter(|(_, kept)| **kept)
            .map(|((&a, &b), _)| (a, b))
            .filter(move |&(a, b)| is_drawn(a, background_a) || is_drawn(b, background_b))
    }
}
