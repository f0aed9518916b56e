//! A's outline elsewhere in B, in another size or turned, as another camera shows it.

use super::Finding;
use super::evidence::{Evidence, FEWEST_PIXELS, count};
use super::moments::Moments;
use crate::compare::{Area, PixelGrid};
use crate::steps::Pace;
use glam::DVec2;

/// Outlines agree if no more than this share of what is drawn does not.
const SAME: f64 = 0.03;
/// The same of a figure that is all that is drawn: one that another place showed from a slightly other side left 6 %.
const SAME_WHOLE: f64 = 0.08;
/// Where so much of each outline lies outside of the other, the figure stands elsewhere, however else
/// it differs.
const ELSEWHERE: f64 = 0.4;
/// A movement that makes the outlines agree leaves at most one in so many pixels of those that
/// differ without it.
const LEFT_ONE_IN: f64 = 4.0;
/// What such a movement may leave of the share that differs.
const ELSEWHERE_LEAVES: f64 = 0.75;
/// Pixels that agree only without the movement: one for so many that differ without it, or else
/// something stayed where it was.
const SPOILED_ONE_IN: f64 = 25.0;
/// Smallest change of size that is told.
const LEAST_SCALE: f64 = 0.02;
/// Smallest turn that is told, in radians.
const LEAST_TURN: f64 = 0.03;
/// Pixels that are looked at while a movement is sought.
const SAMPLES: f64 = 10_000.0;
/// Steps to either side of the middle of a figure in which its nearest place is sought, …
const STEPS: i32 = 6;
/// … of which so many go across it.
const STEPS_ACROSS: f64 = 160.0;
/// Steps of a search that does not come to an end before.
const MOST_STEPS: usize = 200;

/// A's outline found again in B. Told where it explains nearly all of the differences; also where
/// the figure stands quite elsewhere, with what differs even so.
pub(super) async fn placed(evidence: &Evidence<'_>) -> Option<Finding> {
    evidence.outline().await?;
    let outlines = Outlines::new(evidence).await?;
    let place = outlines.best_of(&outlines.starts()).await?;
    let before = outlines.misfit(outlines.still()).await;
    let after = outlines.misfit(place).await;
    let explains_all = after.share() <= SAME && after.explains_most_of(before);
    let is_elsewhere =
        outlines.stands_apart() && after.share() <= before.share() * ELSEWHERE_LEAVES;
    let spoils_little = after.spoiled * SPOILED_ONE_IN <= before.differing;
    let is_told = (explains_all || is_elsewhere) && spoils_little && outlines.are_in_view(after);
    let unexplained = if explains_all { 0.0 } else { after.share() };
    is_told.then(|| outlines.finding(place, unexplained))?
}

/// The same of a figure that is all that is drawn, so that no part of it stands still, with the middle of A's outline. What of it
/// differs even so may be more: from another place it is seen from another side.
pub(super) async fn whole_placed(evidence: &Evidence<'_>) -> Option<(DVec2, Finding)> {
    let outlines = Outlines::new(evidence).await?;
    let [upright, ..] = outlines.starts();
    let of_one_size = Place {
        factor: 1.0,
        ..upright
    };
    let starts = [upright, of_one_size, outlines.nearest().await];
    let place = outlines.best_of(&starts).await?;
    let before = outlines.misfit(outlines.still()).await;
    let after = outlines.misfit(place).await;
    let share = after.share();
    if share > SAME_WHOLE || !after.explains_most_of(before) || !outlines.are_in_view(after) {
        return None;
    }
    let unexplained = if share <= SAME { 0.0 } else { share };
    let finding = outlines.finding(place, unexplained)?;
    Some((outlines.moments[0].center, finding))
}

/// Where B has what A has around a center of its own.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// The place in B of A's center.
    center_b: DVec2,
    /// Size in B by size in A.
    factor: f64,
    /// Clockwise as it is seen, in radians.
    turn: f64,
}

/// How far the outlines differ with A in another place. All in pixels of B.
#[derive(Clone, Copy, Debug, Default)]
struct Misfit {
    /// Drawn in one alone.
    differing: f64,
    /// Those of them that agree where A is.
    spoiled: f64,
    /// Drawn in either.
    drawn: f64,
    /// Drawn in B, with a place in A's picture.
    seen: f64,
}

impl Misfit {
    fn share(self) -> f64 {
        self.differing / self.drawn.max(1.0)
    }

    /// Whether hardly anything is left of what differs `before`.
    fn explains_most_of(self, before: Self) -> bool {
        self.differing * LEFT_ONE_IN <= before.differing
    }
}

