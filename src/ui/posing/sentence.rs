use super::PoseState;
use crate::editor::{Session, Tool};
use crate::scene::ShapeId;

/// What the status line says about bones and what is held: its name, and what can be done.
pub(in crate::ui) fn sentence(
    session: &Session,
    state: &PoseState,
) -> Option<(Option<String>, &'static str)> {
    if let Some(gesture) = &state.gesture {
        let over = joint_name(session, gesture.shape(), gesture.joint());
        return Some((over, "Ctrl snaps · Esc or right click cancels"));
    }
    let hit = state.hovered?;
    let next = match state.tool {
        Tool::Select => "Click to select the joint · B turns bones by hand",
        Tool::Pose => "Drag to turn it · Left, Right roll · Ctrl snaps · click for rings",
        Tool::Move => "Drag to move its root · Shift: all roots · Ctrl snaps",
    };
    Some((joint_name(session, hit.shape, Some(hit.joint)), next))
}

/// What a joint is called, or else its shape.
pub(super) fn joint_name(
    session: &Session,
    shape: ShapeId,
    joint: Option<usize>,
) -> Option<String> {
    let joint = joint.and_then(|joint| {
        let character = session.scene().character(shape)?;
        Some(&character.character.skeleton().joints().get(joint)?.name)
    });
    joint
        .or_else(|| Some(&session.scene().shape(shape)?.name))
        .cloned()
}
