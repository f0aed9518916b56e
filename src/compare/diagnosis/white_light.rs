use super::evidence::FEWEST_PIXELS;
use crate::compare::pair::Pixel;

/// White light up to this (of 255) may be rounding.
const NONE: f64 = 6.0;
/// White light from here on is there.
const SURE: f64 = 16.0;
/// Light is none if so many of the pixels say so, and there if more than the others bear it.
const NEARLY_ALL: f64 = 0.98;
/// So many of the pixels must bear light that is there.
const ENOUGH: f64 = 0.05;
/// So many of the pixels elsewhere must have the colors of one surface.
const MOST: f64 = 0.8;
/// A surface is pale if white light changes its colors by less than this share.
const LEAST_COLOR: f64 = 0.3;
/// Pixels off the line by more are of another surface, or lit.
const OFF_LINE: f64 = 6.0;
/// How often what is off the line is left out, and the line drawn anew.
const ROUNDS: usize = 8;
/// Channels that reach this may have been cut off.
const SATURATED: u8 = 250;

/// Whether a picture has white light in an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WhiteLight {
    None,
    Some,
    /// The colors do not tell.
    Unknown,
}

/// A colored surface without white light: its least channel against its largest. Colored light
/// moves a pixel along the line, white light off it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    slope: f64,
    start: f64,
}

impl Surface {
    /// The surface that most of the pixels belong to; `None` if there is no such surface, or it
    /// is so pale that white light does not show.
    pub(super) fn of(pixels: &[Pixel]) -> Option<Self> {
        let points: Vec<[f64; 2]> = pixels.iter().filter_map(|&pixel| ends(pixel)).collect();
        let mut surface = Self::through(points.iter())?;
        for _ in 0..ROUNDS {
            let mut off: Vec<f64> = points.iter().map(|&at| surface.off_line(at)).collect();
            let middle = off.len() / 2;
            let (_, &mut median, _) = off.select_nth_unstable_by(middle, f64::total_cmp);
            let near = OFF_LINE.max(2.0 * median);
            surface = Self::through(points.iter().filter(|&&at| surface.off_line(at) <= near))?;
        }
        let fitting = points
            .iter()
            .filter(|&&at| surface.off_line(at) <= OFF_LINE)
            .count();
        let sure = fitting as f64 >= MOST * pixels.len() as f64;
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
    pub(super) fn white_light(self, pixel: Pixel) -> Option<f64> {
        let [most, least] = ends(pixel)?;
        Some((least - self.start - self.slope * most) / (1.0 - self.slope))
    }

    /// Whether there is white light in the pixels.
    pub(super) fn judge(self, pixels: &[Pixel]) -> WhiteLight {
        let light = pixels.iter().map(|&pixel| self.white_light(pixel));
        let light: Vec<f64> = light.flatten().collect();
        let share = |above: f64| {
            let count = light.iter().filter(|&&light| light > above).count();
            count as f64 / pixels.len() as f64
        };
        let cut_off = 1.0 - light.len() as f64 / pixels.len() as f64;
        if share(NONE) + cut_off <= 1.0 - NEARLY_ALL {
            WhiteLight::None
        } else if share(SURE) >= ENOUGH {
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
