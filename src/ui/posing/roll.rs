use super::{PoseState, is_pickable};
use crate::editor::{ROLL_STEP, Session, Tool, roll};
use crate::scene::ShapeId;
use crate::ui::{Action, Navigation, UiState};
use egui::{Context, Key, Modifiers};

/// Left and Right over the view roll the bone under the pointer, or else one of the selected
/// joint, about its own axis; where these keys turn the camera, too, only the one under the
/// pointer. Called before the panels, which know these keys too.
pub(in crate::ui) fn roll_by_keys(
    ctx: &Context,
    session: &Session,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let pose = &state.pose;
    if pose.tool != Tool::Pose || !pose.over_view {
        return;
    }
    let under_pointer = pose.hovered.map(|hit| (hit.shape, hit.bone));
    let selected = || match state.navigation {
        Navigation::Mannequin => None,
        _ => bone_of_selected_joint(session, pose),
    };
    let Some((shape, bone)) = under_pointer.or_else(selected) else {
        return;
    };
    let steps = ctx.input_mut(|input| {
        // Held on, they must not turn the camera besides.
        input.keys_down.remove(&Key::ArrowLeft);
        input.keys_down.remove(&Key::ArrowRight);
        let right = input.count_and_consume_key(Modifiers::NONE, Key::ArrowRight) as f32;
        right - input.count_and_consume_key(Modifiers::NONE, Key::ArrowLeft) as f32
    });
    if steps != 0.0 {
        let edit = roll(session, shape, bone, steps * ROLL_STEP);
        actions.extend(edit.map(Action::Edit));
    }
}

/// A character and the index of a bone of it: that taken last, if it is the joint's.
fn bone_of_selected_joint(session: &Session, state: &PoseState) -> Option<(ShapeId, usize)> {
    let shape = session.selected().filter(|&id| is_pickable(session, id))?;
    let joint = session.selected_joint()?;
    let taken = state
        .taken
        .filter(|hit| (hit.shape, hit.joint) == (shape, joint));
    if let Some(hit) = taken {
        return Some((shape, hit.bone));
    }
    let bones = session.scene().character(shape)?.character.bones();
    let first = bones.iter().position(|bone| bone.joint == joint)?;
    Some((shape, first))
}
