//! Pictures with the few colors that a GIF can hold.

use quantette::color_space::{oklab_to_srgb8, srgb8_to_oklab};
use quantette::deps::palette::Srgb;
use quantette::wu::{BinnerF32x3, WuF32x3};
use quantette::{ImageBuf, PaletteSize};
use std::collections::HashSet;

/// Names the ranges of a binner of any size.
type Bins = BinnerF32x3<1, 1, 1>;

/// Colors of a GIF beside the transparent one.
const COLORS: u8 = 255;

/// The pixels of a picture of `width` times `height`, RGBA row by row, in at most 255 colors, by Wu's method: small
/// parts in a color of their own keep it, where the neural network that encoders of GIF bring along takes others. Not
/// dithered, so that what stands still in an animation looks still. Pixels that are wholly transparent stay so, the
/// others become opaque. One that has no more colors stays as it is. `None` if the size is that of other pixels.
pub(super) fn in_few_colors(rgba: &[u8], width: u32, height: u32) -> Option<Vec<u8>> {
    let pixels = rgba.chunks_exact(4);
    let colors = pixels
        .clone()
        .map(|pixel| Srgb::new(pixel[0], pixel[1], pixel[2]));
    let picture = ImageBuf::new(width, height, colors.collect()).ok()?;
    let reduced = if are_few(picture.as_slice()) {
        picture.as_slice().to_vec()
    } else {
        let mut colors = srgb8_to_oklab(picture.as_slice());
        // Brightness in fine steps: gradients of gray would have some twenty shades with the steps that are usual.
        let bins = BinnerF32x3::<200, 32, 32>::new(Bins::OKLAB_COMPONENT_RANGES_FROM_SRGB8);
        let found = WuF32x3::run_slice(&colors, bins).ok()?;
        found
            .color_map(PaletteSize::from_u8_clamped(COLORS))
            .map_slice_in_place(&mut colors);
        oklab_to_srgb8(&colors)
    };
    let pixel = |(color, before): (&Srgb<u8>, &[u8])| match before[3] {
        0 => [0; 4],
        _ => [color.red, color.green, color.blue, 255],
    };
    Some(reduced.iter().zip(pixels).flat_map(pixel).collect())
}

/// Whether there is room for all of these colors.
fn are_few(colors: &[Srgb<u8>]) -> bool {
    let mut known = HashSet::new();
    let is_room = |color: &Srgb<u8>| {
        known.insert((color.red, color.green, color.blue));
        known.len() <= usize::from(COLORS)
    };
    colors.iter().all(is_room)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_pixels_in_a_color_of_their_own_keep_it_beside_many_shades_of_others() {
        let (width, height) = (256, 256);
        let red = [200, 20, 30, 255];
        let is_red = |x: u32, y: u32| (100..106).contains(&x) && (100..106).contains(&y);
        let pixel = |x: u32, y: u32| match (x, y) {
            _ if is_red(x, y) => red,
            (0..4, 0..4) => [9, 9, 9, 0],
            _ => [
                (x / 4 + 60) as u8,
                (x / 3 + y / 4 + 40) as u8,
                (y / 2 + 90) as u8,
                255,
            ],
        };
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let rgba: Vec<u8> = all.clone().flat_map(|(x, y)| pixel(x, y)).collect();
        let reduced = in_few_colors(&rgba, width, height).unwrap();
        let colors: HashSet<&[u8]> = reduced.chunks_exact(4).collect();
        assert!(colors.len() <= 256, "{}", colors.len());
        for ((x, y), reduced) in all.zip(reduced.chunks_exact(4)) {
            let expected = pixel(x, y);
            if expected[3] == 0 {
                assert_eq!(reduced, [0; 4]);
                continue;
            }
            let apart = (0..3).map(|at| expected[at].abs_diff(reduced[at])).max();
            let bound = if is_red(x, y) { 4 } else { 20 };
            assert!(
                apart <= Some(bound),
                "({x}, {y}): {reduced:?}, {expected:?}"
            );
        }
        assert_eq!(in_few_colors(&rgba, width, 2), None);
    }
}
