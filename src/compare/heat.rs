use super::differences::difference;
use super::pair::Pair;
use crate::geometry::Picture;

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
        let colors: [[u8; 4]; 256] = std::array::from_fn(|difference| match difference {
            0 => heat_color(0.0),
            _ => {
                let root = (difference as f32 / 255.0).sqrt();
                heat_color(SMALLEST_HEAT + (1.0 - SMALLEST_HEAT) * root)
            }
        });
        let mut rgba = Vec::with_capacity(4 * self.kept().len());
        for ((&a, &b), &kept) in self.a().iter().zip(self.b()).zip(self.kept()) {
            rgba.extend(if kept {
                colors[usize::from(difference(a, b))]
            } else {
                IGNORED_COLOR
            });
        }
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
    use crate::compare::test_pictures::{filled, from_gray};

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
