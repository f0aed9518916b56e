//! What can be done about differences of pictures.

use super::CompareView;
use crate::compare::Differences;
use crate::scene::Look;

const COVERED: &str = "If A shows the other program's panels, leave them out: Mask its panels.";
const SMOOTH: &str =
    "B has smooth edges. If A has none, as the course's program draws it, untick Smooth edges.";

/// What the person at the panel can do about differences.
pub(super) fn hints(
    compare: &CompareView,
    look: Look,
    counts: &Differences,
) -> impl Iterator<Item = &'static str> {
    let settings = compare.settings;
    let look_is_course = look == Look::Course;
    // Where not even the border has a color of its own, something lies over the scene.
    let covered = settings.masks.is_empty() && counts.drawn_pixels == counts.compared_pixels;
    let other_look = other_look(look, compare.look).into_iter();
    let others = [
        (look_is_course && settings.smooth_edges, SMOOTH),
        (look_is_course && covered, COVERED),
    ];
    let others = others.into_iter();
    other_look.chain(others.filter_map(|(applies, hint)| applies.then_some(hint)))
}

/// The way back to the look that the comparison began with, if the live view has another one.
fn other_look(now: Look, began_in: Look) -> Option<&'static str> {
    match (now, began_in) {
        (Look::Studio, Look::Course) => {
            Some("B has the Studio look. Course look draws it as the course's program does.")
        }
        (Look::Mannequin, Look::Course) => {
            Some("B has the Mannequin look. Course look draws it as the course's program does.")
        }
        (Look::Studio, Look::Mannequin) => {
            Some("B has the Studio look. Mannequin look draws it as the Virtual Mannequin does.")
        }
        (Look::Course, Look::Mannequin) => {
            Some("B has the Course look. Mannequin look draws it as the Virtual Mannequin does.")
        }
        _ => None,
    }
}
