use super::apply_curve::apply_curve_edit;
use super::{Edit, Session, Severity, View};
use crate::math::Aabb;
use crate::scene::{Camera, Scene, Shape, ShapeId};
use glam::Vec3;

/// Carries out a change of the scene: the only place that does. A change to a shape or joint
/// that no longer exists does nothing.
pub fn apply_edit(session: &mut Session, edit: Edit) {
    let scene = &mut session.scene;
    match edit {
        Edit::Insert { name, kind, source } => {
            session.selected = Some(scene.add(name, kind, source));
            session.forget_parts();
        }
        Edit::Delete(id) => delete(session, id),
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
        Edit::SetDisplay(id, display) => {
            if let Some(character) = scene.character_mut(id) {
                character.display = display;
            }
        }
        Edit::SetJointTransform {
            shape,
            joint,
            rotation,
        } => {
            change_pose(scene, shape, joint, |pose| {
                pose.set_joint_transform(joint, rotation)
            });
        }
        Edit::SetRootOffset {
            shape,
            root,
            offset,
        } => {
            change_pose(scene, shape, root, |pose| {
                pose.set_root_offset(root, offset)
            });
        }
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
        Edit::SetControlPoint { .. }
        | Edit::AddControlPoint { .. }
        | Edit::RemoveControlPoint { .. }
        | Edit::AddCurve(..)
        | Edit::RemoveCurveItem { .. }
        | Edit::SetCurves(..)
        | Edit::SetSteps { .. }
        | Edit::SetRadius { .. }
        | Edit::SetFrameClosing(..)
        | Edit::SetCurveDisplay(..)
        | Edit::MakeSurfaceOfRevolution { .. }
        | Edit::MakeSweep { .. } => {
            if let Err(refused) = apply_curve_edit(scene, edit) {
                session.messages.tell(Severity::Error, refused.to_string());
            }
        }
    }
    session.refresh();
}

/// Carries out a change of the view.
pub fn apply_view(session: &mut Session, view: View) {
    match view {
        View::SetCamera(camera) => session.view.camera = camera,
        View::From(direction) => session.view.camera = Camera::preset(direction),
        View::ResetCamera => session.view.camera = Camera::default(),
        View::Fit { aspect } => {
            let bounds = bounds_to_fit(session);
            session.view.camera.fit(&bounds, aspect);
        }
        View::SetAxis(axis) => session.view.axis = axis,
        View::SetGrid(grid) => session.view.grid = grid,
        View::SetLook(look) => session.view.look = look,
        View::SetShading(shading) => session.view.shading = shading,
        View::Select(selected) => {
            if selected != session.selected {
                session.forget_parts();
            }
            session.selected = selected;
        }
        View::SelectJoint(joint) => session.selected_joint = joint,
        View::HoverJoint(joint) => session.hovered_bone = session.selected.zip(joint),
        View::HoverBone(bone) => session.hovered_bone = bone,
        View::HoverControlPoint(point) => session.hovered_control_point = point,
        View::DismissMessage(index) => session.messages.dismiss(index),
        View::DismissMessages => session.messages.dismiss_all(),
    }
    session.refresh();
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

/// Deleting the selected shape selects the one that takes its place in the list, as in the
/// course's editor.
fn delete(session: &mut Session, id: ShapeId) {
    let index = session
        .scene
        .shapes()
        .iter()
        .position(|shape| shape.id == id);
    session.scene.delete(id);
    if session.selected == Some(id) {
        let shapes = session.scene.shapes();
        let next = index.map(|index| index.min(shapes.len().saturating_sub(1)));
        session.selected = next
            .and_then(|index| shapes.get(index))
            .map(|shape| shape.id);
        session.forget_parts();
    }
}

fn bounds_to_fit(session: &Session) -> Aabb {
    session
        .selected
        .and_then(|id| session.evaluated().shape(id))
        .filter(|shape| shape.visible)
        .map_or_else(
            || session.evaluated().world_bounds(),
            |shape| shape.world_bounds(),
        )
}
