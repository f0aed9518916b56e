//! What the panels of comparisons have in common: their place below the view, and columns where there is
//! room for some.

use egui::{Frame, Margin, Panel, ScrollArea, Ui};

/// Least height of a panel, in points.
const LOWEST: f32 = 64.0;
/// Width, in points, below which a panel shows its parts one below the other.
const ROOM_FOR_COLUMNS: f32 = 760.0;

/// A panel below the view, at first of `height`.
pub(super) fn below_the_view(
    root: &mut Ui,
    id: &'static str,
    height: f32,
    contents: impl FnOnce(&mut Ui),
) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 4));
    let highest = (root.available_height() * 0.6).max(LOWEST);
    Panel::bottom(id)
        .frame(frame)
        .resizable(true)
        .default_size(height)
        .size_range(LOWEST..=highest)
        .show(root, contents);
}

/// What is below the header, which scrolls.
pub(super) fn scrolled(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    ui.add_space(2.0);
    ScrollArea::vertical().auto_shrink(false).show(ui, contents);
}

pub(super) fn has_room_for_columns(ui: &Ui) -> bool {
    ui.available_width() >= ROOM_FOR_COLUMNS
}

/// Three columns, wider apart than the widgets in them.
pub(super) fn columns(ui: &mut Ui, contents: impl FnOnce(&mut [Ui; 3])) {
    let gap = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 16.0);
    ui.columns_const(|columns: &mut [Ui; 3]| {
        for column in &mut *columns {
            column.spacing_mut().item_spacing.x = gap;
        }
        contents(columns);
    });
}
