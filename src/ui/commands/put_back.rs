//! Commands that put back where shapes are, how they are turned, or how large they are.

use super::Command;
use crate::editor::{Edit, Session, kept_at_pivot, kept_on_ground};
use crate::math::Transform;
use crate::scene::Shape;
use crate::ui::Action;

/// Puts this part of the selected shapes back to the start, each to its own.
pub(super) fn put_back(command: Command, session: &Session) -> Action {
    let edits = session.selected_shapes().filter_map(|shape| {
        let mut back = back(command, shape)?;
        if command != Command::ResetPosition {
            // It was turned and scaled about the pivot, too.
            back = kept_at_pivot(session, shape.id, back);
        }
        if command == Command::ResetScale {
            back = kept_on_ground(session, shape.id, back);
        }
        Some(Edit::SetTransform(shape.id, back))
    });
    Action::Edit(Edit::Together(edits.collect()))
}

/// Why there is nothing to put back; `None` if there is.
pub(super) fn why_nothing_back(command: Command, session: &Session) -> Option<&'static str> {
    let mut selected = session.selected_shapes().peekable();
    if selected.peek().is_none() {
        return Some("No shape is selected");
    }
    let is_at_start = selected.all(|shape| back(command, shape).is_none());
    is_at_start.then_some(match command {
        Command::ResetPosition => "It is where it started",
        Command::ResetRotation => "It is turned as it started",
        _ => "It is as large as it started",
    })
}

/// The place of a shape with that part of it from its start; `None` if that is no other.
fn back(command: Command, shape: &Shape) -> Option<Transform> {
    let (now, start) = (shape.placement.transform, shape.start.transform);
    let mut back = now;
    match command {
        Command::ResetPosition => back.position = start.position,
        Command::ResetRotation => back.rotation = start.rotation,
        _ => back.scale = start.scale,
    }
    (back != now).then_some(back)
}
