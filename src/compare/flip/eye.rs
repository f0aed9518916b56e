//! What is seen of a tile of a picture from some distance: edges, points and colors.

use super::color::{ColorSpaces, linear};
use crate::compare::filters::{Plane, gaussian, normalized};
use crate::compare::pair::Pixel;
use crate::steps::Pace;
use glam::Vec3;
use std::f32::consts::PI;

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
/// What is worked out for one tile after the other.
#[derive(Default)]
pub(super) struct Planes {
    /// Of one picture, with a rim.
    pub pixels: Vec<Pixel>,
    /// Their Y, Cx and Cz.
    pub opponent: [Plane; 3],
    /// Results on the way.
    pub steps: [Plane; 5],
    /// Of A and of B.
    pub seen: [Seen; 2],
}

/// A tile of a picture as it is seen.
#[derive(Default)]
pub(super) struct Seen {
    /// How strong an edge, and a point, there is at each pixel.
    pub features: [Plane; 2],
    /// CIELab with the Hunt effect, channel by channel.
    pub colors: [Plane; 3],
}

/// What is worked out once for a picture seen from some distance.
pub(super) struct Filters {
    pub spaces: ColorSpaces,
    /// Linear value of each step of a channel.
    pub linear: [f32; 256],
    /// Gaussians by which each opponent channel is blurred.
    pub blurs: [Blur; 3],
    /// Gaussian, slope and bend that find edges and points.
    pub bell: Vec<f32>,
    pub slope: Vec<f32>,
    pub bend: Vec<f32>,
    /// The most pixels that a filter reaches to a side.
    pub reach: usize,
}

impl Filters {
    pub fn new(pixels_per_degree: f32) -> Self {
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
    pub fn opponent_planes(&self, columns: usize, planes: &mut Planes) {
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
    pub async fn features(&self, picture: usize, planes: &mut Planes, pace: &Pace) {
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
    pub async fn seen_colors(&self, picture: usize, planes: &mut Planes, pace: &Pace) {
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

/// A sum of Gaussians, together of weight one. The sum itself does not part into rows and columns,
/// but each Gaussian does.
pub(super) struct Blur {
    /// Weight and taps of each Gaussian.
    pub parts: Vec<(f32, Vec<f32>)>,
    /// Weight of all taps together.
    pub total: f32,
    /// Pixels to a side that they reach.
    pub reach: usize,
}

impl Blur {
    /// Of Gaussians as in [`SENSITIVITY`].
    pub fn new(parts: &[(f32, f32)], pixels_per_degree: f32) -> Self {
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

/// As [`f32::hypot`], without a call.
#[inline]
pub(super) fn length(x: f32, y: f32) -> f32 {
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
