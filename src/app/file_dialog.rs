use crate::disk::Disk;
use crate::program::{FileRequest, Purpose};
use crate::ui;
use egui::{Key, Modifiers};
use egui_file_dialog::{DialogState, FileDialog, FileDialogKeyBindings, Filter, KeyBinding};
use std::path::{Path, PathBuf};

/// The file dialog of the window, drawn inside it: it needs no desktop portal.
#[derive(Default)]
pub(super) struct WindowFileDialog {
    open: Option<(FileRequest, FileDialog)>,
}

impl WindowFileDialog {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Opens it in `folder`, in place of one that is open already. A file that is to be written is
    /// called `name` until the user does otherwise.
    pub fn open(&mut self, request: FileRequest, folder: Option<&Path>, name: &str) {
        let purpose = request.purpose;
        let mut dialog = dialog(purpose, folder);
        if let Some((first, _)) = purpose.written().first() {
            // What is typed belongs to the name, not to a search that would choose another file.
            dialog = dialog
                .show_search(false)
                // Without the search it would stand out of the dialog.
                .show_menu_button(false)
                .default_file_name(name);
            for (name, extension) in purpose.written() {
                dialog = dialog.add_save_extension(name, extension);
            }
            dialog = dialog.default_save_extension(first);
            dialog.save_file();
        } else {
            dialog.pick_file();
        }
        self.open = Some((request, dialog));
    }

    /// Shows the dialog if it is open; returns the file once one is chosen.
    pub fn show(&mut self, context: &egui::Context) -> Option<(FileRequest, PathBuf)> {
        let (request, dialog) = self.open.as_mut()?;
        let request = *request;
        ui::in_colors_of_file_dialogs(context, || {
            dialog.update(context);
        });
        let Some(path) = dialog.take_picked() else {
            if !matches!(dialog.state(), DialogState::Open) {
                self.open = None;
            }
            return None;
        };
        self.open = None;
        match request.purpose.completed(&path) {
            None => Some((request, path)),
            Some(complete) if !complete.exists() => Some((request, complete)),
            Some(complete) => {
                // The dialog has asked about another file: let it ask about this one.
                let name = complete.file_name().unwrap_or_default().to_string_lossy();
                self.open(request, complete.parent(), &name);
                None
            }
        }
    }
}

fn dialog(purpose: Purpose, folder: Option<&Path>) -> FileDialog {
    let filter = Filter::new(move |path: &Path| purpose.offers(&Disk, path));
    let dialog = FileDialog::new()
        .title(purpose.title())
        .id("file dialog")
        .add_file_filter(purpose.filter(), filter)
        .default_file_filter(purpose.filter())
        .keybindings(keys())
        .anchor(egui::Align2::CENTER_CENTER, egui::Vec2::ZERO)
        .default_size([640.0, 440.0]);
    match folder.filter(|folder| folder.is_dir()) {
        Some(folder) => dialog.initial_directory(folder.to_owned()),
        None => dialog,
    }
}

/// The dialog's keys, with Ctrl+L for the path, as other file dialogs have it. The slash, which
/// would open the path of the current folder and be lost, is typed like any other letter.
fn keys() -> FileDialogKeyBindings {
    FileDialogKeyBindings {
        edit_path: vec![KeyBinding::keyboard_shortcut(Modifiers::COMMAND, Key::L)],
        ..FileDialogKeyBindings::default()
    }
}
