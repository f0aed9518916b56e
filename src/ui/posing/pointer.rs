//! What the pointer does to bones, gizmos and shapes with the chosen tool.

use super::held::{Drag, Held};
use super::shown_gizmo::{begin_by_key, shown_gizmo};
use super::{LetGo, PoseState, ik, shows_skeleton, takes_bones_of};
use crate::editor::{BoneDrag, Edit, IkGrip, MoveDrag, MoveTarget, Session, Tool, View, root_of};
use crate::math::Ray;
use crate::scene::{BoneHit, ShapeId, bones_in_world, pick_bone, turned_there};
use crate::ui::grab::{Grab, PointerUse};
use crate::ui::pointing::Pointing;
use crate::ui::scene_places::{Place, ScenePlaces};
use crate::ui::{Action, GestureStep};
use egui::{CursorIcon, InputState, Pos2, Response};
use glam::Vec2;

/// Distance in points within which a bone is taken, however thin it is: with a mouse or a pen, and
/// with a finger, where nothing is nearer.
const POINTER_REACH: f32 = 8.0;
const FINGER_REACH: f32 = 24.0;

/// Handles the pointer over gizmos, bones and, with the Move tool, shapes, in this order: marks
/// what is under it, selects by click, and turns or moves by drag. `list` is the joint of the
/// selected character whose row in the list is under the pointer, `point` the control point that was
/// clicked last: shape, curve and point.
pub(in crate::ui) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut PoseState,
    (list, point): (Option<usize>, Option<(ShapeId, usize, usize)>),
    actions: &mut Vec<Action>,
) -> PointerUse {
    state.over_view = view.hovered();
    state.by_finger = view.ctx.input(InputState::any_touches);
    // Nothing can follow a finger that is not on the screen: the tool waits for the next drag.
    let by_fingers = Pointing::of(&view.ctx) == Pointing::Fingers;
    if let Some((does, step)) = state.asked.take_if(|_| by_fingers)
        && step == GestureStep::Begin
    {
        state.tool = does;
        let what = match does {
            Tool::Move => "Put a finger on the shape to move it",
            Tool::Rotate => "Put a finger on a ring to turn the shape",
            _ => "Put a finger on a handle to scale the shape",
        };
        actions.push(Action::View(View::Tell(what.into())));
    }
    let inserts = |action: &Action| matches!(action, Action::Edit(Edit::Insert(_)));
    // What is inserted is selected from the next frame on, and what covered the view is gone then.
    let is_covered = view.ctx.memory(|memory| memory.top_modal_layer().is_some());
    if state.asked.is_some() && (is_covered || actions.iter().any(inserts)) {
        view.ctx.request_repaint();
    } else if let Some((does, step)) = state.asked.take().filter(|_| state.gesture.is_none()) {
        state.gesture = Grab::begin_by_key(view, places, (step, actions), |place, pixel| {
            begin_by_key(session, state, (does, point), place, pixel)
        });
    }
    if state.gesture.is_none() {
        let all = view.ctx.input(|input| input.modifiers.shift);
        state.gesture = Grab::begin(view, places, actions, |place, pixel, actions| {
            take(session, state, place, pixel, all, actions)
        });
        let is_toggle = |action: &Action| matches!(action, Action::View(View::ToggleSelected(_)));
        if state.gesture.is_some() && actions.iter().any(is_toggle) {
            // Another shape is active from the next frame on, and all others follow that one.
            view.ctx.request_repaint();
            return PointerUse::Holding;
        }
    }
    if let Some(gesture) = &mut state.gesture {
        let held = gesture.held();
        let held = held.joint().map(|joint| (held.shape(), joint));
        let lost = gesture.active().and_then(Held::lost_pins);
        let before = actions.len();
        let goes_on = gesture.follow(view, places, session, actions);
        let is_kept = actions[before..]
            .iter()
            .any(|action| matches!(action, Action::Gesture(GestureStep::Commit)));
        if let Some(what) = lost.filter(|_| is_kept) {
            actions.push(Action::View(View::Tell(what.into())));
        }
        if !goes_on {
            state.gesture = None;
            let at = view.ctx.input(|input| input.pointer.latest_pos());
            let held = at.zip(held);
            state.let_go = held.map(|(at, held)| LetGo::new(at, held, state.tool, session));
        }
        view.ctx.set_cursor_icon(CursorIcon::Grabbing);
        mark(session, held, actions);
        return PointerUse::Holding;
    }
    let at = view.hover_pos().filter(|_| !view.clicked());
    let tool = state.tool;
    let is_at_hand = |let_go: &LetGo| let_go.is_at_hand(at, tool, session);
    state.let_go = state.let_go.take().filter(is_at_hand);
    if let Some(held) = state.let_go.as_ref().map(|let_go| let_go.held)
        && let Some(hit) = state.taken.filter(|hit| (hit.shape, hit.joint) == held)
    {
        state.hovered = Some(hit);
        mark(session, Some(held), actions);
        return PointerUse::Over;
    }
    // A finger that lies on a bone has not said yet what it wants; one that has tapped it has.
    let under = view
        .hover_pos()
        .filter(|_| !view.dragged() && (!state.by_finger || view.clicked()))
        .map_or(Under::Nothing, |at| under(session, state, places, at));
    let bone = match under {
        Under::Bone(hit, place) => Some((hit, place)),
        _ => None,
    };
    state.hovered = bone.map(|(hit, _)| hit);
    state.hovered_grip = bone
        .filter(|_| state.tool == Tool::Ik)
        .and_then(|(hit, place)| {
            let grip = IkGrip::of(session, &hit, &place.screen(session))?;
            Some((hit.shape, grip))
        });
    let in_list = session.selected().zip(list);
    let in_view = bone.map(|(hit, place)| {
        let joint = target_joint(session, state.tool, &hit, place);
        (hit.shape, joint)
    });
    mark(session, in_view.or(in_list), actions);
    match under {
        Under::Nothing => return PointerUse::Free,
        Under::Shape => {
            view.ctx.set_cursor_icon(CursorIcon::Grab);
            return PointerUse::Free;
        }
        // A handle is dragged: a click on it means the bone that is there.
        Under::Handle(Some((hit, place))) | Under::Bone(hit, place) if view.clicked() => {
            let joint = target_joint(session, state.tool, &hit, place);
            let adds = |input: &InputState| input.modifiers.shift || input.modifiers.command;
            let adds = view.ctx.input(adds);
            let is_of_other = session.selected() != Some(hit.shape);
            if adds && is_of_other && !session.selected_joints().is_empty() {
                let why = "Joints of one character at a time are selected: those of the other one no longer are";
                actions.push(Action::View(View::Tell(why.into())));
            }
            state.taken = Some(hit);
            state.without_gizmo = None;
            if adds && !is_of_other {
                actions.push(Action::View(View::ToggleJoint(joint)));
            } else {
                select_alone(session, hit.shape, Some(joint), actions);
            }
        }
        Under::Handle(_) | Under::Bone(..) => {}
    }
    if state.tool != Tool::Select {
        view.ctx.set_cursor_icon(CursorIcon::Grab);
    }
    PointerUse::Over
}

