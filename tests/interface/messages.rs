//! What the program tells, over the view and in the history.

use crate::interface::Editor;
use editor_core::editor::Severity;
use egui::Key;

fn tell(editor: &mut Editor, severity: Severity, text: &str) {
    let messages = &mut editor.harness.state_mut().program.session_mut().messages;
    messages.tell(severity, text);
    editor.settle();
}

/// Lets `seconds` pass, of which a step of the harness is a quarter.
fn wait(editor: &mut Editor, seconds: usize) {
    editor.harness.run_steps(4 * seconds);
}

#[test]
fn an_error_fades_after_a_while_and_stays_in_the_messages() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Error, "a.skel:3:1: no such parent");
    wait(&mut editor, 15);
    assert!(editor.has("a.skel:3:1: no such parent"), "time to read it");
    assert!(editor.has("Error"), "the sign has a name");
    assert!(!editor.has("Show messages"));
    wait(&mut editor, 6);
    assert!(!editor.has("a.skel:3:1: no such parent"));
    editor.click("Show messages");
    assert!(editor.has("a.skel:3:1: no such parent"));
    editor.key(Key::Escape);
    assert!(!editor.has("Show messages"), "they have been looked up");
}

#[test]
fn what_is_being_read_does_not_fade() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Info, "Saved a.png");
    let at = editor.widget("Dismiss: Saved a.png").rect().left_center();
    editor.harness.hover_at(at - egui::vec2(8.0, 0.0));
    wait(&mut editor, 20);
    assert!(editor.has("Saved a.png"));
    // The next frame is drawn when something happens, which may be late.
    let late = editor.harness.input().time.unwrap_or_default() + 600.0;
    editor.harness.input_mut().time = Some(late);
    editor.settle();
    assert!(editor.has("Saved a.png"), "one long step");
    editor.harness.input_mut().time = None;
    editor.harness.hover_at(egui::pos2(300.0, 200.0));
    wait(&mut editor, 10);
    assert!(!editor.has("Saved a.png"));
}

#[test]
fn a_notice_that_is_dismissed_stays_in_the_messages() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Error, "a.skel:3:1: no such parent");
    editor.click("Dismiss: a.skel:3:1: no such parent");
    assert!(!editor.has("a.skel:3:1: no such parent"));
    assert!(!editor.has("Show messages"), "it was seen");
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
fn each_notice_has_a_time_of_its_own_and_a_warning_the_longer_one() {
    let mut editor = Editor::new();
    tell(&mut editor, Severity::Warning, "odd weights");
    wait(&mut editor, 3);
    tell(&mut editor, Severity::Info, "Imported a.dae");
    wait(&mut editor, 4);
    assert!(editor.has("odd weights") && editor.has("Imported a.dae"));
    wait(&mut editor, 2);
    assert!(editor.has("odd weights") && !editor.has("Imported a.dae"));
    wait(&mut editor, 4);
    assert!(!editor.has("odd weights"));
}
