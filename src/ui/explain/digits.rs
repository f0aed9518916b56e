//! How lengths of a character are written: characters are as small as a millimeter in meters, or as
//! large as a tower in millimeters.

use glam::DMat4;

/// Digits after the point of a weight.
const OF_WEIGHTS: usize = 3;

/// A weight, of which one that is not zero is never written as zero.
pub(super) fn weight(value: f64) -> String {
    let least = 10.0_f64.powi(-(OF_WEIGHTS as i32));
    if value != 0.0 && value.abs() < least / 2.0 {
        return match value < 0.0 {
            true => format!(">-{least}"),
            false => format!("<{least}"),
        };
    }
    number(value, OF_WEIGHTS)
}

/// Sizes that are written as they are, without a power of ten.
const PLAIN: std::ops::Range<f64> = 0.2..20_000.0;

/// How lengths are written, the same for all of a character, so that columns are aligned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Digits {
    /// Exponent of the power of ten that lengths are written in.
    power: i32,
    /// Digits after the point that are worth showing.
    decimals: usize,
}

impl Digits {
    /// Those of a character of this size, the diagonal of its box.
    pub(super) fn of_size(size: f64) -> Self {
        let is_plain = PLAIN.contains(&size) || size <= 0.0 || !size.is_finite();
        Self {
            power: if is_plain {
                0
            } else {
                size.log10().floor() as i32
            },
            decimals: match size {
                20.0..200.0 => 2,
                200.0..20_000.0 => 1,
                _ => 3,
            },
        }
    }

    /// A length without its power of ten.
    pub(super) fn length(self, value: f64) -> String {
        number(value / self.unit(), self.decimals)
    }

    /// The numbers of a transform by rows: what moves is a length, all else has no unit.
    pub(super) fn rows(self, matrix: &DMat4) -> Vec<[String; 4]> {
        let mut matrix = *matrix;
        let moves = matrix.w_axis.truncate() / self.unit();
        matrix.w_axis = moves.extend(matrix.w_axis.w);
        let rows = (0..4).map(|row| matrix.row(row).to_array());
        rows.map(|row| row.map(|value| number(value, self.decimals)))
            .collect()
    }

    /// In words which power of ten lengths are written in; `None` if they are written as they are.
    pub(super) fn note(self) -> Option<String> {
        (self.power != 0).then(|| format!("Coordinates × 1e{}", self.power))
    }

    fn unit(self) -> f64 {
        10.0_f64.powi(self.power)
    }
}

/// A number with so many digits after the point; never minus zero.
pub(super) fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| matches!(c, '0' | '.')) => digits.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_that_is_not_zero_is_not_written_as_zero() {
        let written = [0.25, 1.0, 0.0, 0.0004, -0.0001, 0.0006].map(weight);
        let expected = ["0.250", "1.000", "0.000", "<0.001", ">-0.001", "0.001"];
        assert_eq!(written, expected);
    }
    use glam::DVec3;

    #[test]
    fn lengths_have_three_digits_or_more_whatever_the_size() {
        for (size, length, expected, note) in [
            (1.8, -0.12345, "-0.123", None),
            (1.8, -0.0001, "0.000", None),
            (150.0, 75.125, "75.12", None),
            (1800.0, 1234.56, "1234.6", None),
            (0.0018, -0.00123456, "-1.235", Some("Coordinates × 1e-3")),
            (0.05, 0.0123, "1.230", Some("Coordinates × 1e-2")),
            (4.0e7, 1.5e7, "1.500", Some("Coordinates × 1e7")),
            (3.0e-14, 1.5e-14, "1.500", Some("Coordinates × 1e-14")),
            (0.0, 0.0, "0.000", None),
            (f64::INFINITY, 1.0, "1.000", None),
        ] {
            let digits = Digits::of_size(size);
            assert_eq!(digits.length(length), expected, "{size}");
            assert_eq!(digits.note().as_deref(), note, "{size}");
        }
    }

    #[test]
    fn of_a_matrix_only_what_moves_has_the_power_of_ten() {
        let moves = DMat4::from_translation(DVec3::new(0.001, 0.0, -0.0025));
        let rows = Digits::of_size(0.005).rows(&moves);
        assert_eq!(rows[0], ["1.000", "0.000", "0.000", "1.000"]);
        assert_eq!(rows[2], ["0.000", "0.000", "1.000", "-2.500"]);
        assert_eq!(rows[3], ["0.000", "0.000", "0.000", "1.000"]);
    }
}
