//! What panels below the view have in common: their place, and columns where there is room for some.

use egui::{Frame, Id, Margin, Panel, ScrollArea, Ui, UiBuilder};

/// Width, in points, below which a panel shows its parts one below the other.
const ROOM_FOR_COLUMNS: f32 = 760.0;

/// Part of the height above it that a panel takes at most, alone and with another one below the view.
const HIGHEST: f32 = 0.6;
const HIGHEST_OF_TWO: f32 = 0.5;

/// Heights of a panel, which its upper edge changes.
pub(in crate::ui) struct Heights {
    /// Never lower, in points.
    pub lowest: f32,
    /// At first, in points.
    pub alone: f32,
    /// At first with another panel below the view, as a part of the window's height.
    pub beside: f32,
}

/// A panel below the view. With another one it is lower, and has a height of its own, so that the view stays
/// of use and each panel has the height from before when the other one is closed.
pub(in crate::ui) fn below_the_view(
    root: &mut Ui,
    (id, with_another): (&'static str, bool),
    heights: Heights,
    contents: impl FnOnce(&mut Ui),
) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 4));
    let window = root.ctx().content_rect().height();
    let (height, part) = match with_another {
        true => (heights.beside * window, HIGHEST_OF_TWO),
        false => (heights.alone, HIGHEST),
    };
    let lowest = heights.lowest;
    let highest = (root.available_height() * part).max(lowest);
    let height = height.clamp(lowest, highest);
    Panel::bottom(Id::new((id, with_another)))
        .frame(frame)
        .resizable(true)
        .default_size(height)
        .size_range(lowest..=highest)
        .show(root, |ui| {
            // Where there is nothing to show, the panel would shrink, and stay small afterwards.
            ui.take_available_height();
            contents(ui);
        });
}

/// What is below the header, one part below the other, which scrolls.
pub(in crate::ui) fn scrolled(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    ui.add_space(2.0);
    ScrollArea::vertical().auto_shrink(false).show(ui, contents);
}

pub(in crate::ui) fn has_room_for_columns(ui: &Ui) -> bool {
    ui.available_width() >= ROOM_FOR_COLUMNS
}

/// Parts of the width that three columns have: words need more than numbers.
const COLUMNS: [f32; 3] = [0.38, 0.3, 0.32];
/// Space between columns, in points.
const GAP: f32 = 16.0;

/// What is below the header in three columns, each of which scrolls by itself: `contents` fills the one of its
/// number.
pub(in crate::ui) fn columns(ui: &mut Ui, mut contents: impl FnMut(usize, &mut Ui)) {
    ui.add_space(2.0);
    let room = ui.available_rect_before_wrap();
    let mut left = room.left();
    for (number, part) in COLUMNS.into_iter().enumerate() {
        let right = left + part * (room.width() + GAP) - GAP;
        let column = room.with_min_x(left).with_max_x(right);
        ui.scope_builder(UiBuilder::new().max_rect(column), |ui| {
            ui.shrink_clip_rect(column);
            let area = ScrollArea::vertical().id_salt(number).auto_shrink(false);
            area.show(ui, |ui| contents(number, ui));
        });
        left = right + GAP;
    }
}
