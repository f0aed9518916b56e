//! Screenshots of the Virtual Mannequin's page, which show its keyframes below the view.

use crate::geometry::Picture;
use std::ops::{Range, RangeInclusive};

/// Height of the strip of keyframes and the timeline in the page's window, in pixels.
const STRIP_HEIGHT: usize = 200;
/// Rows at the top of the strip in which nothing but its color is drawn, below the frame of the view, …
const EMPTY_ROWS: Range<usize> = 2..40;
/// … of which this share has that color at least: all but the frame at the sides.
const MOST: f64 = 0.98;
/// Rows at the bottom of the view, of which the floor leaves no more than this share in that color, which is also that of
/// the background in the course's pictures.
const LAST_ROWS: usize = 8;
const LEAST: f64 = 0.1;
/// The strip's color, which browsers draw a little differently.
const COLOR: RangeInclusive<u8> = 24..=28;

/// Color of the frame around the page's window, of which a screenshot has the upper and the left line.
const FRAME: RangeInclusive<u8> = 165..=175;

/// The part of a screenshot of the page that shows its view; `None` for another picture.
pub(super) fn view_of_page(picture: &Picture) -> Option<Picture> {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let of_view = height.checked_sub(STRIP_HEIGHT).filter(|&rows| rows > 0)?;
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let is_of_strip =
        |[red, green, blue, _]: &&[u8; 4]| red == green && green == blue && COLOR.contains(red);
    let share = |rows: Range<usize>| {
        let pixels = pixels.get(rows.start * width..rows.end * width)?;
        let of_strip = pixels.iter().filter(is_of_strip).count();
        Some(of_strip as f64 / pixels.len().max(1) as f64)
    };
    let in_strip = share(of_view + EMPTY_ROWS.start..of_view + EMPTY_ROWS.end)?;
    let in_view = share(of_view.saturating_sub(LAST_ROWS)..of_view)?;
    if in_strip < MOST || in_view > LEAST {
        return None;
    }
    let shift = usize::from(is_framed(pixels, width, of_view));
    let rgba = (0..of_view).flat_map(|y| {
        let row = &pixels[(y + shift) * width..(y + shift + 1) * width];
        // What is beyond the last column is like it.
        (0..width).flat_map(move |x| row[(x + shift).min(width - 1)])
    });
    Some(Picture {
        width: picture.width,
        height: of_view as u32,
        rgba: rgba.collect(),
    })
}

/// Whether the first column and row are those of the frame around the page's window, so that its view begins beside them.
fn is_framed(pixels: &[[u8; 4]], width: usize, height: usize) -> bool {
    let is_frame =
        |[red, green, blue, _]: &&[u8; 4]| red == green && green == blue && FRAME.contains(red);
    let side = pixels.iter().step_by(width.max(1)).take(height);
    let framed = pixels[..width].iter().chain(side).filter(is_frame).count();
    framed as f64 >= MOST * (width + height) as f64
}

/// Background of the page's view.
const TEAL: [u8; 3] = [0, 95, 95];
/// How far the channels of a color may be from gray, or from the background's, to be that, and from one another in figures
/// that agree.
const NOISE: u8 = 24;
const SHADES: u8 = 48;
/// Pixels among nine that differ where it is no edge alone.
const SOLID: usize = 7;
/// Share of a figure that may differ so in pictures in which it agrees.
const LITTLE: f64 = 0.002;

/// What a pixel of a picture in the page's look is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// Floor or background.
    Behind,
    /// A bone's line, which is red or, where it is pointed at, cyan.
    Line,
    /// The mesh, colored by its normals.
    Mesh,
}

impl Part {
    fn of([red, green, blue, _]: [u8; 4]) -> Self {
        let color = [red, green, blue];
        let low = red.min(green).min(blue);
        let is_gray = red.max(green).max(blue) - low <= NOISE;
        let is_teal = color.iter().zip(TEAL).all(|(a, b)| a.abs_diff(b) <= NOISE);
        let is_red = red >= 128 && green.max(blue) < red / 3;
        let is_cyan = red < 64 && green.min(blue) > 128;
        if is_gray || is_teal {
            Self::Behind
        } else if is_red || is_cyan {
            Self::Line
        } else {
            Self::Mesh
        }
    }
}

