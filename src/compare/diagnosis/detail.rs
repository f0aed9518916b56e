use super::Finding;
use super::evidence::{Evidence, FEWEST_PIXELS, OTHER_COLOR, ROUNDING, count, drawn_in_either};
use crate::compare::Pair;
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;
use crate::steps::Pace;

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
pub(super) async fn nearly_same(evidence: &Evidence<'_>) -> Option<Finding> {
    let other_color = evidence.pixels_of_other_color();
    if other_color >= FEWEST_PIXELS {
        return None;
    }
    let pair = evidence.pair();
    let mut differences: Vec<u8> = Vec::with_capacity(pair.kept().len());
    let mut drawn = 0;
    evidence
        .pace
        .bands(pair.kept().len(), |band| {
            let pixels = pair.a()[band.clone()].iter().zip(&pair.b()[band.clone()]);
            differences.extend(pixels.map(|(&a, &b)| difference(a, b)));
            drawn += drawn_in_either(pair, band).count() as u64;
        })
        .await;
    let is_other: Vec<bool> = differences.iter().map(|&by| by > ROUNDING).collect();
    let others = count(&is_other);
    evidence.pace.after(is_other.len()).await;
    if others > drawn / OTHERS_ONE_IN {
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
pub(super) async fn edges(evidence: &Evidence<'_>) -> Option<Finding> {
    let (pair, pace) = (evidence.pair(), evidence.pace);
    let differs = evidence.other_colors();
    let differing = evidence.pixels_of_other_color();
    if differing < FEWEST_PIXELS {
        return None;
    }
    let a_between = fits_among((pair, pace), pair.a(), pair.b(), OTHER_COLOR).await;
    let b_between = fits_among((pair, pace), pair.b(), pair.a(), OTHER_COLOR).await;
    let between = differs.iter().zip(a_between.iter().zip(&b_between));
    let between = between.filter(|&(&differs, (&a, &b))| differs & a & b);
    let share = between.count() as f64 / differing as f64;
    if share < ALONG_EDGES {
        return None;
    }
    let area = evidence.area_of(differs)?;
    Some(Finding::Edges { share, area })
}

/// Fine detail that differs: over blocks of pixels the colors have the same means, and no color
/// of B is far from those around it in A.
pub(super) async fn detail(evidence: &Evidence<'_>) -> Option<Finding> {
    let (pair, pace) = (evidence.pair(), evidence.pace);
    let differs = evidence.other_colors();
    let differing = evidence.pixels_of_other_color();
    if differing < FEWEST_PIXELS || !means_agree(pair, pace).await {
        return None;
    }
    let near = fits_among((pair, pace), pair.b(), pair.a(), OVERSHOOT).await;
    let near = differs.iter().zip(&near).filter(|&(a, b)| a & b);
    let share = near.count() as f64 / differing as f64;
    let sizes = pair.a().iter().zip(pair.b());
    let max = sizes.map(|(&a, &b)| difference(a, b)).max()?;
    pace.after(differs.len()).await;
    let area = evidence.area_of(differs)?;
    (share >= NEARLY_ALL).then_some(Finding::Detail { max, area })
}

/// Whether each channel of each of `pixels` lies within the range of the 3×3 of `others` around
/// it, or no more than `slack` beyond.
async fn fits_among(
    (pair, pace): (&Pair<'_>, &Pace),
    pixels: &[Pixel],
    others: &[Pixel],
    slack: u8,
) -> Vec<bool> {
    let width = pair.width() as usize;
    let rows = others.chunks_exact(width).collect::<Vec<_>>();
    let mut fits = Vec::with_capacity(pixels.len());
    // The range of each column of three pixels, then of three columns beside one another; outer
    // ones are repeated. Channel by channel, of which the processor takes many at once.
    let (mut least, mut most) = (vec![0_u8; 4 * width + 8], vec![0_u8; 4 * width + 8]);
    let mut channels = vec![[0_u8; 4]; width];
    for (y, row) in pixels.chunks_exact(width).enumerate() {
        let above = rows[y.saturating_sub(1)].as_flattened();
        let below = rows[(y + 1).min(rows.len() - 1)].as_flattened();
        let column = above.iter().zip(rows[y].as_flattened()).zip(below);
        let ends = least[4..].iter_mut().zip(&mut most[4..]);
        for ((least, most), ((&above, &here), &below)) in ends.zip(column) {
            *least = above.min(here).min(below);
            *most = above.max(here).max(below);
        }
        for ends in [&mut least, &mut most] {
            ends.copy_within(4..8, 0);
            ends.copy_within(4 * width..4 * width + 4, 4 * width + 4);
        }
        let [left, middle, right] = [0, 4, 8].map(|from| {
            let columns = from..from + 4 * width;
            (&least[columns.clone()], &most[columns])
        });
        let outside = channels.as_flattened_mut().iter_mut();
        for (at, (outside, &value)) in outside.zip(row.as_flattened()).enumerate() {
            let least = left.0[at].min(middle.0[at]).min(right.0[at]);
            let most = left.1[at].max(middle.1[at]).max(right.1[at]);
            let is_below = value < least.saturating_sub(slack);
            *outside = u8::from(is_below | (value > most.saturating_add(slack)));
        }
        fits.extend(
            channels
                .iter()
                .map(|&channels| u32::from_ne_bytes(channels) == 0),
        );
        pace.after(width).await;
    }
    fits
}

/// Whether the blocks that differ have nearly the same mean colors in A and B.
async fn means_agree(pair: &Pair<'_>, pace: &Pace) -> bool {
    let blocks = blocks(pair, pace).await;
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

async fn blocks(pair: &Pair<'_>, pace: &Pace) -> Vec<Block> {
    let width = pair.width() as usize;
    let across = width.div_ceil(BLOCK);
    let down = (pair.height() as usize).div_ceil(BLOCK);
    let mut blocks = vec![Block::default(); across * down];
    pace.bands(pair.kept().len(), |band| {
        for index in band {
            let (a, b) = (pair.a()[index], pair.b()[index]);
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
    })
    .await;
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::noise;
    use crate::steps::at_once;

    #[test]
    fn a_pixel_fits_among_those_around_it_as_each_alone_says() {
        for (width, height) in [(1, 1), (1, 5), (5, 1), (2, 2), (17, 9)] {
            let [a, b] = [1, 2].map(|seed| noise(width, height, 0..=90, seed));
            let pair = Pair::new(&a, &b, &[]).unwrap();
            let alone = (0..pair.a().len()).map(|index| {
                (0..4).all(|channel| {
                    let near = || pair.around(index).map(|near| pair.b()[near][channel]);
                    let (least, most) = (near().min().unwrap(), near().max().unwrap());
                    let slack = OTHER_COLOR;
                    let range = least.saturating_sub(slack)..=most.saturating_add(slack);
                    range.contains(&pair.a()[index][channel])
                })
            });
            let at_pace = (&pair, &Pace::new(usize::MAX));
            let found = at_once(|_| fits_among(at_pace, pair.a(), pair.b(), OTHER_COLOR));
            assert_eq!(found, alone.collect::<Vec<bool>>(), "{width}×{height}");
        }
    }
}
