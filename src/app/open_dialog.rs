//! The file dialog while it is open, and the fields in it that have the keyboard.

use super::dialog_files::DialogFiles;
use super::typed_name::full_path;
use super::typed_path::{TypedPath, field_at_top, text};
use crate::disk::Disk;
use crate::program::{FileRequest, Purpose, Suggested};
use crate::ui;
use egui::text::{CCursor, CCursorRange};
use egui::{
    Align2, Context, Id, Key, KeyboardShortcut, LayerId, Modifiers, Order, Rect, TextEdit,
    TextStyle, Vec2, pos2, vec2,
};
use egui_file_dialog::{FileDialog, FileDialogKeyBindings, Filter, KeyBinding};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Size in windows that have room for it, in points.
const SIZE: Vec2 = vec2(640.0, 440.0);
/// Width below which some buttons give way, in points.
const NARROW: f32 = 480.0;
/// Least distance from the edges of the window, in points, with the dialog's own margins.
const AWAY_FROM_EDGES: Vec2 = vec2(40.0, 64.0);
/// Height of the part at the bottom with the name of a file that is to be written, in points.
const BOTTOM: f32 = 88.0;
/// Width at the right of the search in which there is no other field, in points.
const BESIDE_SEARCH: f32 = 40.0;

/// One that is open.
pub(super) struct OpenDialog {
    pub request: FileRequest,
    pub dialog: FileDialog,
    pub recent: Vec<PathBuf>,
    /// Whether the name of the file had the keyboard at the end of the last frame.
    types_name: bool,
    /// Field of that name, once it has had the keyboard.
    pub name_field: Option<Id>,
    /// Whether the dialog asks about an existing file, in place of that field.
    asks: bool,
    /// Whether the path has had the keyboard since it was asked for.
    types_path: bool,
    /// A path that is typed where the dialog would search for it.
    typed: TypedPath,
}

impl OpenDialog {
    /// Opens it. A file that is to be written has the suggested name.
    pub fn new(request: FileRequest, suggested: Suggested) -> Self {
        let purpose = request.purpose;
        let mut dialog = dialog(purpose, &suggested);
        if let Some((first, _)) = purpose.written().first() {
            // What is typed belongs to the name, not to a search that would choose another file.
            dialog = dialog
                .show_search(false)
                // Without the search it would stand out of the dialog.
                .show_menu_button(false)
                // The extension is added where it is missing, as it is to a name.
                .allow_path_edit_to_save_file_without_extension(true)
                .default_file_name(&suggested.name);
            for (name, extension) in purpose.written() {
                dialog = dialog.add_save_extension(name, extension);
            }
            dialog = dialog.default_save_extension(first);
            dialog.save_file();
        } else {
            dialog.pick_file();
        }
        Self {
            request,
            dialog,
            recent: suggested.recent,
            types_name: false,
            name_field: None,
            asks: false,
            types_path: false,
            typed: TypedPath::default(),
        }
    }

