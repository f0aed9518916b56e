//! ꟻLIP, a measure of the difference that a person sees when two pictures are shown in turn:
//! P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
//! "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer
//! Graphics and Interactive Techniques 3 (2), 2020. Section numbers below are the paper's.
//! Written anew: the binding to the authors' code needs a C++ compiler.

mod color;
mod features;

use super::convolve::Plane;
use super::pair::{Pair, Pixel};
use color::{ColorSpaces, color_errors};
use features::feature_errors;
use glam::Vec3;

/// Pixels in a degree of the eye's field, seen as the paper assumes: from 0.7 m, on a screen
/// 0.7 m wide with 3840 columns.
pub const PIXELS_PER_DEGREE: f32 = 67.020_64;

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
        let linear: [f32; 256] = std::array::from_fn(|step| color::linear(step as f32 / 255.0));
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
}
