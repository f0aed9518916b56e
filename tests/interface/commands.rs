//! Commands by their names: the search for them.

use crate::interface::Editor;
use editor_core::ui::COMMANDS;
use egui::{Event, Key, Modifiers};

impl Editor {
    fn find_command(&mut self, words: &str) {
        self.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
        self.harness.event(Event::Text(words.to_owned()));
        self.settle();
    }

    /// How many names of commands are on the screen.
    fn commands_shown(&self) -> usize {
        let is_one = |text: &String| COMMANDS.iter().any(|entry| entry.label == text);
        let painted = self.painted().into_iter();
        painted.filter(|(text, _)| is_one(text)).count()
    }
}

#[test]
fn the_search_for_a_command_has_room_again_after_one_with_a_single_result() {
    let mut editor = Editor::new();
    let before = editor.commands_shown();
    editor.find_command("");
    editor.settle();
    let all = editor.commands_shown();
    assert!(all > before + 8, "{all}");
    editor.key(Key::Escape);
    editor.find_command("utah");
    assert_eq!(editor.commands_shown(), before + 1);
    editor.key(Key::Escape);
    editor.find_command("");
    assert_eq!(editor.commands_shown(), all, "when it is opened again");
    editor.harness.event(Event::Text("utah".to_owned()));
    editor.settle();
    for _ in 0.."utah".len() {
        editor.key(Key::Backspace);
    }
    assert_eq!(editor.commands_shown(), all, "when the words are gone");
}
