/// One channel of a picture, top row first.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) values: Vec<f32>,
}

impl Plane {
    /// The same plane with every value changed.
    pub(super) fn map(&self, change: impl Fn(f32) -> f32) -> Self {
        Self {
            width: self.width,
            values: self.values.iter().map(|&value| change(value)).collect(),
        }
    }

    /// Correlates every row with `taps` (odd in number, the middle one on the pixel itself).
    /// Beyond the ends a row goes on as its last value.
    pub(super) fn along_rows(&self, taps: &[f32]) -> Self {
        let reach = taps.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let mut padded = vec![0.0; self.width + 2 * reach];
        let rows = self.values.chunks_exact(self.width);
        for (row, sums) in rows.zip(values.chunks_exact_mut(self.width)) {
            padded[..reach].fill(row[0]);
            padded[reach..reach + self.width].copy_from_slice(row);
            padded[reach + self.width..].fill(row[self.width - 1]);
            for (offset, &tap) in taps.iter().enumerate() {
                add_scaled(sums, &padded[offset..], tap);
            }
        }
        Self {
            width: self.width,
            values,
        }
    }

    /// The same along every column.
    pub(super) fn along_columns(&self, taps: &[f32]) -> Self {
        let reach = taps.len() / 2;
        let last = self.values.len() / self.width - 1;
        let mut values = vec![0.0; self.values.len()];
        for (y, sums) in values.chunks_exact_mut(self.width).enumerate() {
            for (offset, &tap) in taps.iter().enumerate() {
                let row = (y + offset).saturating_sub(reach).min(last);
                add_scaled(sums, &self.values[row * self.width..], tap);
            }
        }
        Self {
            width: self.width,
            values,
        }
    }
}

fn add_scaled(sums: &mut [f32], values: &[f32], factor: f32) {
    for (sum, value) in sums.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

/// Values of `exp(-x² / 2σ²)` at the whole numbers from `-reach` to `reach`.
pub(super) fn gaussian(sigma: f32, reach: usize) -> Vec<f32> {
    let reach = reach as i32;
    (-reach..=reach)
        .map(|x| (-((x * x) as f32) / (2.0 * sigma * sigma)).exp())
        .collect()
}

/// The taps divided by their sum.
pub(super) fn normalized(taps: Vec<f32>) -> Vec<f32> {
    let sum: f32 = taps.iter().sum();
    taps.into_iter().map(|tap| tap / sum).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane() -> Plane {
        Plane {
            width: 3,
            values: vec![1.0, 2.0, 4.0, 8.0, 16.0, 32.0],
        }
    }

    #[test]
    fn rows_go_on_as_their_last_value() {
        let values = plane().along_rows(&[1.0, 10.0, 100.0]).values;
        assert_eq!(values, [211.0, 421.0, 442.0, 1688.0, 3368.0, 3536.0]);
    }

    #[test]
    fn columns_go_on_as_their_last_value() {
        let values = plane().along_columns(&[1.0, 10.0, 100.0]).values;
        assert_eq!(values, [811.0, 1622.0, 3244.0, 881.0, 1762.0, 3524.0]);
    }

    #[test]
    fn a_window_wider_than_the_plane_keeps_a_constant() {
        let flat = plane().map(|_| 3.0);
        let taps = normalized(gaussian(2.0, 9));
        for value in flat.along_rows(&taps).along_columns(&taps).values {
            assert!((value - 3.0).abs() < 1e-6);
        }
    }
}
