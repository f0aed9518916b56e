//! Numbers of a comparison in words.

/// Digits of a length in words, beginning with the first that is not zero.
const DIGITS: usize = 3;

/// A number rounded to so many digits, beginning with the first that is not zero.
fn to_digits(of: f64, digits: usize) -> f64 {
    format!("{of:.*e}", digits - 1).parse().unwrap_or(of)
}

/// A length in words, as people write numbers; tiny and huge ones in a power of ten.
pub(super) fn length(of: f64) -> String {
    if !of.is_finite() {
        return "infinite".to_owned();
    }
    if of == 0.0 {
        return "0".to_owned();
    }
    // What rounds up to the next power of ten has its digits.
    let rounded = to_digits(of, DIGITS);
    let power = rounded.abs().log10().floor() as i32;
    if !(-5..6).contains(&power) {
        return format!("{rounded:e}");
    }
    rounded.to_string()
}

/// Coordinates up to this round to nothing in words.
const NOTHING: f64 = 5e-7;

/// Whether a movement is any in words.
pub(super) fn is_told(movement: [f64; 3]) -> bool {
    movement.iter().any(|along| along.abs() > NOTHING)
}

/// A place or a movement in words. What rounds to nothing has no sign.
pub(super) fn vector(of: [f64; 3]) -> String {
    let [x, y, z] = of.map(|value| if value.abs() <= NOTHING { 0.0 } else { value });
    format!("({x:.6}, {y:.6}, {z:.6})")
}

/// Digits of a factor in words: as many as single precision keeps through sums.
const DIGITS_OF_FACTOR: usize = 6;

/// A factor in words.
pub(super) fn factor_in_words(factor: f64) -> String {
    to_digits(factor, DIGITS_OF_FACTOR).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_written_as_people_do() {
        for (of, expected) in [
            (0.7335992, "0.734"),
            (0.0, "0"),
            (12.0, "12"),
            (0.99996, "1"),
            (1234.5, "1230"),
            (0.00001, "0.00001"),
            (0.000_012_345, "0.0000123"),
            (1.2345e-7, "1.23e-7"),
            (9.876e9, "9.88e9"),
            (f64::INFINITY, "infinite"),
        ] {
            assert_eq!(length(of), expected);
        }
    }

    #[test]
    fn a_factor_is_told_without_what_rounding_leaves_of_it() {
        for (of, expected) in [(99.999998, "100"), (1.5, "1.5"), (0.123_456_7, "0.123457")] {
            assert_eq!(factor_in_words(of), expected);
        }
    }
}
