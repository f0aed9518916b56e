//! Colors as the eye compares them: opponent colors, CIELab, and how far two of them are apart.

use crate::compare::filters::Plane;
use glam::{Mat3, Vec2, Vec3};

/// Exponent that compresses large color differences (section 4.1.4, q_c).
pub(super) const COMPRESSION: f32 = 0.7;
/// Differences below this share of the largest one ... (p_c)
const SMALL_SHARE: f32 = 0.4;
/// ... fill this share of the result's range (p_t).
const SMALL_RANGE: f32 = 0.95;

/// Linear sRGB and the spaces that ꟻLIP works in.
pub(super) struct ColorSpaces {
    /// CIE XYZ relative to the white point, so that white is (1, 1, 1).
    pub(super) relative_xyz_from_linear: Mat3,
    linear_from_relative_xyz: Mat3,
}

impl ColorSpaces {
    /// From the chromaticities of sRGB's primaries and of its white, D65.
    pub(super) fn new() -> Self {
        let xyz = |x: f32, y: f32| Vec3::new(x / y, 1.0, (1.0 - x - y) / y);
        let primaries = Mat3::from_cols(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
        let white = xyz(0.3127, 0.3290);
        let intensities = primaries.inverse() * white;
        let xyz_from_linear = primaries * Mat3::from_diagonal(intensities);
        let relative_xyz_from_linear = Mat3::from_diagonal(white.recip()) * xyz_from_linear;
        Self {
            relative_xyz_from_linear,
            linear_from_relative_xyz: relative_xyz_from_linear.inverse(),
        }
    }

    /// YCxCz, a linear form of CIELab.
    #[inline]
    pub(super) fn opponent_from_linear(&self, linear: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = self.relative_xyz_from_linear * linear;
        Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    #[inline]
    pub(super) fn linear_from_opponent(&self, opponent: Vec3) -> Vec3 {
        let y = (opponent.x + 16.0) / 116.0;
        let x = y + opponent.y / 500.0;
        let z = y - opponent.z / 200.0;
        self.linear_from_relative_xyz * Vec3::new(x, y, z)
    }

    /// CIELab with the Hunt effect: chroma counts the more the lighter the color is (section
    /// 4.1.2).
    pub(super) fn hunt_lab_from_linear(&self, linear: Vec3) -> Vec3 {
        let relative_xyz = self.relative_xyz_from_linear * linear;
        hunt_lab(Vec3::from_array(relative_xyz.to_array().map(lab_root)))
    }

    /// The same of colors in YCxCz, channel by channel, as far as they can be shown. Step by step:
    /// the processor takes many colors at once.
    pub(super) fn hunt_lab_from_opponent(&self, channels: &mut [Plane; 3]) {
        each_color(channels, |opponent| {
            let linear = self.linear_from_opponent(opponent);
            self.relative_xyz_from_linear * linear.clamp(Vec3::ZERO, Vec3::ONE)
        });
        for channel in &mut *channels {
            for value in &mut channel.values {
                *value = lab_root(*value);
            }
        }
        each_color(channels, hunt_lab);
    }
}

/// The linear value of an sRGB-encoded one (IEC 61966-2-1), both 0..=1.
pub(super) fn linear(encoded: f32) -> f32 {
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// Changes each of the colors that `channels` hold.
fn each_color(channels: &mut [Plane; 3], change: impl Fn(Vec3) -> Vec3) {
    let [first, second, third] = channels.each_mut().map(|plane| plane.values.iter_mut());
    for ((first, second), third) in first.zip(second).zip(third) {
        [*first, *second, *third] = change(Vec3::new(*first, *second, *third)).to_array();
    }
}

/// CIELab with the Hunt effect from the roots of relative X, Y and Z.
#[inline]
pub(super) fn hunt_lab(Vec3 { x, y, z }: Vec3) -> Vec3 {
    let lightness = 116.0 * y - 16.0;
    let chroma = 0.01 * lightness * Vec2::new(500.0 * (x - y), 200.0 * (y - z));
    Vec3::new(lightness, chroma.x, chroma.y)
}

/// CIELab's cube root, linear near zero.
#[inline]
fn lab_root(value: f32) -> f32 {
    const DELTA: f32 = 6.0 / 29.0;
    let (root, line) = (cube_root(value), value / (3.0 * DELTA * DELTA) + 4.0 / 29.0);
    if value > DELTA * DELTA * DELTA {
        root
    } else {
        line
    }
}

/// The cube root of a positive number, rounded to the nearest as [`f32::cbrt`] is, but without a
/// call, so that the processor takes many at once: two of Halley's steps from a guess whose
/// exponent is a third, the second with more digits.
#[inline]
fn cube_root(value: f32) -> f32 {
    /// The division takes two thirds of the exponent's bias away, but for what makes the largest
    /// error of the guess small.
    const BIAS: u32 = 709_958_130;
    let root = f32::from_bits(value.to_bits() / 3 + BIAS);
    let cube = root * root * root;
    let root = root * (value + value + cube) / (value + cube + cube);
    let (root, value) = (f64::from(root), f64::from(value));
    let cube = root * root * root;
    (root * (value + value + cube) / (value + cube + cube)) as f32
}

/// Distance of two Lab colors that holds for large differences too (section 4.1.3).
#[inline]
pub(super) fn hyab(a: Vec3, b: Vec3) -> f32 {
    let difference = a - b;
    difference.x.abs() + Vec2::new(difference.y, difference.z).length()
}

/// Spreads compressed differences over 0..=1, most of it for the small ones (section 4.1.4).
#[inline]
pub(super) fn spread(difference: f32, largest: f32) -> f32 {
    let small = SMALL_SHARE * largest;
    if difference < small {
        SMALL_RANGE * difference / small
    } else {
        SMALL_RANGE + (1.0 - SMALL_RANGE) * (difference - small) / (largest - small)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_those_of_the_standard_library_to_the_last_bit() {
        for bits in (0.008_f32.to_bits()..1.1_f32.to_bits()).step_by(101) {
            let value = f32::from_bits(bits);
            assert_eq!(cube_root(value), value.cbrt(), "{value}");
        }
    }

    #[test]
    fn white_has_lightness_100_and_no_chroma() {
        let spaces = ColorSpaces::new();
        let white = spaces.hunt_lab_from_linear(Vec3::ONE);
        assert!(
            white.abs_diff_eq(Vec3::new(100.0, 0.0, 0.0), 1e-3),
            "{white}"
        );
        let black = spaces.hunt_lab_from_linear(Vec3::ZERO);
        assert!(black.abs_diff_eq(Vec3::ZERO, 1e-4), "{black}");
    }

    #[test]
    fn opponent_colors_turn_back_into_the_same() {
        let spaces = ColorSpaces::new();
        for color in [Vec3::X, Vec3::Y, Vec3::new(0.2, 0.5, 0.9)] {
            let back = spaces.linear_from_opponent(spaces.opponent_from_linear(color));
            assert!(back.abs_diff_eq(color, 1e-5), "{back}");
        }
    }

    #[test]
    fn the_parts_of_the_range_meet() {
        assert_eq!(spread(0.0, 10.0), 0.0);
        assert!((spread(3.999_999, 10.0) - 0.95).abs() < 1e-5);
        assert!((spread(4.0, 10.0) - 0.95).abs() < 1e-6);
        assert!((spread(10.0, 10.0) - 1.0).abs() < 1e-6);
    }
}
