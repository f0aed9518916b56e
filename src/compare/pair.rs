use super::{Area, CompareError, PixelGrid};
use crate::geometry::{GroundColors, Picture};
use crate::steps::{Pace, at_once};
use std::borrow::Cow;
use std::collections::HashMap;

/// A pixel counts as drawn where a channel is farther than this from the background.
pub const DRAWN_THRESHOLD: u8 = 8;

/// One pixel, its colors multiplied by its opacity: the picture as seen over black.
pub(super) type Pixel = [u8; 4];

/// Two pictures of one size, ready to be measured.
///
/// Colors are compared as seen over black, so that what is invisible in both does not count;
/// opacity itself is compared as a fourth channel. Inside of ignored areas B is taken to be
/// equal to A, and the pixels are not counted.
#[derive(Clone, Debug)]
pub struct Pair<'a> {
    width: u32,
    height: u32,
    a: Cow<'a, [Pixel]>,
    b: Cow<'a, [Pixel]>,
    /// Whether each pixel counts.
    kept: Vec<bool>,
    /// Background of A and of B, red, green, blue.
    backgrounds: [Option<[u8; 3]>; 2],
    /// What is behind the figures of a picture without such a background, if it is known.
    ground: Option<GroundColors>,
    /// Whether A, and B, has colors of which none shows, as nothing is opaque at all.
    hides_colors: [bool; 2],
    /// How far from the background a channel of what is drawn is, at least by one more.
    drawn_above: u8,
}

