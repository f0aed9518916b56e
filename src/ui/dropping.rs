//! What is shown over the window while files are dragged over it.

use super::theme::Palette;
use egui::{Area, Context, Id, Label, LayerId, Order, RichText, Stroke, StrokeKind, vec2};

/// Width of the frame along the window's edges, and its distance from them, in points.
const EDGE: f32 = 3.0;
/// How much of the panels it covers.
const SHADE: f32 = 0.75;

/// Says that files can be dropped while some are dragged over the window, or that a question comes first if
/// one `is_asked`.
pub(super) fn show(ctx: &Context, is_asked: bool) {
    if ctx.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let palette = Palette::of(&ctx.global_style().visuals);
    let window = ctx.content_rect();
    let id = Id::new("drop");
    let painter = ctx.layer_painter(LayerId::new(Order::Foreground, id));
    painter.rect_filled(window, 0.0, palette.panel.gamma_multiply(SHADE));
    let line = Stroke::new(EDGE, palette.accent);
    painter.rect_stroke(window.shrink(EDGE), 4.0, line, StrokeKind::Inside);
    let text = match is_asked {
        true => "Answer the question first",
        false => "Drop to open or add",
    };
    let middle = Area::new(id.with("words"))
        .order(Order::Tooltip)
        .interactable(false)
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(window.center());
    middle.show(ctx, |ui| {
        ui.set_max_size(vec2(window.width(), 40.0));
        let words = RichText::new(text).heading().color(palette.strong);
        ui.add(Label::new(words).extend());
    });
}
