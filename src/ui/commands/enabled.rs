//! When commands are disabled.

use super::hiding::{hidden, others};
use super::pose_commands::{mirror_joints, posed_character};
use super::put_back::why_nothing_back;
use super::run::{character_to_compare, selected_character, selected_curves};
use super::sweep::{revolution, sweep};
use super::table::is_in;
use super::{Command, Menu};
use crate::editor::{Session, Tool, selected_roots};
use crate::math::Euler;
use crate::scene::{Look, Shape, ShapeKind};
use crate::ui::state::UiState;
use crate::ui::{control_points, posing};
use glam::Vec3;

/// Why a command is disabled, as text for its tooltip; `None` while it is enabled.
pub(in crate::ui) fn why_disabled(
    command: Command,
    session: &Session,
    state: &UiState,
) -> Option<&'static str> {
    if command == Command::Delete
        && let Some(deletes) = control_points::delete_clicked(session, &state.curves)
    {
        return deletes.err();
    }
    match command {
        Command::Revert if !state.has_file => Some("The document has no file yet"),
        Command::Undo if session.done_steps() == 0 && !session.is_in_gesture() => {
            Some("There is nothing to undo")
        }
        Command::Redo if session.done_steps() == session.steps().len() => {
            Some("There is nothing to redo")
        }
        Command::CopyLink if has_files(session) => {
            Some("A link holds no files, and this scene has some (Save with Files)")
        }
        Command::UnpinAll if !posing::has_pins(session) => Some("Nothing is pinned"),
        Command::ToggleGrid if session.view().look == Look::Course => {
            Some("The Course look has no ground (View ⏵ Look ⏵ Studio)")
        }
        Command::ToggleBones if session.view().look != Look::Mannequin => Some(
            "Only the Mannequin look has them (View ⏵ Look); Model Display Mode in the panel shows skeletons",
        ),
        Command::PinJoint if posing::joints_to_pin(session).is_none() => {
            Some("No joint is selected or under the pointer")
        }
        Command::Delete
        | Command::Reset
        | Command::Cut
        | Command::Copy
        | Command::Duplicate
        | Command::ExportSelected
        | Command::Rename
        | Command::ToggleVisible
        | Command::ToggleLocked
            if session.selected().is_none() =>
        {
            Some("No shape is selected")
        }
        Command::Cut if posed_character(session, state).is_some() => Some(
            "The Pose and IK tools copy the pose, and cut nothing: the Select tool (V) cuts the character",
        ),
        Command::ResetPosition | Command::ResetRotation | Command::ResetScale => {
            why_nothing_back(command, session)
        }
        Command::Begin(does) => why_nothing_begins(does, session, state.pose.tool),
        Command::SelectAll
        | Command::InvertSelection
        | Command::BoxSelect
        | Command::ExportGeometry
        | Command::ExportMaterials
            if session.scene().shapes().is_empty() =>
        {
            Some("There is no shape")
        }
        Command::Explain if !state.explain.is_open() && !has_character(session) => {
            Some("There is no character")
        }
        Command::CompareMesh if state.compares[1] => None,
        Command::CompareMesh if character_to_compare(session).is_none() => {
            Some("No character is selected")
        }
        Command::ExportCharacter if selected_character(session).is_none() => {
            Some("No character is selected")
        }
        Command::ExportCurve if selected_curves(session).is_none() => Some("No curve is selected"),
        Command::MakeSurfaceOfRevolution => revolution(session).err(),
        Command::MakeSweep => sweep(session).err(),
        _ if is_in(Menu::Pose, command) => why_no_pose(command, session),
        Command::HideOthers if session.selected().is_none() => Some("No shape is selected"),
        Command::HideOthers if others(session).next().is_none() => Some("No other shape is shown"),
        Command::ShowAll if hidden(session).next().is_none() => Some("No shape is hidden"),
        Command::SelectNone if session.selected().is_none() => Some("No shape is selected"),
        Command::Fit | Command::FitAll
            if !session.scene().shapes().iter().any(|shape| shape.visible) =>
        {
            Some("There is nothing to fit")
        }
        _ => None,
    }
}

