use super::Finding;
use super::evidence::{FEWEST_PIXELS, OTHER_COLOR, UNEXPLAINED_ONE_IN};
use crate::compare::differences::difference;
use crate::compare::{Area, Pair};

/// Every movement up to so many pixels is tried; farther ones where the outlines suggest it.
const FARTHEST: i32 = 8;
/// A movement may spoil, of the pixels that agree without it, one for so many it explains: more
/// would be things that stayed where they were.
const SPOILED_ONE_IN: u64 = 100;
/// Outlines of another size agree if they differ in no more than this share of their pixels.
const OUTLINE_SLACK: f64 = 0.02;

impl Pair<'_> {
    /// Whether B is A moved or mirrored.
    pub(super) fn motion(&self) -> Option<Finding> {
        let direct = self.pixels_of_other_color();
        if direct < FEWEST_PIXELS {
            return None;
        }
        self.mirrored(direct).or_else(|| self.shifted(direct))
    }

    fn mirrored(&self, direct: u64) -> Option<Finding> {
        let [right, bottom] = [self.width() - 1, self.height() - 1];
        [(true, false), (false, true), (true, true)]
            .into_iter()
            .filter_map(|(left_right, top_bottom)| {
                let place_in_a = |x: u32, y: u32| {
                    let x = if left_right { right - x } else { x };
                    let y = if top_bottom { bottom - y } else { y };
                    Some((x, y))
                };
                let unexplained = self.unexplained_by(self.whole(), direct, place_in_a)?;
                let finding = Finding::Mirrored {
                    left_right,
                    top_bottom,
                };
                Some((unexplained, finding))
            })
            .min_by_key(|(unexplained, _)| *unexplained)
            .map(|(_, finding)| finding)
    }

    fn shifted(&self, direct: u64) -> Option<Finding> {
        let [drawn_a, drawn_b] = match self.drawn_masks() {
            Some([a, b]) => [self.area_of(&a)?, self.area_of(&b)?],
            None => [self.whole(); 2],
        };
        let nearby =
            (-FARTHEST..=FARTHEST).flat_map(|dy| (-FARTHEST..=FARTHEST).map(move |dx| (dx, dy)));
        let suggested = suggested_moves(drawn_a, drawn_b);
        let inside = united(drawn_a, drawn_b);
        nearby
            .chain(suggested)
            .filter(|&by| by != (0, 0) && self.keeps_half_in_view(drawn_a, by))
            .filter_map(|(dx, dy)| {
                let place_in_a =
                    |x: u32, y: u32| Some((x.checked_add_signed(-dx)?, y.checked_add_signed(-dy)?));
                let unexplained = self.unexplained_by(inside, direct, place_in_a)?;
                Some((unexplained, dx * dx + dy * dy, (dx, dy)))
            })
            .min()
            .map(|(_, _, (dx, dy))| Finding::Shifted { dx, dy })
    }

    /// Whether at least half of the area stays within the picture when moved.
    fn keeps_half_in_view(&self, area: Area, (dx, dy): (i32, i32)) -> bool {
        let left = |start: u32, length: u32, by: i32, size: u32| {
            let first = (i64::from(start) + i64::from(by)).max(0);
            let end = (i64::from(start) + i64::from(length) + i64::from(by)).min(size.into());
            2 * (end - first) >= i64::from(length)
        };
        left(area.x, area.width, dx, self.width()) && left(area.y, area.height, dy, self.height())
    }

    /// How many pixels of B within `inside` have another color than A at `place_in_a`; `None` if
    /// they are too many to explain `direct` pixels of another color so. Pixels without a place in A, or with an ignored one, are left
    /// out.
    fn unexplained_by(
        &self,
        inside: Area,
        direct: u64,
        place_in_a: impl Fn(u32, u32) -> Option<(u32, u32)>,
    ) -> Option<u64> {
        let (width, height) = (self.width(), self.height());
        let index = |x: u32, y: u32| y as usize * width as usize + x as usize;
        let (mut unexplained, mut spoiled) = (0, 0);
        for y in inside.y..inside.y + inside.height {
            for x in inside.x..inside.x + inside.width {
                let Some((from_x, from_y)) = place_in_a(x, y) else {
                    continue;
                };
                if from_x >= width || from_y >= height {
                    continue;
                }
                let (from, to) = (index(from_x, from_y), index(x, y));
                let counts = self.kept()[from] && self.kept()[to];
                if counts && difference(self.a()[from], self.b()[to]) > OTHER_COLOR {
                    unexplained += 1;
                    spoiled += u64::from(difference(self.a()[to], self.b()[to]) <= OTHER_COLOR);
                    if unexplained > direct / UNEXPLAINED_ONE_IN
                        || spoiled > direct / SPOILED_ONE_IN
                    {
                        return None;
                    }
                }
            }
        }
        Some(unexplained)
    }

    /// Whether B shows A's outline in another size.
    pub(super) fn scaled(&self) -> Option<Finding> {
        let [drawn_a, drawn_b] = self.drawn_masks()?;
        let [area_a, area_b] = [self.area_of(&drawn_a)?, self.area_of(&drawn_b)?];
        if self.touches_border(area_a) || self.touches_border(area_b) {
            return None;
        }
        let ratio = |b: u32, a: u32| f64::from(b) / f64::from(a);
        let factors = [
            ratio(area_b.width, area_a.width),
            ratio(area_b.height, area_a.height),
        ];
        let count = |mask: &[bool]| mask.iter().filter(|inside| **inside).count() as f64;
        // Steadier than the sides, which are off by up to a pixel each.
        let factor = (count(&drawn_b) / count(&drawn_a)).sqrt();
        let rounding = 2.0 / f64::from(area_a.width.min(area_a.height));
        if (factors[0] - factors[1]).abs() > 0.01 + rounding || (factor - 1.0).abs() < 0.02 {
            return None;
        }
        let width = self.width() as usize;
        let (mut differing, mut drawn) = (0_u32, 0_u32);
        for y in 0..area_b.height {
            for x in 0..area_b.width {
                let in_b = (area_b.y + y) as usize * width + (area_b.x + x) as usize;
                let scaled = |place: u32, factor: f64| ((f64::from(place) + 0.5) / factor) as u32;
                let from_x = area_a.x + scaled(x, factors[0]).min(area_a.width - 1);
                let from_y = area_a.y + scaled(y, factors[1]).min(area_a.height - 1);
                let in_a = from_y as usize * width + from_x as usize;
                drawn += u32::from(drawn_b[in_b]);
                differing += u32::from(drawn_b[in_b] != drawn_a[in_a]);
            }
        }
        (f64::from(differing) <= OUTLINE_SLACK * f64::from(drawn))
            .then_some(Finding::Scaled { factor })
    }

    fn touches_border(&self, area: Area) -> bool {
        area.x == 0
            || area.y == 0
            || area.x + area.width == self.width()
            || area.y + area.height == self.height()
    }

    fn whole(&self) -> Area {
        Area {
            x: 0,
            y: 0,
            width: self.width(),
            height: self.height(),
        }
    }
}

/// Movements that bring corners of the areas together.
fn suggested_moves(a: Area, b: Area) -> impl Iterator<Item = (i32, i32)> {
    let by = |a: u32, b: u32| b as i32 - a as i32;
    let across = [by(a.x, b.x), by(a.x + a.width, b.x + b.width)];
    let down = [by(a.y, b.y), by(a.y + a.height, b.y + b.height)];
    across
        .into_iter()
        .flat_map(move |dx| down.map(|dy| (dx, dy)))
}

/// The smallest area around both.
fn united(a: Area, b: Area) -> Area {
    let corners = [a, b].map(|area| {
        [
            (area.x, area.y),
            (area.x + area.width - 1, area.y + area.height - 1),
        ]
    });
    Area::around(corners.into_iter().flatten()).unwrap_or(a)
}
