//! Messages: notices over the view, and the history in Help ▸ Messages.

use super::Action;
use super::theme::Palette;
use super::widgets::{cover, named, spoken};
use crate::editor::{Message, Messages, Session, Severity, View};
use egui::{
    Align, Button, Color32, Frame, Label, Layout, Pos2, Rect, RichText, ScrollArea, TextStyle, Ui,
    UiBuilder, Vec2, Visuals, vec2,
};
use std::time::Duration;

/// State of the notices over the view.
#[derive(Clone, Debug, Default)]
pub(super) struct NoticeState {
    /// Notices that are shown, by [`Message::number`], with the seconds for which they have been.
    shown: Vec<(u64, f64)>,
    /// Time of the last frame, in seconds of egui's clock.
    last_frame: f64,
    /// Whether the pointer was over one of them in the last frame: their time stands still then,
    /// however long it is until the next.
    is_read: bool,
    /// Number of warnings and errors that have faded and were not looked up since.
    pub faded: usize,
}

/// Number of notices shown at once; the history has all messages.
const SHOWN: usize = 3;
/// Seconds in which a notice fades at the end of its time.
const FADE: f64 = 0.5;

/// Seconds for which a notice is shown: the more it matters, the longer. Where there is only the scene, nothing else
/// says why it is not as it should be, so that errors stay.
fn stays(severity: Severity, is_viewer: bool) -> f64 {
    match severity {
        Severity::Error if is_viewer => f64::INFINITY,
        Severity::Info => 6.0,
        Severity::Warning => 12.0,
        Severity::Error => 20.0,
    }
}

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

/// Notices: messages that are not dismissed yet, at the bottom of the view. They fade by
/// themselves, except while the pointer is over one of them. The oldest go when newer ones need their places: shown
/// later, they would be taken for what has happened just now.
pub(super) fn notices(
    ui: &mut Ui,
    view: Rect,
    (session, is_viewer): (&Session, bool),
    state: &mut NoticeState,
    actions: &mut Vec<Action>,
) {
    let fresh = session.messages.fresh();
    let stay = |index: &usize| stays(fresh[*index].severity, is_viewer).is_infinite();
    let (mut shown, mut passing): (Vec<usize>, Vec<usize>) = (0..fresh.len()).partition(stay);
    // What stays has its place whatever comes after it.
    shown.drain(..shown.len().saturating_sub(SHOWN));
    let room = SHOWN - shown.len();
    shown.extend(passing.drain(passing.len().saturating_sub(room)..));
    shown.sort_unstable();
    let ages = state.ages(ui, shown.iter().map(|&index| &fresh[index]));
    let widest = (view.width() - 24.0).clamp(80.0, 560.0);
    let mut foot = view.left_bottom() + vec2(12.0, -12.0);
    let mut is_read = false;
    let mut next = f64::INFINITY;
    for index in &passing {
        state.faded += usize::from(fresh[*index].severity != Severity::Info);
    }
    let mut gone = passing;
    for (&index, age) in shown.iter().zip(ages).rev() {
        let message = &fresh[index];
        let left = stays(message.severity, is_viewer) - age;
        let opacity = (left / FADE).clamp(0.0, 1.0);
        next = next.min(if left > FADE { left - FADE } else { 0.0 });
        let (rect, dismissed) = notice(ui, message, foot, widest, opacity as f32);
        is_read |= ui.rect_contains_pointer(rect);
        if left <= 0.0 && message.severity != Severity::Info {
            state.faded += 1;
        }
        if dismissed || left <= 0.0 {
            gone.push(index);
        }
        foot.y = rect.top() - 4.0;
    }
    gone.sort_unstable();
    // From the last to the first, so that those before one that goes keep their places.
    let gone = gone.into_iter().rev();
    actions.extend(gone.map(|index| Action::View(View::DismissMessage(index))));
    state.is_read = is_read;
    if is_read {
        state.shown.iter_mut().for_each(|(_, age)| *age = 0.0);
    } else if next.is_finite() {
        let wait = Duration::from_secs_f64(next);
        ui.ctx().request_repaint_after(wait);
    }
}

impl NoticeState {
    /// Seconds for which each of `messages` has been shown, this frame included.
    fn ages<'a>(
        &mut self,
        ui: &Ui,
        messages: impl Iterator<Item = &'a Message> + Clone,
    ) -> Vec<f64> {
        let now = ui.input(|input| input.time);
        let since_last = now - std::mem::replace(&mut self.last_frame, now);
        let passed = if self.is_read { 0.0 } else { since_last };
        let age_of = |message: &Message| {
            let known = self.shown.iter().find(|(of, _)| *of == message.number);
            known.map_or(0.0, |(_, age)| age + passed)
        };
        let ages: Vec<f64> = messages.clone().map(age_of).collect();
        let numbers = messages.map(|message| message.number);
        self.shown = numbers.zip(ages.iter().copied()).collect();
        ages
    }
}

/// One notice with its lower left corner at `foot`; its rectangle, and whether its × was clicked.
fn notice(ui: &mut Ui, message: &Message, foot: Pos2, widest: f32, opacity: f32) -> (Rect, bool) {
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
    let mut contents = ui.new_child(
        UiBuilder::new()
            .id_salt(("notice", message.number))
            .max_rect(rect),
    );
    contents.multiply_opacity(opacity);
    cover(&contents, rect);
    let frame = Frame::popup(ui.style()).inner_margin(0);
    contents.painter().add(frame.paint(rect));

    let inside = rect.shrink2(PADDING);
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

/// A button for the status line while warnings or errors have faded that nobody has looked up;
/// whether it was clicked.
pub(super) fn faded(ui: &mut Ui, state: &NoticeState) -> bool {
    let text = match state.faded {
        0 => return false,
        1 => "⚠ 1 message".to_owned(),
        count => format!("⚠ {count} messages"),
    };
    let color = Palette::of(ui.visuals()).warning;
    let text = RichText::new(text).small().color(color);
    let button = ui.add(Button::new(text).frame_when_inactive(false));
    named(button, "Show messages")
        .on_hover_text("Warnings and errors that have faded: Help ⏵ Messages has them")
        .clicked()
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
