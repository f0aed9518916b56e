//! Small things that several panels share.

use super::theme::Palette;
use egui::{EventFilter, Key, Modifiers, Response, RichText, Ui};

/// Gives a widget the name that screen readers say and tests find.
pub(super) fn named(response: Response, name: &str) -> Response {
    let ctx = response.ctx.clone();
    ctx.accesskit_node_builder(response.id, |node| node.set_label(name));
    response
}

/// Gives a sign the word that screen readers say for it.
pub(super) fn spoken(sign: Response, word: &str) -> Response {
    let ctx = sign.ctx.clone();
    ctx.accesskit_node_builder(sign.id, |node| node.set_value(word));
    sign
}

/// A title above a group of widgets.
pub(super) fn section(ui: &mut Ui, title: &str) {
    ui.add_space(4.0);
    let color = Palette::of(ui.visuals()).strong;
    let label = egui::Label::new(RichText::new(title).color(color)).truncate();
    ui.add(label);
}

/// A move through a list by keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ListMove {
    Up,
    Down,
    First,
    Last,
    Left,
    Right,
}

/// The key of a list that was pressed while its row `row` has the keyboard. Arrow keys then
/// stay with the list rather than moving the keyboard to whatever widget lies in that direction.
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
            (Key::Home, ListMove::First),
            (Key::End, ListMove::Last),
            (Key::ArrowLeft, ListMove::Left),
            (Key::ArrowRight, ListMove::Right),
        ]
        .into_iter()
        .find(|&(key, _)| input.consume_key(Modifiers::NONE, key))
        .map(|(_, movement)| movement)
    })
}

/// Which of `count` rows a move from row `at` leads to.
pub(super) fn moved(movement: ListMove, at: usize, count: usize) -> Option<usize> {
    let last = count.checked_sub(1)?;
    match movement {
        ListMove::Up => Some(at.saturating_sub(1)),
        ListMove::Down => Some((at + 1).min(last)),
        ListMove::First => Some(0),
        ListMove::Last => Some(last),
        ListMove::Left | ListMove::Right => None,
    }
}
