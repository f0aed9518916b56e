use super::PoseState;
use crate::editor::{IkGrip, Session, Tool, root_of};
use crate::scene::ShapeId;

/// What the status line says about bones and what is held: its name, and what can be done.
pub(in crate::ui) fn sentence(
    session: &Session,
    state: &PoseState,
) -> Option<(Option<String>, &'static str)> {
    if let Some(gesture) = &state.gesture {
        let over = joint_name(session, gesture.shape(), gesture.named());
        let next = if gesture.snaps() {
            "Ctrl snaps · Esc or right click cancels"
        } else {
            "Esc or right click cancels"
        };
        return Some((over, next));
    }
    let hit = state.hovered?;
    if let Some((shape, grip)) = state.ik.hovered {
        let over = joint_name(session, shape, Some(grip.joint()));
        return Some((over, ik_sentence(session, state, shape, grip)));
    }
    let (joint, next) = match state.tool {
        Tool::Select => (
            Some(hit.joint),
            "Click to select the joint · B turns bones by hand",
        ),
        Tool::Pose => (
            Some(hit.joint),
            "Drag to turn it · Left, Right roll · Ctrl snaps · click for rings",
        ),
        Tool::Move => (
            root_of(session, hit.shape, hit.joint),
            "Drag to move it and what hangs on it · Shift: all roots · Ctrl snaps",
        ),
        Tool::Ik => (Some(hit.joint), "Drag to bring it somewhere"),
    };
    Some((joint_name(session, hit.shape, joint), next))
}

/// What the IK tool would do with what is under the pointer.
fn ik_sentence(session: &Session, state: &PoseState, shape: ShapeId, grip: IkGrip) -> &'static str {
    let settings = state.ik.settings(shape);
    let is_root = root_of(session, shape, grip.joint()) == Some(grip.joint());
    let is_held = grip.chain(session, shape, &settings).is_none();
    let moves_root = is_root && matches!(grip, IkGrip::Joint(_));
    if settings.pins.contains(&grip.joint()) {
        "Pinned: stays while others are dragged · P unpins"
    } else if moves_root {
        "Drag to move it all; pins stay · P pins"
    } else if is_held {
        "A pin above holds it"
    } else {
        "Drag to bring it somewhere, the chain follows · P pins"
    }
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
