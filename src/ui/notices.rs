use super::state::NoticeState;
use super::theme::Palette;
use super::widgets::named;
use crate::editor::{Action, Message, Session, Severity, View};
use egui::{Align, Color32, Frame, Layout, Margin, Rect, RichText, Ui, UiBuilder, Visuals, vec2};
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
    let width = (view.width() - 24.0).clamp(80.0, 560.0);
    let area = Rect::from_min_max(
        egui::pos2(view.left() + 12.0, view.top()),
        egui::pos2(view.left() + 12.0 + width, view.bottom() - 12.0),
    );
    let builder = UiBuilder::new()
        .id_salt("notices")
        .max_rect(area)
        .layout(Layout::bottom_up(Align::LEFT));
    let mut inner = ui.new_child(builder);
    let first = fresh.len().saturating_sub(SHOWN);
    for (index, message) in fresh.iter().enumerate().skip(first).rev() {
        let newest = index + 1 == fresh.len();
        if notice(&mut inner, message, newest) {
            actions.push(Action::View(View::DismissMessages));
        }
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

/// One message; whether its × was clicked.
fn notice(ui: &mut Ui, message: &Message, newest: bool) -> bool {
    let frame = Frame::popup(ui.style()).inner_margin(Margin::symmetric(8, 4));
    let mut dismissed = false;
    frame.show(ui, |ui| {
        ui.set_max_width(ui.available_width());
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let color = color(ui.visuals(), message.severity);
            let sign = ui.label(RichText::new(icon(message.severity)).color(color));
            named(sign, word(message.severity));
            let button = ui.spacing().interact_size.y;
            let room = ui.available_width() - if newest { button + 8.0 } else { 0.0 };
            ui.scope(|ui| {
                ui.set_max_width(room);
                ui.add(egui::Label::new(&message.text).wrap());
            });
            if newest {
                let close = egui::Button::new("×").frame_when_inactive(false);
                let close = ui.add_sized(vec2(button, button), close);
                dismissed = named(close, "Dismiss messages")
                    .on_hover_text("Hide this; Help ▸ Messages keeps it")
                    .clicked();
            }
        });
    });
    dismissed
}
