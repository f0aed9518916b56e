//! Straight lines among the pixels of a picture, as far as they are seen.

use super::evidence::{FEWEST_PIXELS, count};
use crate::compare::pair::Pair;
use crate::steps::Pace;
use glam::{IVec2, Vec2};
use std::ops::Range;

/// How far from the middle of a line its pixels are, at most.
const HALF_WIDTH: i32 = 2;
/// Fewest pixels along a line that go on without a gap, and fewest of all of them: others are chance.
const LEAST_RUN: usize = 8;
pub(super) const LEAST_LENGTH: usize = 16;
/// Part of the length of an axis, from the first of its pixels to the last, that is seen: a figure may hide half of it, and
/// of what lies in a line by chance a quarter is seen.
const WHOLE: f32 = 0.4;
/// Most pixels that an axis may have, by the width and height of the picture: more are no thin line.
pub(super) const MOST_OF_SIDES: u64 = 4;
/// Sine of the angle at which two of the axes cross in a picture, at least.
const LEAST_SINE: f32 = 0.2;
/// Number of places from which and through which a line is tried.
const STARTS: usize = 16;
const ENDS: usize = 48;

/// Where the lines of axes end.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    /// At sides of the picture.
    AtSides,
    /// Anywhere: a figure around them hides the rest.
    Anywhere,
}

/// A straight line through a picture, by whole steps along the side that it goes along more.
#[derive(Clone, Copy)]
pub(super) struct Line {
    from: [i32; 2],
    to: [i32; 2],
    /// The side that it goes along more: 0 for columns, 1 for rows.
    along: usize,
}

impl Line {
    fn through(from: [i32; 2], to: [i32; 2]) -> Self {
        let by = [to[0] - from[0], to[1] - from[1]].map(i32::abs);
        let along = usize::from(by[1] > by[0]);
        Self { from, to, along }
    }

    /// The pixel `across` beside the line where it is at `at` along it.
    fn pixel(self, at: i32, across: i32) -> [i32; 2] {
        let (from, to, side) = (self.from, self.to, 1 - self.along);
        let part = (at - from[self.along]) as f32 / (to[self.along] - from[self.along]) as f32;
        let rise = part * (to[side] - from[side]) as f32;
        let mut pixel = [at; 2];
        pixel[side] = from[side] + rise.round() as i32 + across;
        pixel
    }
}

/// A line as far as it is seen.
pub(super) struct Seen {
    line: Line,
    /// From where to where along it.
    range: Range<i32>,
}

impl Seen {
    /// The ends.
    fn ends(&self) -> [Vec2; 2] {
        let pixel = |at: i32| {
            let [x, y] = self.line.pixel(at, 0);
            IVec2::new(x, y).as_vec2()
        };
        [pixel(self.range.start), pixel(self.range.end)]
    }

    /// Whether both, as far as they go on in a picture of this size, cross in it, as axes do at the origin: edges of one
    /// thing run beside each other.
    pub(super) fn crosses(&self, other: &Self, size: Vec2) -> bool {
        let [a, b] = self.ends();
        let at = self.crossing(other).map(|part| a + (b - a) * part);
        at.is_some_and(|at| at.cmpge(Vec2::ZERO).all() && at.cmple(size).all())
    }

    /// Whether both cross where they are seen.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let [own, others] = [self.crossing(other), other.crossing(self)];
        let is_between = |part: Option<f32>| part.is_some_and(|part| (0.0..=1.0).contains(&part));
        is_between(own) && is_between(others)
    }

    /// Where it crosses the line of the other, as a part of it: 0 at its first end, 1 at its last; `None` if they run beside
    /// each other.
    fn crossing(&self, other: &Self) -> Option<f32> {
        let ([a, b], [c, d]) = (self.ends(), other.ends());
        let (own, others) = (b - a, d - c);
        let across = own.perp_dot(others);
        let sine = across.abs() / (own.length() * others.length());
        (sine > LEAST_SINE).then(|| (c - a).perp_dot(others) / across)
    }
}

/// Pixels of one color that differ.
pub(super) struct Mask {
    size: [i32; 2],
    inside: Vec<bool>,
}

impl Mask {
    /// Those of a picture as wide and high as `pair` that are `inside`.
    pub(super) fn new(pair: &Pair, inside: Vec<bool>) -> Self {
        Self {
            size: [pair.width() as i32, pair.height() as i32],
            inside,
        }
    }

    fn index(&self, [x, y]: [i32; 2]) -> Option<usize> {
        let is_in = (0..self.size[0]).contains(&x) && (0..self.size[1]).contains(&y);
        is_in.then(|| y as usize * self.size[0] as usize + x as usize)
    }

    fn has(&self, pixel: [i32; 2]) -> bool {
        self.index(pixel).is_some_and(|index| self.inside[index])
    }

