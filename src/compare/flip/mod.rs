//! ꟻLIP, a measure of the difference that a person sees when two pictures are shown in turn:
//! P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
//! "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer
//! Graphics and Interactive Techniques 3 (2), 2020. Section numbers below are the paper's.
//! Written anew: the binding to the authors' code needs a C++ compiler.

mod color;

use super::filters::{Plane, Tile, gaussian, normalized};
use super::pair::{Pair, Pixel};
use crate::steps::{Pace, at_once};
use color::{COMPRESSION, ColorSpaces, hyab, linear, spread};
use glam::Vec3;
use std::f32::consts::{FRAC_1_SQRT_2, PI};

/// Pixels in a degree of the eye's field, seen as the paper assumes: from 0.7 m, on a screen
/// 0.7 m wide with 3840 columns.
pub const PIXELS_PER_DEGREE: f32 = 67.020_64;

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
        at_once(|pace| async move { self.paced_flip(&pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_flip(&self, pace: &Pace) -> Flip {
        if self.a() == self.b() {
            // What the formulas say as well, after many filters.
            return Flip {
                mean: 0.0,
                map: vec![0.0; self.a().len()],
            };
        }
        self.flip_at(PIXELS_PER_DEGREE, pace).await
    }

    /// The same for another distance and screen.
    async fn flip_at(&self, pixels_per_degree: f32, pace: &Pace) -> Flip {
        let filters = Filters::new(pixels_per_degree);
        let (width, height) = (self.width() as usize, self.height() as usize);
        let mut map = vec![0.0; width * height];
        let mut planes = Planes::default();
        let mut errors = Vec::new();
        let mut done = 0;
        for tile in Tile::of(width, height) {
            self.flip_of(&tile, &filters, &mut planes, &mut errors, pace)
                .await;
            tile.put(&errors, &mut map, width);
            done += errors.len();
            pace.tell(done as f32 / map.len() as f32);
        }
        let (mut sum, mut count) = (0.0, 0_u64);
        pace.bands(map.len(), |band| {
            for (error, &kept) in map[band.clone()].iter_mut().zip(&self.kept()[band]) {
                if kept {
                    sum += f64::from(*error);
                    count += 1;
                } else {
                    *error = 0.0;
                }
            }
        })
        .await;
        let mean = sum / count as f64;
        Flip { mean, map }
    }

    /// The differences in one tile.
    async fn flip_of(
        &self,
        tile: &Tile,
        filters: &Filters,
        planes: &mut Planes,
        errors: &mut Vec<f32>,
        pace: &Pace,
    ) {
        for (index, pixels) in [self.a(), self.b()].into_iter().enumerate() {
            let width = self.width() as usize;
            tile.with_rim(pixels, width, filters.reach, &mut planes.pixels);
            filters.opponent_planes(tile.columns.len(), planes);
            filters.features(index, planes, pace).await;
            filters.seen_colors(index, planes, pace).await;
        }
        let [a, b] = &planes.seen;
        let features = feature_errors(&a.features, &b.features);
        let colors = color_errors(&filters.spaces, &a.colors, &b.colors);
        errors.clear();
        errors.extend(
            colors
                .zip(features)
                .map(|(color, feature)| color.powf(1.0 - feature)),
        );
        pace.after(errors.len()).await;
    }
}

/// What is worked out for one tile after the other.
#[derive(Default)]
struct Planes {
    /// Of one picture, with a rim.
    pixels: Vec<Pixel>,
    /// Their Y, Cx and Cz.
    opponent: [Plane; 3],
    /// Results on the way.
    steps: [Plane; 5],
    /// Of A and of B.
    seen: [Seen; 2],
}

/// A tile of a picture as it is seen.
#[derive(Default)]
struct Seen {
    /// How strong an edge, and a point, there is at each pixel.
    features: [Plane; 2],
    /// CIELab with the Hunt effect, channel by channel.
    colors: [Plane; 3],
}

/// What is worked out once for a picture seen from some distance.
struct Filters {
    spaces: ColorSpaces,
    /// Linear value of each step of a channel.
    linear: [f32; 256],
    /// Gaussians by which each opponent channel is blurred.
    blurs: [Blur; 3],
    /// Gaussian, slope and bend that find edges and points.
    bell: Vec<f32>,
    slope: Vec<f32>,
    bend: Vec<f32>,
    /// The most pixels that a filter reaches to a side.
    reach: usize,
}

impl Filters {
    fn new(pixels_per_degree: f32) -> Self {
        let blurs = SENSITIVITY.map(|parts| Blur::new(&parts, pixels_per_degree));
        let sigma = 0.5 * WIDTH * pixels_per_degree;
        let reach_of_bell = (3.0 * sigma).ceil() as usize;
        let bell = gaussian(sigma, reach_of_bell);
        let taps = |factor: &dyn Fn(f32) -> f32| -> Vec<f32> {
            let places = (0..bell.len()).map(|i| i as f32 - reach_of_bell as f32);
            places
                .zip(&bell)
                .map(|(x, bell)| factor(x) * bell)
                .collect()
        };
        Self {
            spaces: ColorSpaces::new(),
            linear: std::array::from_fn(|step| linear(step as f32 / 255.0)),
            reach: blurs
                .iter()
                .fold(reach_of_bell, |most, blur| most.max(blur.reach)),
            blurs,
            slope: signs_normalized(taps(&|x| -x)),
            bend: signs_normalized(taps(&|x| x * x / (sigma * sigma) - 1.0)),
            bell: normalized(bell),
        }
    }

    /// The planes Y, Cx and Cz (section 4.1) of the pixels of a tile of `columns`, with its rim.
    fn opponent_planes(&self, columns: usize, planes: &mut Planes) {
        let Planes {
            pixels, opponent, ..
        } = planes;
        for plane in &mut *opponent {
            let width = columns + 2 * self.reach;
            plane.resize(width, pixels.len() / width);
        }
        let [y, cx, cz] = opponent.each_mut().map(|plane| plane.values.iter_mut());
        for (((y, cx), cz), [r, g, b, _]) in y.zip(cx).zip(cz).zip(&*pixels) {
            let rgb = [*r, *g, *b].map(|channel| self.linear[usize::from(channel)]);
            let color = self.spaces.opponent_from_linear(Vec3::from_array(rgb));
            [*y, *cx, *cz] = color.to_array();
        }
    }

    /// Finds how strong an edge and a point there is at each pixel of a tile, in its Y plane.
    async fn features(&self, picture: usize, planes: &mut Planes, pace: &Pace) {
        let [lightness, across, down, x, y] = &mut planes.steps;
        let rim = self.reach - self.bell.len() / 2;
        planes.opponent[0].inner(rim, |y| (y + 16.0) / 116.0, lightness);
        lightness.along_columns(&self.bell, across);
        lightness.along_rows(&self.bell, down);
        pace.after(lightness.values.len()).await;
        let features = planes.seen[picture].features.iter_mut();
        for (feature, taps) in features.zip([&self.slope, &self.bend]) {
            across.along_rows(taps, x);
            down.along_columns(taps, y);
            let places = x.values.iter().zip(&y.values);
            feature.set(x.width, places.map(|(&x, &y)| length(x, y)));
            pace.after(across.values.len()).await;
        }
    }

    /// Works out the colors of a tile as the eye sees them at this distance.
    async fn seen_colors(&self, picture: usize, planes: &mut Planes, pace: &Pace) {
        let colors = &mut planes.seen[picture].colors;
        let [inner, rows, part, ..] = &mut planes.steps;
        for ((opponent, blur), seen) in planes.opponent.iter().zip(&self.blurs).zip(&mut *colors) {
            opponent.inner(self.reach - blur.reach, |value| value, inner);
            seen.set(0, std::iter::empty());
            for (weight, taps) in &blur.parts {
                inner.along_rows(taps, rows);
                rows.along_columns(taps, part);
                seen.resize(part.width, part.values.len() / part.width);
                for (value, part) in seen.values.iter_mut().zip(&part.values) {
                    *value += weight * part;
                }
                pace.after(inner.values.len()).await;
            }
            for value in &mut seen.values {
                *value /= blur.total;
            }
        }
        self.spaces.hunt_lab_from_opponent(colors);
        pace.after(colors[0].values.len()).await;
    }
}

/// The color differences 0..=1 (section 4.1) of seen colors, channel by channel.
fn color_errors<'a>(
    spaces: &ColorSpaces,
    a: &'a [Plane; 3],
    b: &'a [Plane; 3],
) -> impl Iterator<Item = f32> + use<'a> {
    let [green, blue] = [Vec3::Y, Vec3::Z].map(|color| spaces.hunt_lab_from_linear(color));
    let largest = hyab(green, blue).powf(COMPRESSION);
    let colors = |planes: &'a [Plane; 3]| {
        let [x, y, z] = planes.each_ref().map(|plane| plane.values.iter());
        x.zip(y).zip(z).map(|((&x, &y), &z)| Vec3::new(x, y, z))
    };
    colors(a)
        .zip(colors(b))
        .map(move |(a, b)| spread(hyab(a, b).powf(COMPRESSION), largest))
}

