//! What is seen in a picture in the look of the Virtual Mannequin's page.

use crate::compare::PixelGrid;
use crate::geometry::Picture;

/// Background of the page's view.
pub(super) const TEAL: [u8; 3] = [0, 95, 95];
/// How far the channels of a color may be from gray, or from the background's, to be that.
const NOISE: u8 = 24;

/// What a pixel of a picture in the page's look is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Floor or background.
    Behind,
    /// A bone's line, which is red or, where it is pointed at, cyan.
    Line,
    /// The mesh, colored by its normals.
    Mesh,
}

impl Part {
    pub fn of([red, green, blue, _]: [u8; 4]) -> Self {
        let color = [red, green, blue];
        let low = red.min(green).min(blue);
        let is_gray = red.max(green).max(blue) - low <= NOISE;
        let is_teal = is_of_sky(color);
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

/// Whether a color is that of the page's background.
pub(super) fn is_of_sky(color: [u8; 3]) -> bool {
    color.iter().zip(TEAL).all(|(a, b)| a.abs_diff(b) <= NOISE)
}

/// A picture in that look.
#[derive(Clone, Copy)]
pub(super) struct PageView<'a> {
    pub pixels: &'a [[u8; 4]],
    pub grid: PixelGrid,
}

impl<'a> PageView<'a> {
    pub fn new(picture: &'a Picture) -> Self {
        Self {
            pixels: picture.rgba.as_chunks::<4>().0,
            grid: PixelGrid {
                width: picture.width as usize,
                height: picture.height as usize,
            },
        }
    }

    /// What a pixel is of.
    pub fn part(&self, at: usize) -> Part {
        Part::of(self.pixels[at])
    }
}
