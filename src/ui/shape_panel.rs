use super::commands::Command;
use super::state::UiState;
use super::widgets::named;
use super::{Action, commands, shape_list, shape_properties};
use crate::editor::Session;
use egui::epaint::TextShape;
use egui::{
    Align, Align2, Button, Color32, FontId, Frame, Id, Label, Layout, Margin, Panel, Rect,
    Response, RichText, ScrollArea, Sense, TextStyle, Ui, WidgetInfo, WidgetType, pos2, vec2,
};
use std::f32::consts::FRAC_PI_2;
use std::ops::RangeInclusive;

/// Width in points, margins included, as in the course's editor.
const WIDTH: f32 = 280.0;
const NARROWEST: f32 = 248.0;
const WIDEST: f32 = 560.0;

/// Width of the window in points up to which the panel is folded away until it is asked for, and then a
/// sheet at the bottom: beside it, the view would be too narrow to work in.
const NARROW_WINDOW: f32 = 600.0;

/// The shape panel at the right, or at the bottom of a narrow window: the list of shapes, and all
/// properties of the selected one.
pub(super) fn show(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    state.is_narrow = root.available_width() <= NARROW_WINDOW;
    // Below its view, a low window would have no room.
    if state.is_narrow && root.available_height() > root.available_width() {
        return sheet(root, session, state, actions);
    }
    if state.is_panel_folded() {
        return strip(root, state);
    }
    let widest = (root.available_width() * 0.7).clamp(NARROWEST, WIDEST);
    let shown = Panel::right(Id::new("shape panel").with(state.panel_resets))
        .frame(frame(root))
        .default_size(state.panel_width.unwrap_or(WIDTH))
        .size_range(NARROWEST..=widest)
        .show(root, |ui| {
            heading(ui, state);
            ui.separator();
            content(ui, session, state, actions);
        });
    // In the middle of a drag of its edge it is not worth keeping.
    if !root.input(|input| input.pointer.any_down()) {
        state.panel_width = Some(shown.response.rect.width().round());
    }
}

fn frame(ui: &Ui) -> Frame {
    Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(8, 4))
}

/// Shares of the height that a sheet's handle can be dragged to.
const SHEET_SHARES: RangeInclusive<f32> = 0.25..=0.75;

/// The panel below the view, so that a whole figure is seen while its numbers are dragged. Its handle is
/// all that is left of it when it is folded away.
fn sheet(root: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    let is_folded = state.is_panel_folded();
    let all = root.available_rect_before_wrap();
    let content_height = if is_folded {
        0.0
    } else {
        (all.height() * state.sheet_share).round()
    };
    let shown = Panel::bottom("sheet of shapes")
        .frame(Frame::side_top_panel(root.style()).inner_margin(0))
        .resizable(false)
        .exact_size(HANDLE + content_height)
        .show(root, |ui| {
            let mut place = ui.max_rect();
            place.set_height(HANDLE);
            let button = handle(ui, place, Sense::click_and_drag(), state);
            let centered = Align2::CENTER_CENTER;
            let (font, color) = handle_style(ui, &button);
            let text = format!("{} {HANDLE_TEXT}", if is_folded { "⏶" } else { "⏷" });
            let middle = place.center();
            ui.painter().text(middle, centered, text, font, color);
            if !is_folded {
                frame(ui).show(ui, |ui| content(ui, session, state, actions));
            }
            button
        });
    if let Some(at) = shown.inner.interact_pointer_pos()
        && shown.inner.dragged()
    {
        let share = (all.bottom() - HANDLE / 2.0 - at.y) / all.height().max(1.0);
        state.fold_panel(share < SHEET_SHARES.start() / 2.0);
        state.sheet_share = share.clamp(*SHEET_SHARES.start(), *SHEET_SHARES.end());
    }
}

/// The list of shapes, and the selected one.
fn content(ui: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    let newly_selected = session.selected() != state.selected;
    state.selected = session.selected();
    shape_list::show(ui, session, newly_selected, state, actions);
    ui.separator();
    ScrollArea::vertical()
        // That of another document begins at its top.
        .id_salt(("properties", session.opened()))
        .auto_shrink(false)
        .show(ui, |ui| shape_properties::show(ui, session, state, actions));
}

/// Title of the panel, with the button that folds it away.
fn heading(ui: &mut Ui, state: &mut UiState) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let button = ui.add(Button::new("⏵").frame_when_inactive(false));
        let button = named(button, commands::label(Command::TogglePanel));
        let tip = commands::tooltip(ui.ctx(), Command::TogglePanel);
        if button.on_hover_text(tip).clicked() {
            state.fold_panel(true);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let title = RichText::new("Shape Selector and Properties").heading();
            ui.add(Label::new(title).truncate());
        });
    });
}

/// Width in points of the strip that is left of the panel at the right, and height of the sheet's handle.
const STRIP: f32 = 24.0;
const HANDLE: f32 = 30.0;

/// Words on either, which say what the panel is.
const HANDLE_TEXT: &str = "Shapes and Properties";

/// The strip at the right edge that is left of the folded panel.
fn strip(root: &mut Ui, state: &mut UiState) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(0);
    let strip = Panel::right("folded shape panel").frame(frame);
    strip.resizable(false).exact_size(STRIP).show(root, |ui| {
        let place = ui.max_rect();
        let button = handle(ui, place, Sense::click(), state);
        let button = button.on_hover_text(commands::tooltip(ui.ctx(), Command::TogglePanel));
        let (font, color) = handle_style(ui, &button);
        let top = place.center_top() + vec2(0.0, 16.0);
        let painter = ui.painter();
        painter.text(top, Align2::CENTER_CENTER, "⏴", font.clone(), color);
        // From top to bottom.
        let text = painter.layout_no_wrap(HANDLE_TEXT.to_owned(), font, color);
        let corner = pos2(place.center().x + text.size().y / 2.0, place.top() + 32.0);
        painter.add(TextShape::new(corner, text, color).with_angle(FRAC_PI_2));
    });
}

/// A click anywhere in `place` unfolds the panel, or folds it away, as the words on it say.
fn handle(ui: &mut Ui, place: Rect, sense: Sense, state: &mut UiState) -> Response {
    let button = ui.allocate_rect(place, sense);
    let command = Command::TogglePanel;
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, true, commands::label(command)));
    if button.hovered() || button.has_focus() {
        let fill = ui.style().interact(&button).weak_bg_fill;
        ui.painter().rect_filled(place, 0.0, fill);
    }
    if button.clicked() {
        state.fold_panel(!state.is_panel_folded());
    }
    button
}

fn handle_style(ui: &Ui, button: &Response) -> (FontId, Color32) {
    let color = ui.style().interact(button).text_color();
    (TextStyle::Body.resolve(ui.style()), color)
}
