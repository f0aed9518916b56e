use std::f32::consts::{FRAC_PI_2, PI};

/// The six views of the View menu, named for the side from which they look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewDirection {
    /// From +X.
    PlusX,
    /// From -X.
    MinusX,
    /// From above, with +X to the right.
    PlusY,
    /// From below, with +X to the right.
    MinusY,
    /// From +Z.
    PlusZ,
    /// From -Z.
    MinusZ,
}

impl ViewDirection {
    /// All six, in the order of the menu.
    pub const ALL: [Self; 6] = [
        Self::PlusX,
        Self::MinusX,
        Self::PlusY,
        Self::MinusY,
        Self::PlusZ,
        Self::MinusZ,
    ];

    /// `+X` and so on.
    pub fn label(self) -> &'static str {
        match self {
            Self::PlusX => "+X",
            Self::MinusX => "-X",
            Self::PlusY => "+Y",
            Self::MinusY => "-Y",
            Self::PlusZ => "+Z",
            Self::MinusZ => "-Z",
        }
    }

    /// θ and φ. Seen from straight above or below, θ says which way is up in the picture: at 90°
    /// +X is to the right.
    pub(super) fn angles(self) -> (f32, f32) {
        match self {
            Self::PlusX => (0.0, 0.0),
            Self::MinusX => (PI, 0.0),
            Self::PlusY => (FRAC_PI_2, FRAC_PI_2),
            Self::MinusY => (FRAC_PI_2, -FRAC_PI_2),
            Self::PlusZ => (FRAC_PI_2, 0.0),
            Self::MinusZ => (-FRAC_PI_2, 0.0),
        }
    }
}
