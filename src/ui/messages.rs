//! Messages: notices over the view, and the history in Help ▸ Messages.

use super::Action;
use super::theme::Palette;
use super::widgets::{named, spoken};
use crate::editor::{Message, Messages, Session, Severity, View};
use egui::{
    Align, Button, Color32, Frame, Label, Layout, Pos2, Rect, RichText, ScrollArea, TextStyle, Ui,
    UiBuilder, Vec2, Visuals, vec2,
};
use std::time::Duration;

/// State of the notices over the view.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NoticeState {
    /// Length of the message history when it last grew, and the time of that in seconds of egui's
    /// clock.
    pub seen: Option<(usize, f64)>,
}

/// Number of notices shown at once; the history has all messages.
const SHOWN: usize = 3;
/// Seconds until notices disappear, unless one is a warning or an error.
const STAYS: f64 = 8.0;

/// Icon of a message, so that its severity shows without color too.
fn icon(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "ℹ",
        Severity::Warning => "⚠",
        Severity::Error => "⊗",
    }
}

/// Severity in words, for assistive technology and copies of the history.
fn word(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "Note",
        Severity::Warning => "Warning",
        Severity::Error => "Error",
    }
}

/// Color of a message's icon.
fn color(visuals: &Visuals, severity: Severity) -> Color32 {
    let palette = Palette::of(visuals);
    match severity {
        Severity::Info => palette.accent,
        Severity::Warning => palette.warning,
        Severity::Error => palette.error,
    }
}

/// Notices: messages that are not dismissed yet, at the bottom of the view.
pub(super) fn notices(
    ui: &mut Ui,
    view: Rect,
    session: &Session,
    state: &mut NoticeState,
    actions: &mut Vec<Action>,
) {
    let fresh = session.messages.fresh();
    if fresh.is_empty() {
        state.seen = None;
        return;
    }
    if is_over(ui, session, state) {
        actions.push(Action::View(View::DismissMessages));
        return;
    }
    let widest = (view.width() - 24.0).clamp(80.0, 560.0);
    let first = fresh.len().saturating_sub(SHOWN);
    let mut foot = view.left_bottom() + vec2(12.0, -12.0);
    for (index, message) in fresh.iter().enumerate().skip(first).rev() {
        let (rect, dismissed) = notice(ui, message, foot, widest);
        if dismissed {
            actions.push(Action::View(View::DismissMessage(index)));
        }
        foot.y = rect.top() - 4.0;
    }
}

/// Whether notices have been shown for long enough, and none of them is a warning or an error.
fn is_over(ui: &Ui, session: &Session, state: &mut NoticeState) -> bool {
    let count = session.messages.history().len();
    let now = ui.input(|input| input.time);
    let since = match state.seen {
        Some((seen, since)) if seen == count => since,
        _ => now,
    };
    state.seen = Some((count, since));
    let fresh = session.messages.fresh();
    if fresh.iter().any(|m| m.severity != Severity::Info) {
        return false;
    }
    let left = STAYS - (now - since);
    if left > 0.0 {
        ui.ctx()
            .request_repaint_after(Duration::from_secs_f64(left));
    }
    left <= 0.0
}

/// One notice with its lower left corner at `foot`; its rectangle, and whether its × was clicked.
fn notice(ui: &mut Ui, message: &Message, foot: Pos2, widest: f32) -> (Rect, bool) {
    const PADDING: Vec2 = vec2(8.0, 6.0);
    const SIGN: f32 = 22.0;
    const CLOSE: f32 = 20.0;
    let close = CLOSE + 4.0;
    let text = ui.painter().layout(
        message.text.clone(),
        TextStyle::Body.resolve(ui.style()),
        ui.visuals().text_color(),
        widest - 2.0 * PADDING.x - SIGN - close,
    );
    let inner = vec2(SIGN + text.size().x + close, text.size().y.max(CLOSE));
    let size = inner + 2.0 * PADDING;
    let rect = Rect::from_min_size(foot - vec2(0.0, size.y), size);
    let frame = Frame::popup(ui.style()).inner_margin(0);
    ui.painter().add(frame.paint(rect));

    let inside = rect.shrink2(PADDING);
    let mut contents = ui.new_child(
        UiBuilder::new()
            .id_salt(("notice", foot.y as i32))
            .max_rect(rect),
    );
    let (left, rest) = inside.split_left_right_at_x(inside.left() + SIGN);
    let color = color(ui.visuals(), message.severity);
    let sign = RichText::new(icon(message.severity)).color(color);
    let sign = contents.put(left, Label::new(sign).halign(Align::Min));
    spoken(sign, word(message.severity));
    let (middle, right) = rest.split_left_right_at_x(rest.right() - close);
    contents.put(middle, Label::new(text).halign(Align::Min));
    let button = Rect::from_min_size(right.right_top() - vec2(CLOSE, 0.0), Vec2::splat(CLOSE));
    let cross = Button::new("×").frame_when_inactive(false);
    let cross = named(
        contents.put(button, cross),
        &format!("Dismiss: {}", message.text),
    );
    let cross = cross.on_hover_text("Hide this; Help ⏵ Messages keeps it");
    (rect, cross.clicked())
}

/// Help ▸ Messages: all messages since the program started, newest last.
pub(super) fn history(ui: &mut Ui, messages: &Messages) {
    let history = messages.history();
    ui.horizontal(|ui| {
        let copy = ui.add_enabled(!history.is_empty(), egui::Button::new("Copy all"));
        if copy
            .on_hover_text("Copy the whole history as text")
            .on_disabled_hover_text("There are no messages yet")
            .clicked()
        {
            ui.ctx().copy_text(as_text(history));
        }
        let count = match history.len() {
            1 => "1 message".to_owned(),
            count => format!("{count} messages"),
        };
        ui.label(RichText::new(count).weak());
    });
    ui.separator();
    if history.is_empty() {
        ui.label("There are no messages yet.");
        return;
    }
    ScrollArea::vertical()
        .auto_shrink(false)
        .stick_to_bottom(true)
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing = egui::vec2(8.0, 8.0);
            for message in history {
                line(ui, message);
            }
        });
}

fn line(ui: &mut Ui, message: &Message) {
    ui.with_layout(
        Layout::left_to_right(Align::TOP).with_main_wrap(false),
        |ui| {
            let color = color(ui.visuals(), message.severity);
            let sign = ui.label(RichText::new(icon(message.severity)).color(color));
            spoken(sign, word(message.severity)).on_hover_text(word(message.severity));
            ui.add(Label::new(&message.text).wrap().selectable(true));
        },
    );
}

fn as_text(history: &[Message]) -> String {
    history
        .iter()
        .map(|message| format!("{}: {}\n", word(message.severity), message.text))
        .collect()
}
