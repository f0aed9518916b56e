use super::Finding;
use super::evidence::{FEWEST_PIXELS, OTHER_COLOR};
use crate::compare::Pair;
use crate::compare::pair::Pixel;

/// Differences along edges must be so large a share of all. Small facets meet in fewer pixels
/// than the picture has, so that some of the colors between them are nowhere.
const NEARLY_ALL: f64 = 0.85;
/// Outlines agree if no more than this share of the drawn pixels is drawn in one picture alone.
const OUTLINE_SLACK: f64 = 0.005;
/// Shading differs if it does so in more than this share of the drawn pixels.
const LEAST_SHADING: f64 = 0.001;

impl Pair<'_> {
    /// Whether each picture's colors, where they differ, lie between those that the other has
    /// around the same pixel: what antialiasing and the smallest movements do.
    pub(super) fn edges(&self) -> Option<Finding> {
        let (mut differing, mut between) = (0_u64, 0_u64);
        let differs = self.other_colors();
        for index in (0..differs.len()).filter(|&index| differs[index]) {
            let (a, b) = (self.a()[index], self.b()[index]);
            differing += 1;
            let fits = self.fits_among(a, self.b(), index, OTHER_COLOR)
                && self.fits_among(b, self.a(), index, OTHER_COLOR);
            between += u64::from(fits);
        }
        let share = between as f64 / differing as f64;
        if differing < FEWEST_PIXELS || share < NEARLY_ALL {
            return None;
        }
        let area = self.area_of(&differs)?;
        Some(Finding::Edges { share, area })
    }

    /// Whether each channel of `pixel` lies within the range of the 3×3 pixels around `index`, or
    /// no more than `slack` beyond.
    pub(super) fn fits_among(
        &self,
        pixel: Pixel,
        pixels: &[Pixel],
        index: usize,
        slack: u8,
    ) -> bool {
        let mut least = [u8::MAX; 4];
        let mut most = [0; 4];
        for near in self.around(index) {
            for channel in 0..4 {
                least[channel] = least[channel].min(pixels[near][channel]);
                most[channel] = most[channel].max(pixels[near][channel]);
            }
        }
        (0..4).all(|channel| {
            pixel[channel] >= least[channel].saturating_sub(slack)
                && pixel[channel] <= most[channel].saturating_add(slack)
        })
    }

    /// What is drawn in one picture alone.
    pub(super) fn outline(&self) -> Option<Finding> {
        let [drawn_a, drawn_b] = self.drawn_masks()?;
        let alone = |one: &[bool], other: &[bool]| -> Vec<bool> {
            one.iter()
                .zip(other)
                .map(|(&one, &other)| one && !other)
                .collect()
        };
        let [alone_a, alone_b] = [alone(&drawn_a, &drawn_b), alone(&drawn_b, &drawn_a)];
        let count = |mask: &[bool]| mask.iter().filter(|inside| **inside).count() as u64;
        let (only_a, only_b) = (count(&alone_a), count(&alone_b));
        let drawn = count(&drawn_a) + only_b;
        ((only_a + only_b) as f64 > OUTLINE_SLACK * drawn as f64).then(|| Finding::Outline {
            only_a,
            area_a: self.area_of(&alone_a),
            only_b,
            area_b: self.area_of(&alone_b),
        })
    }

    /// Whether more is drawn in one picture alone than in both: then colors explain nothing.
    pub(super) fn outline_dominates(&self) -> bool {
        let Some(Finding::Outline { only_a, only_b, .. }) = self.outline() else {
            return false;
        };
        only_a + only_b > self.pixels_drawn_in_both().count() as u64
    }

    /// How much of what is drawn has another color. `outlines` is how many pixels are drawn in
    /// one picture alone, where that was told: then more pixels than these must have another
    /// color among those drawn in both. Otherwise the outlines agree.
    pub(super) fn shading(&self, outlines: Option<u64>) -> Option<Finding> {
        let [drawn_a, drawn_b] = self.drawn_masks()?;
        let drawn: Vec<bool> = drawn_a
            .iter()
            .zip(&drawn_b)
            .map(|(&in_a, &in_b)| in_a && in_b || outlines.is_none() && (in_a || in_b))
            .collect();
        let differs: Vec<bool> = self
            .other_colors()
            .into_iter()
            .zip(&drawn)
            .map(|(differs, &drawn)| differs && drawn)
            .collect();
        let count = |mask: &[bool]| mask.iter().filter(|inside| **inside).count() as u64;
        let differing = count(&differs);
        let share = differing as f64 / count(&drawn) as f64;
        if differing <= outlines.unwrap_or(0) || share <= LEAST_SHADING {
            return None;
        }
        let area = self.area_of(&differs)?;
        Some(Finding::Shading {
            share,
            area,
            outlines_agree: outlines.is_none(),
        })
    }
}
