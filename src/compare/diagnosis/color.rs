use super::evidence::{Evidence, FEWEST_PIXELS, OTHER_COLOR, ROUNDING, UNEXPLAINED_ONE_IN};
use super::{Finding, Which};
use crate::compare::Pair;
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;
use crate::steps::Pace;

/// Factors nearer to one than this are not worth mentioning.
const LEAST_CHANGE: f64 = 0.03;
/// Factors beyond this, or below its reciprocal, are chance rather than light or material.
const MOST_CHANGE: f64 = 8.0;
/// Weights of red, green and blue in gray: ITU-R BT.601, BT.709, and the mean.
const GRAYS: [[f32; 3]; 3] = [
    [0.299, 0.587, 0.114],
    [0.2126, 0.7152, 0.0722],
    [1.0 / 3.0; 3],
];
/// Channels that reach this may have been cut off.
const SATURATED: u8 = 250;

/// Colors that opacity 0 of every pixel hides.
pub(super) fn transparent(evidence: &Evidence) -> Option<Finding> {
    let picture = Which::of(evidence.given.hides_colors())?;
    Some(Finding::Transparent { picture })
}

/// A picture whose compared pixels all have one color.
pub(super) async fn blank(evidence: &Evidence<'_>) -> Option<Finding> {
    let pair = evidence.given;
    let mut are_even = [true; 2];
    for (is_even, pixels) in are_even.iter_mut().zip([pair.a(), pair.b()]) {
        let first = pair.kept().iter().position(|kept| *kept);
        let first = first.map(|index| pixels[index]);
        for (pixels, kept) in pixels.chunks(BLOCK).zip(pair.kept().chunks(BLOCK)) {
            let mut compared = pixels.iter().zip(kept).filter(|(_, kept)| **kept);
            *is_even = compared.all(|(pixel, _)| Some(*pixel) == first);
            if !*is_even {
                break;
            }
            evidence.pace.after(pixels.len()).await;
        }
    }
    let picture = Which::of(are_even)?;
    Some(Finding::Blank { picture })
}

/// Pixels of different opacity.
pub(super) async fn opacity(evidence: &Evidence<'_>) -> Option<Finding> {
    let (a, b) = (evidence.given.a(), evidence.given.b());
    let mut pixels = 0;
    evidence
        .pace
        .bands(a.len(), |band| {
            let here = a[band.clone()].iter().zip(&b[band]);
            pixels += here.filter(|(a, b)| a[3] != b[3]).count() as u64;
        })
        .await;
    (pixels > 0).then_some(Finding::Opacity { pixels })
}

/// Color channels of B in the other order, over its own background or A's.
pub(super) async fn red_blue_exchanged(evidence: &Evidence<'_>) -> Option<Finding> {
    let exchange = |[r, g, b, alpha]: Pixel| [b, g, r, alpha];
    let pace = evidence.pace;
    let exchanged = turns_into(evidence.given, pace, exchange).await
        || evidence.backgrounds_differ() && turns_into(evidence.pair(), pace, exchange).await;
    exchanged.then_some(Finding::RedBlueExchanged)
}

/// B as A in shades of gray, by one of the ways in which programs make these.
pub(super) async fn gray(evidence: &Evidence<'_>) -> Option<Finding> {
    let pair = evidence.given;
    let colored = |&[r, g, b, _]: &Pixel| r != g || g != b;
    let mut pixels = pair.b().iter().zip(pair.kept());
    if pixels.any(|(b, &kept)| kept && colored(b)) {
        return None;
    }
    evidence.pace.after(pair.kept().len()).await;
    for weights in GRAYS {
        let gray_by = |[r, g, b, alpha]: Pixel| {
            let channels = [r, g, b].map(f32::from);
            let gray: f32 = channels.iter().zip(weights).map(|(c, w)| c * w).sum();
            let gray = gray.round() as u8;
            [gray, gray, gray, alpha]
        };
        if turns_into(pair, evidence.pace, gray_by).await {
            return Some(Finding::Gray);
        }
    }
    None
}

/// Another background, and no other pixel of different color.
pub(super) fn only_background(evidence: &Evidence) -> Option<Finding> {
    let alone = evidence.pixels_of_other_color() == 0;
    background(evidence, alone).filter(|_| alone)
}

/// Another background beside other differences.
pub(super) fn background_too(evidence: &Evidence) -> Option<Finding> {
    let alone = evidence.pixels_of_other_color() == 0;
    background(evidence, alone).filter(|_| !alone)
}

fn background(evidence: &Evidence, alone: bool) -> Option<Finding> {
    let [Some(a), Some(b)] = evidence.given.backgrounds() else {
        return None;
    };
    (a != b).then_some(Finding::Background { a, b, alone })
}

