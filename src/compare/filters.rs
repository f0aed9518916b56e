use std::iter::repeat_n;
use std::ops::Range;

/// Values that a filter works out at once, in registers of the processor.
const LANES: usize = 32;
/// Sides of a tile. All planes of one stay in the processor's cache.
const TILE: [usize; 2] = [256, 96];

/// One channel of a picture or of a part of one, top row first. Filters put their results into
/// planes that are used again for the next part: memory that is new for each takes longer to get
/// than to fill.
#[derive(Clone, Debug, Default)]
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) values: Vec<f32>,
}

impl Plane {
    /// Makes it a plane of so many columns with these values.
    pub(super) fn set(&mut self, width: usize, values: impl Iterator<Item = f32>) {
        self.width = width;
        self.values.clear();
        self.values.extend(values);
    }

    /// Correlates every row with `taps` (odd in number, the middle one on the pixel itself). As
    /// many columns as the taps reach are left out at both ends.
    pub(super) fn along_rows(&self, taps: &[f32], into: &mut Self) {
        let width = self.width + 1 - taps.len();
        into.resize(width, self.values.len() / self.width);
        let rows = self.values.chunks_exact(self.width);
        for (row, sums) in rows.zip(into.values.chunks_exact_mut(width)) {
            correlate(sums, row, 1, taps);
        }
    }

    /// The same along every column, with rows that are left out.
    pub(super) fn along_columns(&self, taps: &[f32], into: &mut Self) {
        into.resize(self.width, self.values.len() / self.width + 1 - taps.len());
        for (y, sums) in into.values.chunks_exact_mut(self.width).enumerate() {
            correlate(sums, &self.values[y * self.width..], self.width, taps);
        }
    }

    /// Every value changed, without so many rows and columns at each side.
    pub(super) fn inner(&self, rim: usize, change: impl Fn(f32) -> f32, into: &mut Self) {
        into.width = self.width - 2 * rim;
        into.values.clear();
        let rows = self.values.chunks_exact(self.width);
        let inner = rows.len() - 2 * rim;
        for row in rows.skip(rim).take(inner) {
            let values = row[rim..self.width - rim].iter();
            into.values.extend(values.map(|&value| change(value)));
        }
    }

    /// Makes it a plane of so many columns and rows; new values are 0.
    pub(super) fn resize(&mut self, width: usize, rows: usize) {
        self.width = width;
        self.values.resize(width * rows, 0.0);
    }
}

/// Sets each of `sums` to the sum of the values from its place on, `step` apart, times the taps,
/// added in the order of the taps.
fn correlate(sums: &mut [f32], values: &[f32], step: usize, taps: &[f32]) {
    let length = sums.len();
    let mut start = 0;
    while start < length {
        if let Some(lanes) = sums.get_mut(start..start + LANES) {
            let mut of_lanes = [0.0; LANES];
            for (offset, &tap) in taps.iter().enumerate() {
                let from = start + offset * step;
                let values = &values[from..from + LANES];
                for (sum, &value) in of_lanes.iter_mut().zip(values) {
                    *sum += tap * value;
                }
            }
            lanes.copy_from_slice(&of_lanes);
            start += LANES;
        } else if length >= LANES {
            // The last ones once more, to fill the lanes.
            start = length - LANES;
        } else {
            for (place, sum) in sums.iter_mut().enumerate() {
                let values = values[place..].iter().step_by(step);
                *sum = taps.iter().zip(values).fold(0.0, |sum, (t, v)| sum + t * v);
            }
            return;
        }
    }
}

/// A part of a picture that is worked out by itself, with what filters need around it.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    /// Columns and rows.
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

impl Tile {
    /// Tiles that cover a picture of `width` columns and `height` rows.
    pub(super) fn of(width: usize, height: usize) -> impl Iterator<Item = Self> {
        let ranges = |length: usize, side: usize| {
            let starts = (0..length).step_by(side);
            starts.map(move |start| start..(start + side).min(length))
        };
        ranges(height, TILE[1]).flat_map(move |rows| {
            let columns = ranges(width, TILE[0]);
            columns.map(move |columns| Self {
                columns,
                rows: rows.clone(),
            })
        })
    }

    /// Sets `values` to those of `pixels`, rows of `width`, in the tile and `rim` around it, row
    /// by row. Beyond its ends the picture goes on as its last pixels.
    pub(super) fn with_rim<T: Copy>(
        &self,
        pixels: &[T],
        width: usize,
        rim: usize,
        values: &mut Vec<T>,
    ) {
        let last_row = pixels.len() / width - 1;
        let Range { start, end } = self.columns;
        let (first, last) = (start.saturating_sub(rim), (end + rim).min(width));
        let rows = self.rows.start..self.rows.end + 2 * rim;
        values.clear();
        for y in rows.map(|y| y.saturating_sub(rim).min(last_row)) {
            let row = &pixels[y * width..][..width];
            values.extend(repeat_n(row[0], first + rim - start));
            values.extend_from_slice(&row[first..last]);
            values.extend(repeat_n(row[width - 1], end + rim - last));
        }
    }

