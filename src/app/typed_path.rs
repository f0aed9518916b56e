//! Paths that are typed or pasted in the file dialog while nobody has asked for its field for paths.

use super::open_dialog::{EDIT_PATH, focused_field};
use egui::text::CharIndex;
use egui::{Context, Event, InputState, Key, Rect, Response, TextEdit};
use std::collections::VecDeque;
use std::path::Path;

/// Height of the part at the top with the path and the search, in points: these end at 82.5 with the fonts of
/// the window, and the list begins below.
const TOP: f32 = 90.0;

/// What is typed of a path before the field for it has the keyboard. Without it, the dialog would search
/// the folder for it.
#[derive(Default)]
pub(super) struct TypedPath {
    /// Whether what is typed next is the beginning of a path, whose field has been opened by its key.
    is_next: bool,
    /// Dots that may begin a path, or else a search.
    held: String,
    /// What the field gets once it has the keyboard, and what was typed meanwhile.
    waiting: VecDeque<Event>,
}

impl TypedPath {
    /// To be called before the dialog is shown, where no path is typed yet. If what is typed begins a path,
    /// whether its field is to be opened now: it gets the text in the next frame, after the `folder` that the
    /// dialog shows if the path is a relative one.
    pub fn begins(
        &mut self,
        context: &Context,
        dialog: Option<Rect>,
        folder: Option<&Path>,
    ) -> bool {
        if self.held.is_empty() && !is_at_start(context, dialog) {
            return false;
        }
        let typed: String = context.input(|input| input.events.iter().filter_map(text).collect());
        let held = std::mem::take(&mut self.held);
        let all = held.clone() + &typed;
        if begins_path(&all) {
            let path = from_root(&all, folder);
            context.input_mut(|input| {
                self.waiting.push_back(Event::Text(path));
                let keys = taken(input).filter(|event| text(event).is_none());
                self.waiting.extend(keys);
                let key = Event::Key {
                    key: EDIT_PATH.logical_key,
                    physical_key: None,
                    pressed: true,
                    repeat: false,
                    modifiers: EDIT_PATH.modifiers,
                };
                input.events.push(key);
            });
            context.request_repaint();
            return true;
        }
        let may_begin = all == "." || all == "..";
        context.input_mut(|input| {
            let is_other = |event: &Event| match event {
                Event::Key { key, pressed, .. } => *pressed && *key != Key::Period,
                _ => false,
            };
            if may_begin && !input.events.iter().any(is_other) {
                input.events.retain(|event| text(event).is_none());
                self.held = all;
            } else if !held.is_empty() {
                input.events.insert(0, Event::Text(held));
            }
        });
        false
    }

    /// To be called where the field for paths is opened by its key, in which what is typed replaces all.
    pub fn opened_by_key(&mut self) {
        self.is_next = true;
    }

    /// To be called before the dialog is shown: puts the `folder` that it shows before the beginning of a relative
    /// path, since the dialog would look for that where the program was started.
    pub fn complete(&mut self, context: &Context, folder: Option<&Path>) {
        if !self.is_next {
            return;
        }
        // A key may leave some of what was there, and a click lead to another field.
        let ends = |event: &Event| match event {
            Event::Key { pressed, .. } | Event::PointerButton { pressed, .. } => *pressed,
            event => text(event).is_some(),
        };
        context.input_mut(|input| {
            self.is_next = !input.events.iter().any(ends);
            let typed = input.events.iter_mut().find_map(|event| match event {
                Event::Text(typed) | Event::Paste(typed) => Some(typed),
                _ => None,
            });
            if let Some(typed) = typed {
                *typed = from_root(typed, folder);
            }
        });
    }

    /// Keeps what is typed in this frame for the next one.
    pub fn hold_keys(&mut self, context: &Context) {
        context.input_mut(|input| self.waiting.extend(taken(input)));
        context.request_repaint();
    }

    /// To be called before the dialog is shown: gives the field what waits for it, text first and then one
    /// key a frame, since the dialog takes keys before text.
    pub fn give(&mut self, context: &Context) {
        if self.waiting.is_empty() {
            return;
        }
        context.input_mut(|input| {
            self.waiting.extend(taken(input));
            let is_text = self
                .waiting
                .front()
                .is_some_and(|first| text(first).is_some());
            while let Some(event) = self.waiting.pop_front() {
                input.events.push(event);
                let goes_on = |next: &Event| is_text && text(next).is_some();
                if !self.waiting.front().is_some_and(goes_on) {
                    break;
                }
            }
        });
        context.request_repaint();
    }
}

