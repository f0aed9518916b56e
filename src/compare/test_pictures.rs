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
