//! Matrices as 4 × 4 numbers.

use super::digits::Digits;
use crate::ui::theme::{Palette, number_font};
use egui::{
    Align2, Frame, Label, Margin, Rect, Sense, Stroke, Ui, Vec2, WidgetInfo, WidgetText,
    WidgetType, pos2, vec2,
};
use glam::DMat4;

/// Width and height of a number, in points.
const CELL: Vec2 = vec2(45.0, 15.0);

const MARGIN: Margin = Margin::symmetric(6, 4);
/// Width of a matrix in its frame, in points.
pub(super) const WIDTH: f32 = 4.0 * CELL.x + (MARGIN.left + MARGIN.right) as f32 + 2.0 * LINE;
/// Widest line of the frame.
const LINE: f32 = 1.5;

/// Shows a matrix below its title. `called` is its name for assistive technology, `stands_out` draws
/// it before the others.
pub(super) fn show(
    ui: &mut Ui,
    title: impl Into<WidgetText>,
    called: &str,
    matrix: &DMat4,
    digits: Digits,
    stands_out: bool,
) {
    let palette = Palette::of(ui.visuals());
    let line = if stands_out {
        Stroke::new(LINE, palette.accent)
    } else {
        Stroke::new(1.0, palette.line)
    };
    let frame = Frame::new()
        .fill(palette.field)
        .stroke(line)
        .corner_radius(3)
        .inner_margin(MARGIN);
    frame.show(ui, |ui| {
        ui.vertical(|ui| {
            // In what room is left, a title would break letter by letter.
            ui.set_width(4.0 * CELL.x);
            ui.add(Label::new(title).truncate());
            let (rect, cells) = ui.allocate_exact_size(CELL * 4.0, Sense::hover());
            let rows = digits.rows(matrix);
            for (row, cells) in rows.iter().enumerate() {
                for (column, text) in cells.iter().enumerate() {
                    paint(ui, rect, (row, column), text);
                }
            }
            let spoken: Vec<String> = rows.iter().map(|row| row.join(" ")).collect();
            let spoken = format!("{called}: {}", spoken.join("; "));
            cells.widget_info(|| WidgetInfo::labeled(WidgetType::Other, true, &spoken));
        });
    });
}

fn paint(ui: &Ui, whole: Rect, (row, column): (usize, usize), text: &str) {
    let right = whole.left() + CELL.x * (column + 1) as f32;
    let middle = whole.top() + CELL.y * (row as f32 + 0.5);
    let color = Palette::of(ui.visuals()).text;
    let at = pos2(right, middle);
    ui.painter()
        .text(at, Align2::RIGHT_CENTER, text, number_font(), color);
}
