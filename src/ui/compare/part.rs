//! A part of a scene that differs.

use super::how::How;
use crate::compare::{Area, FigureOff};

/// Pixels `(x, y)` that are off of a candidate in the live view, and in the other picture.
pub(super) type Pixels = [Vec<(u32, u32)>; 2];

/// A part that differs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// Name of the joint, with the character's if there are several, or of the shape.
    pub name: String,
    pub kind: Kind,
    /// The area round what is off of it in either picture.
    pub area: Area,
    /// Share of the figure that this is, in percent.
    pub percent: f64,
}

/// What a part is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// A limb, with what else may be turned in its place in a sentence.
    Limb { instead: Option<String> },
    /// A shape without bones, and how it differs, as far as that is told.
    Shape(Option<How>),
    /// A character, of which more than limbs differs, and how if it does not stand elsewhere.
    Character(Option<How>),
    /// Something in the other picture where the live view has nothing; its name is that of a hidden shape, or empty.
    Absent,
    /// All that the live view shows, of which the other picture has nothing.
    All,
}

impl Kind {
    /// Whether what differs is in the live view alone, so that no camera that is elsewhere explains it.
    pub fn is_of_ours_alone(&self) -> bool {
        match self {
            Self::Shape(how) | Self::Character(how) => how.is_some_and(How::is_of_ours_alone),
            Self::Limb { .. } | Self::Absent => false,
            Self::All => true,
        }
    }

    /// Whether it is a shape in its place that has another color, or is displayed otherwise or not at all.
    pub fn is_shown_otherwise(&self) -> bool {
        match self {
            Self::Character(how) => how.is_some_and(|how| how != How::ColorAndPlace),
            Self::Shape(how) => how.is_some_and(|how| how == How::Color || how.is_of_ours_alone()),
            Self::Limb { .. } | Self::Absent | Self::All => false,
        }
    }

    /// Whether it is a shape that is where it should be, though it is shown otherwise, so that the camera is.
    pub fn is_in_place(&self) -> bool {
        match self {
            Self::Character(how) | Self::Shape(how) => how.is_some_and(How::is_in_place),
            Self::Limb { .. } | Self::Absent | Self::All => false,
        }
    }

    /// Share of the figure that these pixels are which are off of it, in percent.
    pub fn percent(&self, [ours, theirs]: &Pixels, off: &FigureOff) -> f64 {
        let figure = (off.ours.len() + off.right.len()) as f64;
        let share = |pixels: usize| 100.0 * pixels as f64 / figure;
        match self.is_of_ours_alone() {
            true => share(ours.len()),
            // The figure is as large in both pictures.
            false => 0.5 * share(ours.len() + theirs.len()),
        }
    }
}