/// One picture as the sRGB encoding of the other.
pub(super) async fn gamma(evidence: &Evidence<'_>) -> Option<Finding> {
    if evidence.outline_dominates().await {
        return None;
    }
    let encoded: [u8; 256] = std::array::from_fn(|step| encode(step as u8));
    let encode = |[r, g, b, alpha]: Pixel| {
        let [r, g, b] = [r, g, b].map(|channel| encoded[usize::from(channel)]);
        [r, g, b, alpha]
    };
    let (given, pace) = (evidence.given, evidence.pace);
    let lighter = if drawn_turns_into(given, pace, encode, |b| b).await {
        Which::B
    } else if drawn_turns_into(given, pace, |a| a, encode).await {
        Which::A
    } else {
        return None;
    };
    Some(Finding::Gamma { lighter })
}

/// What is drawn in B as A's colors times one factor a channel. What is drawn in one picture
/// alone says nothing about colors, so most must be drawn in both.
pub(super) async fn brightness(evidence: &Evidence<'_>) -> Option<Finding> {
    if evidence.outline_dominates().await {
        return None;
    }
    let factors = factors(evidence.given, evidence.pace).await?;
    let sane = 1.0 / MOST_CHANGE..=MOST_CHANGE;
    let changes = |factor: &f64| (factor - 1.0).abs() >= LEAST_CHANGE;
    if !factors.iter().all(|factor| sane.contains(factor)) || !factors.iter().any(changes) {
        return None;
    }
    let scale = |[r, g, b, alpha]: Pixel| {
        let scaled = |channel: u8, factor: f64| (f64::from(channel) * factor).round() as u8;
        [
            scaled(r, factors[0]),
            scaled(g, factors[1]),
            scaled(b, factors[2]),
            alpha,
        ]
    };
    let is_scaled = drawn_turns_into(evidence.given, evidence.pace, scale, |b| b).await;
    is_scaled.then_some(Finding::Brightness { factors })
}

/// For each channel the factor that best takes A to B where both are drawn and neither is
/// saturated; 1 for a channel that is black there. `None` without enough such pixels.
async fn factors(pair: &Pair<'_>, pace: &Pace) -> Option<[f64; 3]> {
    let [background_a, background_b] = pair.backgrounds();
    let (mut products, mut squares, mut pixels) = ([0_u64; 3], [0_u64; 3], 0);
    for ((a, b), kept) in in_blocks(pair) {
        let (mut products_here, mut squares_here, mut pixels_here) = ([0_u32; 3], [0_u32; 3], 0);
        for ((&a, &b), &kept) in a.iter().zip(b).zip(kept) {
            let drawn = pair.is_drawn(a, background_a) & pair.is_drawn(b, background_b);
            let most = (0..3).fold(0, |most, channel| a[channel].max(b[channel]).max(most));
            // A factor instead of a branch, which would often be guessed wrong.
            let counts = u32::from(kept & drawn & (most < SATURATED));
            pixels_here += counts;
            for channel in 0..3 {
                let (a, b) = (counts * u32::from(a[channel]), u32::from(b[channel]));
                products_here[channel] += a * b;
                squares_here[channel] += a * a;
            }
        }
        pixels += u64::from(pixels_here);
        for channel in 0..3 {
            products[channel] += u64::from(products_here[channel]);
            squares[channel] += u64::from(squares_here[channel]);
        }
        pace.after(a.len()).await;
    }
    if pixels < FEWEST_PIXELS {
        return None;
    }
    Some(std::array::from_fn(|channel| {
        if squares[channel] > 0 {
            products[channel] as f64 / squares[channel] as f64
        } else {
            1.0
        }
    }))
}

/// Whether `change` makes A into B, which it is not without.
async fn turns_into(pair: &Pair<'_>, pace: &Pace, change: impl Fn(Pixel) -> Pixel) -> bool {
    let (mut direct, mut unexplained) = (0_u64, 0_u64);
    let mut left = pair.kept().len() as u64;
    for ((a, b), kept) in in_blocks(pair) {
        for ((&a, &b), _) in a.iter().zip(b).zip(kept).filter(|(_, kept)| **kept) {
            direct += u64::from(difference(a, b) > OTHER_COLOR);
            unexplained += u64::from(difference(change(a), b) > ROUNDING);
        }
        left -= a.len() as u64;
        if !explains_most(unexplained, direct + left) {
            return false;
        }
        pace.after(a.len()).await;
    }
    direct >= FEWEST_PIXELS
}

/// Whether A and B, each changed, agree where something is drawn, though most of it differs
/// unchanged.
async fn drawn_turns_into(
    pair: &Pair<'_>,
    pace: &Pace,
    change_a: impl Fn(Pixel) -> Pixel,
    change_b: impl Fn(Pixel) -> Pixel,
) -> bool {
    let [background_a, background_b] = pair.backgrounds();
    let (mut drawn, mut direct, mut unexplained) = (0_u64, 0_u64, 0_u64);
    let mut left = pair.kept().len() as u64;
    for ((a, b), kept) in in_blocks(pair) {
        for ((&a, &b), _) in a.iter().zip(b).zip(kept).filter(|(_, kept)| **kept) {
            if pair.is_drawn(a, background_a) || pair.is_drawn(b, background_b) {
                drawn += 1;
                direct += u64::from(difference(a, b) > ROUNDING);
                unexplained += u64::from(difference(change_a(a), change_b(b)) > ROUNDING);
            }
        }
        left -= a.len() as u64;
        if !explains_most(unexplained, direct + left) {
            return false;
        }
        pace.after(a.len()).await;
    }
    drawn >= FEWEST_PIXELS && 2 * direct > drawn
}