fn has_character(session: &Session) -> bool {
    let mut shapes = session.scene().shapes().iter();
    shapes.any(|shape| matches!(shape.kind, ShapeKind::Character(_)))
}

/// Whether the scene needs files that are not built in. Curves are in the scene itself.
fn has_files(session: &Session) -> bool {
    let needs = |shape: &Shape| {
        let is_curve = matches!(shape.kind, ShapeKind::Curve(_));
        let mut source = shape.source.iter();
        !is_curve && source.any(|source| !source.is_builtin())
    };
    session.scene().shapes().iter().any(needs)
}

/// Why nothing can be done to the selection with the pointer. With a tool that poses, all of the character would move in
/// place of a bone.
fn why_nothing_begins(does: Tool, session: &Session, tool: Tool) -> Option<&'static str> {
    let Some(id) = session.selected() else {
        return Some("No shape is selected");
    };
    let shape = session.evaluated().shape(id);
    let is_free = shape.is_some_and(|shape| shape.pickable);
    if !is_free {
        return Some("The selected shape is hidden or locked");
    }
    if !matches!(tool, Tool::Pose | Tool::Ik) || session.scene().character(id).is_none() {
        return None;
    }
    if session.selected_joint().is_none() {
        // Who has just clicked beside a bone does not mean the whole figure.
        return Some(match does {
            Tool::Rotate => {
                "No joint is selected: click one. The Select tool (V) turns the character"
            }
            Tool::Scale => "A bone only turns (R). The Select tool (V) scales the character",
            _ => "No joint is selected: click one. The Select tool (V) moves the character",
        });
    }
    match does {
        Tool::Move if tool == Tool::Pose && selected_roots(session, id).is_none() => Some(
            "Only the root moves: a bone turns (R). With the Select tool (V), G moves the character",
        ),
        Tool::Scale => {
            Some("A bone only turns (R). With the Select tool (V), S scales the character")
        }
        _ => None,
    }
}

/// Why a command about poses is disabled.
fn why_no_pose(command: Command, session: &Session) -> Option<&'static str> {
    let Some((_, character)) = selected_character(session) else {
        return Some("No character is selected");
    };
    let pose = character.pose();
    let joints = session.selected_joints();
    let roots = character.character.skeleton().roots();
    match command {
        Command::ResetJoint
        | Command::ResetAngles
        | Command::ResetOffset
        | Command::MirrorJoints
            if joints.is_empty() =>
        {
            Some("No joint is selected")
        }
        Command::ResetJoint if !joints.iter().any(|&joint| pose.is_changed(joint)) => {
            Some(match joints.len() {
                1 => "The joint is at rest. Esc deselects it; then this is about the character",
                _ => "The joints are at rest. Esc deselects them; then this is about the character",
            })
        }
        Command::ResetAngles
            if joints
                .iter()
                .all(|&joint| pose.rotation(joint) == Euler::ZERO) =>
        {
            Some(match joints.len() {
                1 => "The joint is turned as at rest",
                _ => "The joints are turned as at rest",
            })
        }
        Command::ResetOffset if !joints.iter().any(|joint| roots.contains(joint)) => {
            Some("Only roots have an offset: other joints turn")
        }
        Command::ResetOffset
            if joints
                .iter()
                .all(|&joint| pose.root_offset(joint) == Vec3::ZERO) =>
        {
            Some("The root is where it is at rest")
        }
        Command::ResetPose if character.is_at_rest() => Some("Every joint is at rest"),
        Command::MirrorPose if pose.is_bind() => {
            Some("There is nothing to mirror: every joint is at rest")
        }
        Command::MirrorJoints => mirror_joints(session).err(),
        _ => None,
    }
}
