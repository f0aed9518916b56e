//! How a picture is held against the live view: what a person chooses in the Compare panel.

use crate::compare::Area;

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
    /// What is left out, each of at least a pixel.
    pub masks: Vec<Area>,
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

/// What the panels of the course's editor cover, in pixels.
const COURSE_MENU_HEIGHT: u32 = 20;
const COURSE_PANEL_WIDTH: u32 = 280;

/// What the menu bar and the panel of the course's editor cover in its window.
pub fn course_panels(size: (u32, u32)) -> [Area; 2] {
    let (width, height) = size;
    let menu_bar = Area {
        x: 0,
        y: 0,
        width,
        height: COURSE_MENU_HEIGHT,
    };
    let panel = Area {
        x: width.saturating_sub(COURSE_PANEL_WIDTH),
        y: COURSE_MENU_HEIGHT,
        width: COURSE_PANEL_WIDTH,
        height,
    };
    [menu_bar, panel].map(|mask| mask.inside(size))
}

/// Height of the strip of keyframes and the timeline in the Virtual Mannequin's window, in pixels.
const MANNEQUIN_STRIP_HEIGHT: u32 = 200;

/// What covers the scene in a screenshot of the Virtual Mannequin of this size.
pub fn mannequin_panels(size: (u32, u32)) -> [Area; 1] {
    let (width, height) = size;
    let strip = Area {
        x: 0,
        y: height.saturating_sub(MANNEQUIN_STRIP_HEIGHT),
        width,
        height: MANNEQUIN_STRIP_HEIGHT,
    };
    [strip.inside(size)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_courses_panels_lie_at_the_top_and_right_of_its_window() {
        let panels = |size| course_panels(size).map(|area| area.to_string());
        assert_eq!(panels((800, 600)), ["0,0,800,20", "520,20,280,580"]);
        assert_eq!(panels((100, 10)), ["0,0,100,10", "0,9,100,1"]);
    }

    #[test]
    fn the_mannequins_strip_lies_at_the_bottom_of_its_window() {
        let strip = |size| mannequin_panels(size).map(|area| area.to_string());
        assert_eq!(strip((800, 800)), ["0,600,800,200"]);
        assert_eq!(strip((100, 10)), ["0,0,100,10"]);
    }
}
