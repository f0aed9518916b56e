//! ꟻLIP, a measure of the difference that a person sees when two pictures are shown in turn:
//! P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
//! "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer
//! Graphics and Interactive Techniques 3 (2), 2020. Section numbers below are the paper's.
//! Written anew: the binding to the authors' code needs a C++ compiler.

use super::filters::{Plane, gaussian, normalized};
use super::pair::{Pair, Pixel};
use glam::{Mat3, Vec2, Vec3};
use std::f32::consts::{FRAC_1_SQRT_2, PI};

/// Pixels in a degree of the eye's field, seen as the paper assumes: from 0.7 m, on a screen
/// 0.7 m wide with 3840 columns.
pub const PIXELS_PER_DEGREE: f32 = 67.020_64;

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

/// Width of the features to look for, in degrees (section 4.2, w).
const WIDTH: f32 = 0.082;
/// Exponent that raises small feature differences (q_f).
const RAISE: f32 = 0.5;

/// The perceived difference of two pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Flip {
    /// Mean over the pixels that are not ignored, from 0 (equal) to 1.
    pub mean: f64,
    /// The difference at each pixel, 0..=1, top row first; 0 in ignored areas.
    pub map: Vec<f32>,
}

impl Pair<'_> {
    /// Low dynamic range ꟻLIP of the pictures, taken as sRGB, at [`PIXELS_PER_DEGREE`].
    pub fn flip(&self) -> Flip {
        if self.a() == self.b() {
            // What the formulas say as well, after many filters.
            return Flip {
                mean: 0.0,
                map: vec![0.0; self.a().len()],
            };
        }
        self.flip_at(PIXELS_PER_DEGREE)
    }

    /// The same for another distance and screen.
    fn flip_at(&self, pixels_per_degree: f32) -> Flip {
        let spaces = ColorSpaces::new();
        let opponent_a = self.opponent_planes(&spaces, self.a());
        let opponent_b = self.opponent_planes(&spaces, self.b());
        let features = feature_errors([&opponent_a[0], &opponent_b[0]], pixels_per_degree);
        let colors = color_errors(&spaces, [opponent_a, opponent_b], pixels_per_degree);
        let mut map: Vec<f32> = colors
            .into_iter()
            .zip(features)
            .map(|(color, feature)| color.powf(1.0 - feature))
            .collect();
        let (mut sum, mut count) = (0.0, 0_u64);
        for (error, &kept) in map.iter_mut().zip(self.kept()) {
            if kept {
                sum += f64::from(*error);
                count += 1;
            } else {
                *error = 0.0;
            }
        }
        let mean = sum / count as f64;
        Flip { mean, map }
    }

    /// The planes Y, Cx and Cz (section 4.1) of a picture.
    fn opponent_planes(&self, spaces: &ColorSpaces, pixels: &[Pixel]) -> [Plane; 3] {
        let linear: [f32; 256] = std::array::from_fn(|step| linear(step as f32 / 255.0));
        let colors: Vec<Vec3> = pixels
            .iter()
            .map(|[r, g, b, _]| {
                let rgb = [r, g, b].map(|&channel| linear[usize::from(channel)]);
                spaces.opponent_from_linear(Vec3::from_array(rgb))
            })
            .collect();
        std::array::from_fn(|channel| Plane {
            width: self.width() as usize,
            values: colors.iter().map(|color| color[channel]).collect(),
        })
    }
}

/// Linear sRGB and the spaces that ꟻLIP works in.
struct ColorSpaces {
    /// CIE XYZ relative to the white point, so that white is (1, 1, 1).
    relative_xyz_from_linear: Mat3,
    linear_from_relative_xyz: Mat3,
}

