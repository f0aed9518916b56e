//! How exactly the numbers of a mesh were written.

use glam::Vec3;

/// Digits that any number of single precision can be told by.
const MOST_DIGITS: usize = 9;

/// Half a unit of the last digit of the largest coordinate, as far as the numbers show: what
/// rounding to the digits that were written moves a coordinate at most.
pub(super) fn half_step(points: &[Vec3]) -> f64 {
    let mut most_digits = 0;
    let mut exponent = i32::MIN;
    for coordinate in points.iter().flat_map(|point| point.to_array()) {
        if coordinate == 0.0 || !coordinate.is_finite() {
            continue;
        }
        let (digits, own) = digits(coordinate);
        most_digits = most_digits.max(digits);
        exponent = exponent.max(own);
    }
    if most_digits == 0 || most_digits >= MOST_DIGITS {
        return 0.0;
    }
    0.5 * 10_f64.powi(exponent + 1 - most_digits as i32)
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
            (vec![Vec3::ZERO], 0.0),
            (vec![Vec3::splat(1.0 / 3.0), Vec3::splat(0.1 + 0.2)], 0.5e-9),
        ] {
            let found = half_step(&points);
            let is_near = (found - expected).abs() <= 1e-6 * expected;
            assert!(
                is_near || found < 1e-8 && expected < 1e-8,
                "{points:?}: {found}"
            );
        }
    }
}
