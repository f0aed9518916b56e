use crate::compare::Area;
use crate::compare::differences::difference;
use crate::compare::pair::{DRAWN_THRESHOLD, Pair, Pixel, is_drawn};
use std::cell::OnceCell;

/// Colors that differ by more than this (of 255) are different colors; less may be rounding.
pub(super) const OTHER_COLOR: u8 = 8;
/// Rounding in a chain of color changes, of 255.
pub(super) const ROUNDING: u8 = 3;
/// A cause must explain all but one in this many of the pixels of different color.
pub(super) const UNEXPLAINED_ONE_IN: u64 = 20;
/// Fewer pixels than this may form any pattern by chance.
pub(super) const FEWEST_PIXELS: u64 = 16;

/// Pixels that are compared at once.
const BLOCK: usize = 64;

/// Outlines agree if no more than this share of the drawn pixels is drawn in one picture alone.
const OUTLINE_SLACK: f64 = 0.005;

const _: () = assert!(OTHER_COLOR == DRAWN_THRESHOLD);

/// Two pictures and what several rules need to know of them, each worked out once, when a rule
/// first asks for it.
pub(super) struct Evidence<'a> {
    /// The pictures as they are.
    pub(super) given: &'a Pair<'a>,
    over_same_background: OnceCell<Option<Pair<'a>>>,
    other_colors: OnceCell<Vec<bool>>,
    drawn_masks: OnceCell<Option<[Vec<bool>; 2]>>,
    outline: OnceCell<Option<Outline>>,
}

/// Pixels that show something in one picture where the other shows its background.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outline {
    /// Number of those drawn only in A, and only in B.
    pub(super) only: [u64; 2],
    /// Smallest area around each.
    pub(super) areas: [Option<Area>; 2],
}

impl<'a> Evidence<'a> {
    pub(super) fn new(given: &'a Pair<'a>) -> Self {
        Self {
            given,
            over_same_background: OnceCell::new(),
            other_colors: OnceCell::new(),
            drawn_masks: OnceCell::new(),
            outline: OnceCell::new(),
        }
    }

    fn over_same_background(&self) -> Option<&Pair<'a>> {
        self.over_same_background
            .get_or_init(|| self.given.over_background_of_a())
            .as_ref()
    }

    /// The pictures with B over A's background, so that another background hides nothing else
    /// that is wrong. All methods below are about these.
    pub(super) fn pair(&self) -> &Pair<'a> {
        self.over_same_background().unwrap_or(self.given)
    }

    /// Whether B had to be put over A's background.
    pub(super) fn backgrounds_differ(&self) -> bool {
        self.over_same_background().is_some()
    }

    /// Whether each pixel has a different color in B than in A.
    pub(super) fn other_colors(&self) -> &[bool] {
        self.other_colors
            .get_or_init(|| different(self.pair().a(), self.pair().b()))
    }

    /// Number of pixels that have a different color in B than in A.
    pub(super) fn pixels_of_other_color(&self) -> u64 {
        count(self.other_colors())
    }

    /// Whether each pixel of A, and of B, shows something else than its background. Ignored
    /// pixels do not. `None` unless both pictures have a background.
    pub(super) fn drawn_masks(&self) -> Option<&[Vec<bool>; 2]> {
        let masks = self.drawn_masks.get_or_init(|| {
            let pair = self.pair();
            let [Some(background_a), Some(background_b)] = pair.backgrounds() else {
                return None;
            };
            let mask = |pixels: &[Pixel], background| -> Vec<bool> {
                let compared = pixels.iter().zip(pair.kept());
                compared
                    .map(|(&pixel, &kept)| kept && is_drawn(pixel, Some(background)))
                    .collect()
            };
            Some([mask(pair.a(), background_a), mask(pair.b(), background_b)])
        });
        masks.as_ref()
    }

    /// What is drawn in one picture alone; `None` if that is next to nothing, or the pictures
    /// have no backgrounds.
    pub(super) fn outline(&self) -> Option<Outline> {
        *self.outline.get_or_init(|| {
            let [drawn_a, drawn_b] = self.drawn_masks()?;
            let alone = |one: &[bool], other: &[bool]| -> Vec<bool> {
                let pixels = one.iter().zip(other);
                pixels.map(|(&one, &other)| one && !other).collect()
            };
            let alone = [alone(drawn_a, drawn_b), alone(drawn_b, drawn_a)];
            let only = [count(&alone[0]), count(&alone[1])];
            let drawn = count(drawn_a) + only[1];
            let matters = (only[0] + only[1]) as f64 > OUTLINE_SLACK * drawn as f64;
            matters.then(|| Outline {
                only,
                areas: alone.map(|mask| self.area_of(&mask)),
            })
        })
    }

    /// Whether more is drawn in one picture alone than in both: then colors explain nothing.
    pub(super) fn outline_dominates(&self) -> bool {
        self.outline()
            .is_some_and(|outline| outline.pixels() > drawn_in_both(self.pair()).count() as u64)
    }

    /// Smallest area around the pixels that are true in `mask`.
    pub(super) fn area_of(&self, mask: &[bool]) -> Option<Area> {
        let rows = mask.chunks_exact(self.pair().width() as usize);
        let ends = rows.enumerate().filter_map(|(y, row)| {
            let first = row.iter().position(|&inside| inside)?;
            let last = row.iter().rposition(|&inside| inside)?;
            Some([(first as u32, y as u32), (last as u32, y as u32)])
        });
        Area::around(ends.flatten())
    }
}

