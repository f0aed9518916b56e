use super::state::NoticeState;
use super::theme::Palette;
use super::widgets::{named, spoken};
use crate::editor::{Message, Session, Severity, View};
use crate::ui::Action;
use egui::{
    Align, Button, Color32, Frame, Label, Pos2, Rect, RichText, TextStyle, Ui, UiBuilder, Vec2,
    Visuals, vec2,
};
use std::time::Duration;

/// How many fresh messages are shown at once; the history has them all.
const SHOWN: usize = 3;
/// Messages that need no decision go away by themselves after this many seconds.
const STAYS: f64 = 8.0;

/// The sign before a message, so that its kind shows without color too.
pub(super) fn icon(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "ℹ",
        Severity::Warning => "⚠",
        Severity::Error => "⊗",
    }
}

/// The kind of message in words, for assistive technology and copies of the history.
pub(super) fn word(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "Note",
        Severity::Warning => "Warning",
        Severity::Error => "Error",
    }
}

/// The color of a message's sign.
pub(super) fn color(visuals: &Visuals, severity: Severity) -> Color32 {
    let palette = Palette::of(visuals);
    match severity {
        Severity::Info => palette.accent,
        Severity::Warning => palette.warning,
        Severity::Error => palette.error,
    }
}

/// Shows what was told and not yet dismissed, at the foot of the view.
pub(super) fn show(
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

/// Whether all that is fresh may go away by itself and has been there for long enough.
fn is_over(ui: &Ui, session: &Session, state: &mut NoticeState) -> bool {
    let told = session.messages.history().len();
    let now = ui.input(|input| input.time);
    let since = match state.seen {
        Some((seen, since)) if seen == told => since,
        _ => now,
    };
    state.seen = Some((told, since));
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

/// One message with its lower left corner at `foot`; where it is and whether its × was clicked.
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
