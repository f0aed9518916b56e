//! Whether parts of a figure are exactly the same in two pictures, so that one camera shows both.

use super::pair::Pixel;
use std::collections::{HashMap, HashSet};

/// Side in pixels of the squares that are looked at one by one, …
const SIDE: u32 = 16;
/// … of which so much of what is shaded is exactly the same where the camera is: of what is turned by a little, colors hardly
/// differ, but few are the same.
const SAME: f64 = 0.98;
/// Fewest shaded pixels of a square that tell something.
const FEWEST: usize = 16;
/// Fewest colors of a square that tells something: in the shade of the Course look all sides of a figure have one color, and two
/// that meet are the same by chance.
const COLORS: usize = 4;
/// Share of what is shaded that is in such squares from which on the camera is the same: with limbs turned it was 0.34 and more,
/// from another camera 0.013 at most.
const ENOUGH: f64 = 0.1;

/// Shaded pixels by the square that they are in, and how many of them are exactly the same.
#[derive(Debug, Default)]
pub(super) struct ExactlySame {
    squares: HashMap<[u32; 2], Counts>,
}

#[derive(Debug, Default)]
struct Counts {
    shaded: usize,
    same: usize,
    colors: HashSet<Pixel>,
}

impl ExactlySame {
    /// Counts a shaded pixel, which has about the same color in both pictures.
    pub fn count(&mut self, pixel: [u32; 2], [a, b]: [Pixel; 2]) {
        let counts = self.squares.entry(pixel.map(|along| along / SIDE));
        let counts = counts.or_default();
        counts.shaded += 1;
        counts.same += usize::from(a == b);
        counts.colors.insert(a);
    }

    /// Whether so much is the same that the camera is.
    pub fn tells_of_camera(&self) -> bool {
        let is_same = |square: &&Counts| {
            square.shaded >= FEWEST
                && square.colors.len() >= COLORS
                && square.same as f64 >= SAME * square.shaded as f64
        };
        let shaded = |square: &Counts| square.shaded;
        let same: usize = self.squares.values().filter(is_same).map(shaded).sum();
        let all: usize = self.squares.values().map(shaded).sum();
        same > 0 && same as f64 >= ENOUGH * all as f64
    }
}