    /// Shows it; returns the file once one is chosen.
    pub fn show(&mut self, context: &Context) -> Option<PathBuf> {
        let room = context.content_rect().size() - AWAY_FROM_EDGES;
        let config = self.dialog.config_mut();
        config.max_size = Some(room);
        config.min_size = config.min_size.min(room);
        // What there is another way to do gives way to the path and the search.
        let is_narrow = room.x < NARROW;
        config.show_forward_button = !is_narrow;
        config.show_new_folder_button = !(is_narrow && self.request.purpose.written().is_empty());
        let popup = egui::Popup::is_any_open(context);
        let escape = !popup && context.input(|input| input.key_pressed(Key::Escape));
        let rect = self.rect(context);
        let searches = self.request.purpose.written().is_empty() && !self.types_path;
        let folder = self.dialog.storage_mut().last_visited_dir.as_deref();
        self.typed.complete(context, folder);
        self.typed.give(context);
        let begins_path = searches && self.typed.begins(context, rect, folder);
        let edits_path = begins_path
            || context.input(|input| {
                input.key_pressed(EDIT_PATH.logical_key)
                    && input.modifiers.matches_exact(EDIT_PATH.modifiers)
            });
        if edits_path {
            // The dialog passes over the key while the name has the keyboard.
            surrender_focus(context);
            if !begins_path {
                self.typed.opened_by_key();
            }
        } else if self.enters_search(context) {
            // The dialog would only let go of the search, and wait for another Enter.
            surrender_focus(context);
            self.typed.hold_keys(context);
        } else {
            self.type_name(context);
        }
        let layer = self.layer();
        ui::in_colors_of_file_dialogs(context, layer, || {
            self.dialog.update(context);
            self.paint_hint(context);
        });
        // The dialog keeps the pointer from what is behind it, but not the keyboard.
        context.memory_mut(|memory| memory.set_modal_layer(layer));
        let focused = context.memory(|memory| memory.focused());
        let is_shown = |field| context.read_response(field).is_some();
        let asks = self.name_field.is_some_and(|name| !is_shown(name));
        let asked = std::mem::replace(&mut self.asks, asks) && !asks;
        if edits_path && let Some(path) = focused {
            // What is typed replaces the path, as in other dialogs.
            select_all(context, path);
        } else if let (true, None, Some(name)) =
            (self.types_path || asked, focused, self.name_field)
        {
            // After the folder comes the name in it; after the question whether to replace a file,
            // another name.
            context.memory_mut(|memory| memory.request_focus(name));
            select_all(context, name);
        }
        self.types_path = focused.is_some() && (edits_path || self.types_path);
        let picked = self.dialog.take_picked().map(|path| full_path(&path));
        if picked.is_none() && escape && self.types_name {
            // The dialog would only let go of the name, and wait for another Esc.
            self.dialog = FileDialog::new();
        }
        self.types_name = self.types_name_now(context);
        if self.types_name {
            self.name_field = context.memory(|memory| memory.focused());
        }
        picked
    }

    /// Gives the keyboard back to the name where a letter is typed after a click elsewhere, such as on a
    /// folder. What is typed replaces the name, as where the dialog opens.
    fn type_name(&self, context: &Context) {
        let is_saved = !self.request.purpose.written().is_empty();
        let Some(name) = self.name_field.filter(|_| is_saved && !self.asks) else {
            return;
        };
        let types = context.input(|input| input.events.iter().any(|event| text(event).is_some()));
        if types && context.memory(|memory| memory.focused()).is_none() {
            context.memory_mut(|memory| memory.request_focus(name));
            select_all(context, name);
        }
    }

    /// Whether Enter is pressed in the search, whose first file is the chosen one.
    fn enters_search(&self, context: &Context) -> bool {
        let dialog = self.rect(context);
        let right = |field: &egui::Response| {
            dialog.is_some_and(|dialog| field.rect.right() > dialog.right() - BESIDE_SEARCH)
        };
        // Where a file is written there is no search.
        self.request.purpose.written().is_empty()
            && field_at_top(context, dialog).is_some_and(|field| right(&field))
            && context.input(|input| input.key_pressed(Key::Enter))
    }

    /// Rectangle of the dialog, in points.
    fn rect(&self, context: &Context) -> Option<Rect> {
        context.memory(|memory| memory.area_rect(self.window()))
    }

    fn window(&self) -> Id {
        self.dialog.get_window_id()
    }

    fn layer(&self) -> LayerId {
        LayerId::new(Order::Middle, self.window())
    }

    /// Whether the field at the bottom has the keyboard: that of the path is at the top.
    fn types_name_now(&self, context: &Context) -> bool {
        let (Some(field), Some(dialog)) = (focused_field(context), self.rect(context)) else {
            return false;
        };
        field.rect.top() > dialog.bottom() - BOTTOM
    }

