use super::notices::{color, icon, word};
use super::widgets::spoken;
use crate::editor::{Message, Messages};
use egui::{Align, Label, Layout, RichText, ScrollArea, Ui};

/// Help ▸ Messages: everything told since the start, newest last.
pub(super) fn show(ui: &mut Ui, messages: &Messages) {
    let history = messages.history();
    ui.horizontal(|ui| {
        let copy = ui.add_enabled(!history.is_empty(), egui::Button::new("Copy all"));
        if copy
            .on_hover_text("Copy the whole history as text")
            .on_disabled_hover_text("Nothing has been told yet")
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
        ui.label("Nothing has been told yet.");
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
