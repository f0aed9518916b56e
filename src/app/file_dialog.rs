use super::dialog_files::DialogFiles;
use super::typed_name::{full_path, trimmed};
use super::typed_path::{TOP, TypedPath, text};
use crate::disk::Disk;
use crate::program::{FileRequest, Purpose, Suggested};
use crate::ui;
use egui::text::{CCursor, CCursorRange};
use egui::{
    Align2, Context, Id, Key, KeyboardShortcut, LayerId, Modifiers, Order, Rect, TextEdit,
    TextStyle, Vec2, pos2, vec2,
};
use egui_file_dialog::{DialogState, FileDialog, FileDialogKeyBindings, Filter, KeyBinding};
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

/// The file dialog of the window, drawn inside it: it needs no desktop portal.
#[derive(Default)]
pub(super) struct WindowFileDialog {
    open: Option<OpenDialog>,
}

struct OpenDialog {
    request: FileRequest,
    dialog: FileDialog,
    recent: Vec<PathBuf>,
    /// Whether the name of the file had the keyboard at the end of the last frame.
    types_name: bool,
    /// Field of that name, once it has had the keyboard.
    name_field: Option<Id>,
    /// Whether the dialog asks about an existing file, in place of that field.
    asks: bool,
    /// Whether the path has had the keyboard since it was asked for.
    types_path: bool,
    /// A path that is typed where the dialog would search for it.
    typed: TypedPath,
}

impl WindowFileDialog {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Opens it, in place of one that is open already. A file that is to be written has the
    /// suggested name until the user does otherwise.
    pub fn open(&mut self, request: FileRequest, suggested: Suggested) {
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
        self.open = Some(OpenDialog {
            request,
            dialog,
            recent: suggested.recent,
            types_name: false,
            name_field: None,
            asks: false,
            types_path: false,
            typed: TypedPath::default(),
        });
    }

    /// Shows the dialog if it is open; returns the file once one is chosen.
    pub fn show(&mut self, context: &Context) -> Option<(FileRequest, PathBuf)> {
        let open = self.open.as_mut()?;
        let Some(path) = open.show(context) else {
            if !matches!(open.dialog.state(), DialogState::Open) {
                self.open = None;
            }
            return None;
        };
        let OpenDialog {
            request, recent, ..
        } = self.open.take()?;
        if let Some(found) = request.purpose.found(&Disk, &path) {
            return Some((request, found));
        }
        let folder = path.parent().map(Path::to_owned);
        let is_new = !(request.purpose.written().is_empty() || path.exists());
        let named = if is_new {
            trimmed(&path)
        } else {
            Some(path.clone())
        };
        let meant = named.map(|path| request.purpose.completed(&path).unwrap_or(path));
        let name = match meant {
            Some(meant) if meant == path || !meant.exists() => return Some((request, meant)),
            // The dialog has asked about another file: let it ask about this one.
            Some(meant) => meant.file_name().map(|name| name.to_string_lossy().into()),
            // Nothing but spaces is no name.
            None => None,
        };
        let suggested = Suggested {
            folder,
            recent,
            name: name.unwrap_or_default(),
        };
        self.open(request, suggested);
        None
    }
}

