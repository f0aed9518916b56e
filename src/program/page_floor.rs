//! What is behind the figure in a picture in the look of the Virtual Mannequin's page: its floor, which tells whether two cameras
//! agree, and its horizon.

use super::page_view::{PageView, Part, is_of_sky};
use crate::compare::{PixelGrid, WholePlaced};
use crate::geometry::Picture;
use crate::ui::FloorSeen;
use glam::DVec2;
use std::ops::Range;

/// Part of the width, one in so many, at either side of a picture in which its horizon is looked for.
const SIDE: usize = 8;
/// Share of the width by which the two may differ in height where the horizon is level.
const LEVEL: f64 = 0.005;
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

/// Whether a picture shows the page's floor near the eye, in both colors of its squares. No other background is as black.
pub(super) fn shows_floor_of_page(picture: &Picture) -> bool {
    let view = PageView::new(picture);
    let PixelGrid { width, height } = view.grid;
    let near = (width * (height - height / NEAR)..view.pixels.len())
        .filter(|&at| view.part(at) == Part::Behind)
        .map(|at| view.pixels[at][0]);
    let black = near.clone().filter(|gray| *gray < BLACK).count();
    let bright = near.filter(|gray| *gray > SQUARES).count();
    black.min(bright) >= FEWEST_OF_EITHER
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

/// Pixels behind the figures in both pictures, by the colors of the floor's squares, and how many of them are off.
#[derive(Default)]
struct Squares {
    bright: usize,
    dark: usize,
    off: usize,
}

impl Squares {
    /// Counts a pixel of two pictures if it is behind the figures.
    fn count(
        &mut self,
        own: [u8; 4],
        other: [u8; 4],
        is_off: impl FnOnce([u8; 4], [u8; 4]) -> bool,
    ) {
        if [own, other].map(Part::of) != [Part::Behind; 2] {
            return;
        }
        if own[0] > SQUARES {
            self.bright += 1;
        } else {
            self.dark += 1;
        }
        self.off += usize::from(is_off(own, other));
    }

    /// The share that is off; `None` if there is too little of either color.
    fn share_off(&self) -> Option<f64> {
        let is_enough = self.bright.min(self.dark) >= FEWEST_OF_EITHER;
        is_enough.then(|| self.off as f64 / (self.bright + self.dark) as f64)
    }
}

impl PageView<'_> {
    /// What the floors tell of the cameras.
    pub fn floor_seen(&self, other: &Self) -> FloorSeen {
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
        let mut squares = Squares::default();
        for (own, of_other) in self.pixels.iter().zip(other.pixels) {
            squares.count(*own, *of_other, |own, other| {
                let mut channels = own.iter().zip(other);
                channels.any(|(a, b)| a.abs_diff(b) > ROUNDING)
            });
        }
        let off = squares.share_off();
        off.is_some_and(|off| off <= SAME_BEHIND)
    }

    /// Whether the horizon is higher on one side than on the other. Lines of bones and single parts of a figure before it do
    /// not count.
    pub fn is_slanted(&self) -> bool {
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

    /// Whether the floor is where `other` has it, and clearly not where a camera would have it that sees the figure moved so:
    /// there nearer parts move farther.
    pub fn has_floor_of(&self, other: &Self, placed: &WholePlaced) -> bool {
        let movement = Movement::from(placed);
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
        let mut squares = Squares::default();
        for y in height - height / NEAR..height {
            for x in 0..width {
                let there = movement.moved(DVec2::new(x as f64, y as f64)).round();
                if there.cmplt(DVec2::ZERO).any() || there.cmpge(size).any() {
                    continue;
                }
                let of_other = other.pixels[there.y as usize * width + there.x as usize];
                let own = self.pixels[y * width + x];
                squares.count(own, of_other, |a, b| a[0].abs_diff(b[0]) > SQUARES);
            }
        }
        squares.share_off()
    }
}

#[cfg(test)]
mod tests {
    use super::super::page_view::TEAL;
    use super::*;

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
            PageView::new(&picture).is_slanted()
        };
        assert!(!slanted(0) && !slanted(2) && slanted(4) && slanted(30));
    }
}
