//! Screenshots of the Virtual Mannequin's page, which show its keyframes below the view.

use super::page_figure::is_of_sky;
use crate::compare::Area;
use crate::geometry::Picture;
use image::RgbaImage;
use image::imageops::thumbnail;
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

/// Width and height of the page's view, in its pixels.
const VIEW: [u32; 2] = [800, 600];
/// How many pixels of a picture are one of the page, across, in screenshots of dense screens and of a page that is made larger.
const SCALES: [f64; 9] = [1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0];

/// Whether a picture has the sky of the page along its upper edge: it may be a screenshot of the page's view alone.
pub(super) fn has_sky_of_page(picture: &Picture) -> bool {
    let width = picture.width as usize;
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    // Below a frame.
    let rows = pixels.get(width..4 * width).unwrap_or_default();
    let of_sky = rows.iter().filter(|[r, g, b, _]| is_of_sky([*r, *g, *b]));
    !rows.is_empty() && of_sky.count() as f64 >= MOST * rows.len() as f64
}

/// The part of a screenshot of the page that shows its view, in the page's pixels, whatever of a browser and of the screen is
/// around the page; `None` for another picture. The strip of keyframes is where a row of its color as long as the page is wide
/// begins below rows without.
pub(super) fn view_of_page(picture: &Picture) -> Option<Picture> {
    let width = picture.width as usize;
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let rows: Vec<&[[u8; 4]]> = pixels.chunks_exact(width.max(1)).collect();
    let share = |rows: &[&[[u8; 4]]], columns: Range<usize>| {
        let of_rows = rows.iter().flat_map(|row| &row[columns.clone()]);
        let of_strip = of_rows.filter(|pixel| is_of_strip(pixel)).count();
        of_strip as f64 / (rows.len() * columns.len()).max(1) as f64
    };
    let view_above = |bottom: usize| -> Option<(Area, f64)> {
        let columns = longest_in_strip(rows[bottom])?;
        let scale = scale_of(columns.len())?;
        let [wide, high] = VIEW.map(|size| (f64::from(size) * scale).round() as usize);
        let top = bottom.checked_sub(high)?;
        let [from, to] =
            [EMPTY_ROWS.start, EMPTY_ROWS.end].map(|row| (row as f64 * scale) as usize);
        let in_strip = share(rows.get(bottom + from..bottom + to)?, columns.clone());
        let in_view = share(
            &rows[bottom.saturating_sub(LAST_ROWS)..bottom],
            columns.clone(),
        );
        let view = Area {
            x: columns.start as u32,
            y: top as u32,
            width: wide as u32,
            height: high as u32,
        };
        (in_strip >= MOST && in_view <= LEAST).then_some((view, scale))
    };
    let (view, scale) = (0..rows.len()).find_map(view_above)?;
    let rgba = (view.y..view.y + view.height).flat_map(|y| {
        let row = rows[y as usize];
        // What is beyond the last column is like it.
        (view.x..view.x + view.width).flat_map(move |x| row[(x as usize).min(width - 1)])
    });
    let found = RgbaImage::from_raw(view.width, view.height, rgba.collect())?;
    let of_page = match scale == 1.0 {
        true => found,
        false => thumbnail(&found, VIEW[0], VIEW[1]),
    };
    Some(Picture {
        width: VIEW[0],
        height: VIEW[1],
        rgba: of_page.into_raw(),
    })
}

/// The longest part of a row that has the strip's color, if there is one.
fn longest_in_strip(row: &[[u8; 4]]) -> Option<Range<usize>> {
    let mut longest = 0..0;
    let mut begin = 0;
    for at in 0..=row.len() {
        if row.get(at).is_none_or(|pixel| !is_of_strip(pixel)) {
            if at - begin > longest.len() {
                longest = begin..at;
            }
            begin = at + 1;
        }
    }
    (!longest.is_empty()).then_some(longest)
}

