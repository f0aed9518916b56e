use super::number_field::NumberField;
use super::properties::labelled;
use super::widgets::{named, section};
use crate::editor::Edit;
use crate::scene::{BoneStyle, CharacterDisplay, JointStyle, ModelDisplay, ShapeId};
use crate::ui::Action;
use egui::{Button, Ui, vec2};

/// What a point's diameter and a line's width may be, in pixels.
const POINT_SIZES: std::ops::RangeInclusive<f64> = 1.0..=64.0;
const LINE_WIDTHS: std::ops::RangeInclusive<f64> = 1.0..=32.0;

/// How a character is drawn: mesh, skeleton or both, and its joints and bones.
pub(super) fn show(ui: &mut Ui, id: ShapeId, display: CharacterDisplay, actions: &mut Vec<Action>) {
    let mut changed = display;
    section(ui, "Model Display Mode");
    choice(
        ui,
        &mut changed.mode,
        &[
            (
                ModelDisplay::Skeleton,
                "Skeletal Model",
                "Show joints and bones",
            ),
            (ModelDisplay::Mesh, "Mesh Model", "Show the deformed mesh"),
            (
                ModelDisplay::Both,
                "Both",
                "Show the mesh with the skeleton seen through it",
            ),
        ],
    );
    if display.mode != ModelDisplay::Mesh {
        skeleton(ui, display, &mut changed);
    }
    if changed != display {
        actions.push(Action::Edit(Edit::SetDisplay(id, changed)));
    }
}

/// How joints and bones are drawn, where any are.
fn skeleton(ui: &mut Ui, display: CharacterDisplay, changed: &mut CharacterDisplay) {
    let default = CharacterDisplay::default();
    labelled(ui, "Joints", |ui, _| {
        let joints = [
            (JointStyle::Points, "Points", "Draw joints as round points"),
            (JointStyle::Spheres, "Spheres", "Draw joints as spheres"),
        ];
        choice(ui, &mut changed.joints, &joints);
        if display.joints == JointStyle::Points {
            let field = NumberField::new("Point size", display.point_size, 0.5)
                .rest(default.point_size)
                .range(POINT_SIZES)
                .unit(" px");
            changed.point_size = beside(ui, field).unwrap_or(changed.point_size);
        }
    });
    labelled(ui, "Bones", |ui, _| {
        let bones = [
            (BoneStyle::Lines, "Lines", "Draw bones as lines"),
            (BoneStyle::Boxes, "Boxes", "Draw bones as boxes"),
        ];
        choice(ui, &mut changed.bones, &bones);
        if display.bones == BoneStyle::Lines {
            let field = NumberField::new("Line width", display.line_width, 0.5)
                .rest(default.line_width)
                .range(LINE_WIDTHS)
                .unit(" px");
            changed.line_width = beside(ui, field).unwrap_or(changed.line_width);
        }
    });
}

/// A field in what is left of the row.
fn beside(ui: &mut Ui, field: NumberField) -> Option<f32> {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    field.show(ui, size)
}

/// Buttons side by side, of which one is on.
fn choice<T: Copy + PartialEq>(ui: &mut Ui, value: &mut T, options: &[(T, &str, &str)]) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding.x = 6.0;
        for &(option, label, hint) in options {
            let button =
                ui.add(Button::selectable(*value == option, label).frame_when_inactive(true));
            let button = named(button, label).on_hover_text(hint);
            if button.clicked() {
                *value = option;
            }
        }
    });
}