impl Outline {
    /// Number of pixels drawn in one picture alone.
    pub(super) fn pixels(self) -> u64 {
        self.only[0] + self.only[1]
    }
}

/// Whether each pixel of `a` has a different color than that of `b`.
pub(super) fn different(a: &[Pixel], b: &[Pixel]) -> Vec<bool> {
    let mut different = Vec::with_capacity(a.len());
    let (blocks_a, rest_a) = a.as_chunks();
    let (blocks_b, rest_b) = b.as_chunks();
    for (a, b) in blocks_a.iter().zip(blocks_b) {
        different.extend_from_slice(&different_in_block(a, b));
    }
    let rest = rest_a.iter().zip(rest_b);
    different.extend(rest.map(|(&a, &b)| difference(a, b) > OTHER_COLOR));
    different
}

/// The same, channel by channel first: the processor takes many of them at once.
fn different_in_block(a: &[Pixel; BLOCK], b: &[Pixel; BLOCK]) -> [bool; BLOCK] {
    let mut channels = [[0_u8; 4]; BLOCK];
    let values = a.as_flattened().iter().zip(b.as_flattened());
    for (differs, (a, b)) in channels.as_flattened_mut().iter_mut().zip(values) {
        *differs = u8::from(a.abs_diff(*b) > OTHER_COLOR);
    }
    channels.map(|channels| u32::from_ne_bytes(channels) != 0)
}

/// Number of pixels that are true in `mask`.
pub(super) fn count(mask: &[bool]) -> u64 {
    mask.iter().filter(|inside| **inside).count() as u64
}

/// A and B at the compared pixels where either shows something else than its background.
pub(super) fn drawn_in_either(pair: &Pair) -> impl Iterator<Item = (Pixel, Pixel)> {
    let [background_a, background_b] = pair.backgrounds();
    let pixels = pair.a().iter().zip(pair.b()).zip(pair.kept());
    pixels
        .filter(|(_, kept)| **kept)
        .map(|((&a, &b), _)| (a, b))
        .filter(move |&(a, b)| is_drawn(a, background_a) || is_drawn(b, background_b))
}

/// A and B at the compared pixels where both show something else than their backgrounds.
pub(super) fn drawn_in_both(pair: &Pair) -> impl Iterator<Item = (Pixel, Pixel)> {
    let [background_a, background_b] = pair.backgrounds();
    drawn_in_either(pair)
        .filter(move |&(a, b)| is_drawn(a, background_a) && is_drawn(b, background_b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::noise;

    #[test]
    fn pixels_are_different_where_a_channel_is_however_many_there_are() {
        let [a, b] = [1, 2].map(|seed| noise(150, 1, 100..=112, seed).rgba);
        let (a, b) = (a.as_chunks::<4>().0, b.as_chunks::<4>().0);
        for length in [0, 1, 63, 64, 65, 128, 150] {
            let (a, b) = (&a[..length], &b[..length]);
            let expected = a
                .iter()
                .zip(b)
                .map(|(&a, &b)| difference(a, b) > OTHER_COLOR);
            assert_eq!(different(a, b), expected.collect::<Vec<bool>>());
        }
        let found = different(a, b);
        assert!(found.contains(&true) && found.contains(&false));
    }
}
