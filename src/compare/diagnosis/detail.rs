use super::Finding;
use super::evidence::{Evidence, FEWEST_PIXELS, OTHER_COLOR, ROUNDING, count, drawn_in_either};
use crate::compare::Pair;
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;

/// Pixels that differ by more than rounding are no more than one in this many of the drawn.
const OTHERS_ONE_IN: u64 = 200;
/// Share of the differences that must lie along edges. Small facets meet in fewer pixels than the
/// picture has, so that some of the colors between them are nowhere.
const ALONG_EDGES: f64 = 0.85;
/// Side of the blocks over which differences even out, in pixels: JPEG keeps the mean color of
/// blocks of 8, or of 16 where it stores color more coarsely than brightness.
const BLOCK: usize = 16;
/// Mean colors agree if no channel differs by more than this, of 255: in nearly all blocks, ...
const SAME_MEAN: f64 = 3.0;
/// ... and in every one.
const WORST_MEAN: f64 = 4.0;
/// Differences of the means are at most this share of the differences of the pixels.
const EVENED_OUT: f64 = 0.3;
/// Share of the blocks, and of the pixels, that must agree.
const NEARLY_ALL: f64 = 0.9;
/// How far colors overshoot those around, of 255, beside an edge that was compressed.
const OVERSHOOT: u8 = 32;

/// Differences of B from A in one block.
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

/// Pictures that agree but for rounding and a few single pixels.
pub(super) fn nearly_same(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let pixels = pair.a().iter().zip(pair.b());
    let differences: Vec<u8> = pixels.map(|(&a, &b)| difference(a, b)).collect();
    let is_other: Vec<bool> = differences.iter().map(|&by| by > ROUNDING).collect();
    let (others, other_color) = (count(&is_other), evidence.pixels_of_other_color());
    let drawn = drawn_in_either(pair).count() as u64;
    if other_color >= FEWEST_PIXELS || others > drawn / OTHERS_ONE_IN {
        return None;
    }
    let rounding = differences.into_iter().filter(|&by| by <= ROUNDING).max();
    let rounding = rounding.unwrap_or(0);
    (rounding > 0 || others > 0).then(|| Finding::NearlySame {
        rounding,
        others,
        other_color,
        area: evidence.area_of(&is_other),
        other_background: evidence.backgrounds_differ(),
    })
}

/// Differences along edges: each picture's colors, where they differ, lie between those that the
/// other has around the same pixel, as antialiasing and the smallest movements make them.
pub(super) fn edges(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let differs = evidence.other_colors();
    let differing = evidence.pixels_of_other_color();
    let between = (0..differs.len()).filter(|&index| {
        let (a, b) = (pair.a()[index], pair.b()[index]);
        differs[index]
            && fits_among(pair, a, pair.b(), index, OTHER_COLOR)
            && fits_among(pair, b, pair.a(), index, OTHER_COLOR)
    });
    let share = between.count() as f64 / differing as f64;
    if differing < FEWEST_PIXELS || share < ALONG_EDGES {
        return None;
    }
    let area = evidence.area_of(differs)?;
    Some(Finding::Edges { share, area })
}

/// Fine detail that differs: over blocks of pixels the colors have the same means, and no color
/// of B is far from those around it in A.
pub(super) fn detail(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let differs = evidence.other_colors();
    let differing = evidence.pixels_of_other_color();
    if differing < FEWEST_PIXELS || !means_agree(pair) {
        return None;
    }
    let near = (0..differs.len()).filter(|&index| {
        differs[index] && fits_among(pair, pair.b()[index], pair.a(), index, OVERSHOOT)
    });
    let share = near.count() as f64 / differing as f64;
    let sizes = pair.a().iter().zip(pair.b());
    let max = sizes.map(|(&a, &b)| difference(a, b)).max()?;
    let area = evidence.area_of(differs)?;
    (share >= NEARLY_ALL).then_some(Finding::Detail { max, area })
}

/// Whether each channel of `pixel` lies within the range of the 3×3 pixels around `index`, or
/// no more than `slack` beyond.
fn fits_among(pair: &Pair, pixel: Pixel, pixels: &[Pixel], index: usize, slack: u8) -> bool {
    let mut least = [u8::MAX; 4];
    let mut most = [0; 4];
    for near in pair.around(index) {
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

/// Whether the blocks that differ have nearly the same mean colors in A and B.
fn means_agree(pair: &Pair) -> bool {
    let blocks = blocks(pair);
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

fn blocks(pair: &Pair) -> Vec<Block> {
    let width = pair.width() as usize;
    let across = width.div_ceil(BLOCK);
    let down = (pair.height() as usize).div_ceil(BLOCK);
    let mut blocks = vec![Block::default(); across * down];
    for (index, (&a, &b)) in pair.a().iter().zip(pair.b()).enumerate() {
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
