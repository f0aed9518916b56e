use super::widgets::{list_move, moved, section};
use crate::editor::{Action, Session, View};
use crate::scene::ShapeId;
use egui::{Align, Button, Layout, RichText, ScrollArea, Ui};

/// The list never takes more than this of the panel, in points; longer ones scroll.
const TALLEST: f32 = 150.0;

/// The shapes, `[i] Name (ID: n)`: click or ↑ and ↓ select one.
/// One that was just `newly_selected`, here or elsewhere, is scrolled into sight.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    newly_selected: bool,
    actions: &mut Vec<Action>,
) {
    section(ui, "Shape Selector");
    let shapes = session.scene().shapes();
    if shapes.is_empty() {
        ui.label(RichText::new("Nothing here yet. Insert adds a shape or a character.").weak());
        return;
    }
    ScrollArea::vertical()
        .id_salt("shape list")
        .max_height(TALLEST.min(ui.available_height() * 0.4))
        .show(ui, |ui| {
            ui.with_layout(Layout::top_down_justified(Align::LEFT), |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                rows(ui, session, newly_selected, actions);
            });
        });
}

fn rows(ui: &mut Ui, session: &Session, newly_selected: bool, actions: &mut Vec<Action>) {
    let shapes = session.scene().shapes();
    let mut chosen: Option<ShapeId> = None;
    let mut responses = Vec::with_capacity(shapes.len());
    let mut movement = None;
    for (index, shape) in shapes.iter().enumerate() {
        let label = format!("[{}] {} (ID: {})", index + 1, shape.name, shape.id);
        let selected = session.selected() == Some(shape.id);
        let row = ui
            .push_id(shape.id, |ui| {
                let button = Button::selectable(selected, &label).truncate();
                ui.add(button.frame_when_inactive(selected))
            })
            .inner
            .on_hover_text(&label);
        if selected && newly_selected {
            row.scroll_to_me(None);
        }
        if row.clicked() {
            row.request_focus();
            chosen = Some(shape.id);
        }
        if let Some(pressed) = list_move(ui, &row) {
            movement = moved(pressed, index, shapes.len());
        }
        responses.push(row);
    }
    if let Some(to) = movement
        && let (Some(row), Some(shape)) = (responses.get(to), shapes.get(to))
    {
        row.request_focus();
        chosen = Some(shape.id);
    }
    if chosen.is_some() && chosen != session.selected() {
        actions.push(Action::View(View::Select(chosen)));
    }
}
