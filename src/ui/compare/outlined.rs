//! The finding whose place is outlined in the pictures.

use crate::compare::Area;

/// Which area of the pictures is outlined: that of the finding under the pointer, or else of the one
/// that was clicked.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::ui) struct Outlined {
    pub(super) hovered: Option<Area>,
    pub(super) clicked: Option<Area>,
}

impl Outlined {
    /// The area; `None` if nothing is outlined.
    pub fn area(self) -> Option<Area> {
        self.hovered.or(self.clicked)
    }
}
