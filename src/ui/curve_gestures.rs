use super::ScenePlaces;
use super::pointer_use::{PointerUse, released_at};
use super::state::CurveState;
use crate::editor::{ControlPointDrag, Session, View, control_point_at};
use crate::ui::{Action, GestureStep};
use egui::{CursorIcon, Key, PointerButton, Response};

/// A control point that was grabbed with the left button.
#[derive(Clone, Debug)]
pub(super) struct PointGesture {
    drag: ControlPointDrag,
    /// Index of the picture of the scene that it began in.
    place: usize,
    /// Once it is cancelled it only waits for the buttons to be released, so that what is left of
    /// the drag does not become another gesture.
    cancelled: bool,
}

/// Drags control points of the selected curves in the view, and marks the one under the pointer.
pub(super) fn control_points(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut CurveState,
    actions: &mut Vec<Action>,
) -> PointerUse {
    if view.drag_started_by(PointerButton::Primary) && state.gesture.is_none() {
        state.gesture = begin(view, places, session);
        if state.gesture.is_some() {
            actions.push(Action::Gesture(GestureStep::Begin));
        }
    }
    let in_view = match &mut state.gesture {
        Some(gesture) => {
            let goes_on = gesture.go_on(view, places, session, actions);
            let point = (!gesture.cancelled).then(|| gesture.drag.control_point());
            if !goes_on {
                state.gesture = None;
            }
            view.ctx.set_cursor_icon(CursorIcon::Grabbing);
            mark(session, point, actions);
            return PointerUse::Holding;
        }
        None => hovered(view, places, session),
    };
    mark(session, in_view.or(state.hovered), actions);
    if in_view.is_none() {
        return PointerUse::Free;
    }
    view.ctx.set_cursor_icon(CursorIcon::Grab);
    PointerUse::Over
}

/// Tells the session which point is under the pointer, if that has changed.
fn mark(session: &Session, point: Option<(usize, usize)>, actions: &mut Vec<Action>) {
    if point != session.hovered_control_point() {
        actions.push(Action::View(View::HoverControlPoint(point)));
    }
}

fn hovered(view: &Response, places: &ScenePlaces, session: &Session) -> Option<(usize, usize)> {
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    let (pixel, size) = places.pixel(places.index_at(position)?, position)?;
    control_point_at(session, pixel, size)
}

/// egui only takes a press for a drag once the pointer has moved; what was grabbed lies where the
/// button went down.
fn begin(view: &Response, places: &ScenePlaces, session: &Session) -> Option<PointGesture> {
    let pressed = view.ctx.input(|input| input.pointer.press_origin())?;
    let place = places.index_at(pressed)?;
    let (pixel, size) = places.pixel(place, pressed)?;
    let drag = ControlPointDrag::begin(session, pixel, size)?;
    Some(PointGesture {
        drag,
        place,
        cancelled: false,
    })
}

impl PointGesture {
    /// Follows the pointer; whether the gesture goes on in the next frame.
    fn go_on(
        &mut self,
        view: &Response,
        places: &ScenePlaces,
        session: &Session,
        actions: &mut Vec<Action>,
    ) -> bool {
        let (cancel, left_down, any_down) = view.ctx.input_mut(|input| {
            // Taken, so that Esc does nothing else in this frame.
            let escape = input.consume_key(egui::Modifiers::NONE, Key::Escape);
            let right = input.pointer.button_pressed(PointerButton::Secondary);
            let pointer = &input.pointer;
            (escape || right, pointer.primary_down(), pointer.any_down())
        });
        if self.cancelled {
            return any_down;
        }
        let shape = session.evaluated().shape(self.drag.shape());
        if !shape.is_some_and(|shape| shape.pickable) {
            actions.push(Action::Gesture(GestureStep::Commit));
            self.cancelled = true;
            return any_down;
        }
        if cancel {
            actions.push(Action::Gesture(GestureStep::Cancel));
            self.cancelled = true;
            return any_down;
        }
        let released = view.ctx.input(released_at);
        let position = released.or(view.interact_pointer_pos());
        if let Some((pixel, size)) = position.and_then(|at| places.pixel(self.place, at)) {
            let edit = self.drag.moved_to(session, pixel, size);
            actions.extend(edit.map(Action::Edit));
        }
        if !left_down {
            actions.push(Action::Gesture(GestureStep::Commit));
        }
        left_down
    }
}
