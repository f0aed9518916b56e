use super::Finding;
use super::evidence::{FEWEST_PIXELS, OTHER_COLOR, ROUNDING};
use crate::compare::differences::difference;
use crate::compare::{Area, Pair};
use std::fmt;

/// Pixels that differ by more than rounding are no more than one in so many of the drawn.
const OTHERS_ONE_IN: u64 = 200;

impl Pair<'_> {
    /// Whether the pictures agree but for rounding and a few single pixels; `other_background` if
    /// B was put over A's background first.
    pub(super) fn nearly_same(&self, other_background: bool) -> Option<Finding> {
        let differences: Vec<u8> = self
            .a()
            .iter()
            .zip(self.b())
            .map(|(&a, &b)| difference(a, b))
            .collect();
        let count = |above: u8| differences.iter().filter(|&&by| by > above).count() as u64;
        let (others, other_color) = (count(ROUNDING), count(OTHER_COLOR));
        let drawn = self.drawn_pixels().count() as u64;
        if other_color >= FEWEST_PIXELS || others > drawn / OTHERS_ONE_IN {
            return None;
        }
        let is_other: Vec<bool> = differences.iter().map(|&by| by > ROUNDING).collect();
        let rounding = differences.into_iter().filter(|&by| by <= ROUNDING).max();
        Some(Finding::NearlySame {
            rounding: rounding.unwrap_or(0),
            others,
            other_color,
            area: self.area_of(&is_other),
            other_background,
        })
    }
}

/// `others` pixels differ by more than `rounding`, and so many of them by more than 8.
pub(super) fn fmt(
    f: &mut fmt::Formatter<'_>,
    rounding: u8,
    [others, other_color]: [u64; 2],
    area: Option<Area>,
) -> fmt::Result {
    let pixels = |count: u64| match count {
        1 => "1 pixel".to_owned(),
        _ => format!("{count} pixels"),
    };
    if rounding > 0 {
        write!(f, "the same but for rounding (at most {rounding} of 255)")?;
    }
    let Some(area) = area else {
        return Ok(());
    };
    match (rounding, other_color) {
        (0, _) => write!(f, "the same but for {}", pixels(others))?,
        (_, 0) => write!(f, " and {} by more, up to {OTHER_COLOR}", pixels(others))?,
        _ if other_color == others => {
            write!(f, " and {} by more than {OTHER_COLOR}", pixels(others))?;
        }
        _ => write!(
            f,
            " and {} by more, {other_color} of them by more than {OTHER_COLOR}",
            pixels(others)
        )?,
    }
    write!(f, ", within {area}")
}
