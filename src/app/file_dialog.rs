use super::open_dialog::OpenDialog;
use super::typed_name::trimmed;
use crate::disk::Disk;
use crate::program::{FileRequest, Suggested};
use egui::Context;
use egui_file_dialog::DialogState;
use std::path::{Path, PathBuf};

/// The file dialog of the window, drawn inside it: it needs no desktop portal.
#[derive(Default)]
pub(super) struct WindowFileDialog {
    open: Option<OpenDialog>,
}

impl WindowFileDialog {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Opens it, in place of one that is open already. A file that is to be written has the
    /// suggested name until the user does otherwise.
    pub fn open(&mut self, request: FileRequest, suggested: Suggested) {
        self.open = Some(OpenDialog::new(request, suggested));
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

#[cfg(test)]
mod tests {
    use super::super::open_dialog::surrender_focus;
    use super::*;
    use crate::program::Purpose;
    use egui::{Event, Key, Modifiers};

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

    /// The file that is chosen in these frames, each with what happens in it.
    fn chosen(
        context: &Context,
        dialog: &mut WindowFileDialog,
        frames: impl IntoIterator<Item = Vec<Event>>,
    ) -> Option<PathBuf> {
        let all = frames
            .into_iter()
            .map(|events| frame(context, dialog, events).1);
        // Every frame is run, also after the one in which the file is chosen.
        all.fold(None, Option::or)
    }

    fn typed(text: &str) -> Vec<Event> {
        vec![Event::Text(text.to_owned())]
    }

    /// Runs a frame with a button behind the dialog; returns whether that has the keyboard, and the file that
    /// is chosen.
    fn frame(
        context: &Context,
        dialog: &mut WindowFileDialog,
        events: Vec<Event>,
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

    fn pressed(key: Key) -> [Event; 2] {
        [true, false].map(|pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        })
    }

    /// Ctrl+L, and what follows when Ctrl is let go.
    fn ctrl_l() -> Vec<Vec<Event>> {
        let ctrl = Modifiers::CTRL | Modifiers::COMMAND;
        let key = Event::Key {
            key: Key::L,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: ctrl,
        };
        let held = Event::ModifiersChanged;
        vec![vec![held(ctrl), key], vec![held(Modifiers::NONE)]]
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
    fn enter_in_the_search_opens_the_first_file_or_folder_that_is_found() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("scenes");
        std::fs::create_dir(&folder).unwrap();
        for name in ["a.scene", "b.scene", "bc.scene"] {
            std::fs::write(folder.join(name), "").unwrap();
        }
        let mut dialog = opened(Purpose::Open, root.path(), "");
        // What a thread finds comes in any frame: the folder is read anew in the first one.
        if let Some(open) = &mut dialog.open {
            open.dialog.config_mut().load_via_thread = false;
        }
        let context = Context::default();
        let enter = || pressed(Key::Enter).to_vec();
        let into_folder = [
            pressed(Key::F5).to_vec(),
            Vec::new(),
            typed("s"),
            Vec::new(),
            enter(),
        ];
        let to_file = [
            Vec::new(),
            Vec::new(),
            typed("b"),
            typed("c"),
            Vec::new(),
            enter(),
            Vec::new(),
        ];
        let chosen = chosen(
            &context,
            &mut dialog,
            into_folder.into_iter().chain(to_file),
        );
        assert_eq!(chosen, Some(folder.join("bc.scene")));
        assert!(!dialog.is_open());
    }

    #[test]
    fn a_relative_path_leads_on_from_the_folder_that_is_shown() {
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
                [ctrl_l(), vec![typed("b"), typed(".scene")]].concat(),
                "shown/b.scene",
            ),
            ([ctrl_l(), vec![typed("../a.scene")]].concat(), "a.scene"),
        ] {
            let mut dialog = opened(Purpose::Open, &folder, "");
            let context = Context::default();
            let opening = [Vec::new(), Vec::new()];
            let enter = [
                Vec::new(),
                Vec::new(),
                pressed(Key::Enter).to_vec(),
                Vec::new(),
                Vec::new(),
            ];
            let frames = opening.into_iter().chain(keys).chain(enter);
            let chosen = chosen(&context, &mut dialog, frames);
            let chosen = chosen.and_then(|path| path.canonicalize().ok());
            assert_eq!(
                chosen,
                root.path().join(found).canonicalize().ok(),
                "{found}"
            );
        }
    }

    #[test]
    fn a_name_is_no_path_where_it_is_clicked_after_ctrl_l() {
        let folder = tempfile::tempdir().unwrap();
        let mut dialog = opened(Purpose::SaveScene, folder.path(), "a.scene");
        let context = Context::default();
        let none = chosen(&context, &mut dialog, [Vec::new(), Vec::new(), Vec::new()]);
        assert_eq!(none, None);
        let name = dialog.open.as_ref().and_then(|open| open.name_field);
        let name = name.and_then(|field| context.read_response(field)).unwrap();
        let button = |pressed| Event::PointerButton {
            pos: name.rect.center(),
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        let click = vec![
            vec![Event::PointerMoved(name.rect.center())],
            vec![button(true)],
            vec![button(false)],
        ];
        chosen(
            &context,
            &mut dialog,
            [ctrl_l(), click, vec![typed("b")], vec![Vec::new()]].concat(),
        );
        let shown = context
            .read_response(name.id)
            .is_some_and(|field| field.has_focus());
        assert!(shown, "the name has no keyboard");
        let rest = [pressed(Key::Enter).to_vec(), Vec::new(), Vec::new()];
        let chosen = chosen(&context, &mut dialog, rest);
        let parent = chosen.and_then(|path| path.parent().map(Path::to_owned));
        assert_eq!(parent.as_deref(), Some(folder.path()));
    }

    #[test]
    fn another_name_is_typed_where_a_file_is_not_to_be_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let there = folder.path().join("a.scene");
        std::fs::write(&there, "").unwrap();
        let mut dialog = opened(Purpose::SaveScene, folder.path(), "a.scene");
        let context = Context::default();
        let mut chosen = None;
        let keys = |events: Vec<Event>, dialog: &mut WindowFileDialog| {
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
            typed("b"),
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
        for number in 0..3 {
            frame(&context, &mut dialog, Vec::new());
            // As a click beside the name does.
            if number == 2 {
                surrender_focus(&context);
            }
        }
        let chosen = chosen(
            &context,
            &mut dialog,
            [
                Vec::new(),
                typed("b"),
                typed("c"),
                pressed(Key::Enter).to_vec(),
                Vec::new(),
            ],
        );
        assert_eq!(chosen, Some(folder.path().join("bc.scene")));
    }

    #[test]
    fn a_file_that_is_there_is_asked_about_also_where_its_name_was_typed_with_spaces() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.scene"), "").unwrap();
        for (name, found) in [
            (" a", None),
            (" a.scene", None),
            ("  ", None),
            (" b ", Some("b.scene")),
        ] {
            let mut dialog = opened(Purpose::SaveScene, folder.path(), "");
            let context = Context::default();
            let chosen = chosen(
                &context,
                &mut dialog,
                [
                    Vec::new(),
                    Vec::new(),
                    typed(name),
                    pressed(Key::Enter).to_vec(),
                    Vec::new(),
                    Vec::new(),
                ],
            );
            assert_eq!(
                chosen,
                found.map(|name| folder.path().join(name)),
                "{name:?}"
            );
            assert_eq!(dialog.is_open(), found.is_none(), "{name:?}");
        }
    }
}
