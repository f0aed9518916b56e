use super::commands::Command;
use super::number_field::NumberField;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::labelled;
use super::{Action, Ask, character_panel, color_field, commands, curve_panel, joint_list};
use crate::editor::{self, Edit, Session, View, for_all_selected, kept_on_ground};
use crate::math::Transform;
use crate::scene::{Shape, ShapeKind};
use egui::{Align, Button, Label, Layout, RichText, Ui, vec2};
use glam::Vec3;
use std::ops::RangeInclusive;

/// Everything about the selected shape.
pub(super) fn show(ui: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    state.curves.hovered = None;
    let shape = session.selected().and_then(|id| session.scene().shape(id));
    let Some(shape) = shape else {
        if !session.scene().shapes().is_empty() {
            ui.label(RichText::new("Select a shape in the list or in the view.").weak());
        }
        leave_joints(state, actions);
        return;
    };
    ui.push_id(shape.id, |ui| {
        properties(ui, session, shape, state, actions);
        if let ShapeKind::Character(character) = &shape.kind {
            ui.separator();
            character_panel::display(ui, session, shape.id, character.display, actions);
            ui.separator();
            character_panel::skinning(ui, shape.id, character, session, state, actions);
            ui.separator();
            character_panel::poses(ui, shape.id, character, &mut state.pose_name, actions);
            ui.separator();
            joint_list::show(ui, session, shape.id, &mut state.joints, actions);
        } else {
            leave_joints(state, actions);
        }
        if let ShapeKind::Mesh(_) = &shape.kind {
            ui.separator();
            let color = Palette::of(ui.visuals()).weak;
            ui.add(Label::new(RichText::new(without_joints(shape)).small().color(color)).wrap());
        }
        if let ShapeKind::Missing(missing) = &shape.kind {
            ui.separator();
            missing_file(ui, shape, &missing.reason, actions);
        }
        if let ShapeKind::Curve(curve) = &shape.kind {
            ui.separator();
            curve_panel::display(ui, shape.id, curve, actions);
            ui.separator();
            curve_panel::list(ui, session, shape.id, &mut state.curves, actions);
        }
    });
}

/// What is said of an imported mesh, which may have been meant as a character.
fn without_joints(shape: &Shape) -> &'static str {
    let file = shape.source.as_ref().map(|source| source.file.as_str());
    if file.is_some_and(|file| file.to_lowercase().ends_with(".dae")) {
        COLLADA_WITHOUT_JOINTS
    } else {
        WITHOUT_JOINTS
    }
}

const COLLADA_WITHOUT_JOINTS: &str = "This mesh has no joints. If its .dae has some, Insert ⏵ Import ⏵ Import \
                                      Character… brings them along.";
const WITHOUT_JOINTS: &str = "This mesh has no joints. Those of a character are in the .skel and .attach beside its .obj: \
                              Insert ⏵ Import ⏵ Import Character… brings them along.";

/// Says why the box stands in for a shape, and lets its file be found.
fn missing_file(ui: &mut Ui, shape: &Shape, reason: &str, actions: &mut Vec<Action>) {
    ui.label("The file of this shape cannot be read. A box stands in for it.");
    ui.label(RichText::new(reason).weak());
    let tip = "Choose where the file is now. Others that are missing are found beside it, too.";
    if ui.button("Find…").on_hover_text(tip).clicked() {
        actions.push(Action::Ask(Ask::FindSource(shape.id)));
    }
}

/// Ends hovering over a joint of the list, where no list is shown.
fn leave_joints(state: &mut UiState, actions: &mut Vec<Action>) {
    if state.joints.hovered.take().is_some() {
        actions.push(Action::View(View::HoverJoint(None)));
    }
}

/// Scale factors that can be set.
const SCALES: RangeInclusive<f64> = editor::SCALES.0 as f64..=editor::SCALES.1 as f64;
/// What a pixel of a drag changes a place or a scale by: figures are a unit or two high, and stay in sight. The course's
/// editor has ten times as much, as Ctrl gives here.
pub(super) const STEP: f64 = 0.01;

