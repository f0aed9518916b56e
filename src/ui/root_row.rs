//! The row below a root joint: how far the root has moved.

use super::joint_columns::{Columns, OFFSET, font, offset_left};
use super::joint_row::reset_button;
use super::joint_tree::Row;
use super::number_field::NumberField;
use super::theme::Palette;
use crate::character::{Pose, SkeletalModel};
use egui::{Align2, Rect, Ui};
use glam::Vec3;

/// What a user did in the row.
pub(super) struct Shown {
    pub hovered: bool,
    /// A new offset from the place at rest, in the character's space.
    pub offset: Option<Vec3>,
}

/// Shows the row below that of the root `row`, in `rect`.
pub(super) fn show(
    ui: &mut Ui,
    skeleton: &SkeletalModel,
    pose: &Pose,
    row: &Row,
    rect: Rect,
    columns: &Columns,
) -> Shown {
    let hovered = ui.rect_contains_pointer(rect);
    let palette = Palette::of(ui.visuals());
    if hovered {
        ui.painter().rect_filled(rect, 3.0, palette.field);
    }
    let at = columns.name(rect, offset_left(row)).left_center();
    let font = font(ui);
    ui.painter()
        .text(at, Align2::LEFT_CENTER, OFFSET, font, palette.weak);

    let called = format!("{} {OFFSET}", skeleton.joints()[row.joint].name);
    let id = ui.id().with(("root", row.joint));
    let now = pose.root_offset(row.joint);
    let mut offset = None;
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{called} {letter}");
        let field = NumberField::new(&called, now[axis], 0.1)
            .decimals(2..=3)
            .axis(axis);
        if let Some(value) = field.show_at(ui, id.with(axis), columns.field(rect, axis)) {
            let mut moved = now;
            moved[axis] = value;
            offset = Some(moved);
        }
    }
    let moved = now != Vec3::ZERO;
    if moved && reset_button(ui, id.with("reset"), columns.reset(rect), &called) {
        offset = Some(Vec3::ZERO);
    }
    Shown { hovered, offset }
}
