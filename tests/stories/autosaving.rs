//! Unsaved work that outlives a crash.

use super::Story;
use crate::host::MemoryHost;
use editor_core::editor::{Edit, Severity};
use editor_core::io::Diagnostic;
use editor_core::program::{HostEvent, NotStored, StorageKey};
use editor_core::ui::{Action, Navigation};
use egui::{Key, Modifiers, vec2};
use std::path::{Path, PathBuf};
use std::time::Duration;

const AUTOSAVE: StorageKey = StorageKey::Autosave;

/// What is stored for the case of a crash, if anything.
fn stored(story: &Story) -> Option<&Vec<u8>> {
    story.host.stored.get(&AUTOSAVE)
}

/// A program that starts where another ended without a word.
fn after_crash(crashed: Story) -> Story {
    let host = MemoryHost {
        files: crashed.host.files,
        stored: crashed.host.stored,
        ..MemoryHost::default()
    };
    Story::start_at(host, &[])
}

fn with_bent_elbow() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "90");
    story
}

#[test]
fn what_was_changed_in_an_archive_comes_back_as_that_of_the_archive() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("File");
    story.click("Save with Files…");
    story.choose("work/bent.zip");
    assert_eq!(story.host.title, "bent.zip — Editor");
    story.type_into("Elbow Z", "77");
    assert!(stored(&story).is_some());
    let mut story = after_crash(story);
    story.click("Restore");
    assert_eq!(story.host.title, "*bent.zip — Editor");
    assert!((story.degrees("Elbow").z - 77.0).abs() < 1e-3);
    story.key_with(Modifiers::COMMAND, Key::S);
    assert_eq!(story.host.title, "bent.zip — Editor");
    assert!(story.host.requests.is_empty(), "where to is known");
}

#[test]
fn work_is_kept_after_a_gesture_and_at_most_every_ten_seconds() {
    let mut story = Story::start(&["models/strip.obj"]);
    assert!(stored(&story).is_none(), "nothing was done");
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(40.0, 0.0));
    assert!(stored(&story).is_none(), "in the middle of a drag");
    story.button(false);
    story.settle();
    let first = stored(&story).expect("it is stored").clone();

    story.type_into("Elbow Z", "80");
    assert_eq!(stored(&story), Some(&first), "too soon");
    let wait = story.frame(Vec::new());
    let most = Duration::from_secs(10);
    assert!(wait > Duration::from_secs(5) && wait <= most, "{wait:?}");
    story.wait(10.1);
    assert_ne!(stored(&story), Some(&first));
}

#[test]
fn a_page_that_is_hidden_keeps_its_work_at_once_and_the_question_about_earlier_work_stays() {
    let mut story = with_bent_elbow();
    story.type_into("Elbow Z", "80");
    let before = stored(&story).cloned();
    story.program.keep(&mut story.host);
    assert_ne!(
        stored(&story).cloned(),
        before,
        "without waiting for ten seconds"
    );
    let mut story = after_crash(story);
    let left = stored(&story).cloned();
    story.program.keep(&mut story.host);
    assert_eq!(stored(&story).cloned(), left);
    story.click("Restore");
    assert_eq!(story.degrees("Elbow").z.round(), 80.0);
}

#[test]
fn what_a_crash_left_is_offered_and_restored() {
    let mut story = after_crash(with_bent_elbow());
    assert!(story.names().is_empty());
    story.click("Restore");
    assert_eq!(story.names(), ["Strip"]);
    assert!((story.degrees("Elbow").z - 90.0).abs() < 1e-4);
    assert_eq!(story.host.title, "*strip — Editor");
    assert!(stored(&story).is_some(), "it is still not saved");
    story.key_with(Modifiers::COMMAND, Key::S);
    story.choose("bent.scene");
    assert!(stored(&story).is_none());
    let again = after_crash(story);
    assert!(!again.has("Restore"));
}

#[test]
fn a_restored_scene_has_the_navigation_of_its_look() {
    // Nobody has chosen the look, which would be that of the next start then.
    let mut story = Story::start(&["builtin:mannequin-5"]);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
    let hide = Edit::SetVisible(story.shape().id, false);
    story
        .program
        .carry_out(vec![Action::Edit(hide)], &mut story.host);
    story.wait(11.0);
    let mut story = after_crash(story);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Course);
    story.click("Restore");
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
}

