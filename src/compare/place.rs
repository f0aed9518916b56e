//! Areas of pictures in words, by where they lie in what is drawn.

use super::Area;
use super::pair::Pair;
use crate::steps::{Pace, at_once};

/// Drawn pixels in a row or column that may be no more than a line that crosses it, such as an axis.
const LINE: u32 = 3;
/// Part of the figure's width and height from which on an area is all over it.
const ALL_OVER: f64 = 0.7;

impl Pair<'_> {
    /// The area round what is drawn in either picture, without lines that reach out of it; `None`
    /// if nothing is drawn.
    pub fn figure(&self) -> Option<Area> {
        at_once(|pace| async move { self.paced_figure(&pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_figure(&self, pace: &Pace) -> Option<Area> {
        let (width, height) = (self.width() as usize, self.height() as usize);
        let (mut columns, mut rows) = (vec![0_u32; width], vec![0_u32; height]);
        pace.bands(self.kept().len(), |band| {
            for index in band {
                if self.kept()[index] && self.figures_at(index).contains(&true) {
                    columns[index % width] += 1;
                    rows[index / width] += 1;
                }
            }
        })
        .await;
        let (x, width) = extent(&columns)?;
        let (y, height) = extent(&rows)?;
        Some(Area {
            x,
            y,
            width,
            height,
        })
    }
}

/// First place and length of what is more than a line; of everything, if there are only lines.
fn extent(counts: &[u32]) -> Option<(u32, u32)> {
    let is_thick = counts.iter().any(|&count| count > LINE);
    let least = if is_thick { LINE + 1 } else { 1 };
    let first = counts.iter().position(|&count| count >= least)?;
    let last = counts.iter().rposition(|&count| count >= least)?;
    Some((first as u32, (last - first + 1) as u32))
}

/// A part in words: `about 3 %`.
pub fn about(percent: f64) -> String {
    match percent {
        percent if percent < 1.0 => "less than 1 %".to_owned(),
        percent => format!("about {:.0} %", percent.min(100.0)),
    }
}

impl Area {
    /// Whether it covers most of the area `figure`, in both directions.
    pub fn is_all_over(&self, figure: Area) -> bool {
        let covers = |length: u32, whole: u32| f64::from(length) >= ALL_OVER * f64::from(whole);
        covers(self.width, figure.width) && covers(self.height, figure.height)
    }

    /// Size of the area by that of `figure`.
    pub fn share_of(&self, figure: Area) -> f64 {
        let pixels = |area: &Area| f64::from(area.width) * f64::from(area.height);
        pixels(self) / pixels(&figure).max(1.0)
    }

    /// The same in words: `about 3 %`.
    pub fn part_of(&self, figure: Area) -> String {
        about(100.0 * self.share_of(figure))
    }

    /// Where the area lies in `figure`, the area round all that is drawn, in words: `at the top left
    /// of the figure, about 3 % of it`.
    pub fn place_in(&self, figure: Area) -> String {
        if self.is_all_over(figure) {
            return "all over the figure".to_owned();
        }
        let third = |start: u32, length: u32, from: u32, whole: u32| {
            let middle = f64::from(start) + f64::from(length) / 2.0 - f64::from(from);
            (3.0 * middle / f64::from(whole.max(1))).clamp(0.0, 2.0) as usize
        };
        let column = third(self.x, self.width, figure.x, figure.width);
        let row = third(self.y, self.height, figure.y, figure.height);
        let place = [
            ["at the top left", "at the top", "at the top right"],
            ["at the left", "in the middle", "at the right"],
            ["at the bottom left", "at the bottom", "at the bottom right"],
        ][row][column];
        format!("{place} of the figure, {} of it", self.part_of(figure))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Picture;

    const FIGURE: Area = Area {
        x: 100,
        y: 50,
        width: 200,
        height: 400,
    };

    #[test]
    fn places_are_told_as_they_are_seen() {
        let at = |x, y, width, height| {
            let area = Area {
                x,
                y,
                width,
                height,
            };
            area.place_in(FIGURE)
        };
        let told = [
            at(110, 60, 20, 80),
            at(190, 240, 20, 20),
            at(280, 430, 20, 20),
            at(105, 55, 190, 390),
            at(120, 60, 160, 40),
            at(0, 0, 10, 10),
        ];
        assert_eq!(
            told,
            [
                "at the top left of the figure, about 2 % of it",
                "in the middle of the figure, less than 1 % of it",
                "at the bottom right of the figure, less than 1 % of it",
                "all over the figure",
                "at the top of the figure, about 8 % of it",
                "at the top left of the figure, less than 1 % of it",
            ]
        );
    }

    #[test]
    fn the_figure_is_what_is_drawn_but_the_axes_that_reach_out_of_it() {
        let (width, height) = (80_u32, 60_u32);
        let picture = |axes: bool| {
            let drawn = |x: u32, y: u32| {
                let figure = (30..50).contains(&x) && (10..40).contains(&y);
                figure || axes && (x == 40 || y == 30)
            };
            let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            Picture {
                width,
                height,
                rgba: pixels
                    .flat_map(|(x, y)| {
                        if drawn(x, y) {
                            [200, 0, 0, 255]
                        } else {
                            [9; 4]
                        }
                    })
                    .collect(),
            }
        };
        let (plain, with_axes) = (picture(false), picture(true));
        let expected = Area {
            x: 30,
            y: 10,
            width: 20,
            height: 30,
        };
        for (a, b) in [
            (&plain, &plain),
            (&with_axes, &with_axes),
            (&plain, &with_axes),
        ] {
            let figure = Pair::new(a, b, &[]).unwrap().figure();
            assert_eq!(figure, Some(expected));
        }
    }
}
