//! Screenshots of the Virtual Mannequin's page, which show its keyframes below the view.

use super::page_view::is_of_sky;
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
const VIEW: [usize; 2] = [800, 600];
/// Height of the strip below it.
const STRIP: usize = 200;
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
    let found_at = |bottom: usize| -> Option<Found> {
        let columns = longest_in_strip(rows[bottom])?;
        let found = Found::of_size((width, rows.len()), columns.clone(), bottom)?;
        let [from, to] = [EMPTY_ROWS.start, EMPTY_ROWS.end].map(|row| scaled(row, found.scale));
        let in_strip = share(rows.get(bottom + from..bottom + to)?, columns.clone());
        let last_rows = &rows[bottom.saturating_sub(LAST_ROWS)..bottom];
        let in_view = share(last_rows, columns);
        (in_strip >= MOST && in_view <= LEAST).then_some(found)
    };
    let found = (0..rows.len()).find_map(found_at)?;
    let [width, height] = found.view.map(|size| scaled(size, found.scale));
    let (left, last) = (found.columns.start, found.columns.end - 1);
    let view = rows[found.bottom - height..found.bottom].iter();
    // What is beyond the strip's last column is the frame, or around the page.
    let rgba = view.flat_map(|row| (left..left + width).flat_map(|x| row[x.min(last)]));
    let shown = RgbaImage::from_raw(width as u32, height as u32, rgba.collect())?;
    let [width, height] = found.view.map(|size| size as u32);
    let of_page = match found.scale == 1.0 {
        true => shown,
        false => thumbnail(&shown, width, height),
    };
    Some(Picture {
        width,
        height,
        rgba: of_page.into_raw(),
    })
}

/// Where a page is in a picture.
struct Found {
    /// Columns of its strip.
    columns: Range<usize>,
    /// The first row of that, below the view.
    bottom: usize,
    /// Width and height of the view in the page's pixels.
    view: [usize; 2],
    /// How many pixels of the picture are one of the page, across.
    scale: f64,
}

impl Found {
    /// A page whose strip has these columns and begins in the row `bottom` of a picture of this width and height: one of any
    /// size that is all of the picture, or else one of the usual size.
    fn of_size(
        (width, height): (usize, usize),
        columns: Range<usize>,
        bottom: usize,
    ) -> Option<Self> {
        let high = height.checked_sub(STRIP).filter(|high| *high > 0);
        // A frame is a pixel wide, on the left and above.
        let is_all = columns.len() + 1 >= width && [height, height + 1].contains(&(bottom + STRIP));
        let (view, scale) = match high.filter(|_| is_all) {
            Some(high) => ([width, high], 1.0),
            None => (VIEW, scale_of(columns.len())?),
        };
        let is_above = bottom >= scaled(view[1], scale);
        is_above.then_some(Self {
            columns,
            bottom,
            view,
            scale,
        })
    }
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

/// So many pixels of the page in those of a picture.
fn scaled(pixels: usize, scale: f64) -> usize {
    (pixels as f64 * scale).round() as usize
}

/// How many pixels of a picture are one of the page whose strip is so wide in it, but for the frame at its sides.
fn scale_of(width: usize) -> Option<f64> {
    let is_of = |scale: &&f64| {
        let lacks = VIEW[0] as f64 * **scale - width as f64;
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

    fn screenshot(height: u32, strip: u8) -> Picture {
        let rows = (0..height).flat_map(|row| {
            let is_of_view = row as usize + STRIP <= height as usize;
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
        // The frame goes on beside the strip.
        (60..260).for_each(|y| framed.rgba[at(0, y)..][..3].fill(170));
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

    #[test]
    fn a_picture_shows_the_sky_of_the_page_where_its_upper_edge_is_teal() {
        let mut picture = screenshot(260, 26);
        let at = |x: usize, y: usize| 4 * (30 * y + x);
        assert!(!has_sky_of_page(&picture));
        for x in 0..150 {
            picture.rgba[at(x % 30, x / 30)..][..3].copy_from_slice(&[0, 95, 95]);
        }
        assert!(has_sky_of_page(&picture));
        // Two pixels of the three rows below the frame are more than noise.
        (10..12).for_each(|x| picture.rgba[at(x, 2)..][..3].fill(26));
        assert!(!has_sky_of_page(&picture), "something is before it");
        assert!(!has_sky_of_page(&screenshot(0, 26)));
    }

    #[test]
    fn a_page_is_found_on_a_screen_in_its_usual_size_alone() {
        let on_screen = |width: usize| {
            let (left, right) = (40, 60);
            let row = |inside: u8| {
                let gray = [vec![255; left], vec![inside; width], vec![255; right]].concat();
                gray.into_iter().flat_map(|gray| [gray, gray, gray, 255])
            };
            let around = (0..30).flat_map(|_| row(255));
            let view = (0..600).flat_map(|_| row(174));
            let strip = (0..STRIP).flat_map(|_| row(26));
            Picture {
                width: (left + width + right) as u32,
                height: 30 + 600 + STRIP as u32,
                rgba: around.chain(view).chain(strip).collect(),
            }
        };
        let view = view_of_page(&on_screen(VIEW[0])).expect("a page");
        assert_eq!((view.width, view.height), (800, 600));
        assert!(view.rgba.chunks(4).all(|pixel| pixel[0] == 174));
        assert!(view_of_page(&on_screen(700)).is_none());
    }
}
