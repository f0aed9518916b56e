use super::Area;
use super::pair::{Pair, Pixel, is_drawn};
use serde::Serialize;

/// How far two pictures are apart, pixel by pixel, in the 0..=255 steps of their channels.
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
    /// How many drawn pixels differ by exactly so much, by difference.
    #[serde(skip)]
    drawn_histogram: Vec<u64>,
}

impl Differences {
    /// Drawn pixels of which a channel differs by more than `threshold`.
    pub fn drawn_pixels_above(&self, threshold: u8) -> u64 {
        self.drawn_histogram[usize::from(threshold) + 1..]
            .iter()
            .sum()
    }
}

/// The largest difference of a channel, opacity included.
pub(super) fn difference(a: Pixel, b: Pixel) -> u8 {
    let [r, g, b, alpha]: Pixel = std::array::from_fn(|channel| a[channel].abs_diff(b[channel]));
    r.max(g).max(b).max(alpha)
}

impl Pair<'_> {
    /// Counts and means of the differences; pixels count as differing above `threshold`.
    pub fn differences(&self, threshold: u8) -> Differences {
        let mut sums = Sums::default();
        let [background_a, background_b] = self.backgrounds();
        let pixels = self.a().iter().zip(self.b()).zip(self.kept());
        for ((&a, &b), _) in pixels.filter(|(_, kept)| **kept) {
            let drawn = is_drawn(a, background_a) || is_drawn(b, background_b);
            sums.add(a, b, drawn);
        }
        let compared_pixels: u64 = sums.histogram.iter().sum();
        let channels = 3.0 * compared_pixels as f64;
        let rmse = (sums.squared as f64 / channels).sqrt();
        Differences {
            compared_pixels,
            differing_pixels: sums.histogram[usize::from(threshold) + 1..].iter().sum(),
            drawn_pixels: sums.drawn_histogram.iter().sum(),
            max: sums.histogram.iter().rposition(|&n| n > 0).unwrap_or(0) as u8,
            mean: sums.absolute as f64 / channels,
            rmse,
            psnr: 20.0 * (255.0 / rmse).log10(),
            differing_area: self.differing_area(threshold),
            drawn_histogram: sums.drawn_histogram.to_vec(),
        }
    }

    /// The area around all pixels that differ by more than `threshold`. Ignored pixels do not
    /// differ.
    fn differing_area(&self, threshold: u8) -> Option<Area> {
        let width = self.width() as usize;
        let rows = self.a().chunks(width).zip(self.b().chunks(width));
        let differs = |(a, b): (&Pixel, &Pixel)| difference(*a, *b) > threshold;
        let ends = rows.enumerate().filter_map(|(y, (a, b))| {
            let first = a.iter().zip(b).position(differs)?;
            let last = a.iter().zip(b).rposition(differs)?;
            Some([(first as u32, y as u32), (last as u32, y as u32)])
        });
        Area::around(ends.flatten())
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

#[cfg(test)]
mod tests {
    use super::*;
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
        let differences = Pair::new(&a, &b, &[]).unwrap().differences(0);
        assert_eq!(differences.drawn_pixels, 1);
        assert_eq!(differences.drawn_pixels_above(2), 1);
        assert_eq!(differences.drawn_pixels_above(9), 0);
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
}
