//! Windows over the view: Keys and Mouse, Messages, History, Preferences, About; which of them are open.

use super::commands::{GESTURES, Menu, entries, entry_of, meant};
use super::key_commands::is_there;
use super::pointing::Pointing;
use super::screenshot::{self, ScreenshotForm};
use super::state::UiState;
use super::theme::Palette;
use super::{Action, ViewInput, fingers, history, messages, preferences};
use crate::editor::Session;
use egui::{Align, Id, Label, Layout, Response, RichText, ScrollArea, Ui, Window, vec2};

/// A window over the view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dialog {
    Keys,
    Messages,
    History,
    Preferences,
    About,
    Screenshot,
}

/// Open windows, and what the screenshot dialog was last set to.
#[derive(Clone, Debug, Default)]
pub(super) struct Windows {
    /// In the order in which they were opened: Esc closes the last one first.
    open: Vec<Dialog>,
    screenshot: ScreenshotForm,
}

impl Windows {
    /// Opens a window; for Esc it then is the last one, even if it was open already.
    pub(super) fn open(&mut self, dialog: Dialog) {
        self.close(dialog);
        self.open.push(dialog);
    }

    fn close(&mut self, dialog: Dialog) {
        self.open.retain(|&open| open != dialog);
    }

    /// Closes the window opened last; whether there was one.
    pub(super) fn close_last(&mut self) -> bool {
        self.open.pop().is_some()
    }

    pub(super) fn is_any_open(&self) -> bool {
        !self.open.is_empty()
    }

    pub(super) fn is_open(&self, dialog: Dialog) -> bool {
        self.open.contains(&dialog)
    }
}

/// Shows the open windows.
pub(super) fn show(
    root: &Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    aspect: f32,
    actions: &mut Vec<Action>,
) {
    let mut windows = std::mem::take(&mut state.windows);
    let title = "Preferences";
    window(root, &mut windows, Dialog::Preferences, title, |ui| {
        preferences::show(ui, session, state, aspect, actions);
    });
    window(root, &mut windows, Dialog::Keys, "Keys and Mouse", |ui| {
        keys_and_mouse(ui, session, state, input);
    });
    state.windows = windows;
    let windows = &mut state.windows;
    window(root, windows, Dialog::Messages, "Messages", |ui| {
        messages::history(ui, &session.messages);
    });
    window(root, windows, Dialog::History, "History", |ui| {
        history::show(ui, session, actions);
    });
    window(root, windows, Dialog::About, "About", |ui| {
        about(ui, input.backend);
    });
    if windows.is_open(Dialog::Screenshot)
        && screenshot::show(root, input, &mut windows.screenshot, actions)
    {
        windows.close(Dialog::Screenshot);
    }
}

/// Shows one window, with a title and a ×, if it is open; never larger than the program's window.
fn window(
    root: &Ui,
    windows: &mut Windows,
    dialog: Dialog,
    title: &str,
    contents: impl FnOnce(&mut Ui),
) {
    if !windows.is_open(dialog) {
        return;
    }
    let screen = root.ctx().content_rect();
    let size = match dialog {
        Dialog::About => vec2(360.0, 140.0),
        // As high as the program's window allows.
        Dialog::Keys => vec2(480.0, 720.0),
        Dialog::History => vec2(280.0, 360.0),
        Dialog::Preferences => vec2(480.0, 600.0),
        _ => vec2(480.0, 420.0),
    };
    let size = size.min(screen.size() - vec2(48.0, 96.0));
    let mut open = true;
    Window::new(title)
        .id(Id::new(title))
        .open(&mut open)
        .collapsible(false)
        .resizable(dialog != Dialog::About)
        .default_size(size)
        .default_pos(screen.center() - size / 2.0)
        .show(root.ctx(), contents);
    if !open {
        windows.close(dialog);
    }
}