#[test]
fn esc_puts_the_offer_to_restore_off() {
    let mut story = after_crash(with_bent_elbow());
    let beside = story.place("Restore") - vec2(0.0, 200.0);
    story.click_at(beside);
    assert!(story.has("Restore"), "a click beside it does not");
    story.key(Key::Escape);
    assert!(!story.has("Restore") && story.names().is_empty());
    assert_eq!(story.host.left.len(), 1, "it waits for the next start");
    assert!(!story.host.quits);
}

#[test]
fn a_saved_document_that_was_changed_is_restored_with_its_file() {
    let mut story = with_bent_elbow();
    story.key_with(Modifiers::COMMAND, Key::S);
    story.choose("work/bent.scene");
    story.type_into("Elbow Z", "45");
    story.wait(11.0);
    let mut story = after_crash(story);
    story.click("Restore");
    assert_eq!(story.host.title, "*bent.scene — Editor");
    assert!((story.degrees("Elbow").z - 45.0).abs() < 1e-4);
    story.key_with(Modifiers::COMMAND, Key::S);
    assert!(!story.has("Overwrite"), "nobody else has written it");
    assert_eq!(story.host.title, "bent.scene — Editor");

    // Had someone else written the file meanwhile, that would not be lost.
    story.type_into("Elbow Z", "30");
    story.wait(11.0);
    let theirs = br#"{"format": "editor-scene", "version": 1}"#.to_vec();
    story.host.files.insert("work/bent.scene".into(), theirs);
    let mut story = after_crash(story);
    story.click("Restore");
    story.key_with(Modifiers::COMMAND, Key::S);
    assert!(story.has("Overwrite"));
}

#[test]
fn what_is_discarded_or_not_saved_on_purpose_is_not_offered_again() {
    let mut story = after_crash(with_bent_elbow());
    story.click("Discard");
    assert!(story.names().is_empty() && stored(&story).is_none());

    let mut story = with_bent_elbow();
    assert!(stored(&story).is_some());
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    story.click("Don't Save");
    assert!(story.host.quits && stored(&story).is_none());

    let mut story = with_bent_elbow();
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert!(stored(&story).is_none(), "all was taken back");
}

#[test]
fn the_question_says_when_the_work_was_kept() {
    let crashed = with_bent_elbow();
    let host = MemoryHost {
        stored: crashed.host.stored,
        stored_since: Some(Duration::from_secs(200)),
        ..MemoryHost::default()
    };
    let story = Story::start_at(host, &[]);
    let text = "The editor ended before changes to strip were saved. \
                The changes were kept 3 minutes ago.";
    assert!(story.has_text(text));
}

#[test]
fn later_keeps_the_work_for_the_next_start_and_this_one_begins_empty() {
    let mut story = after_crash(with_bent_elbow());
    let kept = stored(&story).expect("unsaved work").clone();
    story.click("Later");
    assert!(story.names().is_empty() && !story.has("Restore"));
    assert_eq!(story.host.left, std::slice::from_ref(&kept));
    // What is done now is kept elsewhere.
    story.key_with(Modifiers::SHIFT, Key::C);
    assert_ne!(stored(&story), Some(&kept));
    assert_eq!(story.host.left, [kept]);
}

#[test]
fn the_work_of_several_earlier_runs_is_offered_one_after_the_other() {
    let mut story = with_bent_elbow();
    story.type_into("Elbow Z", "45");
    story.wait(11.0);
    let second = stored(&story).expect("unsaved work").clone();
    let mut story = after_crash(with_bent_elbow());
    story.host.more = [second.clone(), second.clone()].into();
    story.click("Later");
    story.click("Discard");
    story.click("Restore");
    assert!((story.degrees("Elbow").z - 45.0).abs() < 1e-4);
    assert!(!story.has("Restore"));
    assert_eq!(
        story.host.left.len(),
        1,
        "the first waits for the next start"
    );
}

#[test]
fn a_name_that_is_being_typed_when_a_signal_comes_is_kept() {
    let mut story = with_bent_elbow();
    story.click("Edit");
    story.click("Rename");
    story.frame(vec![egui::Event::Text("Arm".to_owned())]);
    story.program.prepare_to_end();
    story.frame(Vec::new());
    story.program.end(&mut story.host);
    let mut story = after_crash(story);
    story.click("Restore");
    assert_eq!(story.names(), ["Arm"]);
}

#[test]
fn the_question_cannot_be_passed_over() {
    let mut story = after_crash(with_bent_elbow());
    story.wait(2.0);
    story.key_with(Modifiers::SHIFT, Key::C);
    story.host.drop_file("models/strip.obj");
    story.settle();
    assert!(story.has("Restore") && story.names().is_empty() && !story.host.quits);
    assert!(stored(&story).is_some());
    let text = "Nothing was dropped: the question comes first";
    assert_eq!(story.messages(), [(Severity::Warning, text)]);
}