/// Puts back what is dragged, and marks no bone.
pub(in crate::ui) fn put_back(session: &Session, state: &mut PoseState, actions: &mut Vec<Action>) {
    if let Some(gesture) = state.gesture.take() {
        gesture.put_back(actions);
    }
    state.hovered = None;
    state.hovered_grip = None;
    mark(session, None, actions);
}

/// Things under the pointer that the chosen tool acts on.
enum Under {
    Nothing,
    /// A handle of a gizmo, and with the Pose tool the bone that is there, too.
    Handle(Option<(BoneHit, Place)>),
    /// A bone, in this picture of the scene.
    Bone(BoneHit, Place),
    /// With the Move tool alone.
    Shape,
}

fn under(session: &Session, state: &mut PoseState, places: &ScenePlaces, at: Pos2) -> Under {
    let Some(place) = places.live_at(at) else {
        return Under::Nothing;
    };
    let pixel = place.pixel(at);
    let bone = bone_at(session, (state.tool, state.by_finger), place, pixel);
    let gizmo = shown_gizmo(session, state, place);
    let handle = gizmo.and_then(|gizmo| gizmo.hit_beside_bones(pixel, || bone.is_some()));
    if handle.is_some() {
        let bone = bone.filter(|_| state.tool == Tool::Pose);
        return Under::Handle(bone.map(|hit| (hit, place)));
    }
    if let Some(hit) = bone {
        return Under::Bone(hit, place);
    }
    let mut is_shape = || {
        state
            .picked
            .shape_at(session, pixel, place.size())
            .is_some()
    };
    if state.tool == Tool::Move && is_shape() {
        return Under::Shape;
    }
    Under::Nothing
}

