use super::Area;
use super::pair::{DRAWN_THRESHOLD, Pair, Pixel};
use crate::geometry::Picture;
use crate::steps::{Pace, at_once};
use serde::Serialize;

/// Columns between pictures that stand side by side.
const GAP: u32 = 8;
const GAP_COLOR: [u8; 4] = [128, 128, 128, 255];
/// Ignored pixels in a heat map.
const IGNORED_COLOR: [u8; 4] = [48, 56, 64, 255];
/// Where the ramp starts for the smallest difference, so that it stands out from none.
const SMALLEST_HEAT: f32 = 0.2;

/// Stops of the ramp at equal distances: black, violet, red, orange, yellow, white; each lighter
/// than the one before, so that the map can be read without seeing colors.
const RAMP: [[f32; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [72.0, 16.0, 120.0],
    [188.0, 44.0, 92.0],
    [240.0, 120.0, 44.0],
    [252.0, 206.0, 92.0],
    [255.0, 255.0, 235.0],
];

/// Differences of two pictures, pixel by pixel, in the 0..=255 steps of their channels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Differences {
    /// Pixels that were compared: all but the ignored.
    pub compared_pixels: u64,
    /// Pixels of which a channel differs by more than the threshold.
    pub differing_pixels: u64,
    /// Compared pixels that show something else than the background, in either picture.
    pub drawn_pixels: u64,
    /// Largest difference of any channel.
    pub max: u8,
    /// Mean difference of the three color channels.
    pub mean: f64,
    /// Root of the mean squared difference of the three color channels.
    pub rmse: f64,
    /// Peak signal to noise ratio of the three color channels in dB, `20 log10(255 / rmse)`;
    /// infinite (JSON null) if they are equal.
    pub psnr: f64,
    /// Smallest area around the differing pixels.
    pub differing_area: Option<Area>,
    /// Drawn pixels of which a channel differs by more than the threshold. Not in JSON, whose
    /// fields scripts rely on.
    #[serde(skip)]
    pub drawn_differing_pixels: u64,
}

/// The largest difference of a channel, opacity included.
#[inline]
pub(crate) fn difference(a: Pixel, b: Pixel) -> u8 {
    let [r, g, b, alpha]: Pixel = std::array::from_fn(|channel| a[channel].abs_diff(b[channel]));
    r.max(g).max(b).max(alpha)
}

impl Area {
    /// Share of its pixels in which two pictures of one size, which it is inside of, have about the same color, 0 to 1.
    pub fn share_alike(&self, a: &Picture, b: &Picture) -> f64 {
        let width = a.width as usize;
        let [a, b] = [a, b].map(|picture| picture.rgba.as_chunks::<4>().0);
        let rows = self.y as usize..(self.y + self.height) as usize;
        let columns = self.x as usize..(self.x + self.width) as usize;
        let places = rows.flat_map(|y| columns.clone().map(move |x| y * width + x));
        let count = places.clone().count().max(1);
        let both = places.filter_map(|at| Some((*a.get(at)?, *b.get(at)?)));
        let alike = both.filter(|(a, b)| difference(*a, *b) <= DRAWN_THRESHOLD);
        alike.count() as f64 / count as f64
    }
}

