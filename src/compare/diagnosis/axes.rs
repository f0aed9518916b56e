use super::evidence::{Evidence, FEWEST_PIXELS, UNEXPLAINED_ONE_IN};
use super::{Finding, Which};
use crate::compare::pair::Pixel;

/// Least distance, of 255, of the strongest channel of an axis from the others, also where the edge of
/// its line is mixed with what is behind it.
const LEAST_COLOR: u8 = 24;

/// Axes drawn in one picture alone: all that differs are thin lines that leave the picture, each in red,
/// green or blue.
pub(super) async fn axes(evidence: &Evidence<'_>) -> Option<Finding> {
    let (pair, lines) = (evidence.pair(), evidence.other_colors());
    let pixels = evidence.pixels_of_other_color();
    let area = evidence.area_of(lines)?;
    let few = pixels / UNEXPLAINED_ONE_IN;
    let is_solid = |&at: &usize| pair.around(at).all(|near| lines[near]);
    let mut thick = 0;
    let pace = evidence.pace;
    pace.bands(lines.len(), |band| {
        thick += band.filter(is_solid).count() as u64;
    })
    .await;
    let leaves = area.x == 0
        || area.y == 0
        || (area.x + area.width, area.y + area.height) == (pair.width(), pair.height());
    if pixels < FEWEST_PIXELS || thick > few || !leaves {
        return None;
    }
    let mut are_in = [true; 2];
    let sides = [(pair.a(), pair.b()), (pair.b(), pair.a())];
    for (is_in, (with, without)) in are_in.iter_mut().zip(sides) {
        let mut others = 0;
        pace.bands(lines.len(), |band| {
            let pixels = with[band.clone()].iter().zip(&without[band.clone()]);
            let differing = pixels.zip(&lines[band]).filter(|(_, line)| **line);
            let other = differing.filter(|((with, without), _)| !is_axis(**with, **without));
            others += other.count() as u64;
        })
        .await;
        *is_in = others <= few;
    }
    let only_in = Which::of(are_in)?;
    (only_in != Which::Both).then_some(Finding::Axes { only_in })
}

/// Whether a color may be that of an axis over another color: more of one channel, less of the others.
fn is_axis(over: Pixel, under: Pixel) -> bool {
    (0..3).any(|channel| {
        let others = (0..3).filter(|&other| other != channel);
        others.into_iter().all(|other| {
            let stands_out = over[channel] >= over[other].saturating_add(LEAST_COLOR);
            let stood_out = i16::from(under[channel]) - i16::from(under[other]);
            let stands_out_by = i16::from(over[channel]) - i16::from(over[other]);
            stands_out && stands_out_by > stood_out
        })
    })
}
