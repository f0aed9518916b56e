//! How exactly the numbers of a mesh were written, and how far vertices may be off for that.

use super::placed::Limits;
use super::skin::{CutOff, Placed};
use super::{MOST_TOLERANCE, SINGLE_PRECISION, TOLERANCE};
use glam::{DVec3, Vec3};
use serde::Serialize;

/// Digits that any number of single precision can be told by.
const MOST_DIGITS: usize = 9;
/// Part of half a unit up to which a number counts as rounded: halves are not exact in binary.
const ROOM: f64 = 1.01;
/// Unit of the last digit, by the largest number, up to which there are digits enough, as where C++ writes numbers: of a mesh
/// that is much too large they are coarse by that alone.
const ENOUGH: f64 = 1e-5;
/// Fewest vertices whose numbers tell by how few digits they have that they are rounded.
const FEWEST_ROUNDED: usize = 12;
/// The coarsest rounding, by the size, after which mistakes can still be told from one another.
const MOST_ROUNDING: f64 = 0.02;
/// The coarsest one after which a mesh can still be told to be right. It may be coarser: where hardly a vertex may move
/// without one of its numbers becoming another, only the exact result has all of them.
const MOST_ROUNDING_OF_RIGHT: f64 = 0.1;

/// Coordinates beyond so many times the largest exact one are none of a mesh, in whatever unit it is.
const BEYOND_ANY: f32 = 1e4;
/// Coordinates beyond so many times the middle one are not those that rounding is told by.
const BEYOND_MOST: f32 = 100.0;

/// How the numbers of a mesh were written, as far as they show it. Single vertices that are far outside of all others, as
/// what was never set is, say nothing about the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Written {
    /// The largest coordinate, but for those vertices.
    pub(super) largest: f64,
    /// Half a unit of its last digit: what rounding to the digits that were written moves a coordinate at most.
    pub(super) half_step: f64,
    /// Whether there are such vertices.
    pub(super) has_outliers: bool,
}

impl Written {
    /// How the vertices `theirs` of a mesh were written that should be at `exact`.
    pub(super) fn of(theirs: &[Vec3], exact: impl Iterator<Item = Vec3>) -> Self {
        let most = |point: &Vec3| point.abs().max_element();
        let largest_exact = exact.map(|point| most(&point)).fold(0.0, f32::max);
        let beyond_any = match largest_exact {
            0.0 => f32::INFINITY,
            largest => BEYOND_ANY * largest,
        };
        let finite = theirs.iter().filter(|point| point.is_finite()).map(most);
        let mut inside: Vec<f32> = finite
            .filter(|most| *most > 0.0 && *most <= beyond_any)
            .collect();
        let middle = inside.len() / 2;
        let reach = match inside.get(middle) {
            Some(_) => BEYOND_MOST * *inside.select_nth_unstable_by(middle, f32::total_cmp).1,
            None => 0.0,
        };
        let told = inside.into_iter().filter(|most| *most <= reach);
        let largest = told.fold(0.0, f32::max);
        let is_outlier = |point: &&Vec3| most(point) > largest;
        let others = theirs.iter().filter(|point| !is_outlier(point));
        Self {
            largest: f64::from(largest),
            half_step: half_step(others),
            has_outliers: theirs.iter().any(|point| is_outlier(&point)),
        }
    }

    /// How far vertices may be from where the mesh is moved or scaled to as a whole, before that in a mesh of this size.
    pub(super) fn limits(&self, size: f64) -> Limits {
        Limits {
            tolerance: self.tolerance(size),
            rounding: of_vertices(self.half_step),
            most: MOST_TOLERANCE * size,
        }
    }

    /// How the numbers of a mesh of this `size` may be cut off instead of rounded; nothing where that would show nothing, or
    /// no more than rounding does.
    pub(super) fn cut_off(&self, count: usize, size: f64) -> Option<[CutOff; 2]> {
        let half_step = self.half_step;
        let is_more = 2.0 * of_vertices(half_step) > self.tolerance(size);
        let is_told = is_more && tells_right(half_step, size) && count >= FEWEST_ROUNDED;
        is_told.then(|| [false, true].map(|is_down| CutOff { is_down, half_step }))
    }

    /// How far vertices may be apart and agree in a mesh of this size.
    pub(super) fn tolerance(&self, size: f64) -> f64 {
        let rounding = of_vertices(self.half_step);
        let by_size = rounding.clamp(TOLERANCE * size, MOST_TOLERANCE * size);
        by_size.max(SINGLE_PRECISION * self.largest)
    }
}

/// Half a unit of the last digit of the largest coordinate, as far as the numbers show. One that is a power of ten, as what
/// lies just below is rounded to, shows no digit.
fn half_step<'a>(points: impl Iterator<Item = &'a Vec3>) -> f64 {
    let (mut most_digits, mut most_decimals) = (0, 0);
    let (mut exponent, mut of_others) = (i32::MIN, i32::MIN);
    for coordinate in points.flat_map(|point| point.to_array()) {
        if coordinate == 0.0 || !coordinate.is_finite() {
            continue;
        }
        let (digits, own) = digits(coordinate);
        most_digits = most_digits.max(digits);
        most_decimals = most_decimals.max(digits as i32 - 1 - own);
        exponent = exponent.max(own);
        let is_power = digits == 1 && f64::from(coordinate.abs()) * 10_f64.powi(-own) < 1.5;
        if !is_power {
            of_others = of_others.max(own);
        }
    }
    if (most_digits, most_decimals) == (1, 1) {
        // With one digit after the point, numbers from one on may look as if they had none.
        return 0.05;
    }
    if most_digits == 0 || most_digits >= MOST_DIGITS {
        return 0.0;
    }
    let exponent = match of_others {
        i32::MIN => exponent,
        of_others => of_others,
    };
    0.5 * 10_f64.powi(exponent + 1 - most_digits as i32)
}