/// How many pixels of a picture are one of the page whose strip is so wide in it, but for the frame at its sides.
fn scale_of(width: usize) -> Option<f64> {
    let is_of = |scale: &&f64| {
        let lacks = f64::from(VIEW[0]) * **scale - width as f64;
        (-1.0..=2.0 * **scale + 1.0).contains(&lacks)
    };
    SCALES.iter().find(is_of).copied()
}

fn is_of_strip([red, green, blue, _]: &[u8; 4]) -> bool {
    red == green && green == blue && COLOR.contains(red)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRIP: u32 = 200;

    /// A screenshot of the page whose view is light and whose strip is of this gray.
    fn screenshot((width, height): (u32, u32), strip: u8) -> Picture {
        let rows = (0..height).flat_map(|row| {
            let is_of_view = row + STRIP < height;
            let gray = if is_of_view { 174 } else { strip };
            vec![[gray, gray, gray, 255]; width as usize].into_flattened()
        });
        Picture {
            width,
            height,
            rgba: rows.collect(),
        }
    }

    const PAGE: (u32, u32) = (VIEW[0], VIEW[1] + STRIP);

    fn at(x: u32, y: u32) -> usize {
        4 * (VIEW[0] * y + x) as usize
    }

    #[test]
    fn only_a_screenshot_with_the_strip_of_keyframes_is_cut() {
        for gray in [25, 26] {
            let view = view_of_page(&screenshot(PAGE, gray)).expect("a strip");
            assert_eq!([view.width, view.height], VIEW);
            assert!(view.rgba.chunks(4).all(|pixel| pixel[0] == 174));
        }
        for (height, gray) in [
            (PAGE.1, 90),
            (PAGE.1 - 1, 26),
            (STRIP, 26),
            (20, 26),
            (0, 26),
        ] {
            assert!(
                view_of_page(&screenshot((VIEW[0], height), gray)).is_none(),
                "{height} {gray}"
            );
        }
        // As wide as no page is shown.
        assert!(view_of_page(&screenshot((700, PAGE.1), 26)).is_none());
        let mut dark = screenshot(PAGE, 26);
        dark.rgba
            .chunks_mut(4)
            .for_each(|pixel| pixel[..3].fill(26));
        assert!(view_of_page(&dark).is_none());
        // Teal is the background of the view.
        let mut teal = screenshot(PAGE, 26);
        teal.rgba.chunks_mut(4).for_each(|pixel| pixel[1] = 95);
        assert!(view_of_page(&teal).is_none());
    }

    #[test]
    fn beside_the_frame_of_the_page_its_view_begins_one_pixel_farther_in_both_directions() {
        let mut framed = screenshot((PAGE.0, PAGE.1 + 1), 26);
        framed.rgba.truncate(4 * (PAGE.0 * PAGE.1) as usize);
        framed.height = PAGE.1;
        for x in 0..PAGE.0 {
            framed.rgba[at(x, 0)..][..3].fill(170);
        }
        for y in 0..PAGE.1 {
            framed.rgba[at(0, y)..][..3].fill(170);
        }
        framed.rgba[at(1, 1)..][..3].fill(9);
        framed.rgba[at(VIEW[0] - 1, VIEW[1])..][..3].fill(7);
        let view = view_of_page(&framed).expect("a strip");
        assert_eq!([view.width, view.height], VIEW);
        let last = at(VIEW[0] - 1, VIEW[1] - 1);
        assert_eq!((view.rgba[0], view.rgba[last]), (9, 7));
    }

    #[test]
    fn a_picture_shows_the_sky_of_the_page_where_its_upper_edge_is_teal() {
        let mut picture = screenshot(PAGE, 26);
        assert!(!has_sky_of_page(&picture));
        for y in 0..5 {
            for x in 0..PAGE.0 {
                picture.rgba[at(x, y)..][..3].copy_from_slice(&[0, 95, 95]);
            }
        }
        assert!(has_sky_of_page(&picture));
        for x in 100..160 {
            picture.rgba[at(x, 2)..][..3].fill(26);
        }
        assert!(!has_sky_of_page(&picture), "something is before it");
        assert!(!has_sky_of_page(&screenshot((VIEW[0], 0), 26)));
    }
}
