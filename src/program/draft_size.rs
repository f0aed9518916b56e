//! Size of the pictures that are shown while something moves.

use std::time::Duration;

/// Drafts that take this long follow the hand badly; with half the width and height they take a quarter of the pixels.
const SLOW: Duration = Duration::from_millis(80);
/// Where drafts of half the width and height take less than this, those of all pixels are not slow, either.
const FAST: Duration = Duration::from_millis(20);
/// Share of the mean that a new draft makes up, and the most that it counts for: a single frame that takes long for
/// another reason changes nothing.
const SHARE: f32 = 0.5;
const MOST: Duration = Duration::from_millis(120);

/// Chooses whether drafts have half the width and height, by how long the last ones took.
#[derive(Debug, Default)]
pub(super) struct DraftSize {
    mean: Duration,
    is_half: bool,
}

impl DraftSize {
    /// Takes note of how long the frame with the last draft took.
    pub fn count(&mut self, took: Duration) {
        let took = took.min(MOST);
        self.mean = self.mean.mul_f32(1.0 - SHARE) + took.mul_f32(SHARE);
        if self.mean > SLOW {
            self.is_half = true;
        } else if self.mean < FAST {
            self.is_half = false;
        }
    }

    /// Whether the next draft has half the width and height.
    pub fn is_half(&self) -> bool {
        self.is_half
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(size: &mut DraftSize, frames: &[u64]) -> bool {
        for &milliseconds in frames {
            size.count(Duration::from_millis(milliseconds));
        }
        size.is_half()
    }

    #[test]
    fn drafts_that_take_long_are_halved_and_a_single_slow_frame_halves_none() {
        let mut size = DraftSize::default();
        assert!(!after(&mut size, &[30; 20]));
        assert!(!after(&mut size, &[5000, 30, 30]));
        assert!(after(&mut size, &[110; 3]));
        // Browsers answer after some frames, for all of them.
        assert!(after(&mut DraftSize::default(), &[180, 30, 180]));
    }

    #[test]
    fn drafts_have_all_pixels_again_where_four_times_as_many_take_no_longer_than_they_may() {
        let mut size = DraftSize::default();
        assert!(after(&mut size, &[300; 4]));
        assert!(after(&mut size, &[40; 50]), "they would take 160 ms");
        assert!(!after(&mut size, &[15; 20]));
        assert!(!after(&mut size, &[60; 50]));
    }
}
