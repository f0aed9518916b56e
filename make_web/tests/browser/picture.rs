//! Pictures of the page.

use image::RgbImage;
use std::collections::HashSet;

/// A part of the page: left, top, right and bottom in points.
pub type Part = (u32, u32, u32, u32);

/// Fails if nearly all of `part` has one color.
pub fn assert_not_blank(picture: &RgbImage, part: Part) {
    let colors: HashSet<[u8; 3]> = pixels(picture, part).collect();
    assert!(colors.len() > 200, "only {} colors", colors.len());
}

/// Share of the pixels of `part` in which two pictures differ visibly, from 0 to 1.
pub fn difference(one: &RgbImage, other: &RgbImage, part: Part) -> f32 {
    assert_eq!(one.dimensions(), other.dimensions());
    let pairs = pixels(one, part).zip(pixels(other, part));
    let differs = |(a, b): &([u8; 3], [u8; 3])| (0..3).any(|i| a[i].abs_diff(b[i]) > 8);
    let count = pixels(one, part).count().max(1);
    pairs.filter(differs).count() as f32 / count as f32
}

fn pixels(picture: &RgbImage, (left, top, right, bottom): Part) -> impl Iterator<Item = [u8; 3]> {
    (top..bottom).flat_map(move |y| (left..right).map(move |x| picture.get_pixel(x, y).0))
}
