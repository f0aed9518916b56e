//! What commands about poses and the joints at hand do.

use super::Command;
use super::run::selected_character;
use crate::character::Mirror;
use crate::editor::{Edit, Session, Tool};
use crate::math::Euler;
use crate::scene::{Camera, FitArea, ShapeId};
use crate::ui::state::UiState;
use crate::ui::{Action, Ask, Navigation};
use glam::Vec3;

/// The character whose pose is copied rather than itself: the selected one, with a tool that poses.
pub(super) fn posed_character(session: &Session, state: &UiState) -> Option<ShapeId> {
    let poses = matches!(state.pose.tool, Tool::Pose | Tool::Ik);
    let (id, _) = selected_character(session).filter(|_| poses)?;
    Some(id)
}

/// Action of a command about the pose of the selected character.
pub(super) fn pose_action(command: Command, session: &Session) -> Option<Action> {
    let (shape, character) = selected_character(session)?;
    let edit = match command {
        Command::ResetJoint => {
            let joints = session.selected_joints().iter();
            Edit::Together(
                joints
                    .map(|&joint| Edit::ResetJoint(shape, joint))
                    .collect(),
            )
        }
        Command::ResetAngles => {
            let joints = session.selected_joints().iter();
            let at_rest = joints.map(|&joint| Edit::SetJointTransform {
                shape,
                joint,
                rotation: Euler::ZERO,
            });
            Edit::Together(at_rest.collect())
        }
        Command::ResetOffset => {
            let roots = character.character.skeleton().roots();
            let selected = session.selected_joints().iter();
            let selected = selected.filter(|joint| roots.contains(joint));
            let at_rest = selected.map(|&root| Edit::SetRootOffset {
                shape,
                root,
                offset: Vec3::ZERO,
            });
            Edit::Together(at_rest.collect())
        }
        Command::ResetPose => Edit::ResetPose(shape),
        Command::MirrorPose => {
            let mirror = Mirror::new(character.character.skeleton());
            Edit::SetPose(shape, mirror.pose(character.pose()))
        }
        Command::MirrorJoints => return mirror_joints(session).ok().map(Action::Edit),
        Command::KeepPose => Edit::KeepPose {
            shape,
            name: character.free_pose_name(),
        },
        Command::PastePose => return Some(Action::Ask(Ask::PastePose(shape))),
        Command::PastePoseMirrored => return Some(Action::Ask(Ask::PastePoseMirrored(shape))),
        Command::SavePose => return Some(Action::Ask(Ask::SavePose(shape, None))),
        Command::LoadPose => return Some(Action::Ask(Ask::LoadPose(shape))),
        _ => return None,
    };
    Some(Action::Edit(edit))
}

/// Gives the joints on the other side the pose of the selected ones, mirrored.
///
/// # Errors
/// In words why that is not possible.
pub(super) fn mirror_joints(session: &Session) -> Result<Edit, &'static str> {
    let (shape, character) = selected_character(session).ok_or("No character is selected")?;
    let mirror = Mirror::new(character.character.skeleton());
    let selected = session.selected_joints().iter();
    let other_side = selected.map(|&joint| (joint, mirror.partner(joint)));
    let other_side = other_side.filter(|(joint, partner)| joint != partner);
    let other_side: Vec<usize> = other_side.map(|(_, partner)| partner).collect();
    if other_side.is_empty() {
        return Err("The selected joint has none on the other side");
    }
    let is_selected = |joint: &usize| session.selected_joints().contains(joint);
    if other_side.iter().any(is_selected) {
        return Err("Joints of both sides are selected (Mirror Pose exchanges them)");
    }
    let pose = character.pose();
    let posed = pose.with_joints_of(&mirror.pose(pose), &other_side);
    Ok(Edit::SetPose(shape, posed))
}

/// The selected joints, where commands about the pose are about them alone: bones are posed in Blender's navigation.
fn joints_alone<'a>(session: &'a Session, state: &UiState) -> Option<&'a [usize]> {
    posed_character(session, state)?;
    let joints = session.selected_joints();
    let is_meant = !joints.is_empty() && state.navigation == Navigation::Blender;
    is_meant.then_some(joints)
}

/// Copies the pose of a character, as in Blender of the selected joints alone.
pub(super) fn copied_pose(shape: ShapeId, session: &Session, state: &UiState) -> Ask {
    let joints = joints_alone(session, state).unwrap_or_default().to_vec();
    Ask::CopyPose { shape, joints }
}

/// Pastes a pose onto the selected joints alone, as in Blender.
pub(super) fn pasted_onto(command: Command, session: &Session, state: &UiState) -> Option<Action> {
    let is_pasted = matches!(
        command,
        Command::Paste | Command::PastePose | Command::PastePoseMirrored
    );
    let joints = joints_alone(session, state).filter(|_| is_pasted)?;
    let (_, character) = selected_character(session)?;
    let are_all = joints.len() == character.character.skeleton().joints().len();
    if are_all {
        return None;
    }
    Some(Action::Ask(Ask::PastePoseOnto {
        shape: posed_character(session, state)?,
        joints: joints.to_vec(),
        mirrored: command == Command::PastePoseMirrored,
    }))
}

/// The camera that has the selected joints with their skin in its `area`, as in Blender while its navigation is chosen and
/// bones are posed.
pub(super) fn fitted_to_joints(
    session: &Session,
    state: &UiState,
    area: FitArea,
) -> Option<Camera> {
    let shape = posed_character(session, state)?;
    let evaluated = session.evaluated().shape(shape)?;
    let joints = session.selected_joints();
    let mut camera = session.view().camera;
    let is_meant = state.navigation == Navigation::Blender
        && camera.fit_joints(session.scene(), evaluated, joints, area);
    is_meant.then_some(camera)
}