    /// Tells how a path is typed, beside the buttons at the bottom: the dialog itself tells nobody.
    fn paint_hint(&self, context: &Context) {
        let Some(dialog) = self.rect(context) else {
            return;
        };
        let painter = context.layer_painter(self.layer());
        let at = pos2(dialog.left() + 16.0, dialog.bottom() - 22.0);
        let style = context.global_style();
        let font = TextStyle::Small.resolve(&style);
        let color = style.visuals.weak_text_color();
        let key = context.format_shortcut(&EDIT_PATH);
        let hint = match self.request.purpose.written() {
            [] => format!("/ or {key}: type a path"),
            _ => format!("{key}: type a path"),
        };
        painter.text(at, Align2::LEFT_CENTER, hint, font, color);
    }
}

/// What has the keyboard, as it was in the last frame.
pub(super) fn focused_field(context: &Context) -> Option<egui::Response> {
    let focused = context.memory(|memory| memory.focused());
    focused.and_then(|id| context.read_response(id))
}

pub(super) fn surrender_focus(context: &Context) {
    context.memory_mut(|memory| {
        if let Some(field) = memory.focused() {
            memory.surrender_focus(field);
        }
    });
}

/// Selects all of the text in a field.
fn select_all(context: &Context, field: Id) {
    let mut state = TextEdit::load_state(context, field).unwrap_or_default();
    // Cursors after the end are at the end.
    let all = CCursorRange::two(CCursor::default(), CCursor::new(usize::MAX));
    state.cursor.set_char_range(Some(all));
    state.store(context, field);
}

fn dialog(purpose: Purpose, suggested: &Suggested) -> FileDialog {
    let filter = Filter::new(move |path: &Path| purpose.offers(&Disk, path));
    let mut dialog = FileDialog::with_file_system(Arc::new(DialogFiles(purpose)))
        .title(purpose.title())
        .id("file dialog")
        .add_file_filter(purpose.filter(), filter)
        .default_file_filter(purpose.filter())
        .keybindings(keys())
        .anchor(Align2::CENTER_CENTER, Vec2::ZERO)
        .default_size(SIZE);
    let recent: Vec<&PathBuf> = suggested.recent.iter().filter(|f| f.is_dir()).collect();
    if !recent.is_empty() {
        dialog = dialog.add_quick_access("Recent", |places| {
            for folder in &recent {
                places.add_path(&name_among(folder, &recent), *folder);
            }
        });
    }
    let folder = suggested.folder.as_ref().filter(|folder| folder.is_dir());
    match folder.or(recent.first().copied()) {
        Some(folder) => dialog.initial_directory(folder.clone()),
        None => dialog,
    }
}

/// Name of a folder, with that of the folder it is in if another of `folders` is called the same.
fn name_among(folder: &Path, folders: &[&PathBuf]) -> String {
    let name = folder.file_name();
    let same = folders.iter().filter(|other| other.file_name() == name);
    let parent = folder.parent().and_then(Path::file_name);
    let name = name.unwrap_or(folder.as_os_str()).to_string_lossy();
    match parent {
        Some(parent) if same.count() > 1 => format!("{}/{name}", parent.to_string_lossy()),
        _ => name.into_owned(),
    }
}

/// Key for the path.
pub(super) const EDIT_PATH: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::L);

/// The dialog's keys, with Ctrl+L for the path, as other file dialogs have it. The slash, which
/// would open the path of the current folder and be lost, is typed like any other letter.
fn keys() -> FileDialogKeyBindings {
    FileDialogKeyBindings {
        edit_path: vec![KeyBinding::KeyboardShortcut(EDIT_PATH)],
        ..FileDialogKeyBindings::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recent_folders_of_one_name_are_told_apart_by_where_they_are() {
        let folders = ["/a/poses", "/b/poses", "/b/scenes", "/"].map(PathBuf::from);
        let all: Vec<&PathBuf> = folders.iter().collect();
        let names: Vec<String> = all.iter().map(|folder| name_among(folder, &all)).collect();
        assert_eq!(names, ["a/poses", "b/poses", "scenes", "/"]);
    }
}
