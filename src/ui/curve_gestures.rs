use super::state::CurveState;
use crate::editor::{Action, ControlPointDrag, Session, View, control_point_at};
use egui::{CursorIcon, Key, PointerButton, Pos2, Response};
use glam::Vec2;

/// A control point that was grabbed with the left button.
#[derive(Clone, Debug)]
pub(super) struct PointGesture {
    drag: ControlPointDrag,
    /// Once it is cancelled it only waits for the buttons to be released, so that what is left of
    /// the drag does not become another gesture.
    cancelled: bool,
}

/// What control points have to do with the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PointerUse {
    /// Nothing.
    Free,
    /// One is under it, and takes its clicks and left drags.
    Over,
    /// One follows it, and nothing else does.
    Holding,
}

/// Drags control points of the selected curves in the view, and marks the one under the pointer.
pub(super) fn control_points(
    view: &Response,
    session: &Session,
    state: &mut CurveState,
    actions: &mut Vec<Action>,
) -> PointerUse {
    if view.drag_started_by(PointerButton::Primary) && state.gesture.is_none() {
        state.gesture = begin(view, session);
    }
    let in_view = match &mut state.gesture {
        Some(gesture) => {
            let goes_on = gesture.go_on(view, session, actions);
            let point = (!gesture.cancelled).then(|| gesture.drag.control_point());
            if !goes_on {
                state.gesture = None;
            }
            view.ctx.set_cursor_icon(CursorIcon::Grabbing);
            mark(session, point, actions);
            return PointerUse::Holding;
        }
        None => hovered(view, session),
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

fn hovered(view: &Response, session: &Session) -> Option<(usize, usize)> {
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    control_point_at(session, pixel(view, position), size(view))
}

/// egui only takes a press for a drag once the pointer has moved; what was grabbed lies where the
/// button went down.
fn begin(view: &Response, session: &Session) -> Option<PointGesture> {
    let pressed = view.ctx.input(|input| input.pointer.press_origin())?;
    let drag = ControlPointDrag::begin(session, pixel(view, pressed), size(view))?;
    Some(PointGesture {
        drag,
        cancelled: false,
    })
}

impl PointGesture {
    /// Follows the pointer; whether the gesture goes on in the next frame.
    fn go_on(&mut self, view: &Response, session: &Session, actions: &mut Vec<Action>) -> bool {
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
        if session.scene().curve(self.drag.shape()).is_none() {
            self.cancelled = true;
            return any_down;
        }
        if cancel {
            actions.push(Action::Edit(self.drag.cancel()));
            self.cancelled = true;
            return any_down;
        }
        if let Some(position) = view.interact_pointer_pos() {
            let edit = self
                .drag
                .moved_to(session, pixel(view, position), size(view));
            actions.extend(edit.map(Action::Edit));
        }
        left_down
    }
}

fn pixel(view: &Response, position: Pos2) -> Vec2 {
    let from_corner = position - view.rect.min;
    Vec2::new(from_corner.x, from_corner.y)
}

fn size(view: &Response) -> Vec2 {
    Vec2::new(view.rect.width(), view.rect.height())
}
