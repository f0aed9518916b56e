//! Edit ▸ Preferences: all that is kept from one run to the next, in one place.

use super::Action;
use super::commands::{Menu, entries, in_words, is_on, is_page, run};
use super::state::UiState;
use super::theme::Palette;
use super::widgets::named;
use crate::editor::Session;
use crate::scene::Look;
use egui::{Button, RichText, ScrollArea, Ui};

/// Choices for the look of what has none of its own.
const LOOKS: [(Option<Look>, &str); 4] = [
    (None, "As suits the file"),
    (Some(Look::Course), "Course"),
    (Some(Look::Studio), "Studio"),
    (Some(Look::Mannequin), "Mannequin"),
];

/// Height of the button below the choices, with what is around it, in points.
const BOTTOM: f32 = 40.0;

/// The contents of the window.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    state: &mut UiState,
    aspect: f32,
    actions: &mut Vec<Action>,
) {
    let room = ui.available_height() - BOTTOM;
    let all = ScrollArea::vertical().auto_shrink(false).max_height(room);
    all.show(ui, |ui| {
        let mut choose = |ui: &mut Ui, state: &mut UiState, menu: Menu| {
            for entry in entries(menu) {
                let is_on = is_on(entry.command, session, state) == Some(true);
                let button = ui.add(Button::selectable(is_on, entry.label));
                let button = named(button, &in_words(entry));
                if button.on_hover_text(entry.tooltip).clicked() {
                    actions.extend(run(entry.command, session, state, aspect));
                }
            }
        };
        part(ui, "Theme", "Colors of the panels, and of the Studio look's background", |ui| {
            choose(ui, state, Menu::Theme);
        });
        let about_look = "How files without a view of their own are shown; View ⏵ Look changes it, too. Characters of the course that are seen well in its editor are shown as there, anything else in the Studio look";
        part(ui, "Look of new views", about_look, |ui| looks(ui, state));
        let about_navigation = format!("Mouse and keys in the view: {}", state.navigation.summary_of_mouse());
        part(ui, "Navigation", &about_navigation, |ui| {
            choose(ui, state, Menu::Navigation);
        });
        part(ui, "Shape panel", "At the right; its left edge is dragged to make it wider", |ui| {
            let mut is_shown = !state.panel_folded;
            if ui.checkbox(&mut is_shown, "Shown").changed() {
                state.panel_folded = !is_shown;
            }
        });
        part(ui, "Skinning", "What deforms characters; pictures are the same", |ui| {
            choose(ui, state, Menu::Skinning);
        });
        if is_page(ui.ctx()) {
            let about = "For who does not see the screen: browsers know nothing of what is drawn here";
            part(ui, "Speech", about, |ui| {
                ui.checkbox(&mut state.reads_aloud, "Read aloud what is used or has the focus");
            });
        }
        let palette = Palette::of(ui.visuals());
        ui.add_space(8.0);
        ui.label(RichText::new("Unsaved work").color(palette.strong));
        ui.label(RichText::new(KEPT).small().color(palette.weak));
    });
    ui.separator();
    let reset = ui.button("Reset to defaults").on_hover_text(
        "Everything in this window, and the width of the panel, as it was at the first start; recent files and folders stay",
    );
    if reset.clicked() {
        state.reset_preferences();
    }
}

const KEPT: &str = "Kept by itself every ten seconds, in the middle of a drag every thirty, and offered at the next start after the program ended without asking. Recent files, folders and the size of the window are kept as well";

/// Choices of one kind below their name, with what they are about.
fn part(ui: &mut Ui, name: &str, about: &str, choices: impl FnOnce(&mut Ui)) {
    let palette = Palette::of(ui.visuals());
    ui.add_space(8.0);
    ui.label(RichText::new(name).color(palette.strong));
    ui.horizontal_wrapped(choices);
    ui.label(RichText::new(about).small().color(palette.weak));
}

fn looks(ui: &mut Ui, state: &mut UiState) {
    for (look, label) in LOOKS {
        let button = ui.add(Button::selectable(state.look_of_new == look, label));
        if named(button, &format!("New views: {label}")).clicked() {
            state.look_of_new = look;
        }
    }
}

impl UiState {
    /// Puts what Edit ▸ Preferences shows back to how it is at the first start.
    fn reset_preferences(&mut self) {
        let first = Self::default();
        self.theme = first.theme;
        self.reset_navigation();
        self.skinning = first.skinning;
        self.look_of_new = first.look_of_new;
        self.panel_folded = first.panel_folded;
        self.reads_aloud = first.reads_aloud;
        self.panel_width = first.panel_width;
        self.panel_resets += 1;
    }
}
