//! Where the figure in a screenshot of the Virtual Mannequin's page is not the one in our picture, whatever differs behind and
//! before it: the page has noise in its floor, and other lines for bones. A picture of this program's own has neither.

use super::page_view::{PageView, Part};
use crate::compare::{FigureOff, whole_outline_placed};
use crate::geometry::Picture;
use crate::ui::{FigureElsewhere, FloorSeen, PageFigure};

/// How far the channels of a color may be apart in figures that agree, on the page …
const SHADES: u8 = 48;
/// … and in a picture of this program's own: a foot that is turned by 25 degrees has hardly other colors of normals, and with less what a jaw
/// hardly moves beside it is off as well.
const OWN_SHADES: u8 = 24;
/// Half the width of the line of a bone, in pixels, with what is mixed with it.
const HALF_A_LINE: usize = 3;

/// Where the figure in `ours` is not the one in `page`, of the same size, but for its edges and what lines of bones cover;
/// `None` without a figure. Where what is behind is the same, so are lines where the figure is right, if their edges are alike.
pub(super) fn compare_figures(
    page: &Picture,
    ours: &Picture,
    are_edges_alike: bool,
) -> Option<PageFigure> {
    if (page.width, page.height) != (ours.width, ours.height) {
        return None;
    }
    let [page, ours] = [page, ours].map(PageView::new);
    let floor = page.floor_seen(&ours);
    let is_slanted = page.is_slanted();
    let is_floor_same = floor == FloorSeen::Same;
    let has_lines = is_floor_same && are_edges_alike;
    let [page, ours] = [page, ours].map(|view| FigureIn { view, has_lines });
    let is_figure = |at: &usize| page.is_figure(*at) || ours.is_figure(*at);
    let figure = (0..page.view.pixels.len()).filter(is_figure);
    let of_figures = page.pixels_of_figure() + ours.pixels_of_figure();
    let islands = [page.islands_off(&ours), ours.islands_off(&page)];
    let outlines = [page.outline(), ours.outline()];
    let shown = outlines
        .each_ref()
        .map(|outline| page.view.grid.apart(outline.clone()));
    let off = FigureOff::new(
        page.view.grid,
        islands.each_ref().map(Vec::as_slice),
        of_figures,
        ours.right(&page),
        shown.each_ref().map(Vec::as_slice),
        true,
        floor.is_in_place(),
    );
    Some(PageFigure {
        area: page.view.grid.area_around(figure)?,
        is_slanted,
        floor,
        elsewhere: off
            .as_ref()
            .and_then(|_| elsewhere(&page, &ours, &outlines, is_floor_same)),
        off,
    })
}

/// How the outline of the figure in `page` is placed in `ours`, of which these are the masks, if it is there and elsewhere.
fn elsewhere(
    page: &FigureIn<'_>,
    ours: &FigureIn<'_>,
    outlines: &[Vec<bool>; 2],
    is_floor_same: bool,
) -> Option<FigureElsewhere> {
    let placed =
        whole_outline_placed(page.view.grid.width, outlines.each_ref().map(Vec::as_slice))?;
    Some(FigureElsewhere {
        is_floor_right: is_floor_same || page.view.has_floor_of(&ours.view, &placed),
        is_only_moved: placed.factor == 1.0 && placed.degrees == 0.0,
        placement: placed.words,
    })
}

/// A picture with a figure in it.
struct FigureIn<'a> {
    view: PageView<'a>,
    /// Whether lines of bones are drawn as in the other picture, so that they are told as well as the mesh.
    has_lines: bool,
}

impl FigureIn<'_> {
    fn is_mesh(&self, at: usize) -> bool {
        self.view.part(at) == Part::Mesh
    }

    fn is_of_figure(&self, at: usize) -> bool {
        match self.view.part(at) {
            Part::Behind => false,
            Part::Line => self.has_lines,
            Part::Mesh => true,
        }
    }

    /// Whether it is in the midst of the figure, and not the edge of a line, whose colors are mixed with those behind it.
    fn is_figure(&self, at: usize) -> bool {
        self.view.grid.is_solid(at, |at| self.is_of_figure(at))
    }

    fn pixels_of_figure(&self) -> usize {
        (0..self.view.pixels.len())
            .filter(|&at| self.is_of_figure(at))
            .count()
    }

    /// The pixels that the figure covers, with those between which lines of bones are drawn over it; lines beside it are none.
    fn outline(&self) -> Vec<bool> {
        let meshes: Vec<bool> = (0..self.view.pixels.len())
            .map(|at| self.is_mesh(at))
            .collect();
        let without_lines = self.view.grid.grown(&self.view.grid.shrunk(&meshes));
        let widths = 0..HALF_A_LINE;
        let wide = widths
            .clone()
            .fold(without_lines, |mask, _| self.view.grid.grown(&mask));
        widths.fold(wide, |mask, _| self.view.grid.shrunk(&mask))
    }

    /// Places of the figure where `other` has another color or none, and not at an edge alone, by which hang together. Where
    /// lines are of the figure, so is a limb that is hardly wider than they are.
    fn islands_off(&self, other: &Self) -> Vec<Vec<usize>> {
        let is_off: Vec<bool> = (0..self.view.pixels.len())
            .map(|at| self.is_of_figure(at) && !other.has_like(self.view.pixels[at], at))
            .collect();
        if !self.has_lines {
            return self.view.grid.islands(&is_off);
        }
        let is_all_off = |at: usize| {
            let mut around = self
                .view
                .grid
                .around(at)
                .filter(|&at| self.is_of_figure(at));
            around.all(|at| is_off[at])
        };
        let is_no_edge = |at: usize| {
            is_off[at] && (self.view.grid.is_solid(at, |at| is_off[at]) || is_all_off(at))
        };
        self.view
            .grid
            .apart((0..is_off.len()).map(is_no_edge).collect())
    }

    /// Places in the midst of the figure where `other` has the same.
    fn right(&self, other: &Self) -> Vec<usize> {
        let is_right = |&at: &usize| {
            let is_inside = match self.has_lines {
                true => self.is_of_figure(at),
                false => self.is_mesh(at) && self.is_figure(at),
            };
            is_inside && other.has_like(self.view.pixels[at], at)
        };
        (0..self.view.pixels.len()).filter(is_right).collect()
    }

    /// Whether a pixel of the figure that is like `pixel`, or a line that may be before it, is at a place or beside it.
    fn has_like(&self, pixel: [u8; 4], at: usize) -> bool {
        let shades = if self.has_lines { OWN_SHADES } else { SHADES };
        self.view.grid.around(at).any(|at| {
            let other = self.view.pixels[at];
            let is_near = |(a, b): (&u8, u8)| a.abs_diff(b) <= shades;
            let is_alike = || pixel.iter().zip(other).all(is_near);
            match self.view.part(at) {
                Part::Line => !self.has_lines || is_alike(),
                Part::Mesh => is_alike(),
                Part::Behind => false,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::page_view::TEAL;
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
        let off = |page: &Picture, ours: &Picture| {
            compare_figures(page, ours, true)
                .unwrap()
                .off
                .map(|off| off.area)
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
}
