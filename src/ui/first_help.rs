use super::posing::BAR_HEIGHT;
use super::theme::Palette;
use super::widgets::named;
use egui::{Align, Button, Frame, Grid, Layout, Margin, Rect, RichText, Ui, UiBuilder, pos2, vec2};

/// What a newcomer needs to know.
const LINES: [(&str, &str); 2] = [
    (
        "Pose",
        "press B and drag a bone, or drag a number at the right",
    ),
    ("More", "Insert adds shapes · ? shows every key"),
];
const SIZE: egui::Vec2 = vec2(380.0, 88.0);

/// Three lines for newcomers in the view's lower left corner; whether their × was clicked.
pub(super) fn show(ui: &mut Ui, view: Rect, look_around: &str) -> bool {
    if view.width() < SIZE.x + 24.0 || view.height() < SIZE.y + 3.0 * BAR_HEIGHT {
        return false;
    }
    let corner = pos2(view.left() + 12.0, view.bottom() - SIZE.y - 12.0);
    let builder = UiBuilder::new()
        .id_salt("first help")
        .max_rect(Rect::from_min_size(corner, SIZE));
    let mut inner = ui.new_child(builder);
    let mut closed = false;
    Frame::popup(ui.style())
        .inner_margin(Margin::symmetric(12, 8))
        .show(&mut inner, |ui| {
            ui.with_layout(Layout::left_to_right(Align::TOP), |ui| {
                Grid::new("first help").num_columns(2).show(ui, |ui| {
                    for (what, how) in [("Look around", look_around)].into_iter().chain(LINES) {
                        let strong = Palette::of(ui.visuals()).strong;
                        ui.label(RichText::new(what).color(strong));
                        ui.label(RichText::new(how).small());
                        ui.end_row();
                    }
                });
                let close = ui.add(Button::new("×").frame_when_inactive(false));
                closed = named(close, "Close help")
                    .on_hover_text("Hide these lines")
                    .clicked();
            });
        });
    closed
}
