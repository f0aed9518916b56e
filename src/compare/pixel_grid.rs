//! The places of pixels in a picture, and masks of them.

use super::Area;
use crate::steps::{Pace, at_once};

/// Pixels among nine that are such ones where it is no edge or line alone.
const SOLID: usize = 7;

/// The places of pixels in a picture, row by row from the top left.
#[derive(Clone, Copy, Debug)]
pub struct PixelGrid {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl PixelGrid {
    /// A place and those beside it.
    pub fn around(self, at: usize) -> impl Iterator<Item = usize> {
        let (width, x, y) = (self.width, at % self.width, at / self.width);
        let rows = y.saturating_sub(1)..(y + 2).min(self.height);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        rows.flat_map(move |y| columns.clone().map(move |x| y * width + x))
    }

    /// `mask` with all pixels beside it.
    pub fn grown(self, mask: &[bool]) -> Vec<bool> {
        at_once(|pace| async move { self.paced_grown(mask, &pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_grown(self, mask: &[bool], pace: &Pace) -> Vec<bool> {
        let is_in = |at| self.around(at).any(|near| mask[near]);
        pixels(mask.len(), is_in, pace).await
    }

    /// `mask` without the pixels at its edge.
    pub fn shrunk(self, mask: &[bool]) -> Vec<bool> {
        at_once(|pace| async move { self.paced_shrunk(mask, &pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_shrunk(self, mask: &[bool], pace: &Pace) -> Vec<bool> {
        let is_in = |at| self.around(at).all(|near| mask[near]);
        pixels(mask.len(), is_in, pace).await
    }

    /// Whether most of the pixels around a place, and so not an edge or a line alone, are such ones.
    pub fn is_solid(self, at: usize, is_such: impl Fn(usize) -> bool) -> bool {
        self.around(at).filter(|&at| is_such(at)).count() >= SOLID
    }

    /// The places that hang together of those that `is_such` has, one for each pixel, but for edges and lines.
    pub fn islands(self, is_such: &[bool]) -> Vec<Vec<usize>> {
        at_once(|pace| async move { self.paced_islands(is_such, &pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_islands(self, is_such: &[bool], pace: &Pace) -> Vec<Vec<usize>> {
        let mut left = vec![false; is_such.len()];
        pace.bands(left.len(), |band| {
            for at in band.filter(|&at| is_such[at]) {
                left[at] = self.is_solid(at, |at| is_such[at]);
            }
        })
        .await;
        self.paced_apart(left, pace).await
    }

    /// The places of a mask by which hang together.
    pub fn apart(self, mask: Vec<bool>) -> Vec<Vec<usize>> {
        at_once(|pace| async move { self.paced_apart(mask, &pace).await })
    }

    /// The same in steps.
    async fn paced_apart(self, mut left: Vec<bool>, pace: &Pace) -> Vec<Vec<usize>> {
        let mut islands = Vec::new();
        for first in 0..left.len() {
            if !std::mem::take(&mut left[first]) {
                continue;
            }
            let (mut island, mut next) = (vec![first], 0);
            while let Some(&at) = island.get(next) {
                next += 1;
                island.extend(self.around(at).filter(|&at| std::mem::take(&mut left[at])));
                pace.after(1).await;
            }
            islands.push(island);
        }
        islands
    }

    /// The area round some places.
    pub fn area_around(self, places: impl Iterator<Item = usize>) -> Option<Area> {
        Area::around(places.map(|at| {
            let [x, y] = self.pixel(at);
            (x, y)
        }))
    }

    /// Those of these places that are so many pixels apart.
    pub(super) fn spread(self, places: Vec<usize>, apart: u32) -> Vec<[u32; 2]> {
        let pixels = places.into_iter().map(|at| self.pixel(at));
        pixels
            .filter(|pixel| pixel.iter().all(|along| along % apart == 0))
            .collect()
    }

    /// Column and row of a place.
    pub(super) fn pixel(self, at: usize) -> [u32; 2] {
        [(at % self.width) as u32, (at / self.width) as u32]
    }
}

/// Whether each of so many pixels is in a mask.
async fn pixels(count: usize, is_in: impl Fn(usize) -> bool, pace: &Pace) -> Vec<bool> {
    let mut mask = Vec::with_capacity(count);
    pace.bands(count, |band| mask.extend(band.map(&is_in)))
        .await;
    mask
}
