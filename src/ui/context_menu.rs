//! The menu that a right click in the view opens, for what is under the pointer.

use super::commands::Command;
use super::scene_places::ScenePlaces;
use super::view_gestures::shape_at;
use super::{Action, UiState};
use crate::editor::{Session, View};
use egui::Response;

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

/// Opens the menu for what is under the pointer, which is selected first unless it is among what is selected.
pub(super) fn ask(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    let Some(at) = view.interact_pointer_pos() else {
        return;
    };
    let bone = state.pose.hovered.map(|hit| (hit.shape, hit.joint));
    let of_bone = bone.map(|(shape, _)| shape);
    let shape = of_bone.or_else(|| shape_at(&mut state.pose.picked, session, places, at));
    state.opens_context_menu = Some(match shape {
        None => ContextMenu::Scene,
        Some(shape) if session.scene().character(shape).is_some() => ContextMenu::Character,
        Some(_) => ContextMenu::Shape,
    });
    if let Some(shape) = shape.filter(|&shape| !session.is_selected(shape)) {
        actions.push(Action::View(View::Select(Some(shape))));
    }
    if let Some((_, joint)) = bone {
        actions.push(Action::View(View::SelectJoint(Some(joint))));
    }
}