/// Help ▸ Keys and Mouse, made from the table of commands.
fn keys_and_mouse(ui: &mut Ui, session: &Session, state: &UiState, input: &ViewInput) {
    let navigation = state.navigation;
    let context = ui.ctx().clone();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let room = ui.available_width();
        // Who has a mouse has no use for them; a screen of touch is known by its first touch.
        if Pointing::of(ui.ctx()) == Pointing::Fingers {
            heading(ui, "Fingers");
            let drag = navigation.drag_of_a_finger();
            for gesture in std::iter::once(&drag).chain(fingers::GESTURES) {
                row(ui, gesture.gesture, gesture.does, room);
            }
        }
        heading(ui, "Mouse");
        let is_its_own = |name: &str| navigation.gestures().any(|own| own.gesture == name);
        let others = GESTURES.iter();
        let others = others.filter(|gesture| !is_its_own(gesture.gesture));
        for gesture in navigation.gestures().chain(others) {
            row(ui, gesture.gesture, gesture.does, room);
        }
        for &menu in Menu::ALL {
            let mut entries = entries(menu)
                .filter(|entry| is_there(entry.command, input))
                .map(|entry| (entry.keys(&context, navigation), entry))
                .filter(|(keys, _)| !keys.is_empty())
                .peekable();
            if entries.peek().is_none() {
                continue;
            }
            heading(ui, title(menu));
            for (keys, entry) in entries {
                let meant = meant(entry.command, session, state.pose.tool);
                let entry = entry_of(meant).unwrap_or(entry);
                row(ui, &keys, entry.label, room).on_hover_text(entry.tooltip);
            }
        }
    });
}

/// One row of a table, `room` points wide: what is pressed or moved, and its effect.
fn row(ui: &mut Ui, pressed: &str, does: &str, room: f32) -> Response {
    let left = (room * 0.42).min(176.0);
    let cell = |ui: &mut Ui, text: RichText, width: f32| {
        let layout = Layout::top_down(Align::LEFT);
        let shown = ui.allocate_ui_with_layout(vec2(width, 0.0), layout, |ui| {
            ui.set_min_width(width);
            ui.add(Label::new(text).wrap())
        });
        shown.inner
    };
    let pressed = key(ui, pressed);
    let both = ui.horizontal_top(|ui| {
        cell(ui, pressed, left);
        cell(ui, RichText::new(does), room - left - 16.0)
    });
    both.inner
}

fn title(menu: Menu) -> &'static str {
    match menu {
        Menu::Document => "File",
        Menu::File => "File, other files",
        Menu::Scenes => "File ⏵ Built-in Scene",
        Menu::Edit => "Edit",
        Menu::Preferences => "Edit, preferences",
        Menu::Clipboard => "Edit, clipboard and selection",
        Menu::Insert => "Insert",
        Menu::Curves => "Insert, curves",
        Menu::Import => "Insert ⏵ Import",
        Menu::Shape => "Edit, selected shape",
        Menu::Transform => "Edit ⏵ Reset Transform",
        Menu::View => "View",
        Menu::Directions => "View ⏵ View from",
        Menu::Look => "View ⏵ Look",
        Menu::Shading => "View ⏵ Shading",
        Menu::Colors => "View ⏵ Colors",
        Menu::Ground => "View, ground and panels",
        Menu::Compare => "View, comparisons",
        Menu::Explain => "View, skinning explained",
        Menu::Navigation => "View ⏵ Navigation",
        Menu::Theme => "View ⏵ Theme",
        Menu::Skinning => "View ⏵ Skinning",
        Menu::Tools => "Pose",
        Menu::Pose => "Pose, selected character",
        Menu::Help => "Help",
    }
}

fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    let color = Palette::of(ui.visuals()).strong;
    ui.label(RichText::new(text).color(color));
}

fn key(ui: &Ui, text: &str) -> RichText {
    RichText::new(text).color(Palette::of(ui.visuals()).accent)
}

/// Help ▸ About.
fn about(ui: &mut Ui, backend: &str) {
    ui.label(RichText::new(concat!("Editor ", env!("CARGO_PKG_VERSION"))).heading());
    ui.label(env!("CARGO_PKG_DESCRIPTION"));
    ui.add_space(8.0);
    ui.label(concat!("License: ", env!("CARGO_PKG_LICENSE")));
    if !backend.is_empty() {
        ui.label(format!("Draws with {backend}"));
    }
}