    /// Puts the tile's `values`, row by row, into their places in `all`, rows of `width`.
    pub(super) fn put<T: Copy>(&self, values: &[T], all: &mut [T], width: usize) {
        let rows = values.chunks_exact(self.columns.len());
        for (y, row) in self.rows.clone().zip(rows) {
            all[y * width..][self.columns.clone()].copy_from_slice(row);
        }
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

    const VALUES: [f32; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

    /// The plane of 3×2 values with so many more around it as tiles have.
    fn with_rim(values: [f32; 6], rim: usize) -> Plane {
        let whole = Tile {
            columns: 0..3,
            rows: 0..2,
        };
        let mut plane = Plane {
            width: 3 + 2 * rim,
            ..Plane::default()
        };
        whole.with_rim(&values, 3, rim, &mut plane.values);
        plane
    }

    fn along_rows(plane: &Plane, taps: &[f32]) -> Plane {
        let mut into = Plane::default();
        plane.along_rows(taps, &mut into);
        into
    }

    fn along_columns(plane: &Plane, taps: &[f32]) -> Plane {
        let mut into = Plane::default();
        plane.along_columns(taps, &mut into);
        into
    }

    #[test]
    fn rows_go_on_as_their_last_value() {
        let rows = along_rows(&with_rim(VALUES, 1), &[1.0, 10.0, 100.0]);
        assert_eq!(rows.width, 3);
        let values = [211.0, 421.0, 442.0, 1688.0, 3368.0, 3536.0];
        assert_eq!(rows.values[3..9], values);
    }

    #[test]
    fn columns_go_on_as_their_last_value() {
        let columns = along_columns(&with_rim(VALUES, 1), &[1.0, 10.0, 100.0]);
        assert_eq!(columns.width, 5);
        let values = [811.0, 1622.0, 3244.0, 881.0, 1762.0, 3524.0];
        assert_eq!(columns.values[1..4], values[..3]);
        assert_eq!(columns.values[6..9], values[3..]);
    }

    #[test]
    fn a_window_wider_than_the_plane_keeps_a_constant() {
        let taps = normalized(gaussian(2.0, 9));
        let blurred = along_columns(&along_rows(&with_rim([3.0; 6], 9), &taps), &taps);
        assert_eq!((blurred.width, blurred.values.len()), (3, 6));
        for value in blurred.values {
            assert!((value - 3.0).abs() < 1e-6);
        }
    }

    #[test]
    fn the_inner_part_of_a_plane_has_no_rim() {
        let mut inner = Plane::default();
        with_rim(VALUES, 2).inner(2, |value| 10.0 * value, &mut inner);
        assert_eq!(
            (inner.width, inner.values),
            (3, VALUES.map(|value| 10.0 * value).to_vec())
        );
    }

    #[test]
    fn sums_are_added_in_the_order_of_the_taps_however_long_a_row_is() {
        let taps = [0.3, 1e4, -0.7, 2e-5, 0.9];
        for length in [1, 5, 31, 32, 33, 64, 100] {
            let values: Vec<f32> = (0..length + 4).map(|i| (i as f32 * 0.37).sin()).collect();
            let expected = (0..length).map(|place| {
                let values = &values[place..];
                let products = taps.iter().zip(values).map(|(tap, value)| tap * value);
                products.fold(0.0, |sum, product| sum + product)
            });
            let expected: Vec<f32> = expected.collect();
            let mut plane = Plane {
                width: values.len(),
                values,
            };
            assert_eq!(along_rows(&plane, &taps).values, expected, "{length}");
            plane.width = 1;
            assert_eq!(along_columns(&plane, &taps).values, expected, "{length}");
        }
    }

    #[test]
    fn tiles_cover_a_picture_once_and_have_the_last_pixels_around_it() {
        let (width, height) = (TILE[0] * 2 + 3, TILE[1] + 1);
        let pixels: Vec<u32> = (0..(width * height) as u32).collect();
        let mut all = vec![u32::MAX; pixels.len()];
        for tile in Tile::of(width, height) {
            let mut with_rim = vec![7; 5];
            tile.with_rim(&pixels, width, 2, &mut with_rim);
            let row = tile.columns.len() + 4;
            for (at, value) in with_rim.iter().enumerate() {
                let place = |start: usize, at: usize, end: usize| {
                    let place = (start + at) as i64 - 2;
                    place.clamp(0, end as i64 - 1) as usize
                };
                let x = place(tile.columns.start, at % row, width);
                let y = place(tile.rows.start, at / row, height);
                assert_eq!(*value as usize, y * width + x);
            }
            let inner = with_rim.chunks_exact(row).skip(2).take(tile.rows.len());
            let inner: Vec<u32> = inner
                .flat_map(|row| &row[2..row.len() - 2])
                .copied()
                .collect();
            tile.put(&inner, &mut all, width);
        }
        assert_eq!(all, pixels);
    }
}
