use super::evidence::{FEWEST_PIXELS, ROUNDING, UNEXPLAINED_ONE_IN};
use super::{Finding, Which};
use crate::compare::Pair;
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;

/// Factors nearer to one than this are not worth a word.
const LEAST_CHANGE: f64 = 0.03;
/// Larger factors, or smaller than one by them, are no light or material but chance.
const MOST_CHANGE: f64 = 8.0;
/// Weights of red, green and blue in gray: ITU-R BT.601, BT.709, and the mean.
const GRAYS: [[f32; 3]; 3] = [
    [0.299, 0.587, 0.114],
    [0.2126, 0.7152, 0.0722],
    [1.0 / 3.0; 3],
];
/// Channels that reach this may have been cut off.
const SATURATED: u8 = 250;

impl Pair<'_> {
    /// Whether the backgrounds differ, and whether that is all: `over_same` are the same pictures
    /// over A's background.
    pub(super) fn background_beside(&self, over_same: &Pair<'_>) -> Option<Finding> {
        let [Some(a), Some(b)] = self.backgrounds() else {
            return None;
        };
        (a != b).then(|| Finding::Background {
            a,
            b,
            alone: over_same.pixels_of_other_color() == 0,
        })
    }

    /// Whether B has the color channels in the other order.
    pub(super) fn red_blue_exchanged(&self) -> Option<Finding> {
        self.turns_into(|[r, g, b, alpha]| [b, g, r, alpha])
            .then_some(Finding::RedBlueExchanged)
    }

    /// Whether B is A in shades of gray, by one of the ways in which programs make these.
    pub(super) fn gray(&self) -> Option<Finding> {
        let colored = |&[r, g, b, _]: &Pixel| r != g || g != b;
        if self
            .b()
            .iter()
            .zip(self.kept())
            .any(|(b, &kept)| kept && colored(b))
        {
            return None;
        }
        GRAYS
            .iter()
            .any(|weights| {
                self.turns_into(|[r, g, b, alpha]| {
                    let channels = [r, g, b].map(f32::from);
                    let gray: f32 = channels.iter().zip(weights).map(|(c, w)| c * w).sum();
                    let gray = gray.round() as u8;
                    [gray, gray, gray, alpha]
                })
            })
            .then_some(Finding::Gray)
    }

    /// Whether one picture is the sRGB encoding of the other.
    pub(super) fn gamma(&self) -> Option<Finding> {
        let encoded: [u8; 256] = std::array::from_fn(|step| encode(step as u8));
        let encode = |[r, g, b, alpha]: Pixel| {
            let [r, g, b] = [r, g, b].map(|channel| encoded[usize::from(channel)]);
            [r, g, b, alpha]
        };
        let lighter = if self.drawn_turn_into(encode, |b| b) {
            Which::B
        } else if self.drawn_turn_into(|a| a, encode) {
            Which::A
        } else {
            return None;
        };
        Some(Finding::Gamma { lighter })
    }

    /// Whether what is drawn in B is lighter or darker than in A by one factor a channel. What is
    /// drawn in one picture alone tells nothing about colors, so most must be drawn in both.
    pub(super) fn brightness(&self) -> Option<Finding> {
        let factors = self.factors()?;
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
        self.drawn_turn_into(scale, |b| b)
            .then_some(Finding::Brightness { factors })
    }

    /// For each channel the factor that best takes A to B where both are drawn and neither is
    /// saturated; 1 for a channel that is black there. `None` without enough such pixels.
    fn factors(&self) -> Option<[f64; 3]> {
        let (mut products, mut squares, mut pixels) = ([0.0; 3], [0.0; 3], 0);
        for (a, b) in self.pixels_drawn_in_both() {
            if a[..3]
                .iter()
                .chain(&b[..3])
                .any(|&channel| channel >= SATURATED)
            {
                continue;
            }
            pixels += 1;
            for channel in 0..3 {
                let (a, b) = (f64::from(a[channel]), f64::from(b[channel]));
                products[channel] += a * b;
                squares[channel] += a * a;
            }
        }
        if pixels < FEWEST_PIXELS {
            return None;
        }
        Some(std::array::from_fn(|channel| {
            if squares[channel] > 0.0 {
                products[channel] / squares[channel]
            } else {
                1.0
            }
        }))
    }

    /// Whether `change` makes A into B, which it is not without.
    fn turns_into(&self, change: impl Fn(Pixel) -> Pixel) -> bool {
        let direct = self.pixels_of_other_color();
        let pixels = self.a().iter().zip(self.b());
        let unexplained = pixels
            .filter(|&(&a, &b)| difference(change(a), b) > ROUNDING)
            .count() as u64;
        direct >= FEWEST_PIXELS && unexplained <= direct / UNEXPLAINED_ONE_IN
    }

    /// Whether A and B, each changed, agree where something is drawn, though most of it differs
    /// unchanged.
    fn drawn_turn_into(
        &self,
        change_a: impl Fn(Pixel) -> Pixel,
        change_b: impl Fn(Pixel) -> Pixel,
    ) -> bool {
        let (mut drawn, mut direct, mut unexplained) = (0_u64, 0_u64, 0_u64);
        for (a, b) in self.drawn_pixels() {
            drawn += 1;
            direct += u64::from(difference(a, b) > ROUNDING);
            unexplained += u64::from(difference(change_a(a), change_b(b)) > ROUNDING);
        }
        drawn >= FEWEST_PIXELS && 2 * direct > drawn && unexplained <= direct / UNEXPLAINED_ONE_IN
    }
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
