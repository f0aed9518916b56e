//! Pictures that the tests of this layer share.

use crate::geometry::Picture;

/// A picture of one color.
pub fn filled(width: u32, height: u32, color: [u8; 4]) -> Picture {
    painted(width, height, |_, _| color)
}

/// An opaque gray picture from its values, row by row.
pub fn from_gray(width: u32, values: &[u8]) -> Picture {
    let height = values.len() as u32 / width;
    painted(width, height, |x, y| {
        let gray = values[(y * width + x) as usize];
        [gray, gray, gray, 255]
    })
}

/// A picture from the color of each pixel at column and row.
pub fn painted(width: u32, height: u32, color: impl Fn(u32, u32) -> [u8; 4]) -> Picture {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Picture {
        width,
        height,
        rgba: places.flat_map(|(x, y)| color(x, y)).collect(),
    }
}

/// A picture of noise whose channels lie within `values`, another for each `seed`.
pub fn noise(width: u32, height: u32, values: std::ops::RangeInclusive<u8>, seed: u64) -> Picture {
    let mut state = seed;
    let (least, steps) = (
        *values.start(),
        u64::from(values.end() - values.start()) + 1,
    );
    let mut channel = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        least + ((state >> 33) % steps) as u8
    };
    let pixels = (0..width * height).flat_map(|_| [channel(), channel(), channel(), 255]);
    Picture {
        width,
        height,
        rgba: pixels.collect(),
    }
}

/// Each of `values`, rows of `width`, replaced by the sum of those along its row, or else its
/// column, times the taps, in their order; the last values go on beyond the ends.
pub fn correlated(values: &[f32], width: usize, taps: &[f32], along_rows: bool) -> Vec<f32> {
    let (reach, last_row) = (taps.len() / 2, values.len() / width - 1);
    let at = |index: usize, offset: usize| {
        let (x, y) = (index % width, index / width);
        let moved = |at: usize, last: usize| (at + offset).saturating_sub(reach).min(last);
        if along_rows {
            y * width + moved(x, width - 1)
        } else {
            moved(y, last_row) * width + x
        }
    };
    let sum = |index: usize| {
        let products = taps
            .iter()
            .enumerate()
            .map(|(k, tap)| tap * values[at(index, k)]);
        products.fold(0.0, |sum, product| sum + product)
    };
    (0..values.len()).map(sum).collect()
}

/// Two pictures that resemble each other, by arithmetic that other programs can repeat: a base
/// of colored ramps, and the same with every third column darker by up to 31.
pub fn alike(width: u32, height: u32) -> [Picture; 2] {
    let base = |x: u32, y: u32| {
        [
            (x * 7 + y * 3) % 256,
            (x * 2 + y * 11 + x * y / 5) % 256,
            (x * x / 4 + y * 5) % 256,
        ]
    };
    let a = painted(width, height, |x, y| {
        let [r, g, b] = base(x, y);
        [r as u8, g as u8, b as u8, 255]
    });
    let b = painted(width, height, |x, y| {
        let darker = if x % 3 == 0 { (x + 2 * y) % 32 } else { 0 };
        let [r, g, b] = base(x, y).map(|channel| channel.saturating_sub(darker) as u8);
        [r, g, b, 255]
    });
    [a, b]
}