/// A sum of Gaussians, together of weight one. The sum itself does not part into rows and columns,
/// but each Gaussian does.
struct Blur {
    /// Weight and taps of each Gaussian.
    parts: Vec<(f32, Vec<f32>)>,
    /// Weight of all taps together.
    total: f32,
    /// Pixels to a side that they reach.
    reach: usize,
}

impl Blur {
    /// Of Gaussians as in [`SENSITIVITY`].
    fn new(parts: &[(f32, f32)], pixels_per_degree: f32) -> Self {
        let reach = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as usize;
        let mut total = 0.0;
        let parts = parts.iter().filter(|(a, _)| *a > 0.0).map(|&(a, b)| {
            // exp(-π² (x / ppd)² / b) = exp(-x² / 2σ²)
            let sigma = pixels_per_degree * (b / 2.0).sqrt() / PI;
            let taps = gaussian(sigma, reach);
            let weight = a * (PI / b).sqrt();
            let sum: f32 = taps.iter().sum();
            total += weight * sum * sum;
            (weight, taps)
        });
        Self {
            parts: parts.collect(),
            total,
            reach,
        }
    }
}

/// Differences 0..=1 of edges and points (section 4.2) of two pictures.
fn feature_errors<'a>(a: &'a [Plane; 2], b: &'a [Plane; 2]) -> impl Iterator<Item = f32> + use<'a> {
    let apart = |kind: usize| {
        let places = a[kind].values.iter().zip(&b[kind].values);
        places.map(|(a, b)| (a - b).abs())
    };
    let places = apart(0).zip(apart(1));
    places.map(|(edge, point)| (FRAC_1_SQRT_2 * edge.max(point)).powf(RAISE))
}

