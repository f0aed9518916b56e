//! How a shape differs that is off at some pixels.

use super::owned::Owned;
use super::seen_in_cells::SeenInCells;
use super::skeleton_shown::shows_skeleton;
use crate::compare::{Area, FigureOff};
use crate::scene::ShapeId;
use glam::Vec2;
use std::collections::HashSet;

/// How a shape differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    /// It covers what it should, in other colors.
    Color,
    /// The same of a character, over whose mesh bones may be drawn in one of the pictures.
    ColorOrDisplay,
    /// It covers nearly that, in other colors: of a character also limbs are turned.
    ColorAndMore,
    /// It covers some of what it should, in other colors: a character that stands elsewhere as well.
    ColorAndPlace,
    /// It covers something else.
    Place,
    /// The same of a curve, which may have other control points.
    PlaceOrPoints,
    /// The same of a surface, which may also be shown as lines in one of the pictures.
    PlaceOrLines,
    /// The other picture has nothing there.
    Missing,
    /// The same of a surface or a skeleton, of which single lines count as nothing.
    MissingOrLines,
    /// The other picture has the bones of a character in place of its mesh.
    Skeleton,
}

impl How {
    /// Whether the other picture has nothing like it there, so that all of it differs and nothing in its place.
    pub fn is_of_ours_alone(self) -> bool {
        match self {
            Self::Missing | Self::MissingOrLines | Self::Skeleton => true,
            Self::Color
            | Self::ColorOrDisplay
            | Self::ColorAndMore
            | Self::ColorAndPlace
            | Self::Place
            | Self::PlaceOrPoints
            | Self::PlaceOrLines => false,
        }
    }

    /// Whether it is in its place, which it would not be seen by another camera.
    pub fn is_in_place(self) -> bool {
        matches!(self, Self::Color | Self::ColorOrDisplay | Self::Skeleton)
    }

    /// The same in words.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Color => "its outline agrees, so that its color or light differs",
            Self::ColorOrDisplay => {
                "its outline agrees, so that its color, its light or Model Display Mode differs"
            }
            Self::ColorAndMore => {
                "its color or light differs, and a part of its outline, or it is turned to another side"
            }
            Self::ColorAndPlace => {
                "its color or light differs, and it is moved, turned or scaled as a whole"
            }
            Self::Place => "it is moved, turned or scaled",
            Self::PlaceOrPoints => {
                "it is moved, turned or scaled, or its control points are elsewhere"
            }
            Self::PlaceOrLines => {
                "it is moved, turned or scaled, its control points are elsewhere, or Surface Visibility shows it otherwise"
            }
            Self::Missing => "A shows nothing in its place",
            Self::MissingOrLines => "A shows nothing in its place, or no more than lines",
            Self::Skeleton => {
                "A shows its skeleton. Choose Skeletal Model for Model Display Mode to compare that"
            }
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

/// Share of the pixels that a character covers in both pictures from which on it tells by its colors there whether these differ as well: of
/// one that was scaled by 0.9 it was more than half.
const RECOLORED_ELSEWHERE: f64 = 0.3;

/// Share of what is seen of a character that the other picture shows elsewhere from which on it may be that: in the Studio look 0.03
/// lay about the feet of one that is missing.
const ELSEWHERE: f64 = 0.1;

/// Share of it that has something in its place from which on the other picture shows something of it: so it was 0.023 of one that
/// is missing, and 0.08 where bones are lines.
pub(super) const EMPTY: f64 = 0.05;

/// How a character differs of which more than limbs does, where it has another color or is shown otherwise, or not at all; `None`
/// where it stands elsewhere. `off` are pixels of all that differs, and the others those of the character.
pub(super) fn how_of_character(
    character: ShapeId,
    (owned, seen): (&Owned, &SeenInCells),
    [ours, theirs]: &[Vec<(u32, u32)>; 2],
    off: &FigureOff,
) -> Option<How> {
    let of_mesh = owned.off_of(character, |_| true);
    if of_mesh.or_else(|| owned.off_of_other(character))? < RECOLORED {
        return None;
    }
    if of_mesh.is_none() {
        return is_less(theirs, NOTHING, ours).then_some(How::MissingOrLines);
    }
    let (session, size) = seen.view();
    let is_inside =
        |&(x, y): &(u32, u32)| seen.shape_at(Vec2::new(x as f32, y as f32)) == Some(character);
    let (inside, outside): (Vec<_>, Vec<_>) = theirs.iter().copied().partition(is_inside);
    let is_in_place = is_less(&outside, ELSEWHERE, ours);
    let thin = off.thin.iter().flatten();
    let thin = thin.map(|&[x, y]| (x, y)).filter(is_inside);
    let all: Vec<_> = inside.iter().copied().chain(thin).collect();
    match share_of_both(ours, theirs) {
        _ if is_in_place && off.thin.is_some() && is_less(&all, EMPTY, ours) => Some(How::Missing),
        // What is outside may be of another character that is elsewhere.
        _ if shows_skeleton(session, character, &all, off.apart, size) => Some(How::Skeleton),
        _ if is_in_place && is_less(&inside, EMPTY, ours) => Some(How::MissingOrLines),
        SAME_PLACE.. => Some(How::ColorOrDisplay),
        RECOLORED_PLACE.. => Some(How::ColorAndMore),
        RECOLORED_ELSEWHERE.. => Some(How::ColorAndPlace),
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

/// Whether pixels are fewer than this share of others.
fn is_less<P>(pixels: &[P], share: f64, others: &[(u32, u32)]) -> bool {
    (pixels.len() as f64) < share * others.len() as f64
}

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
        _ if is_less(theirs, NOTHING, ours) => How::Missing,
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
