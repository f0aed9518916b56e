//! Axes that are drawn in one picture alone: thin straight lines in red, green or blue that leave it, or that cross and are
//! all that differs.

use super::evidence::{FEWEST_PIXELS, UNEXPLAINED_ONE_IN, count};
use super::lines::{Ends, LEAST_LENGTH, Line, MOST_OF_SIDES, Mask, Seen};
use super::{Finding, Which};
use crate::compare::pair::{Pair, Pixel};
use crate::steps::Pace;
use glam::IVec2;

/// Least distance, of 255, of the strongest channel of an axis from the others, also where the edge of
/// its line is mixed with what is behind it.
const LEAST_COLOR: u8 = 24;

/// Axes that one picture shows and the other does not.
pub(super) struct Axes {
    pub only_in: Which,
    /// Whether each pixel is one of theirs.
    pub pixels: Vec<bool>,
    /// Whether next to nothing else differs.
    pub alone: bool,
}

impl Axes {
    /// The axes in `pair`, of which the pixels `other_colors` differ. Where something else differs as well,
    /// a single line is not taken for an axis, nor are lines that do not cross, or that do not leave the picture. Nor are
    /// lines of which a part is in both pictures, such as beside a panel that covers the rest in one of them.
    pub(super) async fn find(pair: &Pair<'_>, other_colors: &[bool], pace: &Pace) -> Option<Self> {
        let mut colored = Vec::new();
        for is_in_b in [false, true] {
            let (with, without) = match is_in_b {
                false => (pair.a(), pair.b()),
                true => (pair.b(), pair.a()),
            };
            let mut channels = Vec::with_capacity(other_colors.len());
            pace.bands(other_colors.len(), |band| {
                let colors = with[band.clone()].iter().zip(&without[band.clone()]);
                let colors = colors.zip(&other_colors[band]);
                channels.extend(colors.map(|((with, without), differs)| match differs {
                    true => axis_channel(*with, *without),
                    false => None,
                }));
            })
            .await;
            for channel in 0..3 {
                let mask = of_channel(pair, &channels, channel).thin();
                pace.after(other_colors.len()).await;
                let leaving = mask.longest_line(Ends::AtSides, pace).await;
                colored.push(Colored {
                    is_in_b,
                    channel,
                    mask,
                    leaving,
                });
            }
        }
        let leaving = Self::among(&colored, pair, other_colors, Ends::AtSides, pace).await;
        let sides = (pair.width() + pair.height()) as u64;
        if leaving.is_some() || count(other_colors) > MOST_OF_SIDES * sides {
            return leaving;
        }
        Self::among(&colored, pair, other_colors, Ends::Anywhere, pace).await
    }

    /// The axes whose lines end there, or at sides.
    async fn among(
        colored: &[Colored],
        pair: &Pair<'_>,
        other_colors: &[bool],
        ends: Ends,
        pace: &Pace,
    ) -> Option<Self> {
        let mut are_in = [false; 2];
        let mut pixels = vec![false; other_colors.len()];
        let mut lines: Vec<Seen> = Vec::new();
        let mut spans = false;
        for one in colored {
            let Some(line) = one.line(ends, pace).await else {
                continue;
            };
            let with = if one.is_in_b { pair.b() } else { pair.a() };
            let both = in_both(pair, with, other_colors, one.channel).thin();
            pace.after(other_colors.len()).await;
            if both.runs(line).flatten().count() >= LEAST_LENGTH {
                return None;
            }
            spans |= one.mask.spans(line);
            lines.push(one.mask.cover(line, other_colors, &mut pixels));
            are_in[usize::from(one.is_in_b)] = true;
        }
        let only_in = Which::of(are_in).filter(|only_in| *only_in != Which::Both)?;
        let (own, all) = (count(&pixels), count(other_colors));
        let alone = all - own <= all / UNEXPLAINED_ONE_IN;
        let size = IVec2::new(pair.width() as i32, pair.height() as i32).as_vec2();
        let mut pairs = lines.iter().enumerate().flat_map(|(index, one)| {
            let others = lines[..index].iter();
            others.map(move |other| (one, other))
        });
        let are_axes = match ends {
            Ends::AtSides => alone || pairs.any(|(one, other)| one.crosses(other, size)),
            Ends::Anywhere => {
                alone && (lines.len() == 1 && spans || pairs.any(|(one, other)| one.meets(other)))
            }
        };
        let are_axes = are_axes && own >= FEWEST_PIXELS;
        are_axes.then_some(Self {
            only_in,
            pixels,
            alone,
        })
    }

    pub(super) fn finding(&self) -> Finding {
        let Self { only_in, alone, .. } = *self;
        Finding::Axes { only_in, alone }
    }
}

/// What differs in one picture in the color of an axis.
struct Colored {
    is_in_b: bool,
    channel: u8,
    mask: Mask,
    /// The longest line that begins at a side.
    leaving: Option<Line>,
}

impl Colored {
    /// The line of an axis that ends there, or at sides.
    async fn line(&self, ends: Ends, pace: &Pace) -> Option<Line> {
        let mask = &self.mask;
        let at_sides = self.leaving.filter(|line| match ends {
            Ends::AtSides => mask.is_axis(*line),
            Ends::Anywhere => mask.is_axis(*line) || mask.spans(*line),
        });
        if at_sides.is_some() || ends == Ends::AtSides {
            return at_sides;
        }
        let line = mask.longest_line(ends, pace).await;
        line.filter(|line| mask.has_few_gaps(*line))
    }
}

/// The channel of an axis that a color may be of, over another color: more of that one, or less of others.
fn axis_channel(over: Pixel, under: Pixel) -> Option<u8> {
    let channel = (1..3).fold(0, |most, channel| match over[channel] > over[most] {
        true => channel,
        false => most,
    });
    let others = || (0..3).filter(|&other| other != channel);
    let more = |other: usize| by(over, channel, other) - by(under, channel, other);
    let stands_out_more = others().all(|it| more(it) >= 0) && others().any(|it| more(it) > 0);
    (stands_out_more && stands_out(over, channel)).then_some(channel as u8)
}

/// Whether a color is that of an axis in this channel.
fn stands_out(color: Pixel, channel: usize) -> bool {
    let mut others = (0..3).filter(|&other| other != channel);
    others.all(|other| by(color, channel, other) >= i16::from(LEAST_COLOR))
}

/// By how much one channel of a color is more than another.
fn by(color: Pixel, channel: usize, other: usize) -> i16 {
    i16::from(color[channel]) - i16::from(color[other])
}

/// The pixels of the color of an axis in this channel.
fn of_channel(pair: &Pair, channels: &[Option<u8>], channel: u8) -> Mask {
    let is_inside = |of: &Option<u8>| *of == Some(channel);
    Mask::new(pair, channels.iter().map(is_inside).collect())
}

/// The pixels of such a color that do not differ.
fn in_both(pair: &Pair, with: &[Pixel], other_colors: &[bool], channel: u8) -> Mask {
    let has_color = |of: Pixel| stands_out(of, usize::from(channel));
    let pixels = with.iter().zip(other_colors);
    let inside = pixels.map(|(&of, &differs)| !differs && has_color(of));
    Mask::new(pair, inside.collect())
}