    fn pixels(&self) -> impl Iterator<Item = [i32; 2]> + '_ {
        let width = self.size[0] as usize;
        let inside = self
            .inside
            .iter()
            .enumerate()
            .filter(|(_, inside)| **inside);
        inside.map(move |(index, _)| [(index % width) as i32, (index / width) as i32])
    }

    /// The pixels that have none of the others near them on two opposite sides.
    pub(super) fn thin(&self) -> Self {
        const BESIDE: i32 = HALF_WIDTH + 1;
        let mut inside = vec![false; self.inside.len()];
        for [x, y] in self.pixels() {
            let is_free = |by: [i32; 2]| {
                !self.has([x - by[0], y - by[1]]) && !self.has([x + by[0], y + by[1]])
            };
            if (is_free([BESIDE, 0]) || is_free([0, BESIDE]))
                && let Some(index) = self.index([x, y])
            {
                inside[index] = true;
            }
        }
        Self { inside, ..*self }
    }

    /// The line with the most of the pixels, of those that begin there; `None` without any that is
    /// long enough.
    pub(super) async fn longest_line(&self, ends: Ends, pace: &Pace) -> Option<Line> {
        let most = MOST_OF_SIDES * (self.size[0] + self.size[1]) as u64;
        if !(FEWEST_PIXELS..=most).contains(&count(&self.inside)) {
            return None;
        }
        let is_at_border = |pixel: &[i32; 2]| {
            let sides = pixel.iter().zip(self.size);
            sides
                .into_iter()
                .any(|(&at, size)| at == 0 || at + 1 == size)
        };
        let starts = self.pixels().filter(|pixel| match ends {
            Ends::AtSides => is_at_border(pixel),
            Ends::Anywhere => true,
        });
        let starts = some_of(starts.collect(), STARTS);
        let ends = some_of(self.pixels().collect(), ENDS);
        let mut longest: Option<(usize, Line)> = None;
        for from in starts {
            for &to in &ends {
                let line = Line::through(from, to);
                if (to[line.along] - from[line.along]).unsigned_abs() as usize >= LEAST_LENGTH {
                    let runs = || self.runs(line).flatten();
                    let own = runs().map(|at| self.across(line, at).count()).sum();
                    let is_long = runs().count() >= LEAST_LENGTH;
                    if is_long && longest.is_none_or(|(known, _)| known < own) {
                        longest = Some((own, line));
                    }
                    pace.after(self.size[line.along] as usize).await;
                }
            }
        }
        longest.map(|(_, line)| line)
    }

    /// Its pixels in and beside a line where that is at `at`.
    fn across(&self, line: Line, at: i32) -> impl Iterator<Item = [i32; 2]> + '_ {
        let across = (-1..=1).map(move |across| line.pixel(at, across));
        across.filter(|pixel| self.has(*pixel))
    }

    /// Where along a line its pixels go on without a gap.
    pub(super) fn runs(&self, line: Line) -> impl Iterator<Item = Range<i32>> + '_ {
        let end = self.size[line.along];
        let is_on = move |at: i32| self.across(line, at).next().is_some();
        let mut at = 0;
        let runs = std::iter::from_fn(move || {
            let first = (at..end).find(|&at| is_on(at))?;
            at = (first..end).find(|&at| !is_on(at)).unwrap_or(end);
            Some(first..at)
        });
        runs.filter(|run| run.len() >= LEAST_RUN)
    }

    /// From the first pixel of a line to the last.
    fn range(&self, line: Line) -> Range<i32> {
        let (mut first, mut end) = (self.size[line.along], 0);
        for run in self.runs(line) {
            (first, end) = (first.min(run.start), end.max(run.end));
        }
        first..end
    }

    /// Whether a line has few gaps, and leaves the picture: it ends at a side, and does not run along it.
    pub(super) fn is_axis(&self, line: Line) -> bool {
        let sides = self.sides_of_ends(line);
        let leaves = sides[0].iter().zip(sides[1]).any(|(a, b)| *a != b);
        leaves && self.has_few_gaps(line)
    }

    /// Whether a line goes from side to side, however much of it is hidden.
    pub(super) fn spans(&self, line: Line) -> bool {
        let sides = self.sides_of_ends(line);
        sides[0] != sides[1] && sides.iter().all(|at| at.contains(&true))
    }

    /// The sides of the picture that the first and the last pixel of a line are at.
    fn sides_of_ends(&self, line: Line) -> [[bool; 4]; 2] {
        let range = self.range(line);
        [range.start, range.end - 1].map(|at| self.sides_at(line.pixel(at, 0)))
    }

    pub(super) fn has_few_gaps(&self, line: Line) -> bool {
        let seen = self.runs(line).flatten().count();
        seen as f32 >= WHOLE * self.range(line).len() as f32
    }

    /// Which sides of the picture a pixel is at.
    fn sides_at(&self, [x, y]: [i32; 2]) -> [bool; 4] {
        let [width, height] = self.size;
        [x, y, width - 1 - x, height - 1 - y].map(|away| away <= HALF_WIDTH)
    }

    /// Marks the pixels of an axis along `line` that differ. Returns how far it is seen.
    pub(super) fn cover(&self, line: Line, other_colors: &[bool], covered: &mut [bool]) -> Seen {
        let range = self.range(line);
        // Where axes cross, a pixel has the colors of both.
        for at in range.clone() {
            for across in -HALF_WIDTH..=HALF_WIDTH {
                if let Some(index) = self.index(line.pixel(at, across)) {
                    covered[index] |= other_colors[index];
                }
            }
        }
        Seen { line, range }
    }
}

/// At most `count` of `all`, evenly.
fn some_of(all: Vec<[i32; 2]>, count: usize) -> Vec<[i32; 2]> {
    let step = all.len().div_ceil(count).max(1);
    all.into_iter().step_by(step).collect()
}
