use super::Finding;
use super::evidence::{FEWEST_PIXELS, OTHER_COLOR};
use crate::compare::Pair;
use crate::compare::differences::difference;

/// Side of the blocks over which differences even out, in pixels: JPEG keeps the mean color of
/// blocks of 8, or of 16 where it stores color more coarsely than brightness.
const BLOCK: usize = 16;
/// Mean colors agree if no channel differs by more than this, of 255: in nearly all blocks, ...
const SAME_MEAN: f64 = 3.0;
/// ... and in every one.
const WORST_MEAN: f64 = 4.0;
/// Differences of means must be so small a share of the differences of the pixels.
const EVENED_OUT: f64 = 0.3;
/// So many blocks, and pixels, must bear it out.
const NEARLY_ALL: f64 = 0.9;
/// How far colors overshoot those around, of 255, beside an edge that was compressed.
const OVERSHOOT: u8 = 32;

/// How B differs from A in one block.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    pixels: u32,
    /// Sums of the differences of red, green and blue.
    sums: [i64; 3],
    /// Sum of the largest difference of each pixel.
    sizes: u64,
    /// Whether a pixel has another color.
    differs: bool,
}

impl Pair<'_> {
    /// Whether only fine detail differs: over blocks of pixels the colors have the same means, and
    /// no color of B is far from those around it in A.
    pub(super) fn detail(&self) -> Option<Finding> {
        let differs = self.other_colors();
        let differing = differs.iter().filter(|differs| **differs).count();
        if (differing as u64) < FEWEST_PIXELS || !self.means_agree() {
            return None;
        }
        let near = (0..differs.len()).filter(|&index| {
            differs[index] && self.fits_among(self.b()[index], self.a(), index, OVERSHOOT)
        });
        let share = near.count() as f64 / differing as f64;
        let sizes = self.a().iter().zip(self.b());
        let max = sizes.map(|(&a, &b)| difference(a, b)).max()?;
        let area = self.area_of(&differs)?;
        (share >= NEARLY_ALL).then_some(Finding::Detail { max, area })
    }

    /// Whether the blocks that differ have nearly the same mean colors in A and B.
    fn means_agree(&self) -> bool {
        let blocks = self.blocks();
        let differing: Vec<&Block> = blocks.iter().filter(|block| block.differs).collect();
        let size = |block: &Block| {
            let sums = block.sums.map(i64::unsigned_abs);
            sums[0].max(sums[1]).max(sums[2]) as f64
        };
        let within = |most: f64| {
            let agree = |block: &&&Block| size(block) <= most * f64::from(block.pixels);
            differing.iter().filter(agree).count()
        };
        let of_means: f64 = differing.iter().map(|block| size(block)).sum();
        let of_pixels: u64 = differing.iter().map(|block| block.sizes).sum();
        within(SAME_MEAN) as f64 >= NEARLY_ALL * differing.len() as f64
            && within(WORST_MEAN) == differing.len()
            && of_means <= EVENED_OUT * of_pixels as f64
    }

    fn blocks(&self) -> Vec<Block> {
        let width = self.width() as usize;
        let across = width.div_ceil(BLOCK);
        let down = (self.height() as usize).div_ceil(BLOCK);
        let mut blocks = vec![Block::default(); across * down];
        for (index, (&a, &b)) in self.a().iter().zip(self.b()).enumerate() {
            let (x, y) = (index % width, index / width);
            let block = &mut blocks[y / BLOCK * across + x / BLOCK];
            block.pixels += 1;
            for channel in 0..3 {
                block.sums[channel] += i64::from(b[channel]) - i64::from(a[channel]);
            }
            let size = difference(a, b);
            block.sizes += u64::from(size);
            block.differs |= size > OTHER_COLOR;
        }
        blocks
    }
}
