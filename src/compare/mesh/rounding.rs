//! Meshes that differ by the digits of their numbers alone.

use super::MeshFinding;
use super::placement::Points;

/// Most digits after the point that rounding is told of: with more, single precision differs as much.
const MOST_DIGITS: i32 = 7;
/// Room for numbers that are not exact in binary: by the number itself, as single precision keeps them.
const PRECISION: f64 = 1.2e-7;
/// Room for halves, which programs that compute otherwise round to the other side: by the largest number, with the rounding
/// of a few sums and products in single precision.
const ROOM: f64 = 1e-6;
/// Fewest vertices that are all as short as that by no chance.
const FEWEST: usize = 12;

/// The coarsest rounding to digits after the point that gives every vertex of B from that of A, if one does.
pub(super) fn rounded(points: &Points) -> Option<MeshFinding> {
    let pairs = || points.a.iter().zip(points.b);
    let are_finite = pairs().all(|(a, b)| a.is_finite() && b.is_finite());
    if points.b.len() < FEWEST || !are_finite {
        return None;
    }
    let numbers = points.a.iter().map(|a| a.abs().max_element());
    let room = ROOM * numbers.fold(0.0, f64::max);
    let gives = |step: f64| {
        pairs().all(|(a, b)| {
            let exact = PRECISION * b.abs();
            let is_round = (*b - (*b / step).round() * step).abs().cmple(exact);
            let is_near = (*a - *b).abs().cmple(exact + room + 0.5 * step);
            is_round.all() && is_near.all()
        })
    };
    let mut steps = (0..=MOST_DIGITS).map(|digits| 10_f64.powi(-digits));
    let to = steps.find(|step| gives(*step))?;
    Some(MeshFinding::Rounded { to })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn found(b: impl Fn(f64) -> f64) -> Option<MeshFinding> {
        let a: Vec<DVec3> = (0..40)
            .map(|index| DVec3::new(0.377, -0.0913, 1.207) * (f64::from(index) * 0.731).sin())
            .collect();
        let written = |at: &DVec3| at.to_array().map(|number| f64::from(b(number) as f32));
        let b: Vec<DVec3> = a.iter().map(|at| DVec3::from_array(written(at))).collect();
        let apart = a.iter().zip(&b).map(|(a, b)| a.distance(*b));
        let apart = apart.fold(0.0, f64::max);
        rounded(&Points {
            a: &a,
            b: &b,
            tolerance: 1e-5,
            apart,
        })
    }

    #[test]
    fn halves_that_a_program_in_double_precision_rounds_the_other_way_are_rounded_all_the_same() {
        let half = |number: f64| ((number * 1e4).floor() + 0.5) / 1e4;
        // What the one has just below the half, the other has just above.
        let a: Vec<DVec3> = (0..40)
            .map(|index| DVec3::splat(half(f64::from(index) * 0.0731) - 2e-7))
            .collect();
        let up = |at: &DVec3| (*at * 1e4).ceil() / 1e4;
        let b: Vec<DVec3> = a.iter().map(up).collect();
        let points = Points {
            a: &a,
            b: &b,
            tolerance: 1e-5,
            apart: 5.02e-5,
        };
        assert_eq!(rounded(&points), Some(MeshFinding::Rounded { to: 1e-4 }));
    }

    #[test]
    fn numbers_with_fewer_digits_are_told_with_the_unit_of_the_last_one() {
        for digits in [1, 2, 3, 4] {
            let unit = 10_f64.powi(digits);
            let to = unit.recip();
            let round = found(|number| (number * unit).round() / unit);
            assert_eq!(round, Some(MeshFinding::Rounded { to }));
            // Cut off, not rounded; and somewhere else.
            assert_eq!(found(|number| (number * unit).trunc() / unit), None);
            assert_eq!(found(|number| (number * unit).round() / unit + 1.0), None);
        }
    }
}
