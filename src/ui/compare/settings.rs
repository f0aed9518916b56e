use super::{CompareView, mask_list};
use crate::editor::{Action, CompareSettings, View};
use crate::scene::{Look, Shading};
use crate::ui::number_field::NumberField;
use egui::{Button, Ui, vec2};

/// What counts as a difference, how the live view is drawn, and what is left out.
pub(super) fn show(
    ui: &mut Ui,
    look_is_course: bool,
    compare: &CompareView,
    changed: &mut CompareSettings,
    actions: &mut Vec<Action>,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label("Threshold");
        let threshold = NumberField::new("Threshold", f32::from(changed.threshold), 1.0)
            .range(0.0..=255.0)
            .decimals(0..=0)
            .show(ui, vec2(48.0, 20.0));
        if let Some(threshold) = threshold {
            changed.threshold = threshold.round().clamp(0.0, 255.0) as u8;
        }
        ui.checkbox(&mut changed.smooth_edges, "Smooth edges")
            .on_hover_text("Draw the live view with antialiasing; the course's program has none");
    });
    ui.horizontal_wrapped(|ui| {
        let as_course = look_is_course && !changed.smooth_edges;
        let course = ui
            .add_enabled(!as_course, Button::new("Course look"))
            .on_hover_text("Draw the live view as the course's program does: its light and background, hard edges")
            .on_disabled_hover_text("The live view is drawn as the course's program does");
        if course.clicked() {
            changed.smooth_edges = false;
            actions.push(Action::View(View::SetLook(Look::Course)));
            actions.push(Action::View(View::SetShading(Shading::AsAuthored)));
        }
        mask_list::buttons(ui, compare.size(), &mut changed.masks);
    });
    mask_list::show(ui, compare.size(), &mut changed.masks);
}
