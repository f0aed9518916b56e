//! What the program tells, over the view and in the history.

use crate::interface::Editor;
use editor_core::editor::{Message, Severity};
use egui::Key;
use egui_kittest::kittest::Queryable;

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
fn a_click_on_a_notice_or_on_the_help_for_newcomers_is_none_in_the_view_below() {
    let mut editor = Editor::with_figure();
    let selected = editor.session().selected();
    assert!(selected.is_some());
    let camera = editor.session().view().camera;
    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    let check = "View ⏵ Compare with Mesh… tells what is wrong in yours";
    let at = editor.harness.get_by_label(check).rect().center();
    editor.click_at(at);
    assert!(editor.has(check), "only its cross hides it");
    editor.hand(at, at + egui::vec2(40.0, -20.0));
    let text = "a.skel:3:1: no such parent";
    tell(&mut editor, Severity::Error, text);
    let at = editor.harness.get_by_label(text).rect().center();
    editor.click_at(at);
    assert_eq!(editor.session().selected(), selected);
    assert_eq!(editor.session().view().camera, camera);
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
fn what_is_told_again_is_shown_once_and_as_the_newest() {
    let mut editor = Editor::new();
    for text in ["no faces in a.obj", "second", "no faces in a.obj", "fourth"] {
        tell(&mut editor, Severity::Warning, text);
    }
    let messages = &editor.session().messages;
    let texts = |all: &[Message]| all.iter().map(|told| told.text.clone()).collect::<Vec<_>>();
    assert_eq!(
        texts(messages.fresh()),
        ["second", "no faces in a.obj", "fourth"]
    );
    assert_eq!(messages.history().len(), 4);
    tell(&mut editor, Severity::Error, "fourth");
    let fresh = editor.session().messages.fresh();
    assert_eq!(
        texts(&fresh[fresh.len() - 2..]),
        ["fourth", "fourth"],
        "it is worse"
    );
}

#[test]
fn the_newest_three_messages_are_shown_and_no_older_one_takes_the_place_of_one_that_went() {
    let mut editor = Editor::new();
    for text in ["first", "second", "third", "fourth", "fifth"] {
        tell(&mut editor, Severity::Error, text);
    }
    let shown = |editor: &Editor| {
        let all = ["first", "second", "third", "fourth", "fifth"];
        all.map(|text| editor.has(text))
    };
    assert_eq!(shown(&editor), [false, false, true, true, true]);
    editor.click("Dismiss: fourth");
    assert_eq!(shown(&editor), [false, false, true, false, true]);
    editor.harness.hover_at(egui::pos2(300.0, 200.0));
    wait(&mut editor, 21);
    assert_eq!(shown(&editor), [false; 5]);
    editor.click("Show messages");
    assert_eq!(shown(&editor), [true; 5], "all are in the messages");
}

#[test]
fn what_succeeds_after_many_errors_stands_with_the_last_two_and_then_alone() {
    let mut editor = Editor::new();
    for file in 1..=6 {
        tell(
            &mut editor,
            Severity::Error,
            &format!("{file}.obj: no faces"),
        );
    }
    wait(&mut editor, 15);
    tell(&mut editor, Severity::Info, "Imported cup.obj");
    assert!(!editor.has("4.obj: no faces") && editor.has("5.obj: no faces"));
    wait(&mut editor, 4);
    assert!(editor.has("Imported cup.obj"));
    for file in 1..=6 {
        assert!(!editor.has(&format!("{file}.obj: no faces")), "{file}");
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
