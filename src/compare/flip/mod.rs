//! ꟻLIP, a measure of the difference that a person sees when two pictures are shown in turn:
//! P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
//! "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer
//! Graphics and Interactive Techniques 3 (2), 2020. Section numbers below are the paper's.
//! Written anew: the binding to the authors' code needs a C++ compiler.

mod color;
mod eye;

use super::filters::{Plane, Tile};
use super::pair::Pair;
use crate::steps::{Pace, at_once};
use color::{COMPRESSION, ColorSpaces, hyab, spread};
use eye::{Filters, Planes};
use glam::Vec3;
use std::f32::consts::FRAC_1_SQRT_2;

/// Pixels in a degree of the eye's field, seen as the paper assumes: from 0.7 m, on a screen
/// 0.7 m wide with 3840 columns.
pub const PIXELS_PER_DEGREE: f32 = 67.020_64;

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

/// Differences 0..=1 of edges and points (section 4.2) of two pictures.
fn feature_errors<'a>(a: &'a [Plane; 2], b: &'a [Plane; 2]) -> impl Iterator<Item = f32> + use<'a> {
    let apart = |kind: usize| {
        let places = a[kind].values.iter().zip(&b[kind].values);
        places.map(|(a, b)| (a - b).abs())
    };
    let places = apart(0).zip(apart(1));
    places.map(|(edge, point)| (FRAC_1_SQRT_2 * edge.max(point)).powf(RAISE))
}

#[cfg(test)]
mod tests;
