//! How a picture is held against the live view: what a person chooses in the Compare panel.

/// What is asked of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum CompareAction {
    /// Choose the picture to compare with; starts a comparison or goes on with another picture.
    Choose,
    /// Replaces everything that can be chosen.
    Set(CompareSettings),
    /// Save both pictures and their difference: choose a file.
    Save,
    /// Back to the view alone.
    Close,
}

/// What can be chosen while a picture is compared with the live view.
#[derive(Clone, Debug, PartialEq)]
pub struct CompareSettings {
    /// How the two are shown.
    pub mode: CompareMode,
    /// Where [`CompareMode::Swipe`] changes from one to the other, 0 (left) to 1.
    pub swipe: f32,
    /// How much of the live view [`CompareMode::OnionSkin`] shows, 0 to 1.
    pub onion: f32,
    /// A pixel differs if a channel does by more than this, of 255.
    pub threshold: u8,
    /// Whether the live view has smooth edges; the course's program has none.
    pub smooth_edges: bool,
    /// What is left out.
    pub masks: Vec<Mask>,
}

impl Default for CompareSettings {
    fn default() -> Self {
        Self {
            mode: CompareMode::SideBySide,
            swipe: 0.5,
            onion: 0.5,
            threshold: 0,
            smooth_edges: false,
            masks: Vec::new(),
        }
    }
}

/// How two pictures are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompareMode {
    /// One beside, or above, the other.
    SideBySide,
    /// The reference left of a line that can be moved, the live view right of it.
    Swipe,
    /// One and the other in turn.
    Blink,
    /// The live view over the reference like thin paper.
    OnionSkin,
    /// Where they differ, lighter where they differ more.
    Difference,
}

impl CompareMode {
    /// All, in the order of the panel.
    pub const ALL: [Self; 5] = [
        Self::SideBySide,
        Self::Swipe,
        Self::Blink,
        Self::OnionSkin,
        Self::Difference,
    ];

    /// Its name in the panel.
    pub fn label(self) -> &'static str {
        match self {
            Self::SideBySide => "Side by side",
            Self::Swipe => "Swipe",
            Self::Blink => "Blink",
            Self::OnionSkin => "Onion skin",
            Self::Difference => "Difference",
        }
    }
}

/// A rectangle of pixels that is left out, from the upper left corner of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mask {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
}

/// What the panels of the course's editor cover, in pixels.
const COURSE_MENU_HEIGHT: u32 = 20;
const COURSE_PANEL_WIDTH: u32 = 280;

impl Mask {
    /// The nearest mask that lies inside of a picture of this size, which has a pixel.
    #[must_use]
    pub fn inside(self, (width, height): (u32, u32)) -> Self {
        let x = self.x.min(width.saturating_sub(1));
        let y = self.y.min(height.saturating_sub(1));
        Self {
            x,
            y,
            width: self.width.clamp(1, (width - x).max(1)),
            height: self.height.clamp(1, (height - y).max(1)),
        }
    }

    /// A mask of half the picture's width and height, in its middle.
    pub fn in_the_middle(size: (u32, u32)) -> Self {
        Self {
            x: size.0 / 4,
            y: size.1 / 4,
            width: size.0 / 2,
            height: size.1 / 2,
        }
        .inside(size)
    }

    /// What the menu bar and the panel of the course's editor cover in its window.
    pub fn course_panels(size: (u32, u32)) -> [Self; 2] {
        let (width, height) = size;
        let menu_bar = Self {
            x: 0,
            y: 0,
            width,
            height: COURSE_MENU_HEIGHT,
        };
        let panel = Self {
            x: width.saturating_sub(COURSE_PANEL_WIDTH),
            y: COURSE_MENU_HEIGHT,
            width: COURSE_PANEL_WIDTH,
            height,
        };
        [menu_bar, panel].map(|mask| mask.inside(size))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mask(x: u32, y: u32, width: u32, height: u32) -> Mask {
        Mask {
            x,
            y,
            width,
            height,
        }
    }

    #[test]
    fn a_mask_is_brought_inside_of_the_picture_and_keeps_a_pixel() {
        let size = (80, 60);
        assert_eq!(mask(10, 5, 20, 7).inside(size), mask(10, 5, 20, 7));
        assert_eq!(mask(70, 50, 90, 90).inside(size), mask(70, 50, 10, 10));
        assert_eq!(mask(500, 600, 5, 0).inside(size), mask(79, 59, 1, 1));
    }

    #[test]
    fn the_courses_panels_lie_at_the_top_and_right_of_its_window() {
        let [menu_bar, panel] = Mask::course_panels((800, 600));
        assert_eq!(menu_bar, mask(0, 0, 800, 20));
        assert_eq!(panel, mask(520, 20, 280, 580));
        let small = Mask::course_panels((100, 10));
        assert_eq!(small, [mask(0, 0, 100, 10), mask(0, 9, 100, 1)]);
    }
}
