use crate::math::Area as Mask;
use crate::ui::course_panels;
use crate::ui::number_field::NumberField;
use crate::ui::widgets::named;
use egui::{Button, Ui, vec2};

/// More would be a picture of their own.
const MOST: usize = 32;

/// What adds masks.
pub(super) fn buttons(ui: &mut Ui, size: (u32, u32), masks: &mut Vec<Mask>) {
    let room = masks.len() < MOST;
    let panels = course_panels(size);
    let masked = panels.iter().all(|panel| masks.contains(panel));
    let course = ui
        .add_enabled(room && !masked, Button::new("Mask its panels"))
        .on_hover_text(
            "Leave out what the panels of the course's editor cover in a screenshot of its window",
        )
        .on_disabled_hover_text("They are masked");
    if course.clicked() {
        for panel in panels {
            if !masks.contains(&panel) {
                masks.push(panel);
            }
        }
    }
    let add = ui
        .add_enabled(room, Button::new("Add mask"))
        .on_hover_text("Leave out a part of the pictures; drag its edges in the view")
        .on_disabled_hover_text("There are as many masks as can be");
    if add.clicked() {
        masks.push(Mask::in_the_middle(size));
    }
}

/// The numbers of each mask.
pub(super) fn show(ui: &mut Ui, size: (u32, u32), masks: &mut Vec<Mask>) {
    let mut removed = None;
    for (index, mask) in masks.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            let name = format!("Mask {}", index + 1);
            ui.label(&name)
                .on_hover_text("First column and row, width × height, in pixels");
            let mut edited = *mask;
            // What moves it keeps its size.
            let farthest = (
                size.0.saturating_sub(mask.width),
                size.1.saturating_sub(mask.height),
            );
            let sides = [
                ("", "X", &mut edited.x, farthest.0),
                (",", "Y", &mut edited.y, farthest.1),
                ("·", "width", &mut edited.width, size.0),
                ("×", "height", &mut edited.height, size.1),
            ];
            for (before, side, value, most) in sides {
                ui.label(before);
                number(ui, &format!("{name} {side}"), value, most);
            }
            *mask = edited.inside(size);
            let remove = named(
                ui.add(Button::new("×")),
                &format!("Remove mask {}", index + 1),
            );
            if remove.on_hover_text("Remove this mask").clicked() {
                removed = Some(index);
            }
        });
    }
    if let Some(index) = removed {
        masks.remove(index);
    }
}

fn number(ui: &mut Ui, name: &str, value: &mut u32, most: u32) {
    let field = NumberField::new(name, *value as f32, 1.0)
        .rest(*value as f32)
        .range(0.0..=f64::from(most))
        .decimals(0..=0);
    if let Some(given) = field.show(ui, vec2(44.0, 20.0)) {
        *value = given.round().max(0.0) as u32;
    }
}
