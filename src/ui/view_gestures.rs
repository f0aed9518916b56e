//! Gestures in the view: what takes the pointer, the camera, and selection.

use super::grab::PointerUse;
use super::navigation::PointerMove;
use super::scene_places::ScenePlaces;
use super::{Action, UiState, box_select, context_menu, control_points, explain, fingers, posing};
use crate::editor::{Session, Tool, View};
use crate::scene::{Look, ShapeId};
use egui::{Event, Key, Modifiers, MouseWheelUnit, Response};
use glam::{Vec2, Vec3};

/// Scrolling of a touchpad, in points, that counts as one notch of a wheel.
const POINTS_PER_NOTCH: f32 = 50.0;

/// Logarithm of the zoom of a touchpad that counts as one notch of a wheel.
const ZOOM_PER_NOTCH: f32 = 0.1;

/// Handles the pointer over the scene: drags and the wheel move the camera according to the
/// [`super::Navigation`], and a click selects the shape under the pointer, or the vertex that is to be
/// explained. Control points of the
/// selected curves take precedence, then gizmos and bones, and with the Move tool shapes: a left
/// drag takes what is under the pointer. A second finger puts that back, and both move the camera.
///
/// `view` is the widget that [`super::show`] returns; panels and windows over it keep the pointer
/// to themselves. `places` are the pictures of the scene in it. Returns the shape under the
/// pointer.
pub fn view_gestures(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) -> Option<ShapeId> {
    let shape = gestures(view, places, session, state, actions);
    let pressed_long = fingers::lifted_after_rest(view, &mut state.finger_rested);
    let clicked = view.secondary_clicked() && !view.long_touched() && !state.gesture_under_way();
    let asked = view.interact_pointer_pos().filter(|_| clicked);
    if let Some(at) = pressed_long.or(asked) {
        let held = state.pose.let_go.as_ref().map(|let_go| let_go.held);
        let held = held.filter(|_| pressed_long.is_some());
        context_menu::ask(places, session, state, at, held, actions);
    }
    control_points::forget_clicked(&mut state.curves, actions);
    shape
}

fn gestures(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) -> Option<ShapeId> {
    if fingers::pointer(view, places, session, state, actions) {
        return None;
    }
    let navigation = state.navigation;
    state.pose.together = navigation.together();
    let box_of = |state: &mut UiState, under, actions: &mut Vec<Action>| {
        let boxed = (&mut state.box_select, navigation, state.pose.tool);
        box_select::pointer(view, places, session, boxed, under, actions)
    };
    if box_of(state, None, actions) == PointerUse::Holding {
        return None;
    }
    let mut pointer = PointerUse::Free;
    // What a key has asked for begins also where the pointer is over a point.
    if state.pose.gesture.is_none() && state.pose.asked.is_none() {
        pointer = control_points::pointer(view, places, session, &mut state.curves, actions);
    }
    let over_point = pointer != PointerUse::Free;
    if pointer == PointerUse::Free {
        let list = state.joints.hovered.or(state.explain.lit());
        let chosen = (list, control_points::clicked(session, &state.curves));
        pointer = posing::pointer(view, places, session, &mut state.pose, chosen, actions);
    }
    if pointer == PointerUse::Holding
        || box_of(state, Some(pointer), actions) == PointerUse::Holding
    {
        return None;
    }
    put_back_on_esc(view, session, state, actions);
    let moved = pointer_move(view, places, session, &mut state.held_point);
    let camera = session.view().camera;
    let camera = state.navigation.moved(camera, view, &moved);
    if camera != session.view().camera {
        actions.push(Action::View(View::SetCamera(camera)));
    }
    let selects = pointer == PointerUse::Over;
    let picks = !over_point
        && explain::pointer(view, places, session, &mut state.explain, selects, actions);
    if selects {
        return None;
    }
    if view.clicked() && !picks {
        let clicked = view.interact_pointer_pos();
        let picked = &mut state.pose.picked;
        let shape = clicked.and_then(|position| picked.shape_at_point(session, places, position));
        let adds = view.ctx.input(|i| i.modifiers.command || i.modifiers.shift);
        let goes_on_posing = posing::posed(session, state.pose.tool).is_some();
        match shape {
            // A click that misses must not lose what was selected before.
            None if adds => return None,
            // Who misses a bone goes on with the same figure; Esc lets it go.
            None if goes_on_posing => actions.push(Action::View(View::SelectJoint(None))),
            Some(shape) if adds => actions.push(Action::View(View::ToggleSelected(shape))),
            _ => actions.push(Action::View(View::Select(shape))),
        }
        if state.pose.tool != Tool::Select {
            actions.push(Action::View(View::SelectJoint(None)));
        }
    }
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    state.pose.picked.shape_at_point(session, places, position)
}

/// What the pointer did in this frame. `held` is the point of a surface where the drag under way
/// began, if it was over one; all else is dragged as if it were as far away as the camera's target.
fn pointer_move(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    held: &mut Option<Vec3>,
) -> PointerMove {
    let in_pixels = |points: egui::Vec2| Vec2::new(points.x, points.y) / places.points_per_pixel;
    let delta = in_pixels(view.drag_delta());
    let mut all = delta;
    let pressed = view.ctx.input(|input| input.pointer.press_origin());
    if !view.dragged() {
        *held = None;
    } else if view.drag_started()
        && let Some((pressed, now)) = pressed.zip(view.interact_pointer_pos())
    {
        // egui recognizes a drag only after some pixels, which must not be lost.
        all = in_pixels(now - pressed);
        *held = places.surface_at(session, pressed);
    }
    let hovered = view.hover_pos();
    let notches = hovered.map_or(0.0, |_| notches(&view.ctx));
    PointerMove {
        delta,
        all,
        held: held.unwrap_or(session.view().camera.target),
        height: places.height(),
        notches,
        as_course: session.view().look == Look::Course,
        turned_over: hovered
            .filter(|_| notches != 0.0)
            .and_then(|at| places.point_at(session, at)),
    }
}

/// Remembers the camera before a drag, and restores it on Esc, which ends the drag in egui.
fn put_back_on_esc(
    view: &Response,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    if view.dragged() {
        state
            .camera_before_drag
            .get_or_insert(session.view().camera);
    } else if let Some(before) = state.camera_before_drag.take() {
        let escape = view
            .ctx
            .input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        if escape {
            actions.push(Action::View(View::SetCamera(before)));
        }
    }
}

/// Notches of the wheel since the last frame. egui's smoothing would spread a notch over several
/// frames, but the course's editor zooms by whole notches.
fn notches(context: &egui::Context) -> f32 {
    context.input(|input| {
        let wheel = input.events.iter().map(|event| match event {
            Event::MouseWheel {
                unit: MouseWheelUnit::Point,
                delta,
                ..
            } => delta.y / POINTS_PER_NOTCH,
            Event::MouseWheel { delta, .. } => delta.y,
            // Two fingers on a touchpad.
            Event::Zoom(factor) => factor.ln() / ZOOM_PER_NOTCH,
            _ => 0.0,
        });
        wheel.sum()
    })
}