/// As [`f32::hypot`], without a call.
#[inline]
fn length(x: f32, y: f32) -> f32 {
    let (x, y) = (f64::from(x), f64::from(y));
    (x * x + y * y).sqrt() as f32
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
    use super::color::hunt_lab;
    use super::*;
    use crate::compare::test_pictures::{alike, correlated, filled, noise, painted};
    use crate::geometry::Picture;

    fn flip(a: &Picture, b: &Picture) -> Flip {
        Pair::new(a, b, &[]).unwrap().flip()
    }

    fn flip_at(pair: &Pair, pixels_per_degree: f32) -> Flip {
        at_once(|pace| async move { pair.flip_at(pixels_per_degree, &pace).await })
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
        assert_eq!(
            flip,
            flip_at(&pair, PIXELS_PER_DEGREE),
            "by the formulas too"
        );
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

    /// The same formulas on the pictures as a whole, with every sum in the same order and the
    /// standard library's roots and lengths.
    fn by_whole_planes(pair: &Pair) -> Vec<f32> {
        let (spaces, filters) = (ColorSpaces::new(), Filters::new(PIXELS_PER_DEGREE));
        let width = pair.width() as usize;
        let [a, b] = [pair.a(), pair.b()].map(|pixels| {
            let opponent = pixels.iter().map(|&[r, g, b, _]| {
                let rgb = [r, g, b].map(|channel| linear(f32::from(channel) / 255.0));
                spaces.opponent_from_linear(Vec3::from_array(rgb))
            });
            let opponent: Vec<Vec3> = opponent.collect();
            let plane = |channel: usize| opponent.iter().map(move |color| color[channel]);
            let lightness: Vec<f32> = plane(0).map(|y| (y + 16.0) / 116.0).collect();
            let across = correlated(&lightness, width, &filters.bell, false);
            let down = correlated(&lightness, width, &filters.bell, true);
            let features = [&filters.slope, &filters.bend].map(|taps| {
                let x = correlated(&across, width, taps, true);
                let y = correlated(&down, width, taps, false);
                x.iter()
                    .zip(y)
                    .map(|(x, y)| x.hypot(y))
                    .collect::<Vec<f32>>()
            });
            let seen = [0, 1, 2].map(|channel| {
                let blur = &filters.blurs[channel];
                let values: Vec<f32> = plane(channel).collect();
                let mut sum = vec![0.0; values.len()];
                for (weight, taps) in &blur.parts {
                    let rows = correlated(&values, width, taps, true);
                    let part = correlated(&rows, width, taps, false);
                    sum.iter_mut()
                        .zip(part)
                        .for_each(|(sum, part)| *sum += weight * part);
                }
                sum.iter().map(|sum| sum / blur.total).collect::<Vec<f32>>()
            });
            let colors = (0..seen[0].len()).map(|i| {
                let linear =
                    spaces.linear_from_opponent(Vec3::new(seen[0][i], seen[1][i], seen[2][i]));
                let shown = linear.clamp(Vec3::ZERO, Vec3::ONE);
                let xyz = (spaces.relative_xyz_from_linear * shown).to_array();
                let delta: f32 = 6.0 / 29.0;
                hunt_lab(Vec3::from_array(xyz.map(|value| match value {
                    value if value > delta * delta * delta => value.cbrt(),
                    value => value / (3.0 * delta * delta) + 4.0 / 29.0,
                })))
            });
            (features, colors.collect::<Vec<Vec3>>())
        });
        let [green, blue] = [Vec3::Y, Vec3::Z].map(|color| spaces.hunt_lab_from_linear(color));
        let largest = hyab(green, blue).powf(COMPRESSION);
        let error = |i: usize| {
            let apart = |kind: usize| (a.0[kind][i] - b.0[kind][i]).abs();
            let feature = (FRAC_1_SQRT_2 * apart(0).max(apart(1))).powf(RAISE);
            let color = spread(hyab(a.1[i], b.1[i]).powf(COMPRESSION), largest);
            color.powf(1.0 - feature)
        };
        (0..a.1.len()).map(error).collect()
    }

    #[test]
    fn tile_by_tile_every_pixel_has_exactly_the_value_of_the_whole() {
        let noise = |seed| noise(530, 200, 0..=255, seed);
        let [flat, _] = alike(40, 30);
        for [a, b] in [
            [noise(1), noise(2)],
            alike(300, 110),
            [flat, filled(40, 30, [9; 4])],
        ] {
            let pair = Pair::new(&a, &b, &[]).unwrap();
            assert!(pair.flip().map == by_whole_planes(&pair), "{}", a.width);
        }
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
        assert!(flip_at(&pair, 80.0).mean < 0.8 * flip_at(&pair, 20.0).mean);
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
    fn lengths_are_those_of_the_standard_library_to_the_last_bit() {
        let values = (0..3000).map(|i| (i as f32 * 0.37).sin() * 10_f32.powi(-(i % 7)));
        let values: Vec<f32> = values.collect();
        for (x, y) in values
            .iter()
            .flat_map(|x| values.iter().step_by(7).map(move |y| (x, y)))
        {
            assert_eq!(length(*x, *y), x.hypot(*y), "{x} {y}");
        }
    }
}