/// Whether so few of `direct` pixels are unexplained that the rest tells the cause.
fn explains_most(unexplained: u64, direct: u64) -> bool {
    unexplained <= direct / UNEXPLAINED_ONE_IN
}

/// Pixels between two looks at whether too many are unexplained already, and whose sums of
/// products fit into 32 bits.
const BLOCK: usize = 4096;

/// A, B and whether each pixel counts, a block at a time.
fn in_blocks<'a>(
    pair: &'a Pair<'_>,
) -> impl Iterator<Item = ((&'a [Pixel], &'a [Pixel]), &'a [bool])> {
    let pixels = pair.a().chunks(BLOCK).zip(pair.b().chunks(BLOCK));
    pixels.zip(pair.kept().chunks(BLOCK))
}

/// The sRGB encoding of a linear value, both 0..=255.
fn encode(linear: u8) -> u8 {
    let linear = f32::from(linear) / 255.0;
    let encoded = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * encoded).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::diagnosis::evidence::{drawn_in_both, drawn_in_either};
    use crate::compare::test_pictures::{filled, noise};
    use crate::steps::at_once;

    #[test]
    fn an_early_end_and_sums_of_blocks_change_no_answer() {
        let even = filled(100, 90, [40, 50, 60, 255]);
        let picture = |values, seed| noise(100, 90, values, seed);
        let pictures = [
            [picture(0..=255, 1), picture(0..=255, 2)],
            [picture(50..=70, 1), picture(50..=70, 2)],
            [picture(50..=52, 1), even.clone()],
            [even.clone(), even],
        ];
        let half = |[r, g, b, alpha]: Pixel| [r / 2, g / 2, b / 2, alpha];
        let pace = &Pace::new(usize::MAX);
        let mut answers = Vec::new();
        for [a, mut b] in pictures {
            for halved in [0, 8_600, 9_000] {
                let pixels = a.rgba.as_chunks::<4>().0;
                for (at, pixel) in pixels.iter().enumerate().take(halved) {
                    b.rgba[4 * at..][..4].copy_from_slice(&half(*pixel));
                }
                let pair = Pair::new(&a, &b, &["5,5,20,20".parse().unwrap()]).unwrap();
                let sums = drawn_in_both(&pair, 0..9_000).filter(|(a, b)| {
                    let mut channels = a[..3].iter().chain(&b[..3]);
                    channels.all(|&channel| channel < SATURATED)
                });
                let mut expected = [[0.0; 2]; 3];
                for (a, b) in sums {
                    for channel in 0..3 {
                        let [a, b] = [a, b].map(|pixel| f64::from(pixel[channel]));
                        expected[channel][0] += a * b;
                        expected[channel][1] += a * a;
                    }
                }
                let expected = expected.map(|[products, squares]| products / squares);
                let is_drawn = expected[0].is_finite();
                let found = at_once(|_| factors(&pair, pace));
                assert_eq!(found, is_drawn.then_some(expected));

                let count = |is: &dyn Fn(Pixel, Pixel) -> bool| {
                    let drawn = drawn_in_either(&pair, 0..9_000);
                    drawn.filter(|&(a, b)| is(a, b)).count() as u64
                };
                let direct = count(&|a, b| difference(a, b) > ROUNDING);
                let unexplained = count(&|a, b| difference(half(a), b) > ROUNDING);
                let (drawn, few) = (
                    count(&|_, _| true),
                    unexplained <= direct / UNEXPLAINED_ONE_IN,
                );
                let expected = drawn >= FEWEST_PIXELS && 2 * direct > drawn && few;
                let found = at_once(|_| drawn_turns_into(&pair, pace, half, |b| b));
                assert_eq!(found, expected);

                let compared = || {
                    let pixels = pair.a().iter().zip(pair.b()).zip(pair.kept());
                    pixels
                        .filter(|(_, kept)| **kept)
                        .map(|((&a, &b), _)| (a, b))
                };
                let direct = compared()
                    .filter(|&(a, b)| difference(a, b) > OTHER_COLOR)
                    .count() as u64;
                let unexplained = compared().filter(|&(a, b)| difference(half(a), b) > ROUNDING);
                let few = unexplained.count() as u64 <= direct / UNEXPLAINED_ONE_IN;
                let found = at_once(|_| turns_into(&pair, pace, half));
                assert_eq!(found, direct >= FEWEST_PIXELS && few);
                answers.push((expected, few));
            }
        }
        assert!(answers.contains(&(true, true)) && answers.contains(&(false, false)));
    }
}
