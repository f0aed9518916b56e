//! What menu items and keys do with the pose of the selected character.

use super::keys::Command;
use crate::character::{Mirror, Pose};
use crate::editor::{Edit, Session};
use crate::scene::{CharacterShape, ShapeId};
use crate::ui::{Action, Ask};

/// What a command starts; `None` if it is not about poses.
pub(super) fn run(command: Command, session: &Session) -> Option<Action> {
    let (shape, character) = selected(session)?;
    let edit = match command {
        Command::ResetJoint => Edit::ResetJoint(shape, session.selected_joint()?),
        Command::ResetPose => Edit::SetPose(shape, Pose::new()),
        Command::MirrorPose => {
            let mirror = Mirror::new(character.character.skeleton());
            Edit::SetPose(shape, mirror.pose(character.pose()))
        }
        Command::KeepPose => Edit::KeepPose {
            shape,
            name: character.free_pose_name(),
        },
        Command::CopyPose => return Some(Action::Ask(Ask::CopyPose(shape))),
        Command::PastePose => return Some(Action::Ask(Ask::PastePose(shape))),
        Command::SavePose => return Some(Action::Ask(Ask::SavePose(shape, None))),
        Command::LoadPose => return Some(Action::Ask(Ask::LoadPose(shape))),
        _ => return None,
    };
    Some(Action::Edit(edit))
}

/// Why a command about poses cannot be used now.
pub(super) fn why_disabled(command: Command, session: &Session) -> Option<&'static str> {
    let Some((_, character)) = selected(session) else {
        return Some("No character is selected");
    };
    let pose = character.pose();
    match (command, session.selected_joint()) {
        (Command::ResetJoint, None) => Some("No joint is selected"),
        (Command::ResetJoint, Some(joint)) if !pose.is_changed(joint) => {
            Some("The joint is at rest")
        }
        (Command::ResetPose | Command::MirrorPose, _) if pose.is_bind() => {
            Some("Every joint is at rest")
        }
        _ => None,
    }
}

fn selected(session: &Session) -> Option<(ShapeId, &CharacterShape)> {
    let id = session.selected()?;
    Some((id, session.scene().character(id)?))
}