/// What is drawn without lines as thin as axes, which reach out of the figure; all of it if one of the
/// two has only lines.
async fn without_lines(grid: PixelGrid, drawn: &[Vec<bool>; 2], pace: &Pace) -> [Vec<bool>; 2] {
    let mut solid = [Vec::new(), Vec::new()];
    for (solid, drawn) in solid.iter_mut().zip(drawn) {
        let inside = grid.paced_shrunk(drawn, pace).await;
        *solid = grid.paced_grown(&inside, pace).await;
    }
    if solid.iter().any(|solid| count(solid) < FEWEST_PIXELS) {
        drawn.clone()
    } else {
        solid
    }
}

/// What is drawn in both pictures.
struct Outlines<'a> {
    pace: &'a Pace,
    width: usize,
    kept: &'a [bool],
    drawn: [Vec<bool>; 2],
    /// Where A is drawn in a pixel or one beside it, and where in all of these: lines are as exact
    /// as a pixel.
    about: [Vec<bool>; 2],
    moments: [Moments; 2],
    /// Part of B in which movements are sought, and the distance of the pixels looked at.
    sought: (Area, usize),
}

impl<'a> Outlines<'a> {
    async fn new(evidence: &'a Evidence<'_>) -> Option<Self> {
        let (pair, pace) = (evidence.pair(), evidence.pace);
        let grid = pair.grid();
        let drawn = without_lines(grid, evidence.drawn_masks().await?, pace).await;
        let width = pair.width() as usize;
        let a = Moments::of(&drawn[0], width, pace).await?;
        let b = Moments::of(&drawn[1], width, pace).await?;
        let about = [
            grid.paced_grown(&drawn[0], pace).await,
            grid.paced_shrunk(&drawn[0], pace).await,
        ];
        let area = evidence.area_of(&drawn[1])?;
        let (beside, above) = (area.width / 4 + 2, area.height / 4 + 2);
        let (x, y) = (area.x.saturating_sub(beside), area.y.saturating_sub(above));
        let region = Area {
            x,
            y,
            width: area.x + area.width + beside - x,
            height: area.y + area.height + above - y,
        };
        let region = region.clipped(pair.width(), pair.height())?;
        let pixels = f64::from(region.width) * f64::from(region.height);
        Some(Self {
            pace,
            width,
            kept: pair.kept(),
            drawn,
            about,
            moments: [a, b],
            sought: (region, (pixels / SAMPLES).sqrt().ceil().max(1.0) as usize),
        })
    }

    /// A where it is.
    fn still(&self) -> Place {
        Place {
            center_b: self.moments[0].center,
            factor: 1.0,
            turn: 0.0,
        }
    }

    /// What is told of A in a place in B, where so much of it differs even so; `None` if it is where it was.
    fn finding(&self, place: Place, unexplained: f64) -> Option<Finding> {
        let by = place.center_b - self.moments[0].center;
        let told = |value: f64, least: f64, size: f64| if size < least { 0.0 } else { value };
        let (dx, dy) = (by.x.round() as i32, by.y.round() as i32);
        let scale = (place.factor - 1.0).abs();
        let factor = 1.0 + told(place.factor - 1.0, LEAST_SCALE, scale);
        let degrees = told(place.turn.to_degrees(), LEAST_TURN, place.turn.abs());
        let is_nothing = (dx, dy) == (0, 0) && factor == 1.0 && degrees == 0.0;
        (!is_nothing).then_some(Finding::Placed {
            dx,
            dy,
            factor,
            degrees,
            unexplained,
        })
    }

    /// Whether half of B at least has a place in A's picture.
    fn are_in_view(&self, misfit: Misfit) -> bool {
        2.0 * misfit.seen >= self.moments[1].count
    }

    /// The best place that is found from some.
    async fn best_of(&self, starts: &[Place]) -> Option<Place> {
        let mut found = Vec::new();
        for start in starts {
            found.push(self.refined(*start).await);
        }
        let best = found.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        best.map(|(_, place)| place)
    }

    /// The best movement by steps that are a part of the figure's size, around where the middles agree.
    async fn nearest(&self) -> Place {
        let (region, _) = self.sought;
        let step = f64::from(region.width.max(region.height)) / STEPS_ACROSS;
        let mut best = (f64::INFINITY, self.still());
        for (x, y) in (-STEPS..=STEPS).flat_map(|y| (-STEPS..=STEPS).map(move |x| (x, y))) {
            let place = Place {
                center_b: self.moments[1].center + step * DVec2::new(x.into(), y.into()),
                ..self.still()
            };
            let cost = self.cost(place).await;
            if cost < best.0 {
                best = (cost, place);
            }
        }
        best.1
    }

    /// Whether much of what either shows is where the other shows nothing. What was only added to A
    /// leaves it where it was.
    fn stands_apart(&self) -> bool {
        let [a, b] = &self.drawn;
        let both = a.iter().zip(b).filter(|(a, b)| **a && **b).count() as f64;
        let mut counts = self.moments.iter().map(|moments| moments.count);
        counts.all(|count| count - both >= ELSEWHERE * count)
    }

