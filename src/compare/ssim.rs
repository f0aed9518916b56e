use super::filters::{Plane, Tile, gaussian, normalized};
use super::pair::{Pair, Pixel};
use crate::steps::{Pace, at_once};

/// Side of the window in pixels.
const WINDOW: usize = 11;
const SIGMA: f32 = 1.5;

impl Pair<'_> {
    /// Mean structural similarity of the lumas, 1 for equal pictures: Z. Wang, A. C. Bovik,
    /// H. R. Sheikh, E. P. Simoncelli, "Image quality assessment: from error visibility to
    /// structural similarity", IEEE Transactions on Image Processing 13 (4), 2004, with its
    /// Gaussian window of 11×11 pixels (σ = 1.5), K1 = 0.01 and K2 = 0.03.
    ///
    /// The mean goes over the windows that lie inside of the picture and whose middle is not
    /// ignored; `None` if there is none.
    pub fn ssim(&self) -> Option<f64> {
        at_once(|pace| async move { self.paced_ssim(&pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_ssim(&self, pace: &Pace) -> Option<f64> {
        let width = self.width() as usize;
        let height = self.height() as usize;
        if width < WINDOW || height < WINDOW {
            return None;
        }
        let map = if self.a() == self.b() {
            // What the formulas say as well, after many filters.
            vec![1.0; self.a().len()]
        } else {
            self.ssim_map(pace).await
        };
        let reach = WINDOW / 2;
        let (mut sum, mut count) = (0.0, 0_u64);
        let rows = map.chunks_exact(width).zip(self.kept().chunks_exact(width));
        for (values, kept) in rows.take(height - reach).skip(reach) {
            let inner = reach..width - reach;
            for (&value, _) in values[inner.clone()]
                .iter()
                .zip(&kept[inner])
                .filter(|(_, kept)| **kept)
            {
                sum += f64::from(value);
                count += 1;
            }
            pace.after(width).await;
        }
        (count > 0).then(|| sum / count as f64)
    }

    /// Equations (13) to (16) of the paper at each pixel.
    async fn ssim_map(&self, pace: &Pace) -> Vec<f32> {
        let (width, height) = (self.width() as usize, self.height() as usize);
        let mut map = vec![0.0; width * height];
        let mut planes = Planes::default();
        let mut values = Vec::new();
        let mut done = 0;
        for tile in Tile::of(width, height) {
            self.ssim_of(&tile, &mut planes, &mut values, pace).await;
            tile.put(&values, &mut map, width);
            done += values.len();
            pace.tell(done as f32 / map.len() as f32);
        }
        map
    }

    /// The same for the pixels of one tile.
    async fn ssim_of(&self, tile: &Tile, planes: &mut Planes, values: &mut Vec<f32>, pace: &Pace) {
        let reach = WINDOW / 2;
        let taps = normalized(gaussian(SIGMA, reach));
        let width = tile.columns.len() + 2 * reach;
        let Planes {
            pixels,
            lumas: [a, b],
            products,
            blurred,
            means: [mean_a, mean_b, mean_aa, mean_bb, mean_ab],
        } = planes;
        for (from, luma_of) in [(self.a(), &mut *a), (self.b(), &mut *b)] {
            tile.with_rim(from, self.width() as usize, reach, pixels);
            luma_of.set(width, pixels.iter().map(|&pixel| luma(pixel)));
        }
        let mut blur = |plane: &Plane, into: &mut Plane| {
            plane.along_rows(&taps, blurred);
            blurred.along_columns(&taps, into);
        };
        blur(a, mean_a);
        blur(b, mean_b);
        pace.after(a.values.len()).await;
        for (one, other, mean) in [(&*a, &*a, &mut *mean_aa), (b, b, mean_bb), (a, b, mean_ab)] {
            let pairs = one.values.iter().zip(&other.values);
            products.set(width, pairs.map(|(one, other)| one * other));
            blur(products, mean);
            pace.after(products.values.len()).await;
        }
        let (c1, c2) = ((0.01_f32 * 255.0).powi(2), (0.03_f32 * 255.0).powi(2));
        let means = mean_a.values.iter().zip(&mean_b.values);
        let squares = mean_aa.values.iter().zip(&mean_bb.values);
        let all = means.zip(squares).zip(&mean_ab.values);
        values.clear();
        values.extend(all.map(|(((a, b), (mean_aa, mean_bb)), mean_ab)| {
            let (aa, bb, ab) = (a * a, b * b, a * b);
            let variances = (mean_aa - aa) + (mean_bb - bb);
            let covariance = mean_ab - ab;
            (ab + ab + c1) * (covariance + covariance + c2) / ((aa + bb + c1) * (variances + c2))
        }));
    }
}

/// What is worked out for one tile after the other.
#[derive(Default)]
struct Planes {
    pixels: Vec<Pixel>,
    lumas: [Plane; 2],
    products: Plane,
    blurred: Plane,
    /// Of A, B, A², B² and AB.
    means: [Plane; 5],
}

/// Luma of ITU-R BT.601, 0..=255.
#[inline]
pub(super) fn luma([r, g, b, _]: Pixel) -> f32 {
    0.299 * f32::from(r) + 0.587 * f32::from(g) + 0.114 * f32::from(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::{alike, correlated, filled, noise, painted};

    #[test]
    fn equal_pictures_are_alike_by_exactly_one() {
        let [a, _] = alike(30, 20);
        let pair = &Pair::new(&a, &a, &[]).unwrap();
        assert_eq!(pair.ssim(), Some(1.0));
        let by_the_formulas = at_once(|pace| async move { pair.ssim_map(&pace).await });
        assert!(by_the_formulas.iter().all(|&value| value == 1.0));
    }

    /// The same formulas on the pictures as a whole, with every sum in the same order.
    #[test]
    fn tile_by_tile_every_pixel_has_exactly_the_value_of_the_whole() {
        let [a, b] = [1, 2].map(|seed| noise(530, 200, 0..=255, seed));
        let pair = &Pair::new(&a, &b, &[]).unwrap();
        let taps = normalized(gaussian(SIGMA, WINDOW / 2));
        let blur = |values: Vec<f32>| {
            let rows = correlated(&values, 530, &taps, true);
            correlated(&rows, 530, &taps, false)
        };
        let [a, b] = [pair.a(), pair.b()].map(|pixels| {
            let lumas = pixels.iter().map(|&pixel| luma(pixel));
            lumas.collect::<Vec<f32>>()
        });
        let product = |a: &[f32], b: &[f32]| blur(a.iter().zip(b).map(|(a, b)| a * b).collect());
        let (aa, bb, ab) = (product(&a, &a), product(&b, &b), product(&a, &b));
        let (a, b) = (blur(a), blur(b));
        let (c1, c2) = ((0.01_f32 * 255.0).powi(2), (0.03_f32 * 255.0).powi(2));
        let expected = (0..a.len()).map(|i| {
            let squares = [a[i] * a[i], b[i] * b[i], a[i] * b[i]];
            let variances = (aa[i] - squares[0]) + (bb[i] - squares[1]);
            let covariance = ab[i] - squares[2];
            (squares[2] + squares[2] + c1) * (covariance + covariance + c2)
                / ((squares[0] + squares[1] + c1) * (variances + c2))
        });
        assert!(
            at_once(|pace| async move { pair.ssim_map(&pace).await })
                == expected.collect::<Vec<f32>>()
        );
    }

    /// scikit-image 0.26 with the paper's Gaussian window on the same lumas.
    #[test]
    fn the_value_agrees_with_another_program() {
        let [a, b] = alike(64, 48);
        let ssim = Pair::new(&a, &b, &[]).unwrap().ssim().unwrap();
        assert!((ssim - 0.949_045_860).abs() < 1e-6, "{ssim}");
    }

    /// Without variance only the first factor of equation (13) is left.
    #[test]
    fn even_pictures_differ_by_their_means_alone() {
        let (a, b) = (
            filled(12, 12, [100, 100, 100, 255]),
            filled(12, 12, [50, 50, 50, 255]),
        );
        let ssim = Pair::new(&a, &b, &[]).unwrap().ssim().unwrap();
        let expected = (2.0 * 100.0 * 50.0 + 6.5025) / (100.0 * 100.0 + 50.0 * 50.0 + 6.5025);
        assert!((ssim - expected).abs() < 1e-5, "{ssim}");
    }

    #[test]
    fn a_picture_smaller_than_the_window_has_no_value() {
        let a = filled(40, 10, [9; 4]);
        assert_eq!(Pair::new(&a, &a, &[]).unwrap().ssim(), None);
    }

    #[test]
    fn an_ignored_area_counts_as_equal_and_its_windows_are_left_out() {
        let a = filled(40, 20, [90, 90, 90, 255]);
        let b = painted(40, 20, |x, y| {
            let gray = if x < 20 { (y * 9) as u8 } else { 90 };
            [gray, gray, gray, 255]
        });
        let left = "0,0,20,20".parse().unwrap();
        assert_eq!(Pair::new(&a, &b, &[left]).unwrap().ssim(), Some(1.0));
        let right = "20,0,20,20".parse().unwrap();
        assert!(Pair::new(&a, &b, &[right]).unwrap().ssim() < Some(0.9));
    }

    #[test]
    fn windows_whose_middle_is_ignored_are_no_part_of_the_mean() {
        let a = filled(40, 20, [90, 90, 90, 255]);
        let b = painted(40, 20, |x, y| {
            let gray = if x < 20 { (y * 9) as u8 } else { 90 };
            [gray, gray, gray, 255]
        });
        let mean = |ignore: &[_]| Pair::new(&a, &b, ignore).unwrap().ssim().unwrap();
        // Of 30×10 windows the 10×10 from column 25 on see equal pixels alone, and have the value 1.
        let kept = mean(&["25,0,15,20".parse().unwrap()]);
        assert!(
            (300.0 * mean(&[]) - (200.0 * kept + 100.0)).abs() < 1e-3,
            "{kept}"
        );
    }
}
