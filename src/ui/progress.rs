//! Progress of work that takes longer than a frame, with a button that ends it.

use super::{Action, Ask};
use egui::{
    Align, Button, Frame, Label, Layout, Margin, ProgressBar, Rect, Ui, UiBuilder, Vec2,
    WidgetInfo, WidgetType, vec2,
};

/// Size of the frame, in points.
const SIZE: Vec2 = vec2(280.0, 58.0);

/// Shows `text` and the `part` that is done, from 0 to 1, in the lower right corner of `view`.
pub(super) fn show(ui: &mut Ui, view: Rect, (text, part): (&str, f32), actions: &mut Vec<Action>) {
    let size = SIZE.min(view.size() - Vec2::splat(24.0));
    let rect = Rect::from_min_size(view.max - size - Vec2::splat(12.0), size);
    let builder = UiBuilder::new().id_salt("progress").max_rect(rect);
    let mut inner = ui.new_child(builder);
    Frame::popup(ui.style())
        .inner_margin(Margin::symmetric(12, 8))
        .show(&mut inner, |ui| {
            ui.add(Label::new(text).truncate());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if ui.add(Button::new("Cancel").small()).clicked() {
                    actions.push(Action::Ask(Ask::CancelWork));
                }
                let bar = ui.add(ProgressBar::new(part).show_percentage());
                bar.widget_info(|| WidgetInfo::labeled(WidgetType::ProgressIndicator, true, text));
            });
        });
}
