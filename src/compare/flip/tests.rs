//! Values of the authors' own program, and properties.

use super::color::{hunt_lab, linear};
use super::eye::length;
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
            let linear = spaces.linear_from_opponent(Vec3::new(seen[0][i], seen[1][i], seen[2][i]));
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