/// How far numbers that rounding moves by `half_step` at most move a vertex, with some room.
pub(super) fn of_vertices(half_step: f64) -> f64 {
    half_step * 3_f64.sqrt() * ROOM
}

/// How far coordinates may be apart and agree in a mesh of this `size` that rounding by `half_step` is too coarse for.
pub(super) fn coarse_limit(half_step: f64, size: f64) -> f64 {
    ROOM * half_step + SINGLE_PRECISION * size
}

/// Whether a mesh of this `size` that is so rounded tells mistakes apart.
pub(super) fn tells_mistakes(half_step: f64, size: f64) -> bool {
    of_vertices(half_step) <= MOST_ROUNDING * size
}

/// Whether it tells that it is right.
fn tells_right(half_step: f64, size: f64) -> bool {
    of_vertices(half_step) <= MOST_ROUNDING_OF_RIGHT * size
}

/// Numbers with too few digits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Coarse {
    /// One unit of the last digit, in model space.
    pub rounded_to: f64,
    /// Whether the digits after it are cut off instead of rounded.
    pub is_cut_off: bool,
    /// Whether the exact result, so rounded, gives the mesh.
    pub may_be_right: bool,
    /// Digits after the point that would be enough.
    pub enough_digits: usize,
}

impl Coarse {
    /// How the numbers of `theirs` are rounded, which moves them by `half_step` at most, if that is too coarse to tell
    /// mistakes apart in a mesh of this `size`.
    pub(super) fn find(
        exact: &[Placed],
        theirs: &[Vec3],
        written: &Written,
        size: f64,
    ) -> Option<Self> {
        let half_step = written.half_step;
        let (rounding, rounded_to) = (of_vertices(half_step), 2.0 * half_step);
        let is_rounded = |place: DVec3| {
            let rounded = (place / rounded_to).round() * rounded_to;
            place.distance(rounded) <= TOLERANCE * size
        };
        // Few numbers are short by chance, and nothing is lost where the right ones have no more digits either.
        let is_coarse = theirs.len() >= FEWEST_ROUNDED
            && rounded_to > ENOUGH * written.largest
            && rounding > MOST_TOLERANCE * size
            && !exact.iter().all(|placed| is_rounded(placed.at));
        let is_so_rounded = |most: f64| {
            let mut pairs = exact.iter().zip(theirs);
            pairs.all(|(exact, theirs)| (exact.at - theirs.as_dvec3()).abs().max_element() <= most)
        };
        is_coarse.then(|| {
            let limit = coarse_limit(half_step, size);
            let may_be_right = tells_right(half_step, size) && is_so_rounded(limit);
            Self::new(half_step, size, may_be_right)
        })
    }

    /// How the numbers of a mesh of this `size` are cut off, which is the exact one if that `may_be_right`.
    pub(super) fn of_cut_off(cut_off: CutOff, size: f64, may_be_right: bool) -> Self {
        Self {
            is_cut_off: true,
            ..Self::new(cut_off.half_step, size, may_be_right)
        }
    }

    fn new(half_step: f64, size: f64, may_be_right: bool) -> Self {
        Self {
            rounded_to: 2.0 * half_step,
            is_cut_off: false,
            may_be_right,
            enough_digits: (-(TOLERANCE * size).log10()).ceil().max(1.0) as usize,
        }
    }
}

/// Number of digits of the shortest decimal that reads back to `number`, and the exponent of the
/// first.
fn digits(number: f32) -> (usize, i32) {
    let text = format!("{:e}", number.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    (digits, exponent.parse().unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_is_that_of_the_last_digit_of_the_largest_number() {
        for (points, expected) in [
            (
                vec![Vec3::new(1.2346, 0.0, -0.5), Vec3::new(0.3, 11.25, 7.0003)],
                0.5e-3,
            ),
            (vec![Vec3::new(1.2346, 0.0012, -0.5)], 0.5e-4),
            (vec![Vec3::new(180.1, 20.05, 3.0)], 0.5e-1),
            (vec![Vec3::new(1.0, 0.9, -0.3)], 0.5e-1),
            (vec![Vec3::new(1.0, 0.97, -0.31)], 0.5e-2),
            (vec![Vec3::new(1.1, 0.97, -0.31)], 0.5e-1),
            (vec![Vec3::new(100.0, 10.0, -1.0)], 0.5e2),
            (vec![Vec3::ZERO], 0.0),
            (vec![Vec3::splat(1.0 / 3.0), Vec3::splat(0.1 + 0.2)], 0.5e-9),
        ] {
            let found = half_step(points.iter());
            let is_near = (found - expected).abs() <= 1e-6 * expected;
            assert!(
                is_near || found < 1e-8 && expected < 1e-8,
                "{points:?}: {found}"
            );
        }
    }
}