impl Pair<'_> {
    /// Counts and means of the differences; pixels count as differing above `threshold`.
    pub fn differences(&self, threshold: u8) -> Differences {
        at_once(|pace| async move { self.paced_differences(threshold, &pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_differences(&self, threshold: u8, pace: &Pace) -> Differences {
        let mut sums = Sums::default();
        let [background_a, background_b] = self.backgrounds();
        pace.bands(self.kept().len(), |band| {
            let pixels = self.a()[band.clone()].iter().zip(&self.b()[band.clone()]);
            let pixels = pixels.zip(&self.kept()[band]);
            for ((&a, &b), _) in pixels.filter(|(_, kept)| **kept) {
                let drawn = self.is_drawn(a, background_a) || self.is_drawn(b, background_b);
                sums.add(a, b, drawn);
            }
        })
        .await;
        let compared_pixels: u64 = sums.histogram.iter().sum();
        let above = |histogram: &[u64; 256]| histogram[usize::from(threshold) + 1..].iter().sum();
        let channels = 3.0 * compared_pixels as f64;
        let rmse = (sums.squared as f64 / channels).sqrt();
        Differences {
            compared_pixels,
            differing_pixels: above(&sums.histogram),
            drawn_pixels: sums.drawn_histogram.iter().sum(),
            max: sums.histogram.iter().rposition(|&n| n > 0).unwrap_or(0) as u8,
            mean: sums.absolute as f64 / channels,
            rmse,
            psnr: 20.0 * (255.0 / rmse).log10(),
            differing_area: self.differing_area(threshold, pace).await,
            drawn_differing_pixels: above(&sums.drawn_histogram),
        }
    }

    /// The area around all pixels that differ by more than `threshold`. Ignored pixels do not
    /// differ.
    async fn differing_area(&self, threshold: u8, pace: &Pace) -> Option<Area> {
        let width = self.width() as usize;
        let rows = self.a().chunks(width).zip(self.b().chunks(width));
        let differs = |(a, b): (&Pixel, &Pixel)| difference(*a, *b) > threshold;
        let mut ends = Vec::new();
        for (y, (a, b)) in rows.enumerate() {
            let first = a.iter().zip(b).position(differs);
            let last = a.iter().zip(b).rposition(differs);
            ends.extend(first.into_iter().chain(last).map(|x| (x as u32, y as u32)));
            pace.after(width).await;
        }
        Area::around(ends)
    }
}

/// Running sums over the compared pixels.
struct Sums {
    absolute: u64,
    squared: u64,
    histogram: [u64; 256],
    drawn_histogram: [u64; 256],
}

impl Default for Sums {
    fn default() -> Self {
        Self {
            absolute: 0,
            squared: 0,
            histogram: [0; 256],
            drawn_histogram: [0; 256],
        }
    }
}

impl Sums {
    fn add(&mut self, a: Pixel, b: Pixel, drawn: bool) {
        let largest = usize::from(difference(a, b));
        self.histogram[largest] += 1;
        self.drawn_histogram[largest] += u64::from(drawn);
        if largest > 0 {
            for channel in 0..3 {
                let difference = u64::from(a[channel].abs_diff(b[channel]));
                self.absolute += difference;
                self.squared += difference * difference;
            }
        }
    }
}

/// The color (RGBA) of a heat from 0 (black) to 1 (nearly white); values outside are clamped.
fn heat_color(heat: f32) -> [u8; 4] {
    let last = (RAMP.len() - 1) as f32;
    let place = (heat.clamp(0.0, 1.0) * last).min(last - 1e-4);
    let (stop, share) = (place as usize, place.fract());
    let [r, g, b] = std::array::from_fn(|channel| {
        let (from, to) = (RAMP[stop][channel], RAMP[stop + 1][channel]);
        (from + (to - from) * share).round() as u8
    });
    [r, g, b, 255]
}

impl Pair<'_> {
    /// The differences as a picture of the same size: black where equal, and lighter the more
    /// the pixels differ. The scale is not linear, so that even a difference of one shows.
    /// Ignored areas are gray.
    pub fn heat_map(&self) -> Picture {
        at_once(|pace| async move { self.paced_heat_map(&pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_heat_map(&self, pace: &Pace) -> Picture {
        let colors: [[u8; 4]; 256] = std::array::from_fn(|difference| match difference {
            0 => heat_color(0.0),
            _ => {
                let root = (difference as f32 / 255.0).sqrt();
                heat_color(SMALLEST_HEAT + (1.0 - SMALLEST_HEAT) * root)
            }
        });
        let mut rgba = Vec::with_capacity(4 * self.kept().len());
        pace.bands(self.kept().len(), |band| {
            let pixels = self.a()[band.clone()].iter().zip(&self.b()[band.clone()]);
            for ((&a, &b), &kept) in pixels.zip(&self.kept()[band]) {
                rgba.extend(if kept {
                    colors[usize::from(difference(a, b))]
                } else {
                    IGNORED_COLOR
                });
            }
        })
        .await;
        Picture {
            width: self.width(),
            height: self.height(),
            rgba,
        }
    }
}

/// The pictures in one row from left to right, with a gray gap between them. Lower ones are
/// filled up with the gap's color.
pub fn side_by_side(pictures: &[&Picture]) -> Picture {
    let height = pictures.iter().map(|p| p.height).max().unwrap_or(0);
    let gaps = GAP * pictures.len().saturating_sub(1) as u32;
    let width = pictures.iter().map(|p| p.width).sum::<u32>() + gaps;
    let mut rgba = GAP_COLOR.repeat(width as usize * height as usize);
    let mut left = 0;
    for picture in pictures {
        let row_bytes = 4 * picture.width as usize;
        if row_bytes > 0 {
            for (y, row) in picture.rgba.chunks_exact(row_bytes).enumerate() {
                let start = 4 * (y * width as usize + left as usize);
                rgba[start..start + row_bytes].copy_from_slice(row);
            }
        }
        left += picture.width + GAP;
    }
    Picture {
        width,
        height,
        rgba,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::ssim::luma;
    use crate::compare::test_pictures::{alike, filled, from_gray};

    #[test]
    fn equal_pictures_do_not_differ_and_have_infinite_psnr() {
        let [a, _] = alike(20, 10);
        let differences = Pair::new(&a, &a, &[]).unwrap().differences(0);
        assert_eq!(differences.compared_pixels, 200);
        assert_eq!((differences.differing_pixels, differences.max), (0, 0));
        assert_eq!((differences.mean, differences.rmse), (0.0, 0.0));
        assert_eq!(differences.psnr, f64::INFINITY);
        assert_eq!(differences.differing_area, None);
        let json = serde_json::to_value(&differences).unwrap();
        assert!(json["psnr"].is_null());
        assert_eq!(json["max"], 0);
    }

    #[test]
    fn counts_and_means_agree_with_a_small_case_by_hand() {
        let a = from_gray(3, &[10, 10, 10, 10, 50, 10]);
        let mut b = from_gray(3, &[10, 10, 14, 10, 40, 10]);
        b.rgba[4 * 2] = 10; // only green and blue of the third pixel differ
        let differences = Pair::new(&a, &b, &[]).unwrap().differences(4);
        assert_eq!(differences.compared_pixels, 6);
        assert_eq!(differences.differing_pixels, 1);
        assert_eq!(differences.max, 10);
        assert_eq!(differences.mean, (2.0 * 4.0 + 3.0 * 10.0) / 18.0);
        assert_eq!(differences.rmse, ((2.0 * 16.0 + 300.0) / 18.0_f64).sqrt());
        assert!((differences.psnr - 10.0 * (65025.0 * 18.0 / 332.0_f64).log10()).abs() < 1e-12);
        assert_eq!(differences.differing_area, "1,1,1,1".parse().ok());
    }

    #[test]
    fn drawn_pixels_are_those_that_leave_the_background_in_either_picture() {
        let a = from_gray(4, &[26; 24]);
        let mut values = [26; 24];
        values[9] = 34;
        values[10] = 35;
        values[14] = 30;
        let b = from_gray(4, &values);
        let pair = Pair::new(&a, &b, &[]).unwrap();
        let drawn = |threshold| pair.differences(threshold).drawn_differing_pixels;
        assert_eq!(pair.differences(0).drawn_pixels, 1);
        assert_eq!([2, 8, 9].map(drawn), [1, 1, 0]);
        assert_eq!(pair.differences(2).differing_pixels, 3);
    }

    #[test]
    fn ignored_areas_do_not_count() {
        let [a, b] = alike(20, 10);
        let ignore = ["0,0,20,9".parse().unwrap(), "1,9,99,99".parse().unwrap()];
        let differences = Pair::new(&a, &b, &ignore).unwrap().differences(0);
        assert_eq!(differences.compared_pixels, 1);
        assert_eq!(differences.max, 18);
        assert_eq!(differences.mean, 18.0);
    }

    #[test]
    fn opacity_counts_and_invisible_color_does_not() {
        let clear = filled(2, 2, [200, 0, 0, 0]);
        let other_clear = filled(2, 2, [0, 0, 90, 0]);
        let black = filled(2, 2, [0, 0, 0, 255]);
        let against = |b| Pair::new(&clear, b, &[]).unwrap().differences(0);
        assert_eq!(against(&other_clear).max, 0);
        assert_eq!(against(&black).max, 255);
        assert_eq!(against(&black).mean, 0.0);
    }

    #[test]
    fn the_ramp_gets_lighter_all_the_way() {
        let lumas: Vec<f32> = (0..=255)
            .map(|step| luma(heat_color(step as f32 / 255.0)))
            .collect();
        assert!(lumas.windows(2).all(|pair| pair[1] >= pair[0]));
        assert_eq!(heat_color(-1.0), [0, 0, 0, 255]);
        assert_eq!(heat_color(f32::INFINITY), [255, 255, 235, 255]);
    }

    #[test]
    fn the_heat_map_is_black_where_equal_and_gray_where_ignored() {
        let a = from_gray(2, &[10, 10, 10, 10]);
        let b = from_gray(2, &[10, 11, 99, 10]);
        let ignore = ["0,1,1,1".parse().unwrap()];
        let map = Pair::new(&a, &b, &ignore).unwrap().heat_map();
        let (pixels, _) = map.rgba.as_chunks::<4>();
        assert_eq!(pixels[0], [0, 0, 0, 255]);
        assert!(
            luma(pixels[1]) > 30.0,
            "a difference of one must be visible"
        );
        assert_eq!(pixels[2], IGNORED_COLOR);
    }

    #[test]
    fn pictures_stand_side_by_side() {
        let a = filled(2, 1, [1, 2, 3, 4]);
        let b = filled(1, 2, [5, 6, 7, 8]);
        let both = side_by_side(&[&a, &b]);
        assert_eq!((both.width, both.height), (2 + GAP + 1, 2));
        let (pixels, _) = both.rgba.as_chunks::<4>();
        let row = both.width as usize;
        assert_eq!(pixels[..2], [[1, 2, 3, 4]; 2]);
        assert_eq!(pixels[2], GAP_COLOR);
        assert_eq!(pixels[row], GAP_COLOR);
        assert_eq!([pixels[row - 1], pixels[2 * row - 1]], [[5, 6, 7, 8]; 2]);
    }
}
