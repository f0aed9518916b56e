use super::evidence::{Evidence, FEWEST_PIXELS, OTHER_COLOR, count};
use super::{Finding, HighlightChange, Which};
use crate::compare::differences::difference;
use crate::compare::pair::Pixel;
use crate::compare::ssim::luma;
use crate::steps::Pace;

/// A highlight covers no more than one in this many drawn pixels.
const ONE_IN: u64 = 3;
/// Where things are gray, less light looks the same as less white light: there its pixels must be
/// among the brightest, this many times as many as they are.
const BRIGHTEST_TIMES: usize = 3;
/// White light adds as much to each channel, but for rounding (of 255).
const NEUTRAL: u8 = 4;
/// A thing has a color of its own if its channels are this far apart.
const COLORED: u8 = 24;
/// Channels that reach this may have been cut off, and say nothing about the color of the light.
const SATURATED: u8 = 250;
/// The brightest light is that which one in this many drawn pixels has.
const PEAK_ONE_IN: usize = 1000;
/// Share of the pixels that must bear each sign of a highlight.
const NEARLY_ALL: f64 = 0.95;

/// White light up to this (of 255) may be rounding.
const NO_LIGHT: f64 = 6.0;
/// White light of at least this (of 255) is no rounding.
const SURE_LIGHT: f64 = 16.0;
/// Share of the pixels that must be without white light for it to be missing.
const WITHOUT_LIGHT: f64 = 0.98;
/// Share of the pixels that must have white light for it to be there.
const WITH_LIGHT: f64 = 0.05;
/// Share of the other pixels that must have the colors of one surface.
const OF_ONE_SURFACE: f64 = 0.8;
/// A surface is pale if white light changes its colors by less than this share.
const LEAST_COLOR: f64 = 0.3;
/// Pixels off the line by more are of another surface, or lit.
const OFF_LINE: f64 = 6.0;
/// Rounds in which pixels off the line are left out and the line is fitted again.
const ROUNDS: usize = 8;

/// White light that one picture has and the other lacks: a highlight that is missing there, or a
/// different one.
pub(super) async fn highlight(evidence: &Evidence<'_>) -> Option<Finding> {
    if evidence.outline().await.is_some() {
        return None;
    }
    let pair = evidence.pair();
    let (a, b) = (pair.a(), pair.b());
    match less_in(Which::B, evidence, a, b).await {
        None => less_in(Which::A, evidence, b, a).await,
        found => found,
    }
}

