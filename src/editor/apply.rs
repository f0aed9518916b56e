use super::apply_curve::apply_curve_edit;
use super::{Change, Edit};
use crate::scene::{CurveSetError, Scene, Shape, ShapeId};
use glam::Vec3;
use std::sync::Arc;

/// Why an edit was refused.
pub type EditError = CurveSetError;

/// Carries out an edit: the only function that changes a scene, and it does nothing else. A change
/// of a shape or joint that does not exist does nothing.
///
/// # Errors
/// If the edit would not leave a valid scene; then the scene is as it was.
pub fn apply(scene: &mut Scene, edit: Edit) -> Result<Change, EditError> {
    let before = scene.clone();
    let opens = matches!(edit, Edit::Open(_));
    if let Err(error) = carry_out(scene, edit) {
        *scene = before;
        return Err(error);
    }
    Ok(if opens {
        Change::opened(scene)
    } else {
        Change::between(&before, scene)
    })
}

fn carry_out(scene: &mut Scene, edit: Edit) -> Result<(), EditError> {
    match edit {
        Edit::Together(edits) => {
            for edit in edits {
                carry_out(scene, edit)?;
            }
        }
        Edit::Open(shapes) => *scene = shapes.into_iter().collect(),
        Edit::Insert(shapes) => scene.extend(shapes),
        Edit::Delete(id) => {
            scene.delete(id);
        }
        Edit::Reset(id) => scene.reset(id),
        Edit::SetTransform(id, transform) => {
            change(scene, id, |shape| shape.placement.transform = transform);
        }
        Edit::SetUniformScaling(id, uniform) => change(scene, id, |shape| {
            shape.placement.uniform_scaling = uniform;
            if uniform {
                let scale = &mut shape.placement.transform.scale;
                *scale = Vec3::splat(scale.x);
            }
        }),
        Edit::SetColor(id, color) => change(scene, id, |shape| shape.placement.color = color),
        Edit::SetVisible(id, visible) => change(scene, id, |shape| shape.visible = visible),
        Edit::SetLocked(id, locked) => change(scene, id, |shape| shape.locked = locked),
        character @ (Edit::SetDisplay(..)
        | Edit::LimitInfluences(..)
        | Edit::SetJointAngle { .. }
        | Edit::SetJointTransform { .. }
        | Edit::SetRootOffset { .. }
        | Edit::ResetJoint(..)
        | Edit::KeepPose { .. }
        | Edit::ForgetPose(..)
        | Edit::SetPose(..)) => apply_character_edit(scene, character),
        curve => apply_curve_edit(scene, curve)?,
    }
    Ok(())
}

/// Carries out the edits that concern a character.
fn apply_character_edit(scene: &mut Scene, edit: Edit) {
    match edit {
        Edit::SetDisplay(id, display) => {
            if let Some(character) = scene.character_mut(id) {
                character.display = display;
            }
        }
        Edit::LimitInfluences(id, most) => {
            if let Some(shape) = scene.character_mut(id) {
                shape.character = Arc::new(shape.character.limited(most));
            }
        }
        Edit::SetJointAngle {
            shape,
            joint,
            axis,
            radians,
        } => change_pose(scene, shape, joint, |pose| {
            let mut rotation = pose.rotation(joint);
            rotation.radians[axis.min(2)] = radians;
            pose.set_joint_transform(joint, rotation);
        }),
        Edit::SetJointTransform {
            shape,
            joint,
            rotation,
        } => change_pose(scene, shape, joint, |pose| {
            pose.set_joint_transform(joint, rotation)
        }),
        Edit::SetRootOffset {
            shape,
            root,
            offset,
        } => change_pose(scene, shape, root, |pose| {
            pose.set_root_offset(root, offset)
        }),
        Edit::ResetJoint(shape, joint) => {
            change_pose(scene, shape, joint, |pose| pose.reset_joint(joint));
        }
        Edit::KeepPose { shape, name } => {
            if let Some(character) = scene.character_mut(shape) {
                character.keep_pose(name);
            }
        }
        Edit::ForgetPose(id, index) => {
            if let Some(character) = scene.character_mut(id) {
                character.forget_pose(index);
            }
        }
        Edit::SetPose(id, pose) => {
            if let Some(character) = scene.character_mut(id) {
                character.set_pose(pose);
            }
        }
        _ => {}
    }
}

fn change(scene: &mut Scene, id: ShapeId, change: impl FnOnce(&mut Shape)) {
    if let Some(shape) = scene.shape_mut(id) {
        change(shape);
    }
}

fn change_pose(
    scene: &mut Scene,
    id: ShapeId,
    joint: usize,
    change: impl FnOnce(&mut crate::character::Pose),
) {
    if let Some(character) = scene.character_mut(id)
        && joint < character.character.skeleton().joints().len()
    {
        let mut pose = character.pose().clone();
        change(&mut pose);
        character.set_pose(pose);
    }
}