/// The bone under the pointer: of a character whose bones the tool takes or whose skeleton is displayed; with tools that
/// turn and scale shapes none.
pub(super) fn bone_at(
    session: &Session,
    (tool, by_finger): (Tool, bool),
    place: Place,
    pixel: Vec2,
) -> Option<BoneHit> {
    if matches!(tool, Tool::Rotate | Tool::Scale) {
        return None;
    }
    let camera = &session.view().camera;
    let at = |reach| {
        pick_bone(
            session.scene(),
            session.evaluated(),
            camera,
            pixel,
            place.size(),
            reach,
        )
    };
    let by_finger = || by_finger.then(|| at(FINGER_REACH)).flatten();
    let hit = at(POINTER_REACH).or_else(by_finger)?;
    let hit = match tool {
        // It leads the end of a bone, and the ball belongs to that.
        Tool::Ik => hit,
        _ => {
            let (scene, evaluated) = (session.scene(), session.evaluated());
            turned_there(scene, evaluated, camera, hit, (pixel, place.size()))
        }
    };
    let is_taken = takes_bones_of(session, tool, hit.shape) || shows_skeleton(session, hit.shape);
    is_taken.then_some(hit)
}

/// The joint that a tool acts on when it takes a bone.
fn target_joint(session: &Session, tool: Tool, hit: &BoneHit, place: Place) -> usize {
    let meant = match tool {
        Tool::Select | Tool::Pose | Tool::Rotate | Tool::Scale => None,
        Tool::Move => root_of(session, hit.shape, hit.joint),
        Tool::Ik => IkGrip::of(session, hit, &place.screen(session)).map(IkGrip::joint),
    };
    meant.unwrap_or(hit.joint)
}

/// Begins a drag of what is at `pixel`: a gizmo's handle, a bone or a shape. With `all`, roots move
/// together.
fn take(
    session: &Session,
    state: &mut PoseState,
    place: Place,
    pixel: Vec2,
    all: bool,
    actions: &mut Vec<Action>,
) -> Option<Held> {
    if state.tool == Tool::Select {
        return None;
    }
    let screen = place.screen(session);
    let ray = screen.ray(pixel);
    let bone = bone_at(session, (state.tool, state.by_finger), place, pixel);
    if let Some(gizmo) = shown_gizmo(session, state, place)
        && let Some(hit) = gizmo.hit_beside_bones(pixel, || bone.is_some())
    {
        return gizmo.take(session, state, place, (hit, pixel), all);
    }
    if let Some(hit) = bone {
        let drag = match state.tool {
            Tool::Pose => turn_bone(session, state, hit, (pixel, place.size()))?,
            Tool::Ik => ik::take(session, &hit, &screen, &ray)?,
            _ => move_root(session, hit, &ray, all)?,
        };
        state.taken = Some(hit);
        let joint = target_joint(session, state.tool, &hit, place);
        select(session, hit.shape, Some(joint), actions);
        return Some(Held::new(drag, None, ray, state.axes));
    }
    if state.tool != Tool::Move {
        return None;
    }
    let shape = state.picked.shape_at(session, pixel, place.size())?;
    let target = MoveTarget::Shape(shape);
    let drag = MoveDrag::begin(session, target, target.free(session), &ray)?;
    if session.is_selected(shape) && session.selected() != Some(shape) {
        // Taken out and added again it is the active one, and all others stay selected.
        let toggle = Action::View(View::ToggleSelected(shape));
        actions.extend([toggle.clone(), toggle]);
    } else {
        select(session, shape, None, actions);
    }
    Some(Held::new(Drag::Move(drag), None, ray, state.axes))
}

