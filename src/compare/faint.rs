//! Figures of nearly the background's color.

use super::pair::{DRAWN_THRESHOLD, Pair, distance};
use crate::steps::Pace;

/// What noise leaves of the background's color in most pixels …
const NOISE: u8 = 3;
/// … and how many times as many pixels a figure of nearly that color has to have: of a robot seen from behind, without any noise,
/// where its own shades are so near it had 42 times as many.
const FAINT_BY_NOISE: usize = 10;

impl Pair<'_> {
    /// What [`Self::drawn_above`] is: of a figure that is seen from its unlit side, most is by no more than 6 darker than the
    /// background of the course's look.
    pub(super) async fn paced_drawn_above(&self, pace: &Pace) -> u8 {
        let [Some(of_a), Some(of_b)] = self.backgrounds() else {
            return DRAWN_THRESHOLD;
        };
        let mut is_faint = false;
        for (pixels, background) in [(self.a(), of_a), (self.b(), of_b)] {
            let [mut noise, mut faint, mut clear] = [0_usize; 3];
            pace.bands(pixels.len(), |band| {
                for at in band.filter(|&at| self.kept()[at]) {
                    let from_background = |at: usize| distance(pixels[at], background);
                    let is_within = |least, most| {
                        self.grid()
                            .is_solid(at, |at| (least..=most).contains(&from_background(at)))
                    };
                    match from_background(at) {
                        0 => {}
                        apart if apart <= NOISE => noise += usize::from(is_within(1, NOISE)),
                        apart if apart <= DRAWN_THRESHOLD => {
                            faint += usize::from(is_within(NOISE + 1, DRAWN_THRESHOLD));
                        }
                        _ => clear += 1,
                    }
                }
            })
            .await;
            if noise > faint / FAINT_BY_NOISE {
                return DRAWN_THRESHOLD;
            }
            is_faint |= faint > clear;
        }
        if is_faint { NOISE } else { DRAWN_THRESHOLD }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::from_gray;

    #[test]
    fn a_figure_of_nearly_the_background_s_color_is_drawn_unless_that_may_be_noise() {
        // A figure in the middle that is darker by so much, one beside it that is lighter by so much, and noise on the left.
        let picture = |darker: u8, lighter: u8, noise: u8| {
            let gray = (0..40 * 40).map(|at| match (at % 40, at / 40) {
                (18..=29, 10..=29) => 26 - darker,
                (32..=34, 10..=19) => 26 + lighter,
                (2..=7, 2..=37) => 26 + noise,
                _ => 26,
            });
            from_gray(40, &gray.collect::<Vec<u8>>())
        };
        for (drawn_above, faint, clear, noise) in [
            (NOISE, 6, 40, 0),
            (DRAWN_THRESHOLD, 20, 6, 0),
            (DRAWN_THRESHOLD, 6, 40, 2),
            (DRAWN_THRESHOLD, 0, 40, 0),
            (DRAWN_THRESHOLD, 0, 0, 0),
        ] {
            let picture = picture(faint, clear, noise);
            let pair = Pair::new(&picture, &picture, &[]).unwrap();
            assert_eq!(pair.drawn_above(), drawn_above, "{faint} {clear} {noise}");
        }
        // Where one of them has noise, so may the other.
        let [clean, noisy] = [0, 1].map(|noise| picture(6, 40, noise));
        let pair = Pair::new(&clean, &noisy, &[]).unwrap();
        assert_eq!(pair.drawn_above(), DRAWN_THRESHOLD);
    }
}
