//! Angles in files: degrees in the text, radians in the program.

use super::json_text;
use crate::math::Euler;
use glam::Vec3;
use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, Error};
use std::f32::consts::PI;

/// Radians of a degree, rounded as panels and files have always had it.
const RADIANS: f32 = PI / 180.0;

/// Angle that a file has in degrees.
pub(super) trait Angle: Copy + DeserializeOwned {
    /// The angle of so many radians.
    fn from_radians(radians: f32) -> Self;
    /// The angle, radians.
    fn radians(self) -> f32;
}

/// Degrees with the precision of `f32`, as in pose files and version 1 of scenes: not every angle
/// can be written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Degrees(f32);

/// Degrees in which every angle can be written. A number that is the shortest for an `f32` means
/// that `f32`, so that 12.34 is the same angle as in the panel; others are taken as `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExactDegrees(f32);

impl Angle for Degrees {
    fn from_radians(radians: f32) -> Self {
        Self(radians)
    }

    fn radians(self) -> f32 {
        self.0
    }
}

impl Angle for ExactDegrees {
    fn from_radians(radians: f32) -> Self {
        Self(radians)
    }

    fn radians(self) -> f32 {
        self.0
    }
}

impl<'de> Deserialize<'de> for Degrees {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        f32::deserialize(deserializer).map(|degrees| Self(degrees * RADIANS))
    }
}

impl<'de> Deserialize<'de> for ExactDegrees {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let radians = exact_radians(f64::deserialize(deserializer)?);
        if radians.is_finite() {
            Ok(Self(radians))
        } else {
            let message = "expected an angle below 3.4e38 radians, found a larger one";
            Err(D::Error::custom(message))
        }
    }
}

/// Radians of `degrees`, read by the rule of [`ExactDegrees`].
fn exact_radians(degrees: f64) -> f32 {
    let single = degrees as f32;
    let is_shortest = single.to_string().parse() == Ok(degrees);
    let degrees = if is_shortest { single.into() } else { degrees };
    // Of an `f32` the product is exact, and rounded once as in `Euler::from_degrees`.
    (degrees * f64::from(RADIANS)) as f32
}

/// The number of degrees with the fewest digits that [`ExactDegrees`] reads as `radians`, which are
/// finite.
pub(super) fn exact_degrees(radians: f32) -> String {
    let degrees = f64::from(radians) / f64::from(RADIANS);
    let rounded = |digits: usize| format!("{degrees:.digits$e}").parse::<f64>().ok();
    // 17 digits tell every `f64` from its neighbors.
    let shortest = (0..17).filter_map(rounded);
    let mut found = shortest.filter(|&degrees| exact_radians(degrees) == radians);
    // Only what happens to be the shortest number of another `f32` is not found.
    json_text::number(found.next().unwrap_or_else(|| degrees.next_up()))
}

/// Euler angles of three angles about X, Y and Z.
pub(super) fn euler<A: Angle>([x, y, z]: [A; 3]) -> Euler {
    Euler::from_radians(Vec3::new(x.radians(), y.radians(), z.radians()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> f32 {
        exact_radians(text.parse().unwrap())
    }

    #[test]
    fn every_angle_has_a_number_of_degrees_that_means_it() {
        // A step that is no power of two meets every exponent and all kinds of fractions.
        for bits in (0..f32::INFINITY.to_bits()).step_by(40_009) {
            for radians in [f32::from_bits(bits), -f32::from_bits(bits)] {
                let text = exact_degrees(radians);
                assert_eq!(read(&text), radians, "{text}");
            }
        }
    }

    #[test]
    fn what_people_type_is_written_as_they_typed_it() {
        for hundredths in -72_000..=72_000_i32 {
            let text = format!("{}", f64::from(hundredths) / 100.0);
            let radians = read(&text);
            let single: f32 = text.parse().unwrap();
            assert_eq!(radians, Euler::from_degrees(Vec3::splat(single)).radians.x);
            let written = exact_degrees(radians);
            assert!(written.len() <= text.len(), "{text} {written}");
            assert_eq!(read(&written), radians, "{text} {written}");
        }
        for text in ["30", "12.34", "-400", "0.1", "359.99", "1e-30"] {
            assert_eq!(exact_degrees(read(text)), text);
        }
    }
}
