//! The menu that a right click in the view opens, for what is under the pointer.

use super::commands::Command;
use super::scene_places::ScenePlaces;
use super::{Action, UiState};
use crate::editor::{Session, View};
use crate::scene::ShapeId;
use egui::Pos2;

/// What the menu is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ContextMenu {
    /// The selected character.
    Character,
    /// The selected shape, or several.
    Shape,
    /// The scene.
    Scene,
}

/// The menu that was asked for last.
#[derive(Clone, Copy, Debug)]
pub(super) struct OpenMenu {
    pub menu: ContextMenu,
    /// Its corner, as a point of the window.
    pub at: Pos2,
    /// Whether it opens in the next frame.
    pub opens: bool,
}

/// Parts of the menu, each with its commands.
type Parts = &'static [&'static [Command]];

const OF_SHAPES: &[Command] = &[
    Command::Rename,
    Command::Duplicate,
    Command::Cut,
    Command::Copy,
    Command::Paste,
    Command::Delete,
];
/// Without Copy and Paste, which are about poses while bones are posed.
const OF_FIGURES: &[Command] = &[Command::Rename, Command::Duplicate, Command::Delete];
const OF_SEEING: &[Command] = &[
    Command::ToggleVisible,
    Command::HideOthers,
    Command::ToggleLocked,
    Command::Fit,
];
const OF_POSES: &[Command] = &[
    Command::ResetJoint,
    Command::ResetPose,
    Command::MirrorPose,
    Command::MirrorJoints,
    Command::CopyPose,
    Command::PastePose,
    Command::PastePoseMirrored,
];
const OF_THE_SCENE: &[Command] = &[
    Command::InsertMenu,
    Command::Paste,
    Command::SelectAll,
    Command::ShowAll,
    Command::FitAll,
];

impl ContextMenu {
    pub(super) fn parts(self) -> Parts {
        match self {
            Self::Character => &[OF_POSES, OF_FIGURES, OF_SEEING],
            Self::Shape => &[OF_SHAPES, OF_SEEING],
            Self::Scene => &[OF_THE_SCENE],
        }
    }
}

/// Opens the menu for what is at the point `at` of the window, which is selected first unless it is among what is
/// selected. A gizmo's handle is a part of what it is of. A finger that rested has `held` a joint, which may be beside it.
pub(super) fn ask(
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    at: Pos2,
    held: Option<(ShapeId, usize)>,
    actions: &mut Vec<Action>,
) {
    // What lights up: the joint that the tool would take.
    let hovered = session
        .hovered_bone()
        .filter(|_| state.pose.hovered.is_some());
    let bone = held.or(hovered);
    let of_bone = bone.map(|(shape, _)| shape);
    let of_handle = session.selected().filter(|_| state.pose.hot.is_some());
    let shape = of_bone.or(of_handle);
    let shape = shape.or_else(|| state.pose.picked.shape_at_point(session, places, at));
    about(shape, session, state, at, actions);
    let is_selected = |joint: usize| session.selected_joints().contains(&joint);
    if let Some((_, joint)) = bone.filter(|&(_, joint)| !is_selected(joint)) {
        actions.push(Action::View(View::SelectJoint(Some(joint))));
    }
}

/// Opens the menu for a shape, or for the scene, at a point of the window.
pub(super) fn about(
    shape: Option<ShapeId>,
    session: &Session,
    state: &mut UiState,
    at: Pos2,
    actions: &mut Vec<Action>,
) {
    let menu = match shape {
        None => ContextMenu::Scene,
        Some(shape) if session.scene().character(shape).is_some() => ContextMenu::Character,
        Some(_) => ContextMenu::Shape,
    };
    state.context_menu = Some(OpenMenu {
        menu,
        at,
        opens: true,
    });
    if let Some(shape) = shape.filter(|&shape| !session.is_selected(shape)) {
        actions.push(Action::View(View::Select(Some(shape))));
    }
}
