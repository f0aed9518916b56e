//! What the arrow keys do to bones.

use super::pointer::select;
use super::{LetGo, PoseState, Rolled};
use crate::editor::{ROLL_STEP, Session, Tool, roll};
use crate::scene::ShapeId;
use crate::ui::grab::is_pickable;
use crate::ui::{Action, GestureStep, Navigation, UiState};
use egui::{Context, Event, Key, Modifiers};

/// Rolls the bone under the pointer, or else one of the selected joint, about its own axis while
/// Left or Right is pressed over the view. If the navigation turns the camera by these keys, only
/// the bone under the pointer or its rings, and keys that were pressed beside all bones go on turning the camera until the
/// pointer moves, whatever comes below it. To be called before the panels, which use these keys, too.
pub(in crate::ui) fn roll_by_keys(
    ctx: &Context,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    let is_press = |event: &Event| {
        matches!(
            event,
            Event::Key {
                key: Key::ArrowLeft | Key::ArrowRight,
                pressed: true,
                repeat: false,
                ..
            }
        )
    };
    if ctx.input(|input| input.events.iter().any(is_press)) {
        let pose = &mut state.pose;
        let at = ctx.input(|input| input.pointer.latest_pos());
        let is_beside = pose.hovered.is_none() && pose.hot.is_none();
        pose.turns_camera_at = at.filter(|_| is_beside || pose.turns_camera_at == at);
    }
    if let Some(rolled) = &mut state.pose.rolled
        && !session.is_in_gesture()
    {
        rolled.document.get_or_insert(session.document());
    }
    let pose = &state.pose;
    if pose.tool != Tool::Pose || !pose.over_view {
        return;
    }
    let is_mannequin = state.navigation == Navigation::Mannequin;
    let turns_camera = pose.turns_camera_at.is_some();
    let hovered = pose.hovered.filter(|_| !(is_mannequin && turns_camera));
    let under_pointer = hovered.map(|hit| (hit.shape, hit.bone));
    // Over a ring it is about the bone that this turns.
    let selected = || match is_mannequin && (pose.hot.is_none() || turns_camera) {
        true => None,
        false => bone_of_selected_joint(session, pose),
    };
    let Some((shape, bone)) = under_pointer.or_else(selected) else {
        return;
    };
    let steps = ctx.input_mut(|input| {
        // A press that is consumed does not turn the camera as well.
        let right = input.count_and_consume_key(Modifiers::NONE, Key::ArrowRight) as f32;
        right - input.count_and_consume_key(Modifiers::NONE, Key::ArrowLeft) as f32
    });
    if steps == 0.0 {
        return;
    }
    let Some(edit) = roll(session, shape, bone, steps * ROLL_STEP) else {
        return;
    };
    let document = Some(session.document());
    let goes_on = |rolled: Rolled| rolled.bone == (shape, bone) && rolled.document == document;
    // As one that is dragged, whose numbers the panel shows then; without rings, which would come under the pointer.
    if let Some(hit) = hovered {
        select(session, hit.shape, Some(hit.joint), actions);
    }
    if pose.rolled.is_some_and(goes_on) {
        actions.push(Action::Gesture(GestureStep::BeginOnLastStep));
    }
    actions.push(Action::Edit(edit));
    state.pose.rolled = Some(Rolled {
        bone: (shape, bone),
        document: None,
    });
    // What the roll swings under the pointer is not what is meant by the next tap.
    if let Some(hit) = hovered {
        let at = ctx.input(|input| input.pointer.latest_pos());
        let held = (hit.shape, hit.joint);
        state.pose.let_go = at.map(|at| LetGo::new(at, held, Tool::Pose, session));
        state.pose.taken = Some(hit);
        state.pose.without_gizmo = Some(held);
    }
}

/// Character and index of a bone of the selected joint: the one dragged or clicked last, or else
/// the first.
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
