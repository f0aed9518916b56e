//! Where the figure in a screenshot of the Virtual Mannequin's page is not the one in our picture, whatever differs behind and
//! before it: the page has noise in its floor, and other lines for bones. A picture of this program's own has neither.

use crate::compare::{FigureOff, PixelGrid, WholePlaced, whole_outline_placed};
use crate::geometry::Picture;
use crate::ui::{FigureElsewhere, FloorSeen, PageFigure};
use glam::DVec2;
use std::ops::Range;

/// Background of the page's view.
const TEAL: [u8; 3] = [0, 95, 95];
/// How far the channels of a color may be from gray, or from the background's, to be that, and from one another in figures
/// that agree.
const NOISE: u8 = 24;
const SHADES: u8 = 48;
/// Part of the width, one in so many, at either side of a picture in which its horizon is looked for.
const SIDE: usize = 8;
/// Share of the width by which the two may differ in height where the horizon is level.
const LEVEL: f64 = 0.005;
/// Half the width of the line of a bone, in pixels, with what is mixed with it.
const HALF_A_LINE: usize = 3;
/// Part of the height, one in so many, in which the floor is near: farther off its squares are as small as the page's noise.
const NEAR: usize = 4;
/// How far the brightness of squares of the floor is apart.
const SQUARES: u8 = 64;
/// Brightness below which a square is black: the course's background has 26.
const BLACK: u8 = 16;
/// Fewest pixels of either color of the floor's squares that tell where it is.
const FEWEST_OF_EITHER: usize = 500;
/// Share of it that differs where the camera is turned: by the page's noise 0.017 does, and by 3 degrees, of which the figure
/// itself hardly shows anything, 0.037.
const FLOOR_OFF: f64 = 0.03;
/// The same where it is in its place: from a camera that is a twentieth nearer 0.044 differed.
const FLOOR_IN_PLACE: f64 = 0.022;
/// The same from which on no figure is worth a look before the camera is right: 5 degrees make it 0.066 even without noise.
const FLOOR_ELSEWHERE: f64 = 0.06;
/// Share of what is behind the figures in both pictures that differs where it is the same without noise: by the page's 0.1 does, and
/// where a figure moved, which has colors of the floor in places as well, 0.01.
const SAME_BEHIND: f64 = 0.02;
/// How far channels are apart there.
const ROUNDING: u8 = 2;
/// Share of it that differs at most where it is in its place, …
const STILL: f64 = 0.05;
/// … and how many times as much does where it is not.
const CLEARLY: f64 = 1.3;
/// How far a floor moves that another camera shows elsewhere, by how far the figure does.
const MOVED_WITH_IT: [f64; 4] = [0.5, 1.0, 1.5, 2.0];

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

/// Where the figure in `ours` is not the one in `page`, of the same size, but for its edges and what lines of bones cover;
/// `None` without a figure. Where what is behind is the same, so are lines where the figure is right.
pub(super) fn compare_figures(page: &Picture, ours: &Picture) -> Option<PageFigure> {
    if (page.width, page.height) != (ours.width, ours.height) {
        return None;
    }
    let [mut page, mut ours] = [page, ours].map(FigureIn::new);
    let floor = page.floor_seen(&ours);
    let is_same_behind = floor == FloorSeen::Same;
    page.has_lines_in_figure = is_same_behind;
    ours.has_lines_in_figure = is_same_behind;
    let is_figure = |at: &usize| page.is_figure(*at) || ours.is_figure(*at);
    let figure = (0..page.pixels.len()).filter(is_figure);
    let of_figures = page.pixels_of_figure() + ours.pixels_of_figure();
    let islands = [page.islands_off(&ours), ours.islands_off(&page)];
    let off = FigureOff::new(
        page.grid,
        islands.each_ref().map(Vec::as_slice),
        of_figures,
        ours.right(&page),
        true,
    );
    let off = off.map(|off| FigureOff {
        is_camera_right: floor.is_in_place(),
        ..off
    });
    Some(PageFigure {
        area: page.grid.area_around(figure)?,
        is_slanted: page.is_slanted(),
        floor,
        elsewhere: off.as_ref().and_then(|_| elsewhere(&page, &ours)),
        off,
    })
}

