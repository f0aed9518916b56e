//! Widgets and helpers shared by several panels.

use super::theme::Palette;
use egui::collapsing_header::CollapsingState;
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{
    Align, Align2, Button, CollapsingHeader, Color32, Context, EventFilter, FontId, Id, Key, Label,
    Layout, Modifiers, Painter, PointerState, Popup, Pos2, Rect, RectAlign, Response, RichText,
    Sense, Tooltip, Ui, Vec2, vec2,
};

/// Sets the name of a widget for assistive technology and tests.
pub(super) fn named(response: Response, name: &str) -> Response {
    let ctx = response.ctx.clone();
    ctx.accesskit_node_builder(response.id, |node| node.set_label(name));
    response
}

/// Sets the value of an icon for assistive technology.
pub(super) fn spoken(sign: Response, word: &str) -> Response {
    let ctx = sign.ctx.clone();
    ctx.accesskit_node_builder(sign.id, |node| node.set_value(word));
    sign
}

/// What is folded away below a heading, and unfolded by a click anywhere in the row of that.
pub(super) fn foldable(ui: &mut Ui, title: &str, salt: &str, contents: impl FnOnce(&mut Ui)) {
    let header = CollapsingHeader::new(title).id_salt(salt);
    let header = header.show(ui, contents).header_response;
    let row = header.rect.with_max_x(ui.max_rect().right());
    let rest = row.with_min_x(header.rect.right());
    // Not in the way of Tab, which stops at the heading.
    let rest = ui.interact(rest, header.id.with("rest of the row"), Sense::CLICK);
    if rest.clicked() {
        let mut state = CollapsingState::load_with_default_open(ui.ctx(), header.id, false);
        state.toggle(ui);
        state.store(ui.ctx());
    }
}

/// Narrowest and widest tooltip beside an item, in points.
const TIP: std::ops::RangeInclusive<f32> = 96.0..=320.0;
/// Distance between it and the item, in points.
const TIP_GAP: f32 = 8.0;

/// Shows a tooltip beside an item of a menu, where it covers none of the others: `text`, or why the
/// item is disabled.
pub(super) fn tip_beside(item: &Response, text: &str, why_disabled: Option<&str>) {
    let mut tooltip = match why_disabled {
        None => Tooltip::for_enabled(item),
        Some(_) => Tooltip::for_disabled(item),
    };
    let screen = item.ctx.content_rect();
    // The margins of the tooltip count, too.
    let right = screen.right() - item.rect.right() - TIP_GAP - 16.0;
    let left = item.rect.left() - screen.left() - TIP_GAP - 16.0;
    let (side, room) = if right >= left.min(*TIP.end()) {
        (RectAlign::RIGHT_START, right)
    } else {
        (RectAlign::LEFT_START, left)
    };
    tooltip.popup = aside(tooltip.popup, side, room);
    tooltip.show(|ui| ui.add(Label::new(why_disabled.unwrap_or(text)).wrap()));
}

/// Shows a tooltip of something in a panel at the right, beside the panel, where it covers none of what comes
/// below; where there is no room for it, below the item.
pub(super) fn tip_beside_panel(ui: &Ui, item: &Response, text: &str) {
    let panel = ui.clip_rect();
    let room = panel.left() - ui.ctx().content_rect().left() - TIP_GAP - 16.0;
    let mut tooltip = Tooltip::for_enabled(item);
    if room >= *TIP.start() {
        let row = item.rect.with_min_x(panel.left()).with_max_x(panel.right());
        tooltip.popup = aside(tooltip.popup.anchor(row), RectAlign::LEFT_START, room);
    }
    tooltip.show(|ui| ui.add(Label::new(text).wrap()));
}

