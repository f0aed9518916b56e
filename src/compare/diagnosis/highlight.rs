use super::evidence::{FEWEST_PIXELS, OTHER_COLOR};
use super::white_light::{Surface, WhiteLight};
use super::{Finding, HighlightChange, Which};
use crate::compare::Pair;
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;
use crate::compare::ssim::luma;

/// A highlight covers no more than one in so many drawn pixels.
const ONE_IN: usize = 3;
/// On gray things, where less light looks the same as less white light, its pixels are among the
/// so many times brightest.
const BRIGHTEST_TIMES: usize = 3;
/// White light adds as much to each channel, but for rounding (of 255).
const NEUTRAL: u8 = 4;
/// A thing has a color of its own if its channels are this far apart.
const COLORED: u8 = 24;
/// Channels that reach this may have been cut off, and say nothing about the color of the light.
const SATURATED: u8 = 250;
/// The brightest light is that which one in so many drawn pixels has.
const PEAK_ONE_IN: usize = 1000;
/// Share of the pixels that must bear each sign of a highlight.
const NEARLY_ALL: f64 = 0.95;

impl Pair<'_> {
    /// Whether one picture has white light that the other lacks: a highlight that is missing
    /// there, or another one.
    pub(super) fn highlight(&self) -> Option<Finding> {
        self.highlight_less_in(Which::B, self.a(), self.b())
            .or_else(|| self.highlight_less_in(Which::A, self.b(), self.a()))
    }

    fn highlight_less_in(&self, less_in: Which, lit: &[Pixel], unlit: &[Pixel]) -> Option<Finding> {
        let [drawn_a, _] = self.drawn_masks()?;
        if self.outline().is_some() {
            return None;
        }
        let differs: Vec<bool> = lit
            .iter()
            .zip(unlit)
            .map(|(&lit, &unlit)| difference(lit, unlit) > OTHER_COLOR)
            .collect();
        let differing: Vec<(Pixel, Pixel)> = pixels_in(lit, unlit, &differs).collect();
        let mut lumas: Vec<f32> = pixels_in(lit, unlit, &drawn_a)
            .map(|(lit, _)| luma(lit))
            .collect();
        let count = differing.len();
        if (count as u64) < FEWEST_PIXELS || count * ONE_IN > lumas.len() {
            return None;
        }
        let place = lumas.len() - (count * BRIGHTEST_TIMES).min(lumas.len());
        let (_, &mut least_bright, _) = lumas.select_nth_unstable_by(place, f32::total_cmp);
        let signs = differing.iter().filter(|&&(lit, unlit)| {
            let telling = is_colored(unlit) || luma(lit) >= least_bright;
            telling && added_light(lit, unlit).is_some()
        });
        let enough = signs.count() as f64 >= NEARLY_ALL * count as f64;
        if !enough || !fades(&differing) {
            return None;
        }
        let area = self.area_of(&differs)?;
        let drawn = pixels_in(lit, unlit, &drawn_a).collect::<Vec<_>>();
        let in_b = match (change(&drawn), less_in) {
            (Change::Missing, missing_in) => return Some(Finding::Highlight { missing_in, area }),
            (Change::Strength, Which::B) => HighlightChange::Weaker,
            (Change::Strength, _) => HighlightChange::Stronger,
            (Change::Width, Which::B) => HighlightChange::Narrower,
            (Change::Width, _) => HighlightChange::Wider,
            (Change::Unknown, Which::B) => HighlightChange::Less,
            (Change::Unknown, _) => HighlightChange::More,
        };
        Some(Finding::HighlightChanged { in_b, area })
    }
}

/// What the less lit picture lacks.
enum Change {
    /// The highlight.
    Missing,
    /// A part of its strength.
    Strength,
    /// Its rim.
    Width,
    /// One of these.
    Unknown,
}

/// What the less lit of two pictures lacks, of which these are the drawn pixels.
fn change(drawn: &[(Pixel, Pixel)]) -> Change {
    let differs = |&&(lit, unlit): &&(Pixel, Pixel)| difference(lit, unlit) > OTHER_COLOR;
    let unlit_pixels = |inside: bool| -> Vec<Pixel> {
        let pixels = drawn.iter().filter(|pair| differs(pair) == inside);
        pixels.map(|&(_, unlit)| unlit).collect()
    };
    let Some(surface) = Surface::of(&unlit_pixels(false)) else {
        return Change::Unknown;
    };
    match surface.judge(&unlit_pixels(true)) {
        WhiteLight::None => return Change::Missing,
        WhiteLight::Unknown => return Change::Unknown,
        WhiteLight::Some => {}
    }
    let peak = |pixel: fn(&(Pixel, Pixel)) -> Pixel| {
        let light = drawn.iter().map(|pair| surface.white_light(pixel(pair)));
        // What is cut off hides how bright it was.
        let mut light: Vec<f64> = light.collect::<Option<_>>()?;
        light.sort_unstable_by(f64::total_cmp);
        light.iter().rev().nth(light.len() / PEAK_ONE_IN).copied()
    };
    match (peak(|pair| pair.0), peak(|pair| pair.1)) {
        (Some(lit), Some(unlit)) if (lit - unlit).abs() <= f64::from(OTHER_COLOR) => Change::Width,
        (Some(lit), Some(unlit)) if lit > unlit => Change::Strength,
        _ => Change::Unknown,
    }
}

fn pixels_in<'a>(
    lit: &'a [Pixel],
    unlit: &'a [Pixel],
    mask: &'a [bool],
) -> impl Iterator<Item = (Pixel, Pixel)> + 'a {
    let pixels = lit.iter().zip(unlit).zip(mask);
    pixels
        .filter(|(_, inside)| **inside)
        .map(|((&lit, &unlit), _)| (lit, unlit))
}

/// The light that was added, if it is white and none was taken away.
fn added_light(lit: Pixel, unlit: Pixel) -> Option<u8> {
    let mut least = u8::MAX;
    let mut most = 0;
    for channel in 0..3 {
        let added = lit[channel].checked_sub(unlit[channel])?;
        most = most.max(added);
        if lit[channel] < SATURATED {
            least = least.min(added);
        }
    }
    // A cut-off channel may have got more than it shows, never less.
    (least == u8::MAX || most <= least.saturating_add(NEUTRAL)).then_some(most)
}

fn is_colored([r, g, b, _]: Pixel) -> bool {
    r.max(g).max(b) - r.min(g).min(b) >= COLORED
}

/// Whether the light fades toward the rim instead of filling the area evenly, as an object in
/// front would.
fn fades(differing: &[(Pixel, Pixel)]) -> bool {
    let mut added: Vec<u8> = differing
        .iter()
        .filter_map(|&(lit, unlit)| added_light(lit, unlit))
        .collect();
    added.sort_unstable();
    let at = |percent: usize| added.get(added.len() * percent / 100).copied().unwrap_or(0);
    2 * u16::from(at(10)) <= u16::from(at(90))
}