    /// Where the middles, numbers of pixels and, in all but one, the long sides of both agree.
    fn starts(&self) -> [Place; 3] {
        let [a, b] = self.moments;
        let upright = Place {
            center_b: b.center,
            factor: (b.count / a.count).sqrt(),
            turn: 0.0,
        };
        // The long side points both ways.
        let turn = b.direction - a.direction;
        let other = if turn > 0.0 { -1.0 } else { 1.0 };
        let turned = [turn, turn + other * std::f64::consts::PI];
        let [one, opposite] = turned.map(|turn| Place { turn, ..upright });
        [upright, one, opposite]
    }

    /// The nearest place from which no small step is better, with the share that differs there.
    async fn refined(&self, start: Place) -> (f64, Place) {
        let (region, _) = self.sought;
        let size = f64::from(region.width.max(region.height));
        let (mut best, mut least) = (start, self.cost(start).await);
        let mut step = 1.0 / 16.0;
        for _ in 0..MOST_STEPS {
            if step * size < 0.2 {
                break;
            }
            let by = step * size;
            let moved = [DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y].map(|to| Place {
                center_b: best.center_b + by * to,
                ..best
            });
            let scaled = [step, -step].map(|by| Place {
                factor: best.factor * by.exp(),
                ..best
            });
            let turned = [step, -step].map(|by| Place {
                turn: best.turn + by,
                ..best
            });
            let tried = moved.into_iter().chain(scaled).chain(turned);
            let mut costs = Vec::new();
            for place in tried {
                costs.push((self.cost(place).await, place));
            }
            match costs.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some((cost, place)) if cost < least => (best, least) = (place, cost),
                _ => step /= 2.0,
            }
        }
        (least, best)
    }

    /// Share that differs, by some of the pixels.
    async fn cost(&self, place: Place) -> f64 {
        let (region, step) = self.sought;
        let (mut differing, mut drawn) = (0_u32, 0_u32);
        let from = Source::new(self, place);
        for y in (region.y..region.y + region.height).step_by(step) {
            for x in (region.x..region.x + region.width).step_by(step) {
                let (Some(in_a), in_b) = (from.index(x, y), y as usize * self.width + x as usize)
                else {
                    continue;
                };
                let (a, b) = (self.drawn[0][in_a], self.drawn[1][in_b]);
                drawn += u32::from(a | b);
                differing += u32::from(a != b);
            }
        }
        self.pace.after(SAMPLES as usize).await;
        if drawn == 0 {
            return 1.0;
        }
        f64::from(differing) / f64::from(drawn)
    }

    /// What differs by more than a pixel, by all pixels.
    async fn misfit(&self, place: Place) -> Misfit {
        let mut misfit = Misfit::default();
        let from = Source::new(self, place);
        let (width, height) = (self.width as u32, (self.kept.len() / self.width) as u32);
        for y in 0..height {
            for x in 0..width {
                let in_b = y as usize * self.width + x as usize;
                let b = self.drawn[1][in_b];
                let Some(in_a) = from.index(x, y).filter(|_| self.kept[in_b]) else {
                    continue;
                };
                if !b && !self.about[0][in_a] {
                    continue;
                }
                let differs = if b {
                    !self.about[0][in_a]
                } else {
                    self.about[1][in_a]
                };
                let agrees_still = self.drawn[0][in_b] == b;
                misfit.drawn += f64::from(b || self.drawn[0][in_a]);
                misfit.seen += f64::from(b);
                misfit.differing += f64::from(differs);
                misfit.spoiled += f64::from(differs && agrees_still);
            }
            self.pace.after(self.width).await;
        }
        misfit
    }
}

/// The places in A that pixels of B show.
struct Source<'a> {
    outlines: &'a Outlines<'a>,
    place: Place,
    /// A step along x in B, as one in A.
    along: DVec2,
}

impl<'a> Source<'a> {
    fn new(outlines: &'a Outlines, place: Place) -> Self {
        Self {
            outlines,
            place,
            along: DVec2::from_angle(-place.turn) / place.factor,
        }
    }

    /// Index in A of the pixel that column and row of B show; `None` outside of the picture, and
    /// where A is left out.
    fn index(&self, x: u32, y: u32) -> Option<usize> {
        let off = DVec2::new(f64::from(x), f64::from(y)) - self.place.center_b;
        let at = (self.outlines.moments[0].center + self.along.rotate(off)).round();
        let (width, kept) = (self.outlines.width, self.outlines.kept);
        let is_beside = at.x < 0.0 || at.y < 0.0 || at.x >= width as f64;
        if is_beside {
            return None;
        }
        let index = at.y as usize * width + at.x as usize;
        kept.get(index)?.then_some(index)
    }
}