/// Whether a picture shows the page's floor near the eye, in both colors of its squares. No other background is as black.
pub(super) fn shows_floor_of_page(picture: &Picture) -> bool {
    let figure = FigureIn::new(picture);
    let PixelGrid { width, height } = figure.grid;
    let near = &figure.pixels[width * (height - height / NEAR)..];
    let count = |is_such: &dyn Fn(u8) -> bool| {
        let such = near.iter().filter(|pixel| is_such(pixel[0]));
        such.filter(|pixel| Part::of(**pixel) == Part::Behind)
            .count()
    };
    let [black, bright] = [count(&|gray| gray < BLACK), count(&|gray| gray > SQUARES)];
    black.min(bright) >= FEWEST_OF_EITHER
}

/// How the outline of the figure in `page` is placed in `ours`, if it is there and elsewhere.
fn elsewhere(page: &FigureIn<'_>, ours: &FigureIn<'_>) -> Option<FigureElsewhere> {
    let outlines = [page.outline(), ours.outline()];
    let placed = whole_outline_placed(page.grid.width, outlines.each_ref().map(Vec::as_slice))?;
    Some(FigureElsewhere {
        is_floor_right: page.has_lines_in_figure
            || page.has_floor_of(ours, Movement::from(&placed)),
        is_only_moved: placed.factor == 1.0 && placed.degrees == 0.0,
        placement: placed.words,
    })
}

/// How a figure that has its middle at `center` is moved and resized, in pixels.
#[derive(Clone, Copy, Debug)]
struct Movement {
    center: DVec2,
    by: DVec2,
    factor: f64,
}

/// No movement.
const STANDING: Movement = Movement {
    center: DVec2::ZERO,
    by: DVec2::ZERO,
    factor: 1.0,
};

impl From<&WholePlaced> for Movement {
    fn from(placed: &WholePlaced) -> Self {
        Self {
            center: placed.middle,
            by: placed.by,
            factor: placed.factor,
        }
    }
}

impl Movement {
    /// This share of the movement.
    fn part(self, share: f64) -> Self {
        Self {
            by: share * self.by,
            factor: 1.0 + share * (self.factor - 1.0),
            ..self
        }
    }

    fn moved(self, at: DVec2) -> DVec2 {
        self.center + self.by + self.factor * (at - self.center)
    }
}

/// A picture with a figure in it.
struct FigureIn<'a> {
    pixels: &'a [[u8; 4]],
    grid: PixelGrid,
    /// Whether lines of bones are drawn as in the other picture, so that they are told as well as the mesh.
    has_lines_in_figure: bool,
}

impl<'a> FigureIn<'a> {
    fn new(picture: &'a Picture) -> Self {
        Self {
            pixels: picture.rgba.as_chunks::<4>().0,
            grid: PixelGrid {
                width: picture.width as usize,
                height: picture.height as usize,
            },
            has_lines_in_figure: false,
        }
    }

    fn is_mesh(&self, at: usize) -> bool {
        Part::of(self.pixels[at]) == Part::Mesh
    }

    fn is_of_figure(&self, at: usize) -> bool {
        match Part::of(self.pixels[at]) {
            Part::Behind => false,
            Part::Line => self.has_lines_in_figure,
            Part::Mesh => true,
        }
    }

    /// What the floors tell of the cameras.
    fn floor_seen(&self, other: &Self) -> FloorSeen {
        if self.has_same_behind(other) {
            return FloorSeen::Same;
        }
        match self.floor_off(other, STANDING) {
            Some(FLOOR_ELSEWHERE..) => FloorSeen::Elsewhere,
            Some(FLOOR_OFF..) => FloorSeen::Off,
            Some(..=FLOOR_IN_PLACE) => FloorSeen::InPlace,
            _ => FloorSeen::Unknown,
        }
    }

