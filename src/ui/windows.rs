use super::state::{Dialog, UiState};
use super::{ViewInput, about, help, messages, screenshot};
use crate::editor::Session;
use crate::ui::Action;
use egui::{Ui, Window, vec2};

/// The windows that are open over the view.
pub(super) fn show(
    root: &Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    actions: &mut Vec<Action>,
) {
    let navigation = state.navigation;
    window(root, state, Dialog::Keys, "Keys and Mouse", |ui| {
        help::show(ui, navigation);
    });
    window(root, state, Dialog::Messages, "Messages", |ui| {
        messages::show(ui, &session.messages);
    });
    window(root, state, Dialog::About, "About", |ui| {
        about::show(ui, input.backend);
    });
    if state.is_open(Dialog::Screenshot) && screenshot::show(root, &mut state.screenshot, actions) {
        state.close(Dialog::Screenshot);
    }
}

/// One window with a title and a ×, never larger than the program's.
fn window(
    root: &Ui,
    state: &mut UiState,
    dialog: Dialog,
    title: &str,
    contents: impl FnOnce(&mut Ui),
) {
    if !state.is_open(dialog) {
        return;
    }
    let screen = root.ctx().content_rect();
    let size = match dialog {
        Dialog::About => vec2(360.0, 140.0),
        // Long: as high as the window lets it be.
        Dialog::Keys => vec2(480.0, 720.0),
        _ => vec2(480.0, 420.0),
    };
    let size = size.min(screen.size() - vec2(48.0, 96.0));
    let mut open = true;
    Window::new(title)
        .id(egui::Id::new(title))
        .open(&mut open)
        .collapsible(false)
        .resizable(dialog != Dialog::About)
        .default_size(size)
        .default_pos(screen.center() - size / 2.0)
        .show(root.ctx(), contents);
    if !open {
        state.close(dialog);
    }
}
