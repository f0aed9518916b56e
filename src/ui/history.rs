//! Edit ▸ History: the steps since the document was opened.

use super::{Action, HistoryMove};
use crate::editor::Session;
use egui::{RichText, ScrollArea, Ui};

/// The list of steps, oldest first; a click goes to the document after a step. Steps that were
/// undone come last, and are dim.
pub(super) fn show(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    let done = session.done_steps();
    let list = ScrollArea::vertical().auto_shrink(false);
    list.stick_to_bottom(true).show(ui, |ui| {
        let names = std::iter::once("Document as it was opened").chain(session.steps());
        for (step, name) in names.enumerate() {
            let text = RichText::new(name);
            let text = if step > done { text.weak() } else { text };
            if ui.selectable_label(step == done, text).clicked() {
                actions.push(Action::History(HistoryMove::GoTo(step)));
            }
        }
    });
}