impl ColorSpaces {
    /// From the chromaticities of sRGB's primaries and of its white, D65.
    fn new() -> Self {
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
    fn opponent_from_linear(&self, linear: Vec3) -> Vec3 {
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
fn linear(encoded: f32) -> f32 {
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
fn color_errors(
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

/// Differences 0..=1 of edges and points (section 4.2) from the Y planes of two pictures.
fn feature_errors(lightness: [&Plane; 2], pixels_per_degree: f32) -> Vec<f32> {
    let [a, b] = lightness.map(|plane| features(plane, pixels_per_degree));
    a.into_iter()
        .zip(b)
        .map(|([edge_a, point_a], [edge_b, point_b])| {
            let difference = (edge_a - edge_b).abs().max((point_a - point_b).abs());
            (FRAC_1_SQRT_2 * difference).powf(RAISE)
        })
        .collect()
}

/// How strong an edge and a point there is at each pixel.
fn features(lightness: &Plane, pixels_per_degree: f32) -> Vec<[f32; 2]> {
    let sigma = 0.5 * WIDTH * pixels_per_degree;
    let reach = (3.0 * sigma).ceil() as usize;
    let bell = gaussian(sigma, reach);
    let taps = |factor: &dyn Fn(f32) -> f32| -> Vec<f32> {
        let places = (0..bell.len()).map(|i| i as f32 - reach as f32);
        places
            .zip(&bell)
            .map(|(x, bell)| factor(x) * bell)
            .collect()
    };
    let slope = signs_normalized(taps(&|x| -x));
    let bend = signs_normalized(taps(&|x| x * x / (sigma * sigma) - 1.0));
    let bell = normalized(bell);
    let lightness = lightness.map(|y| (y + 16.0) / 116.0);
    let across = lightness.along_columns(&bell);
    let down = lightness.along_rows(&bell);
    let edges = lengths(across.along_rows(&slope), down.along_columns(&slope));
    let points = lengths(across.along_rows(&bend), down.along_columns(&bend));
    edges
        .zip(points)
        .map(|(edge, point)| [edge, point])
        .collect()
}

fn lengths(x: Plane, y: Plane) -> impl Iterator<Item = f32> {
    x.values.into_iter().zip(y.values).map(|(x, y)| x.hypot(y))
}

/// Scales positive and negative taps so that each kind sums up to one.
fn signs_normalized(taps: Vec<f32>) -> Vec<f32> {
    let positive: f32 = taps.iter().filter(|tap| **tap > 0.0).sum();
    let negative: f32 = -taps.iter().filter(|tap| **tap < 0.0).sum::<f32>();
    taps.into_iter()
        .map(|tap| tap / if tap > 0.0 { positive } else { negative })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::{alike, filled, painted};
    use crate::geometry::Picture;

    fn flip(a: &Picture, b: &Picture) -> Flip {
        Pair::new(a, b, &[]).unwrap().flip()
    }

    fn mean_of_colors(a: [u8; 3], b: [u8; 3]) -> f64 {
        let picture = |[r, g, b]: [u8; 3]| filled(32, 24, [r, g, b, 255]);
        flip(&picture(a), &picture(b)).mean
    }

    #[track_caller]
    fn assert_near(found: impl Into<f64>, expected: f64) {
        let found = found.into();
        assert!((found - expected).abs() < 1e-5, "{found}, not {expected}");
    }

    #[test]
    fn equal_pictures_do_not_differ_at_any_pixel() {
        let [a, _] = alike(30, 20);
        let pair = Pair::new(&a, &a, &[]).unwrap();
        let flip = pair.flip();
        assert_eq!(flip.mean, 0.0);
        assert!(flip.map.iter().all(|&error| error == 0.0));
        assert_eq!(flip, pair.flip_at(PIXELS_PER_DEGREE), "by the formulas too");
    }

    #[test]
    fn the_most_distant_colors_green_and_blue_differ_by_one() {
        assert_near(mean_of_colors([0, 255, 0], [0, 0, 255]), 1.0);
    }

    /// Values of the authors' own program, version 1.7.
    #[test]
    fn even_colors_differ_as_in_the_authors_program() {
        assert_near(mean_of_colors([255; 3], [0; 3]), 0.967_391_07);
        assert_near(mean_of_colors([255, 0, 0], [0, 255, 0]), 0.986_673_83);
        assert_near(mean_of_colors([120; 3], [130, 120, 120]), 0.123_132_9);
        assert_near(mean_of_colors([26; 3], [30; 3]), 0.093_487_89);
    }

    /// Values of the authors' own program, version 1.7.
    #[test]
    fn pictures_differ_as_in_the_authors_program() {
        let [a, b] = alike(64, 48);
        let flip = flip(&a, &b);
        assert_near(flip.mean, 0.133_852_94);
        assert_near(flip.map[0], 0.024_275_2);
        assert_near(flip.map[20 * 64 + 30], 0.094_969_8);
        assert_near(flip.map[47 * 64 + 63], 0.397_583_84);
        assert_near(flip.map[10 * 64 + 3], 0.194_757_5);
    }

    /// Values of the authors' own program, version 1.7.
    #[test]
    fn points_and_edges_weigh_as_in_the_authors_program() {
        let gray = |value: u8| [value, value, value, 255];
        let black = filled(32, 24, gray(0));
        let dot = painted(32, 24, |x, y| {
            gray(if (x, y) == (16, 12) { 255 } else { 0 })
        });
        assert_near(flip(&black, &dot).mean, 0.018_631_877);
        assert_near(flip(&black, &dot).map[12 * 32 + 18], 0.480_560_7);
        let edge = |at| painted(32, 24, move |x, _| gray(if x < at { 0 } else { 200 }));
        assert_near(flip(&edge(16), &edge(17)).mean, 0.083_439_596);
    }

    #[test]
    fn the_order_of_the_pictures_does_not_matter() {
        let [a, b] = alike(40, 30);
        assert_eq!(flip(&a, &b), flip(&b, &a));
    }

    #[test]
    fn fine_patterns_are_seen_less_from_afar() {
        let checked = painted(40, 40, |x, y| [((x + y) % 2 * 60) as u8, 0, 0, 255]);
        let even = filled(40, 40, [30, 0, 0, 255]);
        let pair = Pair::new(&checked, &even, &[]).unwrap();
        assert!(pair.flip_at(80.0).mean < 0.8 * pair.flip_at(20.0).mean);
    }

    #[test]
    fn ignored_areas_do_not_differ() {
        let [a, b] = alike(40, 30);
        let right: crate::compare::Area = "20,0,20,30".parse().unwrap();
        let part = Pair::new(&a, &b, &[right]).unwrap().flip();
        assert!((0..1200).all(|i| i % 40 < 20 || part.map[i] == 0.0));
        let sum: f64 = part.map.iter().map(|&error| f64::from(error)).sum();
        assert!((part.mean - sum / 600.0).abs() < 1e-12);
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
