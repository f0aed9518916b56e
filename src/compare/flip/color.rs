use crate::compare::convolve::{Plane, gaussian};
use glam::{Mat3, Vec2, Vec3};
use std::f32::consts::PI;

/// Exponent that compresses large color differences (section 4.1.4, q_c).
const COMPRESSION: f32 = 0.7;
/// Differences below this share of the largest one ... (p_c)
const SMALL_SHARE: f32 = 0.4;
/// ... fill this share of the result's range (p_t).
const SMALL_RANGE: f32 = 0.95;

/// Sensitivity of the eye to contrast in each opponent channel (section 4.1.1): two Gaussians
/// `a sqrt(π / b) exp(-π² x² / b)`, `x` in degrees, each as `(a, b)`.
const SENSITIVITY: [[(f32, f32); 2]; 3] = [
    [(1.0, 0.0047), (0.0, 1e-5)],
    [(1.0, 0.0053), (0.0, 1e-5)],
    [(34.1, 0.04), (13.5, 0.025)],
];
/// The widest `b` of all, which sets the reach of every filter.
const WIDEST: f32 = 0.04;

/// Linear sRGB and the spaces that ꟻLIP works in.
pub struct ColorSpaces {
    /// CIE XYZ relative to the white point, so that white is (1, 1, 1).
    relative_xyz_from_linear: Mat3,
    linear_from_relative_xyz: Mat3,
}

impl ColorSpaces {
    /// From the chromaticities of sRGB's primaries and of its white, D65.
    pub fn new() -> Self {
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
    pub fn opponent_from_linear(&self, linear: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = self.relative_xyz_from_linear * linear;
        Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    fn linear_from_opponent(&self, opponent: Vec3) -> Vec3 {
        let y = (opponent.x + 16.0) / 116.0;
        let x = y + opponent.y / 500.0;
        let z = y - opponent.z / 200.0;
        self.linear_from_relative_xyz * Vec3::new(x, y, z)
    }

    /// CIELab with the Hunt effect: chroma counts the more the lighter the color is (section
    /// 4.1.2).
    fn hunt_lab_from_linear(&self, linear: Vec3) -> Vec3 {
        let [x, y, z] = (self.relative_xyz_from_linear * linear)
            .to_array()
            .map(lab_root);
        let lightness = 116.0 * y - 16.0;
        let chroma = 0.01 * lightness * Vec2::new(500.0 * (x - y), 200.0 * (y - z));
        Vec3::new(lightness, chroma.x, chroma.y)
    }
}

/// The linear value of an sRGB-encoded one (IEC 61966-2-1), both 0..=1.
pub fn linear(encoded: f32) -> f32 {
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// CIELab's cube root, linear near zero.
fn lab_root(value: f32) -> f32 {
    const DELTA: f32 = 6.0 / 29.0;
    if value > DELTA * DELTA * DELTA {
        value.cbrt()
    } else {
        value / (3.0 * DELTA * DELTA) + 4.0 / 29.0
    }
}

/// The color differences 0..=1 (section 4.1) from the YCxCz planes of two pictures.
pub fn color_errors(
    spaces: &ColorSpaces,
    opponent: [[Plane; 3]; 2],
    pixels_per_degree: f32,
) -> Vec<f32> {
    let [a, b] = opponent.map(|planes| {
        let [y, cx, cz] = see(planes, pixels_per_degree);
        let colors = y.values.iter().zip(cx.values).zip(cz.values);
        colors
            .map(|((&y, cx), cz)| {
                let linear = spaces.linear_from_opponent(Vec3::new(y, cx, cz));
                spaces.hunt_lab_from_linear(linear.clamp(Vec3::ZERO, Vec3::ONE))
            })
            .collect::<Vec<Vec3>>()
    });
    let [green, blue] = [Vec3::Y, Vec3::Z].map(|color| spaces.hunt_lab_from_linear(color));
    let largest = hyab(green, blue).powf(COMPRESSION);
    a.into_iter()
        .zip(b)
        .map(|(a, b)| spread(hyab(a, b).powf(COMPRESSION), largest))
        .collect()
}

/// Distance of two Lab colors that holds for large differences too (section 4.1.3).
fn hyab(a: Vec3, b: Vec3) -> f32 {
    let difference = a - b;
    difference.x.abs() + Vec2::new(difference.y, difference.z).length()
}

/// Spreads compressed differences over 0..=1, most of it for the small ones (section 4.1.4).
fn spread(difference: f32, largest: f32) -> f32 {
    let small = SMALL_SHARE * largest;
    if difference < small {
        SMALL_RANGE * difference / small
    } else {
        SMALL_RANGE + (1.0 - SMALL_RANGE) * (difference - small) / (largest - small)
    }
}

/// Blurs each opponent channel as the eye does at this distance.
fn see(planes: [Plane; 3], pixels_per_degree: f32) -> [Plane; 3] {
    let reach = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as usize;
    let mut sensitivities = SENSITIVITY.iter();
    planes.map(|plane| {
        let parts = sensitivities.next().into_iter().flatten();
        blur(
            &plane,
            parts.filter(|(a, _)| *a > 0.0),
            reach,
            pixels_per_degree,
        )
    })
}

/// Blurs by a sum of Gaussians, together of weight one. The sum itself does not part into rows
/// and columns, but each Gaussian does.
fn blur<'a>(
    plane: &Plane,
    parts: impl Iterator<Item = &'a (f32, f32)>,
    reach: usize,
    pixels_per_degree: f32,
) -> Plane {
    let mut blurred = plane.map(|_| 0.0);
    let mut total = 0.0;
    for &(a, b) in parts {
        // exp(-π² (x / ppd)² / b) = exp(-x² / 2σ²)
        let sigma = pixels_per_degree * (b / 2.0).sqrt() / PI;
        let taps = gaussian(sigma, reach);
        let weight = a * (PI / b).sqrt();
        let sum: f32 = taps.iter().sum();
        total += weight * sum * sum;
        let part = plane.along_rows(&taps).along_columns(&taps);
        for (value, part) in blurred.values.iter_mut().zip(part.values) {
            *value += weight * part;
        }
    }
    blurred.map(|value| value / total)
}

#[cfg(test)]
mod tests {
    use super::*;

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