/// Position, scale, rotation and color of a shape, with Delete and Reset.
fn properties(
    ui: &mut Ui,
    session: &Session,
    shape: &Shape,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let for_all = |edit| Action::Edit(for_all_selected(session, edit));
    title(ui, session, shape, state, actions);
    let placement = &shape.placement;
    let (now, start) = (placement.transform, shape.start.transform);
    let mut edited = None;

    let position = row_of_three(ui, "Position", "Position", |axis, name| {
        NumberField::new(name, now.position[axis], STEP)
            .rest(start.position[axis])
            .decimals(2..=3)
    });
    if let Some((axis, value)) = position {
        edited = Some(with(now, |to| to.position[axis] = value));
    }

    uniform_scaling(ui, session, shape, actions);
    if placement.uniform_scaling {
        let scale = labelled(ui, "Uniform Scale", |ui, size| {
            NumberField::new("Uniform Scale", now.scale.x, STEP)
                .rest(start.scale.x)
                .range(SCALES)
                .decimals(2..=3)
                .show(ui, size)
        });
        if let Some(scale) = scale {
            let scaled = with(now, |to| to.scale = Vec3::splat(scale));
            edited = Some(kept_on_ground(session, shape.id, scaled));
        }
    } else {
        let scale = row_of_three(ui, "Scale (X, Y, Z)", "Scale", |axis, name| {
            NumberField::new(name, now.scale[axis], STEP)
                .rest(start.scale[axis])
                .range(SCALES)
                .decimals(2..=3)
        });
        if let Some((axis, value)) = scale {
            let scaled = with(now, |to| to.scale[axis] = value);
            edited = Some(kept_on_ground(session, shape.id, scaled));
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
        actions.push(for_all(Edit::SetTransform(shape.id, transform)));
    }
    let color = labelled(ui, "Color", |ui, size| {
        color_field::show(ui, placement.color, size.x)
    });
    if let Some(color) = color {
        actions.push(for_all(Edit::SetColor(shape.id, color)));
    }
}

fn uniform_scaling(ui: &mut Ui, session: &Session, shape: &Shape, actions: &mut Vec<Action>) {
    labelled(ui, "", |ui, _| {
        let mut uniform = shape.placement.uniform_scaling;
        let hint = "Scale X, Y and Z together. Turning it on takes the scale of X for all.";
        if ui
            .checkbox(&mut uniform, "Uniform Scaling")
            .on_hover_text(hint)
            .changed()
        {
            let edit = Edit::SetUniformScaling(shape.id, uniform);
            actions.push(Action::Edit(for_all_selected(session, edit)));
        }
    });
}

fn with(transform: Transform, change: impl FnOnce(&mut Transform)) -> Transform {
    let mut changed = transform;
    change(&mut changed);
    changed
}

/// The shape's ID, with Delete and Reset.
fn title(
    ui: &mut Ui,
    session: &Session,
    shape: &Shape,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        for (command, label, edit) in [
            (Command::Delete, "Delete", Edit::Delete(shape.id)),
            (Command::Reset, "Reset", Edit::Reset(shape.id)),
        ] {
            let button = ui.add(Button::new(label));
            let tip = commands::tooltip_now(ui.ctx(), command, session, state);
            if button.on_hover_text(tip).clicked() {
                actions.push(Action::Edit(for_all_selected(session, edit)));
            }
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let text = match session.selected_shapes().count() {
                1 => format!("Selected Shape ID: {}", shape.id),
                count => format!("{count} shapes, active ID: {}", shape.id),
            };
            let color = Palette::of(ui.visuals()).strong;
            ui.add(Label::new(RichText::new(text).color(color)).truncate())
                .on_hover_text(&shape.name);
        });
    });
    ui.add_space(2.0);
}

/// A label and three fields named `NAME X`, `NAME Y` and `NAME Z`; axis and value of the one that
/// was changed.
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