    /// Whether what is behind both figures is the same, of which enough is seen.
    fn has_same_behind(&self, other: &Self) -> bool {
        let pairs = self.pixels.iter().zip(other.pixels);
        let behind = pairs.filter(|(a, b)| [**a, **b].map(Part::of) == [Part::Behind; 2]);
        let (mut bright, mut dark, mut off) = (0, 0, 0);
        for (a, b) in behind {
            if a[0] > SQUARES {
                bright += 1;
            } else {
                dark += 1;
            }
            off += usize::from(a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > ROUNDING));
        }
        bright.min(dark) >= FEWEST_OF_EITHER && off as f64 <= SAME_BEHIND * (bright + dark) as f64
    }

    /// Whether the horizon is higher on one side than on the other. Lines of bones and single parts of a figure before it do
    /// not count.
    fn is_slanted(&self) -> bool {
        let side = self.grid.width / SIDE;
        let heights = |columns: Range<usize>| -> Option<f64> {
            let mut heights: Vec<usize> = columns.filter_map(|x| self.horizon_in(x)).collect();
            heights.sort_unstable();
            heights.get(heights.len() / 2).map(|&height| height as f64)
        };
        let sides = [0..side, self.grid.width - side..self.grid.width].map(heights);
        let [Some(left), Some(right)] = sides else {
            return false;
        };
        (left - right).abs() > (LEVEL * self.grid.width as f64).max(1.0)
    }

    /// The row in which the sky ends in a column, if it begins and ends there.
    fn horizon_in(&self, column: usize) -> Option<usize> {
        let is_of_sky = |row: usize| {
            let [red, green, blue, _] = self.pixels[row * self.grid.width + column];
            is_of_sky([red, green, blue])
        };
        (0..self.grid.height)
            .find(|&row| !is_of_sky(row))
            .filter(|&row| row > 0)
    }

    /// Whether it is in the midst of the figure, and not the edge of a line, whose colors are mixed with those behind it.
    fn is_figure(&self, at: usize) -> bool {
        self.grid.is_solid(at, |at| self.is_of_figure(at))
    }

    fn pixels_of_figure(&self) -> usize {
        (0..self.pixels.len())
            .filter(|&at| self.is_of_figure(at))
            .count()
    }

    /// The pixels that the figure covers, with those between which lines of bones are drawn over it; lines beside it are none.
    fn outline(&self) -> Vec<bool> {
        let meshes: Vec<bool> = (0..self.pixels.len()).map(|at| self.is_mesh(at)).collect();
        let without_lines = self.grid.grown(&self.grid.shrunk(&meshes));
        let widths = 0..HALF_A_LINE;
        let wide = widths
            .clone()
            .fold(without_lines, |mask, _| self.grid.grown(&mask));
        widths.fold(wide, |mask, _| self.grid.shrunk(&mask))
    }

    /// Whether the floor is where `other` has it, and clearly not where a camera would have it that sees the figure moved so:
    /// there nearer parts move farther.
    fn has_floor_of(&self, other: &Self, movement: Movement) -> bool {
        let off = |share: f64| self.floor_off(other, movement.part(share));
        let Some(still) = off(0.0).filter(|still| *still <= STILL) else {
            return false;
        };
        let mut moved = MOVED_WITH_IT.into_iter().map(off);
        moved.all(|moved| moved.is_none_or(|moved| moved >= CLEARLY * still))
    }

    /// The share of the floor near the eye that differs from where `other` has it after a movement; `None` if too little of it is
    /// seen, or not both of its colors.
    fn floor_off(&self, other: &Self, movement: Movement) -> Option<f64> {
        let PixelGrid { width, height } = self.grid;
        let size = DVec2::new(width as f64, height as f64);
        let (mut bright, mut dark, mut off) = (0, 0, 0);
        for y in height - height / NEAR..height {
            for x in 0..width {
                let there = movement.moved(DVec2::new(x as f64, y as f64)).round();
                if there.cmplt(DVec2::ZERO).any() || there.cmpge(size).any() {
                    continue;
                }
                let of_other = other.pixels[there.y as usize * width + there.x as usize];
                let own = self.pixels[y * width + x];
                if [own, of_other].map(Part::of) == [Part::Behind; 2] {
                    if own[0] > SQUARES {
                        bright += 1;
                    } else {
                        dark += 1;
                    }
                    off += usize::from(own[0].abs_diff(of_other[0]) > SQUARES);
                }
            }
        }
        let is_enough = bright.min(dark) >= FEWEST_OF_EITHER;
        is_enough.then(|| off as f64 / (bright + dark) as f64)
    }

    /// Places of the figure where `other` has another color or none, and not at an edge alone, by which hang together. Where
    /// lines are of the figure, so is a limb that is hardly wider than they are.
    fn islands_off(&self, other: &Self) -> Vec<Vec<usize>> {
        let is_off: Vec<bool> = (0..self.pixels.len())
            .map(|at| self.is_of_figure(at) && !other.has_like(self.pixels[at], at))
            .collect();
        if !self.has_lines_in_figure {
            return self.grid.islands(&is_off);
        }
        let is_all_off = |at: usize| {
            let mut around = self.grid.around(at).filter(|&at| self.is_of_figure(at));
            around.all(|at| is_off[at])
        };
        let is_no_edge =
            |at: usize| is_off[at] && (self.grid.is_solid(at, |at| is_off[at]) || is_all_off(at));
        self.grid.apart((0..is_off.len()).map(is_no_edge).collect())
    }

    /// Places in the midst of the figure where `other` has the same.
    fn right(&self, other: &Self) -> Vec<usize> {
        let is_right = |&at: &usize| {
            let is_inside = match self.has_lines_in_figure {
                true => self.is_of_figure(at),
                false => self.is_mesh(at) && self.is_figure(at),
            };
            is_inside && other.has_like(self.pixels[at], at)
        };
        (0..self.pixels.len()).filter(is_right).collect()
    }

    /// Whether a pixel of the figure that is like `pixel`, or a line that may be before it, is at a place or beside it.
    fn has_like(&self, pixel: [u8; 4], at: usize) -> bool {
        self.grid.around(at).any(|at| {
            let other = self.pixels[at];
            let is_near = |(a, b): (&u8, u8)| a.abs_diff(b) <= SHADES;
            let is_alike = || pixel.iter().zip(other).all(is_near);
            match Part::of(other) {
                Part::Line => !self.has_lines_in_figure || is_alike(),
                Part::Mesh => is_alike(),
                Part::Behind => false,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let off = |page: &Picture, ours: &Picture| {
            compare_figures(page, ours).unwrap().off.map(|off| off.area)
        };
        assert_eq!(off(&page, &picture(5..10, [170; 3])), None);
        // An edge says nothing.
        assert_eq!(off(&page, &picture(5..11, TEAL)), None);
        // What differs is where the part is in either, but for edges.
        let elsewhere = picture(15..20, TEAL);
        assert_eq!(off(&page, &elsewhere), "17,6,2,13".parse().ok());
        let without = picture(0..0, TEAL);
        assert!(off(&page, &without).is_some() && off(&without, &page).is_some());
    }

    #[test]
    fn a_horizon_is_slanted_that_is_higher_on_one_side() {
        let slanted = |rise: usize| {
            let pixels = (0..400 * 60).flat_map(|at| {
                let (x, y) = (at % 400, at / 400);
                let is_figure = (190..210).contains(&x) && (10..50).contains(&y);
                let is_sky = y < 20 + rise * x / 400;
                let [red, green, blue] = match (is_figure, is_sky) {
                    (true, _) => [200, 120, 40],
                    (_, true) => TEAL,
                    _ => [90; 3],
                };
                [red, green, blue, 255]
            });
            let picture = Picture {
                width: 400,
                height: 60,
                rgba: pixels.collect(),
            };
            compare_figures(&picture, &picture).unwrap().is_slanted
        };
        assert!(!slanted(0) && !slanted(2) && slanted(4) && slanted(30));
    }
}