async fn less_in(
    less_in: Which,
    evidence: &Evidence<'_>,
    lit: &[Pixel],
    unlit: &[Pixel],
) -> Option<Finding> {
    let [drawn_a, _] = evidence.drawn_masks().await?;
    let differs = evidence.other_colors();
    let few = evidence.pixels_of_other_color() < FEWEST_PIXELS;
    if few || evidence.pixels_of_other_color() * ONE_IN > count(drawn_a) {
        return None;
    }
    let differing: Vec<(Pixel, Pixel)> = pixels_in(lit, unlit, differs).collect();
    let mut lumas: Vec<f32> = pixels_in(lit, unlit, drawn_a)
        .map(|(lit, _)| luma(lit))
        .collect();
    evidence.pace.after(drawn_a.len()).await;
    let differing_pixels = differing.len();
    let place = lumas.len() - (differing_pixels * BRIGHTEST_TIMES).min(lumas.len());
    let (_, &mut least_bright, _) = lumas.select_nth_unstable_by(place, f32::total_cmp);
    evidence.pace.after(lumas.len()).await;
    let signs = differing.iter().filter(|&&(lit, unlit)| {
        let telling = is_colored(unlit) || luma(lit) >= least_bright;
        telling && added_light(lit, unlit).is_some()
    });
    let enough = signs.count() as f64 >= NEARLY_ALL * differing_pixels as f64;
    if !enough || !fades(&differing) {
        return None;
    }
    let area = evidence.area_of(differs)?;
    let drawn = pixels_in(lit, unlit, drawn_a).collect::<Vec<_>>();
    evidence.pace.after(drawn_a.len()).await;
    let in_b = match (change(&drawn, evidence.pace).await, less_in) {
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
async fn change(drawn: &[(Pixel, Pixel)], pace: &Pace) -> Change {
    let differs = |&&(lit, unlit): &&(Pixel, Pixel)| difference(lit, unlit) > OTHER_COLOR;
    let unlit_pixels = |inside: bool| -> Vec<Pixel> {
        let pixels = drawn.iter().filter(|pair| differs(pair) == inside);
        pixels.map(|&(_, unlit)| unlit).collect()
    };
    let Some(surface) = Surface::of(&unlit_pixels(false), pace).await else {
        return Change::Unknown;
    };
    match surface.judge(&unlit_pixels(true)) {
        WhiteLight::None => return Change::Missing,
        WhiteLight::Unknown => return Change::Unknown,
        WhiteLight::Some => {}
    }
    pace.after(drawn.len()).await;
    let peak = |pixel: fn(&(Pixel, Pixel)) -> Pixel| {
        let light = drawn.iter().map(|pair| surface.white_light(pixel(pair)));
        // What is cut off hides how bright it was.
        let mut light: Vec<f64> = light.collect::<Option<_>>()?;
        let place = light.len().checked_sub(1 + light.len() / PEAK_ONE_IN)?;
        let (_, &mut peak, _) = light.select_nth_unstable_by(place, f64::total_cmp);
        Some(peak)
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

/// Whether a picture has white light in an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WhiteLight {
    None,
    Some,
    /// The colors do not tell.
    Unknown,
}

/// A colored surface without white light: its least channel against its largest. Colored light
/// moves a pixel along the line, white light off it.
#[derive(Clone, Copy, Debug)]
struct Surface {
    slope: f64,
    start: f64,
}

impl Surface {
    /// The surface that most of the pixels belong to; `None` if there is no such surface, or it
    /// is so pale that white light does not show.
    async fn of(pixels: &[Pixel], pace: &Pace) -> Option<Self> {
        let points: Vec<[f64; 2]> = pixels.iter().filter_map(|&pixel| ends(pixel)).collect();
        let mut surface = Self::through(points.iter())?;
        for _ in 0..ROUNDS {
            let mut off: Vec<f64> = points.iter().map(|&at| surface.off_line(at)).collect();
            let middle = off.len() / 2;
            let (_, &mut median, _) = off.select_nth_unstable_by(middle, f64::total_cmp);
            let near = OFF_LINE.max(2.0 * median);
            surface = Self::through(points.iter().filter(|&&at| surface.off_line(at) <= near))?;
            pace.after(points.len()).await;
        }
        let fitting = points
            .iter()
            .filter(|&&at| surface.off_line(at) <= OFF_LINE)
            .count();
        let sure = fitting as f64 >= OF_ONE_SURFACE * pixels.len() as f64;
        (sure && 1.0 - surface.slope >= LEAST_COLOR).then_some(surface)
    }

    /// The straight line of least squares.
    fn through<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> Option<Self> {
        let [mut count, mut x, mut y, mut xx, mut xy] = [0.0; 5];
        for [most, least] in points {
            count += 1.0;
            x += most;
            y += least;
            xx += most * most;
            xy += most * least;
        }
        let spread = count * xx - x * x;
        if count < FEWEST_PIXELS as f64 || spread <= count * count {
            return None;
        }
        let slope = (count * xy - x * y) / spread;
        Some(Self {
            slope,
            start: (y - slope * x) / count,
        })
    }

    fn off_line(self, [most, least]: [f64; 2]) -> f64 {
        (least - self.start - self.slope * most).abs()
    }

    /// How much white light a pixel has on this surface, of 255; `None` if it is cut off.
    fn white_light(self, pixel: Pixel) -> Option<f64> {
        let [most, least] = ends(pixel)?;
        Some((least - self.start - self.slope * most) / (1.0 - self.slope))
    }

    /// Whether there is white light in the pixels.
    fn judge(self, pixels: &[Pixel]) -> WhiteLight {
        let light = pixels.iter().map(|&pixel| self.white_light(pixel));
        let light: Vec<f64> = light.flatten().collect();
        let share = |above: f64| {
            let count = light.iter().filter(|&&light| light > above).count();
            count as f64 / pixels.len() as f64
        };
        let cut_off = 1.0 - light.len() as f64 / pixels.len() as f64;
        if share(NO_LIGHT) + cut_off <= 1.0 - WITHOUT_LIGHT {
            WhiteLight::None
        } else if share(SURE_LIGHT) >= WITH_LIGHT {
            WhiteLight::Some
        } else {
            WhiteLight::Unknown
        }
    }
}

/// The largest and the least channel of a pixel that is not cut off.
fn ends([r, g, b, _]: Pixel) -> Option<[f64; 2]> {
    let most = r.max(g).max(b);
    (most < SATURATED).then(|| [f64::from(most), f64::from(r.min(g).min(b))])
}
