//! Commands that hide, show, lock and unlock shapes.

use super::Command;
use crate::editor::{BoxMode, Edit, Session, View, for_all_selected};
use crate::scene::{Shape, ShapeId};
use crate::ui::Action;

/// Hides, shows, locks or unlocks the selected shape.
pub(super) fn toggle(command: Command, session: &Session) -> Option<Action> {
    let shape = session.scene().shape(session.selected()?)?;
    let edit = match command {
        Command::ToggleVisible => Edit::SetVisible(shape.id, !shape.visible),
        _ => Edit::SetLocked(shape.id, !shape.locked),
    };
    Some(Action::Edit(for_all_selected(session, edit)))
}

/// Hides the shapes that are shown and not selected.
pub(super) fn hide_others(session: &Session) -> Action {
    let hide = others(session).map(|shape| Edit::SetVisible(shape.id, false));
    Action::Edit(Edit::Together(hide.collect()))
}

/// The shapes that are shown and not selected.
pub(super) fn others(session: &Session) -> impl Iterator<Item = &Shape> {
    let shapes = session.scene().shapes().iter();
    shapes.filter(|shape| shape.visible && !session.is_selected(shape.id))
}

/// Shows the shapes that are hidden, and selects them as well, as Blender does: what is active stays that. While a figure
/// `is_posed` it stays the only one.
pub(super) fn show_all(session: &Session, is_posed: bool) -> Vec<Action> {
    let ids: Vec<ShapeId> = hidden(session).map(|shape| shape.id).collect();
    let show = ids.iter().map(|&id| Edit::SetVisible(id, true));
    let show = Edit::Together(show.collect());
    let select = Action::View(View::SelectInBox(ids, BoxMode::Add));
    let select = Some(select).filter(|_| !is_posed);
    std::iter::once(Action::Edit(show)).chain(select).collect()
}

/// The shapes that are hidden.
pub(super) fn hidden(session: &Session) -> impl Iterator<Item = &Shape> {
    let shapes = session.scene().shapes().iter();
    shapes.filter(|shape| !shape.visible)
}