impl<'a> Pair<'a> {
    /// Puts the reference `a` and `b` together, leaving out the areas in `ignore`.
    ///
    /// # Errors
    /// If the sizes differ, a picture is malformed, or no pixel is left to compare.
    pub fn new(a: &'a Picture, b: &'a Picture, ignore: &[Area]) -> Result<Self, CompareError> {
        at_once(|pace| async move { Self::paced_new(a, b, ignore, &pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_new(
        a: &'a Picture,
        b: &'a Picture,
        ignore: &[Area],
        pace: &Pace,
    ) -> Result<Self, CompareError> {
        let size = [a.width, a.height];
        let pixels_of_a = pixels('A', a, pace).await?;
        let mut pixels_of_b = pixels('B', b, pace).await?;
        if size != [b.width, b.height] {
            return Err(CompareError::Size {
                a: size,
                b: [b.width, b.height],
            });
        }
        let mut kept = vec![true; pixels_of_a.len()];
        for &area in ignore {
            let inside = area
                .clipped(a.width, a.height)
                .ok_or(CompareError::AreaOutside { area, size })?;
            for row in inside.y..inside.y + inside.height {
                let start = row as usize * a.width as usize + inside.x as usize;
                let range = start..start + inside.width as usize;
                kept[range.clone()].fill(false);
                pixels_of_b.to_mut()[range.clone()].copy_from_slice(&pixels_of_a[range]);
                pace.after(inside.width as usize).await;
            }
        }
        if !kept.contains(&true) {
            return Err(CompareError::NothingToCompare);
        }
        let mut hides = [false; 2];
        for (hides, picture) in hides.iter_mut().zip([a, b]) {
            *hides = hides_colors(picture, &kept);
            pace.after(kept.len()).await;
        }
        let mut pair = Self {
            width: a.width,
            height: a.height,
            a: pixels_of_a,
            b: pixels_of_b,
            kept,
            backgrounds: [None; 2],
            ground: None,
            hides_colors: hides,
            drawn_above: DRAWN_THRESHOLD,
        };
        pair.backgrounds = [pair.background_of(&pair.a), pair.background_of(&pair.b)];
        pair.drawn_above = pair.paced_drawn_above(pace).await;
        Ok(pair)
    }

    /// Pixels a row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The background of A and of B (red, green, blue): the color that most of the border has;
    /// `None` where the border has no such color.
    pub fn backgrounds(&self) -> [Option<[u8; 3]>; 2] {
        self.backgrounds
    }

    /// The same, where figures stand on a ground in a picture that has no background of one color.
    pub(super) fn on_ground(self, ground: Option<GroundColors>) -> Self {
        Self { ground, ..self }
    }

    /// Whether A, and B, shows more at `index` than what is behind figures, as far as that is known.
    #[inline]
    pub(super) fn figures_at(&self, index: usize) -> [bool; 2] {
        let row = index / self.width as usize;
        let up = 1.0 - (row as f32 + 0.5) / self.height as f32;
        let pixels = [self.a[index], self.b[index]];
        [0, 1].map(|which| match (self.backgrounds[which], &self.ground) {
            (None, Some(ground)) => !ground.may_be(pixels[which], up),
            (background, _) => self.is_drawn(pixels[which], background),
        })
    }

    /// Whether a pixel shows something else than `background`; everything does if there is none.
    #[inline]
    pub(super) fn is_drawn(&self, pixel: Pixel, background: Option<[u8; 3]>) -> bool {
        background.is_none_or(|color| distance(pixel, color) > self.drawn_above)
    }

    /// How far from the background a channel of what is drawn is, at least by one more: [`DRAWN_THRESHOLD`], or less where a figure
    /// has nearly the background's color and there is no noise.
    pub(super) fn drawn_above(&self) -> u8 {
        self.drawn_above
    }

    /// Whether figures are told from what is behind them in both pictures.
    pub(super) fn has_figures(&self) -> bool {
        self.ground.is_some() || self.backgrounds.iter().all(Option::is_some)
    }

    /// Whether A, and B, has different colors that opacity 0 of every pixel hides.
    pub(super) fn hides_colors(&self) -> [bool; 2] {
        self.hides_colors
    }

    /// The places of its pixels.
    pub(super) fn grid(&self) -> PixelGrid {
        PixelGrid {
            width: self.width as usize,
            height: self.height as usize,
        }
    }

    /// The indices of the pixels around one, itself among them.
    pub(super) fn around(&self, index: usize) -> impl Iterator<Item = usize> + use<> {
        self.grid().around(index)
    }

    /// The indices of the kept pixels along the border.
    pub(super) fn border(&self) -> impl Iterator<Item = usize> {
        self.ring(0)
    }

    /// The indices of the kept pixels along the border of what is left without so many rows and columns on each side.
    fn ring(&self, inside: usize) -> impl Iterator<Item = usize> {
        let (width, height) = (self.width as usize, self.height as usize);
        let rows = [inside, height - 1 - inside].into_iter();
        let columns = [inside, width - 1 - inside].into_iter();
        rows.flat_map(move |y| (inside..width - inside).map(move |x| y * width + x))
            .chain(columns.flat_map(move |x| (inside..height - inside).map(move |y| y * width + x)))
            .filter(|&index| self.kept[index])
    }

    /// A, top row first.
    pub(super) fn a(&self) -> &[Pixel] {
        &self.a
    }

    /// B, top row first.
    pub(super) fn b(&self) -> &[Pixel] {
        &self.b
    }

    /// Whether each pixel counts, top row first.
    pub(super) fn kept(&self) -> &[bool] {
        &self.kept
    }

    /// The color that more than half of the kept pixels along the border have. A thin frame, such as browsers draw around
    /// what is on a page, is none.
    fn background_of(&self, pixels: &[Pixel]) -> Option<[u8; 3]> {
        let at_border = most_of(pixels, self.border())?;
        let has_room = self.width.min(self.height) as usize > 4 * FRAME;
        let is_frame = has_room && most_of(pixels, self.ring(FRAME)) != Some(at_border);
        (!is_frame).then_some(at_border)
    }
}

/// Width of the widest frame, in pixels.
const FRAME: usize = 3;

/// The color that more than half of the pixels at `indices` have.
fn most_of(pixels: &[Pixel], indices: impl Iterator<Item = usize>) -> Option<[u8; 3]> {
    let mut counts: HashMap<[u8; 3], usize> = HashMap::new();
    let mut total = 0;
    for index in indices {
        let [r, g, b, _] = pixels[index];
        *counts.entry([r, g, b]).or_default() += 1;
        total += 1;
    }
    let mut counts = counts.into_iter();
    let most = counts.find(|&(_, count)| 2 * count > total);
    most.map(|(color, _)| color)
}

impl Pair<'_> {
    /// The same with other pixels of B, over a background that A has as well.
    pub(super) fn with_b(&self, b: Vec<Pixel>, background: [u8; 3]) -> Pair<'_> {
        Pair {
            width: self.width,
            height: self.height,
            a: Cow::Borrowed(&self.a),
            b: Cow::Owned(b),
            kept: self.kept.clone(),
            backgrounds: [Some(background); 2],
            ground: self.ground,
            hides_colors: self.hides_colors,
            drawn_above: self.drawn_above,
        }
    }

    /// Leaves out what A, or else B, has at `pixels`: what the other has is there then.
    pub(super) fn leave_out(&mut self, pixels: &[bool], in_a: bool) {
        let (from, into) = match in_a {
            true => (&self.b, &mut self.a),
            false => (&self.a, &mut self.b),
        };
        let places = into.to_mut().iter_mut().zip(from.iter()).zip(pixels);
        for ((pixel, other), _) in places.filter(|(_, is_left_out)| **is_left_out) {
            *pixel = *other;
        }
    }
}

/// The largest difference of a channel of color.
#[inline]
pub(super) fn distance(pixel: Pixel, color: [u8; 3]) -> u8 {
    let [r, g, b] = std::array::from_fn(|channel| pixel[channel].abs_diff(color[channel]));
    r.max(g).max(b)
}

/// The pixels of a picture with colors multiplied by opacity, borrowed if it is opaque.
async fn pixels<'a>(
    which: char,
    picture: &'a Picture,
    pace: &Pace,
) -> Result<Cow<'a, [Pixel]>, CompareError> {
    let expected = 4 * u64::from(picture.width) * u64::from(picture.height);
    let found = picture.rgba.len() as u64;
    if expected != found {
        return Err(CompareError::Bytes {
            which,
            expected,
            found,
        });
    }
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let mut is_opaque = true;
    pace.bands(pixels.len(), |band| {
        is_opaque &= pixels[band].iter().all(|pixel| pixel[3] == 255);
    })
    .await;
    if is_opaque {
        return Ok(Cow::Borrowed(pixels));
    }
    let mut seen = Vec::with_capacity(pixels.len());
    pace.bands(pixels.len(), |band| {
        seen.extend(pixels[band].iter().map(|&pixel| seen_over_black(pixel)));
    })
    .await;
    Ok(Cow::Owned(seen))
}

