//! Whether the figure in a screenshot of the Virtual Mannequin's page is the one in our picture, whatever differs behind and
//! before it: the page has noise in its floor, and other lines for bones.

use crate::geometry::Picture;

/// Background of the page's view.
const TEAL: [u8; 3] = [0, 95, 95];
/// How far the channels of a color may be from gray, or from the background's, to be that, and from one another in figures
/// that agree.
const NOISE: u8 = 24;
const SHADES: u8 = 48;
/// Pixels among nine that differ where it is no edge alone.
const SOLID: usize = 7;
/// Share of a figure that may differ so in pictures in which it agrees: in one that is right a thousandth does, and a forearm
/// that is turned a little is more than a hundredth.
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
    use std::ops::Range;

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
