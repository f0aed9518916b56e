use super::filters::{Plane, gaussian, normalized};
use super::pair::{Pair, Pixel};

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
        let width = self.width() as usize;
        let height = self.height() as usize;
        if width < WINDOW || height < WINDOW {
            return None;
        }
        let map = if self.a() == self.b() {
            // What the formulas say as well, after many filters.
            vec![1.0; self.a().len()]
        } else {
            self.ssim_map()
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
        }
        (count > 0).then(|| sum / count as f64)
    }

    /// Equations (13) to (16) of the paper at each pixel.
    fn ssim_map(&self) -> Vec<f32> {
        let taps = normalized(gaussian(SIGMA, WINDOW / 2));
        let blur = |plane: &Plane| plane.along_rows(&taps).along_columns(&taps).values;
        let width = self.width() as usize;
        let luma = |pixels: &[Pixel]| Plane {
            width,
            values: pixels.iter().map(|&pixel| luma(pixel)).collect(),
        };
        let (a, b) = (luma(self.a()), luma(self.b()));
        let product = Plane {
            width,
            values: a.values.iter().zip(&b.values).map(|(a, b)| a * b).collect(),
        };
        let mean_a = blur(&a);
        let mean_b = blur(&b);
        let mean_aa = blur(&a.map(|value| value * value));
        let mean_bb = blur(&b.map(|value| value * value));
        let mean_ab = blur(&product);
        let (c1, c2) = ((0.01_f32 * 255.0).powi(2), (0.03_f32 * 255.0).powi(2));
        (0..mean_a.len())
            .map(|i| {
                let (a, b) = (mean_a[i], mean_b[i]);
                let (aa, bb, ab) = (a * a, b * b, a * b);
                let variances = (mean_aa[i] - aa) + (mean_bb[i] - bb);
                let covariance = mean_ab[i] - ab;
                (ab + ab + c1) * (covariance + covariance + c2)
                    / ((aa + bb + c1) * (variances + c2))
            })
            .collect()
    }
}

/// Luma of ITU-R BT.601, 0..=255.
pub(super) fn luma([r, g, b, _]: Pixel) -> f32 {
    0.299 * f32::from(r) + 0.587 * f32::from(g) + 0.114 * f32::from(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::{alike, filled, painted};

    #[test]
    fn equal_pictures_are_alike_by_exactly_one() {
        let [a, _] = alike(30, 20);
        let pair = Pair::new(&a, &a, &[]).unwrap();
        assert_eq!(pair.ssim(), Some(1.0));
        let by_the_formulas = pair.ssim_map();
        assert!(by_the_formulas.iter().all(|&value| value == 1.0));
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