/// Whether the kept pixels have different colors, all of opacity 0.
fn hides_colors(picture: &Picture, kept: &[bool]) -> bool {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let kept = || pixels.iter().zip(kept).filter(|(_, kept)| **kept);
    let first = kept().next();
    kept().all(|(pixel, _)| pixel[3] == 0)
        && kept().any(|(pixel, _)| Some(pixel) != first.map(|(pixel, _)| pixel))
}

fn seen_over_black([r, g, b, alpha]: Pixel) -> Pixel {
    let seen = |channel: u8| ((u16::from(channel) * u16::from(alpha) + 127) / 255) as u8;
    [seen(r), seen(g), seen(b), alpha]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::{filled, from_gray};

    #[test]
    fn pictures_of_different_sizes_are_not_compared() {
        let (a, b) = (filled(4, 3, [0; 4]), filled(3, 4, [0; 4]));
        assert_eq!(
            Pair::new(&a, &b, &[]).unwrap_err(),
            CompareError::Size {
                a: [4, 3],
                b: [3, 4]
            }
        );
    }

    #[test]
    fn malformed_or_fully_ignored_pictures_are_errors() {
        let good = filled(4, 3, [0; 4]);
        let mut short = good.clone();
        short.rgba.pop();
        assert!(matches!(
            Pair::new(&good, &short, &[]),
            Err(CompareError::Bytes { which: 'B', .. })
        ));
        let empty = filled(0, 0, [0; 4]);
        let nothing = Some(CompareError::NothingToCompare);
        assert_eq!(Pair::new(&empty, &empty, &[]).err(), nothing);
        let all = "0,0,9,9".parse().unwrap();
        assert_eq!(Pair::new(&good, &good, &[all]).err(), nothing);
        let outside = "4,0,1,1".parse().unwrap();
        assert!(matches!(
            Pair::new(&good, &good, &[outside]),
            Err(CompareError::AreaOutside { .. })
        ));
    }

    #[test]
    fn the_background_is_what_most_of_the_border_shows() {
        let framed = from_gray(4, &[5, 5, 5, 5, 5, 90, 90, 5, 5, 5, 7, 5]);
        let half = from_gray(2, &[1, 1, 2, 2]);
        let pair = Pair::new(&framed, &framed, &[]).unwrap();
        assert_eq!(pair.backgrounds()[0], Some([5; 3]));
        assert_eq!(
            Pair::new(&half, &half, &[]).unwrap().backgrounds(),
            [None; 2]
        );
        // A frame of one pixel around another color.
        let gray: Vec<u8> = (0..20 * 20)
            .map(|at| {
                let (x, y) = (at % 20, at / 20);
                if x == 0 || y == 0 || x == 19 || y == 19 {
                    170
                } else {
                    9
                }
            })
            .collect();
        let in_frame = from_gray(20, &gray);
        let pair = Pair::new(&in_frame, &in_frame, &[]).unwrap();
        assert_eq!(pair.backgrounds(), [None; 2]);
        let ignoring = Pair::new(&half, &half, &["0,1,2,1".parse().unwrap()]).unwrap();
        assert_eq!(ignoring.backgrounds()[0], Some([1; 3]));
    }

    #[test]
    fn a_picture_is_seen_over_black() {
        assert_eq!(seen_over_black([200, 100, 51, 128]), [100, 50, 26, 128]);
        assert_eq!(seen_over_black([200, 100, 51, 0]), [0; 4]);
        assert_eq!(seen_over_black([200, 100, 51, 255]), [200, 100, 51, 255]);
    }
}
