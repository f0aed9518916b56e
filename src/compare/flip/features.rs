use crate::compare::convolve::{Plane, gaussian, normalized};
use std::f32::consts::FRAC_1_SQRT_2;

/// Width of the features to look for, in degrees (section 4.2, w).
const WIDTH: f32 = 0.082;
/// Exponent that raises small feature differences (q_f).
const RAISE: f32 = 0.5;

/// Differences 0..=1 of edges and points (section 4.2) from the Y planes of two pictures.
pub fn feature_errors(lightness: [&Plane; 2], pixels_per_degree: f32) -> Vec<f32> {
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
