//! Screenshots of the Virtual Mannequin's page, which show its keyframes below the view.

use crate::geometry::Picture;
use crate::ui::mannequin_panels;
use std::ops::{Range, RangeInclusive};

/// Rows at the top of the strip in which nothing but its color is drawn, below the frame of the view, …
const EMPTY_ROWS: Range<usize> = 2..40;
/// … of which this share has that color at least: all but the frame at the sides.
const MOST: f64 = 0.98;
/// Rows at the bottom of the view, of which the floor leaves no more than this share in that color, which is also that of
/// the background in the course's pictures.
const LAST_ROWS: usize = 8;
const LEAST: f64 = 0.1;
/// The strip's color, which browsers draw a little differently.
const COLOR: RangeInclusive<u8> = 24..=28;

/// Color of the frame around the page's window, of which a screenshot has the upper and the left line.
const FRAME: RangeInclusive<u8> = 165..=175;

/// The part of a screenshot of the page that shows its view; `None` for another picture.
pub(super) fn view_of_page(picture: &Picture) -> Option<Picture> {
    let width = picture.width as usize;
    let [strip] = mannequin_panels((picture.width, picture.height));
    let of_view = Some(strip.y as usize).filter(|&rows| rows > 0)?;
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let is_of_strip =
        |[red, green, blue, _]: &&[u8; 4]| red == green && green == blue && COLOR.contains(red);
    let share = |rows: Range<usize>| {
        let pixels = pixels.get(rows.start * width..rows.end * width)?;
        let of_strip = pixels.iter().filter(is_of_strip).count();
        Some(of_strip as f64 / pixels.len().max(1) as f64)
    };
    let in_strip = share(of_view + EMPTY_ROWS.start..of_view + EMPTY_ROWS.end)?;
    let in_view = share(of_view.saturating_sub(LAST_ROWS)..of_view)?;
    if in_strip < MOST || in_view > LEAST {
        return None;
    }
    let shift = usize::from(is_framed(pixels, width, of_view));
    let rgba = (0..of_view).flat_map(|y| {
        let row = &pixels[(y + shift) * width..(y + shift + 1) * width];
        // What is beyond the last column is like it.
        (0..width).flat_map(move |x| row[(x + shift).min(width - 1)])
    });
    Some(Picture {
        width: picture.width,
        height: of_view as u32,
        rgba: rgba.collect(),
    })
}

/// Whether the first column and row are those of the frame around the page's window, so that its view begins beside them.
fn is_framed(pixels: &[[u8; 4]], width: usize, height: usize) -> bool {
    let is_frame =
        |[red, green, blue, _]: &&[u8; 4]| red == green && green == blue && FRAME.contains(red);
    let side = pixels.iter().step_by(width.max(1)).take(height);
    let framed = pixels[..width].iter().chain(side).filter(is_frame).count();
    framed as f64 >= MOST * (width + height) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRIP: u32 = 200;

    fn screenshot(height: u32, strip: u8) -> Picture {
        let rows = (0..height).flat_map(|row| {
            let is_of_view = row + STRIP <= height;
            let gray = if is_of_view { 174 } else { strip };
            [[gray, gray, gray, 255]; 30].into_iter().flatten()
        });
        Picture {
            width: 30,
            height,
            rgba: rows.collect(),
        }
    }

    #[test]
    fn only_a_screenshot_with_the_strip_of_keyframes_is_cut() {
        for gray in [25, 26] {
            let view = view_of_page(&screenshot(260, gray)).expect("a strip");
            assert_eq!((view.width, view.height), (30, 60));
            assert!(view.rgba.chunks(4).all(|pixel| pixel[0] == 174));
        }
        for (height, gray) in [(260, 90), (200, 26), (20, 26), (0, 26)] {
            assert_eq!(view_of_page(&screenshot(height, gray)), None);
        }
        // Beside a frame the view begins one pixel farther in both directions.
        let mut framed = screenshot(260, 26);
        let at = |x: usize, y: usize| 4 * (30 * y + x);
        for along in 0..60 {
            framed.rgba[at(0, along)..][..3].fill(170);
            framed.rgba[at(along % 30, 0)..][..3].fill(170);
        }
        framed.rgba[at(1, 1)..][..3].fill(9);
        framed.rgba[at(29, 60)..][..3].fill(7);
        let view = view_of_page(&framed).expect("a strip");
        assert_eq!((view.width, view.height), (30, 60));
        assert_eq!((view.rgba[0], view.rgba[at(29, 59)]), (9, 7));
        let mut dark = screenshot(260, 26);
        dark.rgba
            .chunks_mut(4)
            .for_each(|pixel| pixel[..3].fill(26));
        assert_eq!(view_of_page(&dark), None);
        // Teal is the background of the view.
        let mut teal = screenshot(260, 26);
        teal.rgba.chunks_mut(4).for_each(|pixel| pixel[1] = 95);
        assert_eq!(view_of_page(&teal), None);
    }
}