/// A tooltip on one side of what it is about, and on no other, where it has so much room.
fn aside(tip: Popup<'_>, side: RectAlign, room: f32) -> Popup<'_> {
    let width = room.clamp(*TIP.start(), *TIP.end());
    tip.align(side)
        .align_alternatives(&[])
        .gap(TIP_GAP)
        .width(width)
}

/// Selects the whole text of a field, so that typing replaces it.
pub(super) fn select_all(ui: &Ui, id: Id, text: &str) {
    // What was typed into the field earlier is not there to be undone any more.
    let mut state = TextEditState::default();
    let end = CCursor::new(text.chars().count());
    state
        .cursor
        .set_char_range(Some(CCursorRange::two(CCursor::default(), end)));
    state.store(ui.ctx(), id);
}

/// Counts the buttons of the mouse as released until they are pressed anew, and the pointer as nowhere until it
/// moves. A press that ends a drag is
/// no click on what happens to be under the pointer, and its release, or that of the button that dragged,
/// is none either.
pub(super) fn forget_buttons(ctx: &Context) {
    ctx.input_mut(|input| input.pointer = PointerState::default());
}

/// A title above a group of widgets.
pub(super) fn section(ui: &mut Ui, title: &str) {
    ui.add_space(4.0);
    let color = Palette::of(ui.visuals()).strong;
    let label = Label::new(RichText::new(title).color(color)).truncate();
    ui.add(label);
}

/// Width of the column of labels, in points.
const LABELS: f32 = 88.0;

/// A label in the left column. The rest of the row is what `add` adds, given its size in points.
pub(super) fn labelled<R>(ui: &mut Ui, label: &str, add: impl FnOnce(&mut Ui, Vec2) -> R) -> R {
    ui.horizontal(|ui| {
        let height = ui.spacing().interact_size.y;
        let layout = Layout::left_to_right(Align::Center);
        ui.allocate_ui_with_layout(vec2(LABELS, height), layout, |ui| {
            ui.set_min_width(LABELS);
            ui.add(Label::new(label).truncate());
        });
        let size = vec2(ui.available_width(), height);
        add(ui, size)
    })
    .inner
}

/// Buttons side by side, of which one is on. `options` are values with their labels and tooltips.
pub(super) fn choice<T: Copy + PartialEq>(ui: &mut Ui, value: &mut T, options: &[(T, &str, &str)]) {
    ui.horizontal(|ui| buttons(ui, value, options, str::to_owned));
}

/// A title, and below it buttons as in [`choice`], in as many rows as they need. Their names for
/// assistive technology start with the title, because several titles have an “Off”.
pub(super) fn titled_choice<T: Copy + PartialEq>(
    ui: &mut Ui,
    title: &str,
    value: &mut T,
    options: &[(T, &str, &str)],
) {
    section(ui, title);
    ui.horizontal_wrapped(|ui| buttons(ui, value, options, |label| format!("{title}: {label}")));
}

fn buttons<T: Copy + PartialEq>(
    ui: &mut Ui,
    value: &mut T,
    options: &[(T, &str, &str)],
    name: impl Fn(&str) -> String,
) {
    ui.spacing_mut().item_spacing.x = 2.0;
    ui.spacing_mut().button_padding.x = 6.0;
    for &(option, label, hint) in options {
        let button = Button::selectable(*value == option, label)
            .frame_when_inactive(true)
            .wrap_mode(egui::TextWrapMode::Extend);
        let button = named(ui.add(button), &name(label));
        if button.on_hover_text(hint).clicked() {
            *value = option;
        }
    }
}

/// A move through a list by keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ListMove {
    Up,
    Down,
    Left,
    Right,
}

/// The move whose key was pressed while `row` of a list has the keyboard focus. Arrow keys then act
/// on the list instead of moving the focus to the next widget in that direction. Home is no such key: it is about the
/// view, also for who has just chosen in a list what to look at.
pub(super) fn list_move(ui: &Ui, row: &Response) -> Option<ListMove> {
    if !row.has_focus() {
        return None;
    }
    let filter = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(row.id, filter));
    ui.input_mut(|input| {
        [
            (Key::ArrowUp, ListMove::Up),
            (Key::ArrowDown, ListMove::Down),
            (Key::ArrowLeft, ListMove::Left),
            (Key::ArrowRight, ListMove::Right),
        ]
        .into_iter()
        .find(|&(key, _)| input.consume_key(Modifiers::NONE, key))
        .map(|(_, movement)| movement)
    })
}

/// Index of the row that a move leads to from row `at` of `count`; `None` for moves to the side.
pub(super) fn moved(movement: ListMove, at: usize, count: usize) -> Option<usize> {
    let last = count.checked_sub(1)?;
    match movement {
        ListMove::Up => Some(at.saturating_sub(1)),
        ListMove::Down => Some((at + 1).min(last)),
        ListMove::Left | ListMove::Right => None,
    }
}

/// Keeps clicks and drags in `rect` from what is below it, such as the view. To be called before what is shown there.
pub(super) fn cover(ui: &Ui, rect: Rect) {
    ui.interact(rect, ui.id().with("cover"), Sense::CLICK | Sense::DRAG);
}

/// Behind lines and words over the scene, so that they stand out from whatever is there.
pub(super) const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0xa0);

/// A word over the scene whose lower left corner is at `corner`.
pub(super) fn word_over_scene(painter: &Painter, corner: Pos2, text: &str) {
    let font = FontId::proportional(13.0);
    let galley = painter.layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    let rect = Align2::LEFT_BOTTOM.anchor_size(corner, galley.size());
    painter.rect_filled(rect.expand2(vec2(4.0, 1.0)), 3.0, SHADE);
    painter.galley(rect.min, galley, Color32::WHITE);
}
