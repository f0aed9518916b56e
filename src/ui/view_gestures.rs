use super::curve_gestures;
use super::pointer_use::PointerUse;
use super::posing::{self, Picked};
use super::{ScenePlaces, UiState};
use crate::editor::{Session, Tool, View};
use crate::scene::ShapeId;
use crate::ui::Action;
use egui::{Event, Key, Modifiers, MouseWheelUnit, Pos2, Rect, Response};
use glam::Vec2;

/// Points of a touchpad's scrolling that count as one notch of a wheel.
const POINTS_PER_NOTCH: f32 = 50.0;

/// What the pointer does to the scene: drags and the wheel move the camera as the chosen
/// [`super::Navigation`] has it, a click selects the shape under the pointer. Control points of
/// the selected curves come first, then gizmos and bones, and with the Move tool shapes: a left
/// drag takes what is under the pointer.
///
/// `view` is the widget that [`super::show`] returns; panels and windows over it keep the pointer
/// to themselves. `places` are where the scene is shown in it. Returns the shape that the pointer
/// is over.
pub fn view_gestures(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) -> Option<ShapeId> {
    let mut pointer = PointerUse::Free;
    if state.pose.gesture.is_none() {
        pointer = curve_gestures::control_points(view, places, session, &mut state.curves, actions);
    }
    if pointer == PointerUse::Free {
        let list = state.joints.hovered;
        pointer = posing::pointer(view, places, session, &mut state.pose, list, actions);
    }
    if pointer == PointerUse::Holding {
        return None;
    }
    let delta = view.drag_delta() / places.points_per_pixel;
    let notches = if view.hovered() {
        notches(&view.ctx)
    } else {
        0.0
    };
    let height = places.rects.first().map_or(1.0, Rect::height) / places.points_per_pixel;
    let delta = Vec2::new(delta.x, delta.y);
    put_back_on_esc(view, session, state, actions);
    let camera = session.view().camera;
    let camera = state
        .navigation
        .moved(camera, view, delta, height.max(1.0), notches);
    if camera != session.view().camera {
        actions.push(Action::View(View::SetCamera(camera)));
    }
    if pointer == PointerUse::Over {
        return None;
    }
    if view.clicked() {
        let clicked = view.interact_pointer_pos();
        let picked = &mut state.pose.picked;
        let shape = clicked.and_then(|position| shape_at(picked, session, places, position));
        actions.push(Action::View(View::Select(shape)));
        if state.pose.tool != Tool::Select {
            actions.push(Action::View(View::SelectJoint(None)));
        }
    }
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    shape_at(&mut state.pose.picked, session, places, position)
}

/// Notes where the camera was before a drag, and puts it back there on Esc, by which egui ends it.
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

fn shape_at(
    picked: &mut Picked,
    session: &Session,
    places: &ScenePlaces,
    position: Pos2,
) -> Option<ShapeId> {
    let (pixel, size) = places.pixel(places.index_at(position)?, position)?;
    picked.shape_at(session, pixel, size)
}

/// How far the wheel went since the last frame. egui's own smoothing would spread a notch over
/// frames, and the course's step is a whole one.
fn notches(context: &egui::Context) -> f32 {
    context.input(|input| {
        let wheel = input.events.iter().map(|event| match event {
            Event::MouseWheel {
                unit: MouseWheelUnit::Point,
                delta,
                ..
            } => delta.y / POINTS_PER_NOTCH,
            Event::MouseWheel { delta, .. } => delta.y,
            _ => 0.0,
        });
        wheel.sum()
    })
}
