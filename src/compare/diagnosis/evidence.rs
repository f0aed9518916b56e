use super::Which;
use super::axes::Axes;
use crate::compare::Area;
use crate::compare::differences::difference;
use crate::compare::pair::{DRAWN_THRESHOLD, Pair, Pixel};
use crate::steps::Pace;
use std::cell::OnceCell;
use std::ops::Range;

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

/// Two pictures and what several rules need to know of them, each worked out once. What no rule can do
/// without is there from the start, the rest when a rule first asks for it.
pub(super) struct Evidence<'a> {
    /// The pictures as they are.
    pub(super) given: &'a Pair<'a>,
    /// How the work goes on.
    pub(super) pace: &'a Pace,
    /// The pictures without what hides nothing else that is wrong, if there is any.
    without: Option<Pair<'a>>,
    backgrounds_differ: bool,
    axes: Option<Axes>,
    other_colors: Vec<bool>,
    pixels_of_other_color: u64,
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
    pub(super) async fn new(given: &'a Pair<'a>, pace: &'a Pace) -> Self {
        let mut without = given.over_background_of_a(pace).await;
        let backgrounds_differ = without.is_some();
        let pair = without.as_ref().unwrap_or(given);
        let mut other_colors = Vec::with_capacity(given.kept().len());
        pace.bands(given.kept().len(), |band| {
            other_colors.extend(different(&pair.a()[band.clone()], &pair.b()[band]));
        })
        .await;
        let axes = Axes::find(pair, &other_colors, pace).await;
        if let Some(axes) = &axes {
            let pair = without.get_or_insert_with(|| given.clone());
            pair.leave_out(&axes.pixels, axes.only_in == Which::A);
            pace.after(axes.pixels.len()).await;
            for (differs, is_axis) in other_colors.iter_mut().zip(&axes.pixels) {
                *differs &= !is_axis;
            }
        }
        Self {
            given,
            pace,
            without,
            backgrounds_differ,
            axes,
            pixels_of_other_color: count(&other_colors),
            other_colors,
            drawn_masks: OnceCell::new(),
            outline: OnceCell::new(),
        }
    }

    /// The pictures with B over A's background, and without axes that only one has, so that these hide
    /// nothing else that is wrong. All methods below are about these.
    pub(super) fn pair(&self) -> &Pair<'a> {
        self.without.as_ref().unwrap_or(self.given)
    }

    /// Whether B had to be put over A's background.
    pub(super) fn backgrounds_differ(&self) -> bool {
        self.backgrounds_differ
    }

    /// Axes that only one of the pictures shows.
    pub(super) fn axes(&self) -> Option<&Axes> {
        self.axes.as_ref()
    }

    /// Whether each pixel has a different color in B than in A.
    pub(super) fn other_colors(&self) -> &[bool] {
        &self.other_colors
    }

    /// Number of pixels that have a different color in B than in A.
    pub(super) fn pixels_of_other_color(&self) -> u64 {
        self.pixels_of_other_color
    }

    /// Whether each pixel of A, and of B, shows something else than its background. Ignored
    /// pixels do not. `None` unless both pictures have a background.
    pub(super) async fn drawn_masks(&self) -> Option<&[Vec<bool>; 2]> {
        if self.drawn_masks.get().is_none() {
            let masks = self.find_drawn_masks().await;
            // Set once: only one rule is asked at a time.
            let _ = self.drawn_masks.set(masks);
        }
        self.drawn_masks.get()?.as_ref()
    }

    async fn find_drawn_masks(&self) -> Option<[Vec<bool>; 2]> {
        let pair = self.pair();
        let [Some(background_a), Some(background_b)] = pair.backgrounds() else {
            return None;
        };
        let mut masks = [Vec::new(), Vec::new()];
        let sides = [(pair.a(), background_a), (pair.b(), background_b)];
        for (mask, (pixels, background)) in masks.iter_mut().zip(sides) {
            mask.reserve_exact(pixels.len());
            self.pace
                .bands(pixels.len(), |band| {
                    let compared = pixels[band.clone()].iter().zip(&pair.kept()[band]);
                    mask.extend(
                        compared
                            .map(|(&pixel, &kept)| kept && pair.is_drawn(pixel, Some(background))),
                    );
                })
                .await;
        }
        Some(masks)
    }

    /// What is drawn in one picture alone; `None` if that is next to nothing, or the pictures
    /// have no backgrounds.
    pub(super) async fn outline(&self) -> Option<Outline> {
        if self.outline.get().is_none() {
            let outline = self.find_outline().await;
            let _ = self.outline.set(outline);
        }
        *self.outline.get()?
    }

    async fn find_outline(&self) -> Option<Outline> {
        let [drawn_a, drawn_b] = self.drawn_masks().await?;
        let mut alone = [Vec::new(), Vec::new()];
        let sides = [(drawn_a, drawn_b), (drawn_b, drawn_a)];
        for (alone, (one, other)) in alone.iter_mut().zip(sides) {
            let pixels = one.iter().zip(other);
            *alone = pixels
                .map(|(&one, &other)| one && !other)
                .collect::<Vec<bool>>();
            self.pace.after(one.len()).await;
        }
        let only = [count(&alone[0]), count(&alone[1])];
        let drawn = count(drawn_a) + only[1];
        self.pace.after(drawn_a.len()).await;
        let matters = (only[0] + only[1]) as f64 > OUTLINE_SLACK * drawn as f64;
        matters.then(|| Outline {
            only,
            areas: alone.map(|mask| self.area_of(&mask)),
        })
    }

    /// Whether more is drawn in one picture alone than in both: then colors explain nothing.
    pub(super) async fn outline_dominates(&self) -> bool {
        let Some(outline) = self.outline().await else {
            return false;
        };
        let pair = self.pair();
        let mut in_both = 0;
        self.pace
            .bands(pair.kept().len(), |band| {
                in_both += drawn_in_both(pair, band).count() as u64;
            })
            .await;
        outline.pixels() > in_both
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

/// A and B at the compared pixels of a band where either shows something else than its background.
pub(super) fn drawn_in_either(
    pair: &Pair,
    band: Range<usize>,
) -> impl Iterator<Item = (Pixel, Pixel)> {
    let [background_a, background_b] = pair.backgrounds();
    let pixels = pair.a()[band.clone()].iter().zip(&pair.b()[band.clone()]);
    pixels
        .zip(&pair.kept()[band])
        .filter(|(_, kept)| **kept)
        .map(|((&a, &b), _)| (a, b))
        .filter(move |&(a, b)| pair.is_drawn(a, background_a) || pair.is_drawn(b, background_b))
}

/// A and B at the compared pixels of a band where both show something else than their backgrounds.
pub(super) fn drawn_in_both(
    pair: &Pair,
    band: Range<usize>,
) -> impl Iterator<Item = (Pixel, Pixel)> {
    let [background_a, background_b] = pair.backgrounds();
    drawn_in_either(pair, band)
        .filter(move |&(a, b)| pair.is_drawn(a, background_a) && pair.is_drawn(b, background_b))
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