/// How far from its joint a bone is grabbed, in points, that points to the pointer from then on: nearer, its direction
/// from the joint is any.
const AT_JOINT: f32 = 10.0;

/// Begins to turn a bone that is grabbed at a pixel of a view of this size.
fn turn_bone(
    session: &Session,
    state: &mut PoseState,
    hit: BoneHit,
    (pixel, size): (Vec2, Vec2),
) -> Option<Drag> {
    let camera = &session.view().camera;
    let eye = camera.eye();
    let mut drag = BoneDrag::begin(
        session,
        hit.shape,
        hit.joint,
        (eye, hit.point),
        state.together,
    )?;
    let shape = session.evaluated().shape(hit.shape)?;
    let (_, joint, tip) = bones_in_world(session.scene(), shape).nth(hit.bone)?;
    let at = camera.pixel(joint, size);
    if let Some(at) = at.filter(|at| at.distance(pixel) < AT_JOINT) {
        let [joint, beside] =
            [at, at + AT_JOINT * Vec2::X].map(|at| camera.ray(at, size).direction);
        drag = drag.pointing(eye, tip, f64::from(joint.angle_between(beside)));
    }
    state.without_gizmo = Some((hit.shape, hit.joint));
    Some(Drag::Bone(drag))
}

fn move_root(session: &Session, hit: BoneHit, ray: &Ray, all: bool) -> Option<Drag> {
    let root = MoveTarget::Root {
        shape: hit.shape,
        joint: root_of(session, hit.shape, hit.joint)?,
    };
    let target = if all { root.all_roots() } else { root };
    let drag = MoveDrag::begin(session, target, target.free(session), ray)?;
    Some(Drag::Move(drag))
}

/// Selects a shape and one joint of it, or none, and no other.
fn select_alone(
    session: &Session,
    shape: ShapeId,
    joint: Option<usize>,
    actions: &mut Vec<Action>,
) {
    let is_other = session.selected() != Some(shape);
    if is_other {
        actions.push(Action::View(View::Select(Some(shape))));
    }
    if is_other || session.selected_joints() != joint.as_slice() {
        actions.push(Action::View(View::SelectJoint(joint)));
    }
}

/// The same, but where the joint is selected among others it becomes the active one of them.
pub(super) fn select(
    session: &Session,
    shape: ShapeId,
    joint: Option<usize>,
    actions: &mut Vec<Action>,
) {
    let among = joint.filter(|joint| session.selected_joints().contains(joint));
    match among.filter(|_| session.selected() == Some(shape)) {
        Some(joint) if session.selected_joint() != Some(joint) => {
            // Taken out and added again it is the active one.
            let toggle = Action::View(View::ToggleJoint(joint));
            actions.extend([toggle.clone(), toggle]);
        }
        Some(_) => {}
        None => select_alone(session, shape, joint, actions),
    }
}

/// Marks a bone as hovered, or none.
fn mark(session: &Session, bone: Option<(ShapeId, usize)>, actions: &mut Vec<Action>) {
    if bone != session.hovered_bone() {
        actions.push(Action::View(View::HoverBone(bone)));
    }
}