impl OpenDialog {
    /// Shows it; returns the file once one is chosen.
    fn show(&mut self, context: &Context) -> Option<PathBuf> {
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
        self.typed.folder = self.dialog.storage_mut().last_visited_dir.clone();
        self.typed.complete(context);
        self.typed.give(context);
        let searches = self.request.purpose.written().is_empty() && !self.types_path;
        let begins_path = searches && self.typed.begins(context, self.rect(context));
        let edits_path = begins_path
            || context.input(|input| {
                input.key_pressed(EDIT_PATH.logical_key)
                    && input.modifiers.matches_exact(EDIT_PATH.modifiers)
            });
        if edits_path {
            // The dialog passes over the key while the name has the keyboard.
            surrender_focus(context);
            if !begins_path {
                self.typed.expect();
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
        let field = focused_field(context);
        let (Some(field), Some(dialog)) = (field, self.rect(context)) else {
            return false;
        };
        let is_search = self.request.purpose.written().is_empty()
            && field.rect.bottom() < dialog.top() + TOP
            && field.rect.right() > dialog.right() - BESIDE_SEARCH;
        is_search && context.input(|input| input.key_pressed(Key::Enter))
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
        let field = focused_field(context);
        let (Some(field), Some(dialog)) = (field, self.rect(context)) else {
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
fn focused_field(context: &Context) -> Option<egui::Response> {
    let focused = context.memory(|memory| memory.focused());
    focused.and_then(|id| context.read_response(id))
}

fn surrender_focus(context: &Context) {
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

    /// Opens a dialog that starts in `folder`.
    fn opened(purpose: Purpose, folder: &Path, name: &str) -> WindowFileDialog {
        let mut dialog = WindowFileDialog::default();
        let request = FileRequest {
            purpose,
            opened: crate::revision::Revision::new(),
        };
        let suggested = Suggested {
            folder: Some(folder.to_owned()),
            recent: Vec::new(),
            name: name.to_owned(),
        };
        dialog.open(request, suggested);
        dialog
    }

    /// Runs a frame with a button behind the dialog; returns whether that has the keyboard, and the file that
    /// is chosen.
    fn frame(
        context: &Context,
        dialog: &mut WindowFileDialog,
        events: Vec<egui::Event>,
    ) -> (bool, Option<PathBuf>) {
        let input = egui::RawInput {
            events,
            ..egui::RawInput::default()
        };
        let (mut is_behind, mut chosen) = (false, None);
        let mut output = context.run_ui(input, |ui| {
            is_behind = ui.button("Behind").has_focus();
            chosen = dialog.show(ui.ctx()).map(|(_, path)| path);
        });
        output.textures_delta.clear();
        (is_behind, chosen)
    }

    fn pressed(key: Key) -> [egui::Event; 2] {
        [true, false].map(|pressed| egui::Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: egui::Modifiers::NONE,
        })
    }

    #[test]
    fn the_keyboard_stays_in_the_dialog() {
        let folder = tempfile::tempdir().unwrap();
        let mut dialog = opened(Purpose::Open, folder.path(), "");
        let context = Context::default();
        let (mut inside, mut behind) = (0, 0);
        for number in 0..80 {
            // The first frames make the dialog.
            let events = if number < 5 {
                Vec::new()
            } else {
                vec![pressed(Key::Tab)[number % 2].clone()]
            };
            let (is_behind, _) = frame(&context, &mut dialog, events);
            behind += usize::from(is_behind);
            inside += usize::from(!is_behind && context.memory(|it| it.focused()).is_some());
        }
        assert!(
            inside > 20 && behind == 0,
            "{inside} inside, {behind} behind"
        );
    }

    #[test]
    fn enter_in_the_search_opens_the_first_file_that_is_found() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.scene", "b.scene", "bc.scene"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let mut dialog = opened(Purpose::Open, folder.path(), "");
        let context = Context::default();
        let mut chosen = None;
        for events in [
            Vec::new(),
            Vec::new(),
            vec![egui::Event::Text("b".to_owned())],
            Vec::new(),
            vec![egui::Event::Text("c".to_owned())],
            Vec::new(),
            pressed(Key::Enter).to_vec(),
            Vec::new(),
        ] {
            chosen = chosen.or(frame(&context, &mut dialog, events).1);
        }
        assert_eq!(chosen, Some(folder.path().join("bc.scene")));
        assert!(!dialog.is_open());
    }

    #[test]
    fn a_relative_path_leads_on_from_the_folder_that_is_shown() {
        let ctrl = Modifiers::CTRL | Modifiers::COMMAND;
        let key = egui::Event::Key {
            key: Key::L,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: ctrl,
        };
        let held = |modifiers| egui::Event::ModifiersChanged(modifiers);
        let ctrl_l = [vec![held(ctrl), key], vec![held(Modifiers::NONE)]];
        let typed = |text: &str| vec![egui::Event::Text(text.to_owned())];
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("shown");
        std::fs::create_dir(&folder).unwrap();
        for file in [root.path().join("a.scene"), folder.join("b.scene")] {
            std::fs::write(file, "").unwrap();
        }
        for (keys, found) in [
            (vec![typed("../a.scene")], "a.scene"),
            (
                vec![typed("."), typed("."), typed("/"), typed("a.scene")],
                "a.scene",
            ),
            (vec![typed("./b.scene")], "shown/b.scene"),
            (
                [ctrl_l.to_vec(), vec![typed("b"), typed(".scene")]].concat(),
                "shown/b.scene",
            ),
            (
                [ctrl_l.to_vec(), vec![typed("../a.scene")]].concat(),
                "a.scene",
            ),
        ] {
            let mut dialog = opened(Purpose::Open, &folder, "");
            let context = Context::default();
            let mut chosen = None;
            let enter = [
                Vec::new(),
                Vec::new(),
                pressed(Key::Enter).to_vec(),
                Vec::new(),
                Vec::new(),
            ];
            for events in [Vec::new(), Vec::new()]
                .into_iter()
                .chain(keys)
                .chain(enter)
            {
                chosen = chosen.or(frame(&context, &mut dialog, events).1);
            }
            let chosen = chosen.and_then(|path| path.canonicalize().ok());
            assert_eq!(
                chosen,
                root.path().join(found).canonicalize().ok(),
                "{found}"
            );
        }
    }

    #[test]
    fn another_name_is_typed_where_a_file_is_not_to_be_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let there = folder.path().join("a.scene");
        std::fs::write(&there, "").unwrap();
        let mut dialog = opened(Purpose::SaveScene, folder.path(), "a.scene");
        let context = Context::default();
        let mut chosen = None;
        let keys = |events: Vec<egui::Event>, dialog: &mut WindowFileDialog| {
            let mut found = None;
            for events in [events].into_iter().chain((0..4).map(|_| Vec::new())) {
                found = found.or(frame(&context, dialog, events).1);
            }
            found
        };
        for events in [
            Vec::new(),
            pressed(Key::Enter).to_vec(),
            pressed(Key::Escape).to_vec(),
            vec![egui::Event::Text("b".to_owned())],
            pressed(Key::Enter).to_vec(),
        ] {
            chosen = chosen.or(keys(events, &mut dialog));
        }
        assert_eq!(chosen, Some(folder.path().join("b.scene")));
    }

    #[test]
    fn a_name_is_typed_after_a_click_elsewhere_in_the_dialog() {
        let folder = tempfile::tempdir().unwrap();
        let mut dialog = opened(Purpose::SaveScene, folder.path(), "a.scene");
        let context = Context::default();
        let mut chosen = None;
        for number in 0..3 {
            frame(&context, &mut dialog, Vec::new());
            // As a click beside the name does.
            if number == 2 {
                surrender_focus(&context);
            }
        }
        for events in [
            Vec::new(),
            vec![egui::Event::Text("b".to_owned())],
            vec![egui::Event::Text("c".to_owned())],
            pressed(Key::Enter).to_vec(),
            Vec::new(),
        ] {
            chosen = chosen.or(frame(&context, &mut dialog, events).1);
        }
        assert_eq!(chosen, Some(folder.path().join("bc.scene")));
    }

    #[test]
    fn a_file_that_is_there_is_asked_about_also_where_its_name_was_typed_with_spaces() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.scene"), "").unwrap();
        for (typed, found) in [
            (" a", None),
            (" a.scene", None),
            ("  ", None),
            (" b ", Some("b.scene")),
        ] {
            let mut dialog = opened(Purpose::SaveScene, folder.path(), "");
            let context = Context::default();
            let mut chosen = None;
            for events in [
                Vec::new(),
                Vec::new(),
                vec![egui::Event::Text(typed.to_owned())],
                pressed(Key::Enter).to_vec(),
                Vec::new(),
                Vec::new(),
            ] {
                chosen = chosen.or(frame(&context, &mut dialog, events).1);
            }
            assert_eq!(
                chosen,
                found.map(|name| folder.path().join(name)),
                "{typed:?}"
            );
            assert_eq!(dialog.is_open(), found.is_none(), "{typed:?}");
        }
    }
}
