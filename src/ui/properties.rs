use super::color_field;
use super::keys::{self, Command};
use super::number_field::NumberField;
use super::theme::Palette;
use crate::editor::Edit;
use crate::math::Transform;
use crate::scene::Shape;
use crate::ui::Action;
use egui::{Align, Button, Layout, RichText, Ui, Vec2, vec2};
use glam::Vec3;

/// Width of the column of labels, in points.
const LABELS: f32 = 88.0;
const SCALES: std::ops::RangeInclusive<f64> = 0.1..=10.0;

/// Position, scale, rotation and color of the selected shape, with Delete and Reset.
pub(super) fn show(ui: &mut Ui, shape: &Shape, actions: &mut Vec<Action>) {
    title(ui, shape, actions);
    let placement = &shape.placement;
    let (now, start) = (placement.transform, shape.start.transform);
    let mut edited = None;

    let position = row_of_three(ui, "Position", "Position", |axis, name| {
        NumberField::new(name, now.position[axis], 0.1)
            .rest(start.position[axis])
            .decimals(2..=3)
    });
    if let Some((axis, value)) = position {
        edited = Some(with(now, |to| to.position[axis] = value));
    }

    uniform_scaling(ui, shape, actions);
    if placement.uniform_scaling {
        let scale = labelled(ui, "Uniform Scale", |ui, size| {
            NumberField::new("Uniform Scale", now.scale.x, 0.1)
                .rest(start.scale.x)
                .range(SCALES)
                .decimals(2..=3)
                .show(ui, size)
        });
        if let Some(scale) = scale {
            edited = Some(with(now, |to| to.scale = Vec3::splat(scale)));
        }
    } else {
        let scale = row_of_three(ui, "Scale (X, Y, Z)", "Scale", |axis, name| {
            NumberField::new(name, now.scale[axis], 0.1)
                .rest(start.scale[axis])
                .range(SCALES)
                .decimals(2..=3)
        });
        if let Some((axis, value)) = scale {
            edited = Some(with(now, |to| to.scale[axis] = value));
        }
    }

    let rotation = row_of_three(ui, "Rotation", "Rotation", |axis, name| {
        NumberField::degrees(name, now.rotation.degrees()[axis])
            .rest(start.rotation.degrees()[axis])
    });
    if let Some((axis, value)) = rotation {
        let radians = value.to_radians();
        edited = Some(with(now, |to| to.rotation.radians[axis] = radians));
    }

    if let Some(transform) = edited {
        actions.push(Action::Edit(Edit::SetTransform(shape.id, transform)));
    }
    let color = labelled(ui, "Color", |ui, size| {
        color_field::show(ui, placement.color, size.x)
    });
    if let Some(color) = color {
        actions.push(Action::Edit(Edit::SetColor(shape.id, color)));
    }
}

fn uniform_scaling(ui: &mut Ui, shape: &Shape, actions: &mut Vec<Action>) {
    labelled(ui, "", |ui, _| {
        let mut uniform = shape.placement.uniform_scaling;
        let hint = "Scale X, Y and Z together. Turning it on takes the scale of X for all.";
        if ui
            .checkbox(&mut uniform, "Uniform Scaling")
            .on_hover_text(hint)
            .changed()
        {
            let edit = Edit::SetUniformScaling(shape.id, uniform);
            actions.push(Action::Edit(edit));
        }
    });
}

fn with(transform: Transform, change: impl FnOnce(&mut Transform)) -> Transform {
    let mut changed = transform;
    change(&mut changed);
    changed
}

/// The shape's name and id, with what can be done to all of it.
fn title(ui: &mut Ui, shape: &Shape, actions: &mut Vec<Action>) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        for (command, label, edit) in [
            (Command::Delete, "Delete", Edit::Delete(shape.id)),
            (Command::Reset, "Reset", Edit::Reset(shape.id)),
        ] {
            let button = ui.add(Button::new(label));
            if button
                .on_hover_text(keys::tooltip(ui.ctx(), command))
                .clicked()
            {
                actions.push(Action::Edit(edit));
            }
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let text = format!("Selected Shape ID: {}", shape.id);
            let color = Palette::of(ui.visuals()).strong;
            ui.add(egui::Label::new(RichText::new(text).color(color)).truncate())
                .on_hover_text(&shape.name);
        });
    });
    ui.add_space(2.0);
}

/// A label in the left column and, in what is left of the row, whatever `add` makes of the size
/// that it is given.
pub(super) fn labelled<R>(ui: &mut Ui, label: &str, add: impl FnOnce(&mut Ui, Vec2) -> R) -> R {
    ui.horizontal(|ui| {
        let height = ui.spacing().interact_size.y;
        ui.allocate_ui_with_layout(
            vec2(LABELS, height),
            Layout::left_to_right(Align::Center),
            |ui| {
                ui.set_min_width(LABELS);
                ui.add(egui::Label::new(label).truncate());
            },
        );
        let size = vec2(ui.available_width(), height);
        add(ui, size)
    })
    .inner
}

/// A label and three fields called `NAME X`, `NAME Y` and `NAME Z`; the axis and value of the
/// one that was changed.
fn row_of_three<'n>(
    ui: &mut Ui,
    label: &str,
    name: &str,
    field: impl for<'f> Fn(usize, &'f str) -> NumberField<'f>,
) -> Option<(usize, f32)> {
    labelled(ui, label, |ui, size| {
        let gap = ui.spacing().item_spacing.x;
        let each = vec2(((size.x - 2.0 * gap) / 3.0).floor(), size.y);
        let mut changed = None;
        for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
            let name = format!("{name} {letter}");
            let given = field(axis, &name).axis(axis).show(ui, each);
            changed = given.map(|value| (axis, value)).or(changed);
        }
        changed
    })
}
