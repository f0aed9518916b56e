//! What is said of the figure in a screenshot of the Virtual Mannequin's page.

use super::apart::{CameraTold, KeptPlaces, Place};
use super::place::{MUCH, much_differs, place, placed_elsewhere};
use super::{CompareView, FloorSeen, PageFigure};
use crate::compare::sentence;
use crate::editor::Session;

pub(super) const AGREES: &str =
    "The figure agrees but for its edges and what lines of bones cover.";

pub(super) const DIFFERS: &str =
    "The figure differs, not only by its edges and what lines of bones cover:";

/// What always differs, of the page and of what may be its view.
const ALWAYS: [&str; 2] = [
    "A is the Virtual Mannequin's page, which has noise in its floor and longer lines for the last bones: these always differ.",
    "If A is the Virtual Mannequin's page, the noise in its floor and its longer lines for the last bones always differ.",
];

/// What to do where the figure hardly shows that the camera is turned.
const FLOOR: &str = "The floor differs by more than the page's noise: B's camera may be turned a little. Home leads to where the page's \
                     starts.";

/// What to do where the floor tells of another camera.
const HOME: &str = "Home leads B's camera to where it started here, and once more to where the Virtual Mannequin's page does.";

/// What to do where nothing is in its place.
const ELSEWHERE: [&str; 2] = [
    "A is the Virtual Mannequin's page. If all of the figure differs, turn B's camera to where the page's was: Home leads to \
     where it starts.",
    "If A is the Virtual Mannequin's page and all of the figure differs, turn B's camera to where the page's was: Home leads to \
     where the camera started here, and once more to where the page's does.",
];

/// Why a screenshot cannot be compared.
pub(super) const SLANTED: &str = "The horizon of A is slanted, for the page's camera rolls when it is dragged. B's keeps level, so that \
                                  no view of it can match: compare a screenshot that is taken before the page's camera is turned.";

/// What is said of a figure.
pub(super) struct FigureTold {
    /// Where it differs from that of the live view: limb by limb, or where that is not all, altogether.
    pub places: Vec<Place>,
    /// Whether the camera may be elsewhere, so that the hint comes before all that follows from it.
    pub is_elsewhere: bool,
    /// Whether it is sure that the other picture is of the page.
    is_sure: bool,
    /// How the floors agree.
    floor: FloorSeen,
}

impl FigureTold {
    pub(super) fn new(
        session: &Session,
        compare: &CompareView,
        figure: &PageFigure,
        kept: &mut KeptPlaces,
    ) -> Self {
        let (is_sure, floor) = (compare.is_cut, figure.floor);
        let Some(off) = &figure.off else {
            return Self {
                places: Vec::new(),
                is_elsewhere: false,
                is_sure,
                floor,
            };
        };
        let area = off.area;
        let elsewhere = || {
            let elsewhere = figure.elsewhere.as_ref()?;
            let camera = match elsewhere.is_floor_right {
                true => CameraTold::Right,
                false if floor == FloorSeen::Elsewhere => CameraTold::Other,
                false => CameraTold::Unknown,
            };
            let told = placed_elsewhere(&elsewhere.placement, 1, camera);
            Some(Place::new(told, area, camera))
        };
        let places = match floor {
            // Whatever differs besides, it is seen by another camera.
            FloorSeen::Elsewhere => kept.seen_elsewhere(session, compare, off, elsewhere),
            _ => kept.of_figure(session, compare, off, elsewhere),
        };
        // Whatever bone is nearest, of so much of a figure the camera is to blame rather than a joint.
        let is_much = area.share_of(figure.area) >= MUCH;
        let may_be_camera = !floor.is_in_place();
        if places.is_empty() {
            let told = match is_much {
                true if may_be_camera => sentence(&area.place_in(figure.area)),
                true => much_differs(&area.place_in(figure.area)),
                false => place(session, area, figure.area, compare.size()),
            };
            return Self {
                places: vec![Place::new(told, area, CameraTold::Unknown)],
                is_elsewhere: is_much && may_be_camera,
                is_sure,
                floor,
            };
        }
        let elsewhere = figure.elsewhere.as_ref();
        let is_only_moved = elsewhere.is_some_and(|elsewhere| elsewhere.is_only_moved);
        let are_parts = places.iter().any(|place| place.camera == CameraTold::Right);
        let is_by_outline = is_much && !are_parts && (is_sure || !is_only_moved);
        // What the floor tells is said before what to do about it.
        let is_by_floor = floor == FloorSeen::Elsewhere;
        let is_elsewhere = is_sure || !is_by_floor;
        Self {
            places,
            is_elsewhere: is_elsewhere && may_be_camera && (is_by_outline || is_by_floor),
            is_sure,
            floor,
        }
    }

    /// What to do, or to know, unless the other picture is one of this program's own from the same camera.
    pub(super) fn hint(&self) -> Option<&'static str> {
        match self.floor {
            FloorSeen::Same if !self.is_sure => return None,
            FloorSeen::Elsewhere if !self.is_sure => return Some(HOME),
            FloorSeen::Off | FloorSeen::Elsewhere if self.is_sure && self.places.is_empty() => {
                return Some(FLOOR);
            }
            _ => {}
        }
        let hints = if self.is_elsewhere { ELSEWHERE } else { ALWAYS };
        Some(hints[usize::from(!self.is_sure)])
    }
}
