//! What the program tells, over the view and in the history.

use crate::interface::Editor;
use editor_core::editor::Severity;
use egui::Key;

fn tell(editor: &mut Editor, severity: Severity, text: &str) {
    let messages = &mut editor.harness.state_mut().program.session_mut().messages;
    messages.tell(severity, text);
    editor.settle();
}

#[test]
fn an_error_stays_in_sight_until_it_is_dismissed_and_in_the_history_after() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Error, "a.skel:3:1: no such parent");
    editor.harness.run_steps(100);
    assert!(editor.has("a.skel:3:1: no such parent"));
    assert!(editor.has("Error"), "the sign has a name");
    editor.click("Dismiss: a.skel:3:1: no such parent");
    assert!(!editor.has("a.skel:3:1: no such parent"));
    editor.choose(&["Help", "Messages"]);
    assert!(editor.has("a.skel:3:1: no such parent"));
}

#[test]
fn each_message_is_dismissed_by_itself_and_makes_room_for_an_older_one() {
    let mut editor = Editor::new();
    for text in ["first", "second", "third", "fourth"] {
        tell(&mut editor, Severity::Error, text);
    }
    assert!(!editor.has("first") && editor.has("second"));
    editor.click("Dismiss: third");
    for (text, shown) in [
        ("first", true),
        ("second", true),
        ("third", false),
        ("fourth", true),
    ] {
        assert_eq!(editor.has(text), shown, "{text}");
    }
}

#[test]
fn a_note_goes_away_by_itself() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Info, "Saved a.png");
    assert!(editor.has("Saved a.png"));
    // A step of the harness is a quarter of a second.
    editor.harness.run_steps(40);
    assert!(!editor.has("Saved a.png"));
    editor.key(Key::F9);
    assert!(editor.has("Saved a.png"));
}

#[test]
fn the_history_is_copied_with_words_for_the_signs() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Warning, "odd weights");
    tell(&mut editor, Severity::Error, "no file");
    editor.key(Key::F9);
    editor.widget("Copy all").click();
    editor.harness.step();
    let commands = &editor.harness.output().platform_output.commands;
    let copied = commands.iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.as_str()),
        _ => None,
    });
    assert_eq!(copied, Some("Warning: odd weights\nError: no file\n"));
}

#[test]
fn a_warning_stays_in_sight_and_so_does_a_note_beside_it() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Warning, "odd weights");
    tell(&mut editor, Severity::Info, "Imported a.dae");
    editor.harness.run_steps(100);
    assert!(editor.has("odd weights") && editor.has("Imported a.dae"));
    editor.click("Dismiss: odd weights");
    editor.harness.run_steps(40);
    assert!(!editor.has("Imported a.dae"));
}
