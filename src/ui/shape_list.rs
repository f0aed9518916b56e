use super::shape_signs;
use super::theme::Palette;
use super::widgets::{list_move, moved, section};
use crate::editor::{Session, View};
use crate::scene::{Shape, ShapeId};
use crate::ui::Action;
use egui::{Align, Button, Layout, Response, RichText, ScrollArea, Ui, UiBuilder, vec2};

/// The list never takes more than this of the panel, in points; longer ones scroll.
const TALLEST: f32 = 150.0;

/// The shapes, `[i] Name (ID: n)`: click or ↑ and ↓ select one. Signs at the end of its row hide
/// it and lock it.
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
        let selected = session.selected() == Some(shape.id);
        let row = ui
            .push_id(shape.id, |ui| row(ui, index, shape, selected, actions))
            .inner;
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

/// One row; what is clicked to select the shape.
fn row(
    ui: &mut Ui,
    index: usize,
    shape: &Shape,
    selected: bool,
    actions: &mut Vec<Action>,
) -> Response {
    let height = ui.spacing().interact_size.y;
    let (_, whole) = ui.allocate_space(vec2(ui.available_width(), height));
    let palette = Palette::of(ui.visuals());
    if selected {
        ui.painter().rect_filled(whole, 3.0, palette.selection);
    }
    let (name, signs) = whole.split_left_right_at_x(whole.right() - shape_signs::WIDTH);
    let label = format!("[{}] {} (ID: {})", index + 1, shape.name, shape.id);
    let color = match (selected, shape.visible) {
        (true, _) => palette.on_selection,
        (false, true) => palette.text,
        (false, false) => palette.weak,
    };
    let fill = Layout::top_down_justified(Align::LEFT);
    let place = UiBuilder::new().max_rect(name).layout(fill);
    // Its frame would not go round the signs.
    let button = Button::selectable(selected, RichText::new(&label).color(color))
        .frame_when_inactive(false)
        .truncate();
    let row = ui
        .scope_builder(place, |ui| ui.add(button))
        .inner
        .on_hover_text(&label);
    shape_signs::show(ui, signs, shape, selected, actions);
    row
}