/// What an event types.
pub(super) fn text(event: &Event) -> Option<&str> {
    match event {
        Event::Text(text) | Event::Paste(text) => Some(text),
        _ => None,
    }
}

/// Takes what is typed and the keys that are pressed and released out of a frame.
fn taken(input: &mut InputState) -> impl Iterator<Item = Event> + use<> {
    let is_typed = |event: &Event| text(event).is_some() || matches!(event, Event::Key { .. });
    let (taken, left) = std::mem::take(&mut input.events)
        .into_iter()
        .partition::<Vec<_>, _>(is_typed);
    input.events = left;
    taken.into_iter()
}

/// Whether what is typed next would be the first of a search: nothing has the keyboard, or a field at the
/// top of the dialog whose cursor is at its start.
fn is_at_start(context: &Context, dialog: Option<Rect>) -> bool {
    if context.memory(|memory| memory.focused()).is_none() {
        return true;
    }
    field_at_top(context, dialog).is_some_and(|field| {
        let state = TextEdit::load_state(context, field.id);
        let cursor = state.and_then(|state| state.cursor.char_range());
        cursor.is_none_or(|cursor| cursor.sorted_cursors()[0].index == CharIndex::default())
    })
}

/// The field for the path or the search, if it has the keyboard.
pub(super) fn field_at_top(context: &Context, dialog: Option<Rect>) -> Option<Response> {
    let (field, dialog) = focused_field(context).zip(dialog)?;
    (field.rect.bottom() < dialog.top() + TOP).then_some(field)
}

/// Whether a text is the beginning of a path and no part of a name.
fn begins_path(text: &str) -> bool {
    ["/", "~", "./", "../"]
        .iter()
        .any(|start| text.starts_with(start))
        || text.len() > 1 && Path::new(text).is_absolute()
}

/// A path that is typed, or its beginning, with what a tilde and a relative path in `folder` mean.
fn from_root(typed: &str, folder: Option<&Path>) -> String {
    let home = directories::BaseDirs::new();
    let path = with_home(typed, home.as_ref().map(directories::BaseDirs::home_dir));
    in_folder(&path, folder)
}

/// `path` with the user's folder in place of a tilde.
fn with_home(path: &str, home: Option<&Path>) -> String {
    match (path.strip_prefix('~'), home) {
        (Some(rest), Some(home)) if rest.is_empty() || rest.starts_with('/') => {
            format!("{}{rest}", home.display())
        }
        _ => path.to_owned(),
    }
}

/// `path`, or its beginning, in `folder` if it is a relative one.
fn in_folder(path: &str, folder: Option<&Path>) -> String {
    // Of a letter it is not known whether that is a drive.
    let is_relative = !Path::new(path).has_root() && (cfg!(not(windows)) || path.starts_with('.'));
    match folder {
        Some(folder) if is_relative && !path.starts_with('~') => {
            // With a separator behind it, and the dots as they are typed.
            format!("{}{path}", folder.join("").display())
        }
        _ => path.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_begins_a_path_is_told_from_a_search() {
        for path in ["/", "/home", "~", "~/models", "./a", "../b.obj"] {
            assert!(begins_path(path), "{path}");
        }
        for name in ["", ".", "..", ".obj", "robot", "a/b", "...", "é"] {
            assert!(!begins_path(name), "{name}");
        }
    }

    #[test]
    fn a_tilde_is_the_folder_of_the_user() {
        let home = Some(Path::new("/home/ada"));
        assert_eq!(with_home("~/a.obj", home), "/home/ada/a.obj");
        assert_eq!(with_home("~", home), "/home/ada");
        assert_eq!(with_home("~bob/a.obj", home), "~bob/a.obj");
        assert_eq!(with_home("/tmp/~", home), "/tmp/~");
        assert_eq!(with_home("~/a", None), "~/a");
    }

    #[test]
    fn a_relative_path_is_in_the_folder_that_the_dialog_shows() {
        let folder = Some(Path::new("/home/ada"));
        for (typed, meant) in [
            ("../a.obj", "/home/ada/../a.obj"),
            ("./", "/home/ada/./"),
            ("/tmp/a", "/tmp/a"),
            ("~bob/a", "~bob/a"),
        ] {
            assert_eq!(in_folder(typed, folder), meant);
            assert_eq!(in_folder(typed, None), typed);
        }
        assert_eq!(in_folder("./a", Some(Path::new("/"))), "/./a");
    }
}
