//! How a shape differs that is off at some pixels.

use super::owned::Owned;
use crate::compare::Area;
use crate::scene::ShapeId;
use glam::Vec2;
use std::collections::HashSet;

/// How a shape differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    /// It covers what it should, in other colors.
    Color,
    /// It covers nearly that, in other colors: of a character also limbs are turned.
    ColorAndMore,
    /// It covers something else.
    Place,
    /// The same of a curve, which may have other control points.
    PlaceOrPoints,
    /// The same of a surface, which may also be shown as lines in one of the pictures.
    PlaceOrLines,
    /// The other picture has nothing there.
    Missing,
    /// The same of a surface, of which single lines count as nothing.
    MissingOrLines,
}

impl How {
    /// The same in words.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Color => "its outline agrees, so that its color or light differs",
            Self::ColorAndMore => "its color or light differs, and a part of its outline",
            Self::Place => "it is moved, turned or scaled",
            Self::PlaceOrPoints => {
                "it is moved, turned or scaled, or its control points are elsewhere"
            }
            Self::PlaceOrLines => {
                "it is moved, turned or scaled, its control points are elsewhere, or Surface Visibility shows it otherwise"
            }
            Self::Missing => "A shows nothing in its place",
            Self::MissingOrLines => "A shows nothing in its place, or no more than lines",
        }
    }
}

/// Share of the pixels that a shape covers in both pictures from which on it is where it should be, …
const SAME_PLACE: f64 = 0.95;
/// … and up to which it is elsewhere: one that is turned in its place covers much of what it did.
const OTHER_PLACE: f64 = 0.9;

/// Share of the pixels that a character covers in both pictures from which on it may have another color: with a knee that is
/// turned by 60 degrees as well it was 0.93, …
const RECOLORED_PLACE: f64 = 0.8;
/// … and share of what is seen of it that is off, then: one that is moved by a little keeps its color where it still is.
const RECOLORED: f32 = 0.95;

/// How a character differs of which more than limbs does, where it has another color; `None` where it stands elsewhere.
pub(super) fn how_of_character(
    character: ShapeId,
    owned: &Owned,
    [ours, theirs]: &[Vec<(u32, u32)>; 2],
) -> Option<How> {
    let off = owned.off_of(character, |_| true)?;
    if off < RECOLORED {
        return None;
    }
    match share_of_both(ours, theirs) {
        SAME_PLACE.. => Some(How::Color),
        RECOLORED_PLACE.. => Some(How::ColorAndMore),
        _ => None,
    }
}

/// Share of the pixels that these are in both pictures.
fn share_of_both(ours: &[(u32, u32)], theirs: &[(u32, u32)]) -> f64 {
    let of_theirs: HashSet<_> = theirs.iter().collect();
    let both = ours.iter().filter(|pixel| of_theirs.contains(pixel));
    both.count() as f64 / ours.len().max(theirs.len()).max(1) as f64
}

/// Share of what it covers that the other picture shows something at which has nothing there.
const NOTHING: f64 = 0.02;

/// Share of what is seen of a surface that is off where the other picture shows it as lines: of one that was moved by a tenth of its
/// height it was 0.51.
const LINES_OFF: f32 = 0.97;

/// How a shape differs that is off at these pixels of the live view, and at those of the other picture, where the share `off_of_curve`
/// is off of it if it is a curve.
pub(super) fn how_of_shape(
    [ours, theirs]: &[Vec<(u32, u32)>; 2],
    off_of_curve: Option<f32>,
) -> Option<How> {
    let how = match share_of_both(ours, theirs) {
        _ if (theirs.len() as f64) < NOTHING * ours.len() as f64 => How::Missing,
        SAME_PLACE.. => How::Color,
        ..=OTHER_PLACE => How::Place,
        _ => return None,
    };
    let Some(off) = off_of_curve else {
        return Some(how);
    };
    let may_be_lines = off >= LINES_OFF;
    Some(match how {
        How::Missing if may_be_lines => How::MissingOrLines,
        How::Place if may_be_lines && have_one_middle(ours, theirs) => How::PlaceOrLines,
        How::Place => How::PlaceOrPoints,
        how => how,
    })
}

/// How far apart the middles of two areas are at most that are about the same, by their sides: of a goblet as a wireframe with
/// normals it was 0.02.
const ONE_MIDDLE: f32 = 0.05;

/// Whether the areas round pixels lie about the same middle, as where a shape stays where it is.
fn have_one_middle(ours: &[(u32, u32)], theirs: &[(u32, u32)]) -> bool {
    let corners = |pixels: &[(u32, u32)]| Some(Area::around(pixels.iter().copied())?.corners());
    let (Some(ours), Some(theirs)) = (corners(ours), corners(theirs)) else {
        return false;
    };
    let middle = |[least, most]: [Vec2; 2]| 0.5 * (least + most);
    let apart = middle(ours) - middle(theirs);
    let size = ours[1] - ours[0];
    apart.abs().cmple(ONE_MIDDLE * size).all()
}