#[test]
fn a_signal_keeps_unsaved_work_and_ends_the_program() {
    let mut story = with_bent_elbow();
    let first = stored(&story).expect("it is stored").clone();
    story.type_into("Elbow Z", "80");
    let field = story.place("Hip X");
    story.press_and_drag(field, field + vec2(40.0, 0.0));
    story.program.end(&mut story.host);
    assert!(story.host.quits);
    assert_ne!(stored(&story), Some(&first), "ten seconds or not");
    let mut story = after_crash(story);
    story.click("Restore");
    assert!((story.degrees("Elbow").z - 80.0).abs() < 1e-4);
    assert!(
        (story.degrees("Hip").x - 40.0).abs() < 1e-4,
        "what was dragged, too"
    );

    let mut saved = Story::start(&["models/strip.obj"]);
    saved.program.end(&mut saved.host);
    assert!(saved.host.quits && stored(&saved).is_none());
}

fn not_stored(kept_in: Option<&str>) -> HostEvent {
    HostEvent::StoreFailed(NotStored {
        error: Diagnostic::new(Path::new("autosave.json"), "the disk is full"),
        kept_in: kept_in.map(PathBuf::from),
    })
}

#[test]
fn what_is_kept_in_another_place_is_said_with_the_place() {
    let mut story = with_bent_elbow();
    let spare = Some("/run/autosave.json");
    story.host.events.push_back(not_stored(spare));
    story.settle();
    let [(Severity::Warning, text)] = story.messages()[..] else {
        panic!("{:?}", story.messages());
    };
    assert!(text.contains("in /run/autosave.json only"), "{text}");
    assert!(text.ends_with("autosave.json: the disk is full"), "{text}");
}

#[test]
fn what_cannot_be_kept_is_said_once() {
    let mut story = with_bent_elbow();
    for _ in 0..2 {
        story.host.events.push_back(not_stored(None));
        story.settle();
    }
    let text = "Unsaved work cannot be kept for the case of a crash: \
                autosave.json: the disk is full";
    assert_eq!(story.messages(), [(Severity::Warning, text)]);
}

#[test]
fn what_could_not_be_kept_is_tried_again() {
    let mut story = with_bent_elbow();
    story.wait(1.0);
    story.host.stored.remove(&AUTOSAVE);
    story.host.events.push_back(not_stored(None));
    story.settle();
    assert!(stored(&story).is_none(), "not at once");
    story.wait(11.0);
    assert!(stored(&story).is_some());
}

#[test]
fn what_cannot_be_restored_is_said() {
    let kept = br#"{"path": null, "digest": null, "scene": "{"}"#.to_vec();
    let host = MemoryHost {
        stored: [super::started_before(), (AUTOSAVE, kept)].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &[]);
    story.click("Restore");
    let (severity, text) = story.messages()[0];
    assert_eq!(severity, Severity::Error);
    let start = "The unsaved changes cannot be restored: restored.scene:1:";
    assert!(text.starts_with(start), "{text}");
    assert!(
        stored(&story).is_none(),
        "it is put aside before other work is stored"
    );

    let host = MemoryHost {
        stored: [super::started_before(), (AUTOSAVE, b"{".to_vec())].into(),
        ..MemoryHost::default()
    };
    let story = Story::start_at(host, &[]);
    let (severity, text) = story.messages()[0];
    assert_eq!(severity, Severity::Error);
    assert!(
        text.starts_with("The unsaved changes cannot be restored: "),
        "{text}"
    );
    assert!(!story.has("Restore") && stored(&story).is_none());
}

#[test]
fn work_is_kept_in_the_middle_of_a_drag_that_does_not_end() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Y", "20");
    story.wait(11.0);
    assert!(keeps(&story, "20"));
    story.type_into("Hip Y", "33");
    let field = story.place("Elbow Y");
    story.press_and_drag(field, field + egui::vec2(45.0, 0.0));
    assert!(story.session().is_in_gesture());
    story.wait(31.0);
    assert!(story.session().is_in_gesture());
    assert!(keeps(&story, "33"));
}

/// Whether the unsaved work that is kept has `number` in it.
fn keeps(story: &Story, number: &str) -> bool {
    stored(story).is_some_and(|bytes| String::from_utf8_lossy(bytes).contains(number))
}