/// Whether the figure in `ours` is the one in `page`, of the same size, but for its edges and what lines of bones cover.
pub(super) fn figures_agree(page: &Picture, ours: &Picture) -> bool {
    if (page.width, page.height) != (ours.width, ours.height) {
        return false;
    }
    let [page, ours] = [page, ours].map(|picture| FigureIn {
        pixels: picture.rgba.as_chunks::<4>().0,
        width: picture.width as usize,
        height: picture.height as usize,
    });
    let (mut figure, mut off) = (0_usize, 0_usize);
    for (one, other) in [(&page, &ours), (&ours, &page)] {
        let is_mesh = |at: usize| Part::of(one.pixels[at]) == Part::Mesh;
        let is_off: Vec<bool> = (0..one.pixels.len())
            .map(|at| is_mesh(at) && !other.has_like(one.pixels[at], at))
            .collect();
        figure += (0..is_off.len()).filter(|&at| is_mesh(at)).count();
        let solid =
            |at: &usize| is_off[*at] && one.around(*at).filter(|&at| is_off[at]).count() >= SOLID;
        off += (0..is_off.len()).filter(solid).count();
    }
    figure > 0 && off as f64 <= LITTLE * figure as f64
}

/// A picture with a figure in it.
struct FigureIn<'a> {
    pixels: &'a [[u8; 4]],
    width: usize,
    height: usize,
}

impl FigureIn<'_> {
    /// A place and those beside it.
    fn around(&self, at: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, x, y) = (self.width, at % self.width, at / self.width);
        let rows = y.saturating_sub(1)..(y + 2).min(self.height);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        rows.flat_map(move |y| columns.clone().map(move |x| y * width + x))
    }

    /// Whether a pixel of the figure that is like `pixel`, or a line before it, is at a place or beside it.
    fn has_like(&self, pixel: [u8; 4], at: usize) -> bool {
        self.around(at).any(|at| {
            let other = self.pixels[at];
            let mut channels = pixel.iter().zip(other);
            match Part::of(other) {
                Part::Line => true,
                Part::Mesh => channels.all(|(a, b)| a.abs_diff(b) <= SHADES),
                Part::Behind => false,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn screenshot(height: u32, strip: u8) -> Picture {
        let rows = (0..height).flat_map(|row| {
            let is_of_view = row + STRIP_HEIGHT as u32 <= height;
            let gray = if is_of_view { 174 } else { strip };
            [[gray, gray, gray, 255]; 30].into_iter().flatten()
        });
        Picture {
            width: 30,
            height,
            rgba: rows.collect(),
        }
    }

    #[test]
    fn only_a_screenshot_with_the_strip_of_keyframes_is_cut() {
        for gray in [25, 26] {
            let view = view_of_page(&screenshot(260, gray)).expect("a strip");
            assert_eq!((view.width, view.height), (30, 60));
            assert!(view.rgba.chunks(4).all(|pixel| pixel[0] == 174));
        }
        for (height, gray) in [(260, 90), (200, 26), (20, 26), (0, 26)] {
            assert_eq!(view_of_page(&screenshot(height, gray)), None);
        }
        // Beside a frame the view begins one pixel farther in both directions.
        let mut framed = screenshot(260, 26);
        let at = |x: usize, y: usize| 4 * (30 * y + x);
        for along in 0..60 {
            framed.rgba[at(0, along)..][..3].fill(170);
            framed.rgba[at(along % 30, 0)..][..3].fill(170);
        }
        framed.rgba[at(1, 1)..][..3].fill(9);
        framed.rgba[at(29, 60)..][..3].fill(7);
        let view = view_of_page(&framed).expect("a strip");
        assert_eq!((view.width, view.height), (30, 60));
        assert_eq!((view.rgba[0], view.rgba[at(29, 59)]), (9, 7));
        let mut dark = screenshot(260, 26);
        dark.rgba
            .chunks_mut(4)
            .for_each(|pixel| pixel[..3].fill(26));
        assert_eq!(view_of_page(&dark), None);
        // Teal is the background of the view.
        let mut teal = screenshot(260, 26);
        teal.rgba.chunks_mut(4).for_each(|pixel| pixel[1] = 95);
        assert_eq!(view_of_page(&teal), None);
    }

    #[test]
    fn figures_agree_whatever_is_behind_them_and_not_where_a_part_is_elsewhere() {
        let picture = |part: Range<usize>, behind: [u8; 3]| {
            let pixels = (0..30 * 30).flat_map(|at| {
                let (x, y) = (at % 30, at / 30);
                let of_body = (5..15).contains(&x) && (5..25).contains(&y);
                let of_part = (15..20).contains(&x) && part.contains(&y);
                let [red, green, blue] = if of_body || of_part {
                    [200, 120, 40]
                } else {
                    behind
                };
                [red, green, blue, 255]
            });
            Picture {
                width: 30,
                height: 30,
                rgba: pixels.collect(),
            }
        };
        let page = picture(5..10, TEAL);
        assert!(figures_agree(&page, &picture(5..10, [170; 3])));
        // An edge says nothing.
        assert!(figures_agree(&page, &picture(5..11, TEAL)));
        assert!(!figures_agree(&page, &picture(15..20, TEAL)));
        let empty = picture(0..0, TEAL);
        assert!(!figures_agree(&page, &empty) && !figures_agree(&empty, &page));
    }
}
