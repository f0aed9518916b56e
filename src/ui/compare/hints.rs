//! What can be done about differences of pictures.

use super::CompareView;
use super::names::all_of;
use crate::compare::{Differences, FigureOff, Finding};
use crate::editor::Session;
use crate::scene::{Camera, Look, ModelDisplay, Shape};
use crate::ui::commands::homes;

const COVERED: &str = "If A shows the other program's panels, leave them out: Mask its panels.";
const SMOOTH: &str =
    "B has smooth edges. If A has none, as the course's program draws it, untick Smooth edges.";

const HARD_HERE: &str = "A has smooth edges, and B hard ones: tick Smooth edges.";
const SMOOTH_HERE: &str = "B has smooth edges, and A hard ones: untick Smooth edges.";

const CAMERA: &str =
    "If A has the camera that the course's program starts with, Home gives it to B.";
const CAMERA_TWICE: &str = "If A has the camera that the course's program starts with, Home, pressed twice, gives it to B.";

/// How to come to the camera that the course's program starts with, where another camera may be what `findings` show, or
/// behind what they do not explain.
pub(super) fn camera(session: &Session, findings: &[Finding]) -> Option<&'static str> {
    let (view, first) = (session.view(), Camera::default());
    let is_elsewhere = |finding: &Finding| match finding {
        Finding::Placed { .. } => true,
        Finding::Outline { only_a, only_b, .. } => *only_a > 0 && *only_b > 0,
        _ => false,
    };
    let may_be_camera = view.look == Look::Course && view.camera != first;
    let [next, _] = homes(session);
    let hint = if next == first { CAMERA } else { CAMERA_TWICE };
    let is_open = findings.is_empty() || findings.iter().any(is_elsewhere);
    (may_be_camera && is_open).then_some(hint)
}

/// What the person at the panel can do about differences.
pub(super) fn hints(
    compare: &CompareView,
    look: Look,
    counts: &Differences,
) -> impl Iterator<Item = &'static str> {
    let settings = compare.settings;
    let look_is_course = look == Look::Course;
    let may_be_hard = compare.is_reference_smooth.is_none();
    let is_smooth = settings.smooth_edges && compare.are_edges_chosen && may_be_hard;
    // Where not even the border has a color of its own, something lies over the scene.
    let covered = settings.masks.is_empty() && counts.drawn_pixels == counts.compared_pixels;
    let other_look = other_look(look, compare.look).into_iter();
    let others = [
        (look_is_course && is_smooth, SMOOTH),
        (look_is_course && covered, COVERED),
    ];
    let others = others.into_iter();
    other_look.chain(others.filter_map(|(applies, hint)| applies.then_some(hint)))
}

/// That the user has chosen other edges for the live view than the reference has, which differ all over the figure then.
pub(super) fn other_edges(compare: &CompareView) -> Option<&'static str> {
    match (compare.is_reference_smooth?, compare.settings.smooth_edges) {
        _ if !compare.are_edges_chosen => None,
        (true, false) => Some(HARD_HERE),
        (false, true) => Some(SMOOTH_HERE),
        _ => None,
    }
}

/// How many times as much the other picture shows where it differs that may show a mesh instead of a skeleton.
const MESH_BY_SKELETON: usize = 2;

/// That characters show their skeletons, where the other picture may show its mesh.
pub(super) fn other_display(session: &Session, off: Option<&FigureOff>) -> Option<String> {
    let off = off.filter(|off| off.theirs.len() > MESH_BY_SKELETON * off.ours.len());
    let shapes = off.map(|_| session.scene().shapes()).unwrap_or_default();
    let is_skeleton = |shape: &&Shape| {
        let character = session.scene().character(shape.id);
        character.is_some_and(|it| shape.visible && it.display.mode == ModelDisplay::Skeleton)
    };
    let names = shapes.iter().filter(is_skeleton);
    let names: Vec<&str> = names.map(|shape| &*shape.name).collect();
    if names.is_empty() {
        return None;
    }
    let (how, other) = match names.len() {
        1 => ("its skeleton", "its mesh"),
        _ => ("skeletons", "meshes"),
    };
    let names = all_of(&names);
    Some(format!(
        "B shows {names} as {how}: if A shows {other}, choose Mesh Model for Model Display Mode."
    ))
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
