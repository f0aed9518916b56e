//! A line between two pictures in one place, which is dragged.

use super::theme::Palette;
use super::widgets::named;
use egui::{Color32, CursorIcon, Rect, Sense, Stroke, Ui, pos2};

/// How far from the line it can be taken hold of, in points.
const GRIP: f32 = 6.0;

/// Where the line stands at `share` of the width of `place`, on a whole pixel of the screen so that both
/// parts stay sharp.
pub(super) fn x(ui: &Ui, place: Rect, share: f32) -> f32 {
    let pixels_per_point = ui.ctx().pixels_per_point();
    let x = place.left() + place.width() * share.clamp(0.0, 1.0);
    (x * pixels_per_point).round() / pixels_per_point
}

/// Shows the line at `share` of the width of `place`, 0 (left) to 1, and lets it be dragged.
pub(super) fn show(ui: &Ui, place: Rect, share: &mut f32) {
    let x = x(ui, place, *share);
    let strip = Rect::from_x_y_ranges(x - GRIP..=x + GRIP, place.y_range());
    let line = ui
        .interact(strip, ui.id().with("swipe line"), Sense::drag())
        .on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
    let line = named(line, "Line between the pictures");
    let palette = Palette::of(ui.visuals());
    let held = line.hovered() || line.dragged();
    let color = if held { palette.accent } else { Color32::WHITE };
    let painter = ui.painter();
    // White with black beside it shows on every picture.
    painter.vline(
        x,
        place.y_range(),
        Stroke::new(3.0, Color32::from_black_alpha(160)),
    );
    painter.vline(x, place.y_range(), Stroke::new(1.0, color));
    painter.circle(
        pos2(x, place.center().y),
        5.0,
        color,
        Stroke::new(1.0, Color32::BLACK),
    );
    if line.dragged()
        && let Some(pointer) = line.interact_pointer_pos()
    {
        *share = ((pointer.x - place.left()) / place.width()).clamp(0.0, 1.0);
    }
}
