use super::Finding;
use super::evidence::{FEWEST_PIXELS, OTHER_COLOR};
use crate::compare::Pair;
use crate::compare::differences::difference;
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
        for index in 0..self.a().len() {
            let (a, b) = (self.a()[index], self.b()[index]);
            if difference(a, b) > OTHER_COLOR {
                differing += 1;
                let fits =
                    self.fits_among(a, self.b(), index) && self.fits_among(b, self.a(), index);
                between += u64::from(fits);
            }
        }
        let share = between as f64 / differing as f64;
        (differing >= FEWEST_PIXELS && share >= NEARLY_ALL).then_some(Finding::Edges { share })
    }

    /// Whether each channel of `pixel` lies within the range of the 3×3 pixels around `index`.
    fn fits_among(&self, pixel: Pixel, pixels: &[Pixel], index: usize) -> bool {
        let mut least = [u8::MAX; 4];
        let mut most = [0; 4];
        for near in self.around(index) {
            for channel in 0..4 {
                least[channel] = least[channel].min(pixels[near][channel]);
                most[channel] = most[channel].max(pixels[near][channel]);
            }
        }
        (0..4).all(|channel| {
            pixel[channel] >= least[channel].saturating_sub(OTHER_COLOR)
                && pixel[channel] <= most[channel].saturating_add(OTHER_COLOR)
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

    /// How much of what is drawn in both has another color. To be asked once the outlines are
    /// known to agree.
    pub(super) fn shading(&self) -> Option<Finding> {
        self.drawn_masks()?;
        let (mut drawn, mut differing) = (0_u64, 0_u64);
        for (a, b) in self.drawn_pixels() {
            drawn += 1;
            differing += u64::from(difference(a, b) > OTHER_COLOR);
        }
        let share = differing as f64 / drawn as f64;
        (drawn > 0 && share > LEAST_SHADING).then_some(Finding::Shading { share })
    }
}
