//! A host that has to bring some of the built-in files, as a page does.

use super::{Story, started_before};
use crate::host::MemoryHost;
use editor_core::io::Diagnostic;
use editor_core::program::StorageKey;
use editor_core::ui::{Action, Ask};
use egui::{Key, Modifiers};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// A story on a host without the robot and the dog.
fn without_some(files: &[&str]) -> Story {
    let absent = ["robot.obj", "robot.attach", "dog.obj", "dog.attach"];
    let absent = absent.map(|name| PathBuf::from(format!("builtin:characters/{name}")));
    let host = MemoryHost {
        absent: Arc::new(Mutex::new(absent.into())),
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    Story::start_at(host, files)
}

fn ask(story: &mut Story, ask: Ask) {
    story
        .program
        .carry_out(vec![Action::Ask(ask)], &mut story.host);
    story.settle();
}

fn bring(story: &mut Story) {
    story.host.answer_asked(Ok(()));
    story.settle();
}

#[test]
fn a_built_in_character_is_added_when_it_has_been_brought_with_all_its_files() {
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::InsertBuiltin("robot"));
    assert_eq!(story.names(), ["Gem"]);
    assert!(story.has("Fetching files"), "its progress is shown");
    assert_eq!(story.host.asked.len(), 2, "{:?}", story.host.asked);
    bring(&mut story);
    assert_eq!(story.names(), ["Gem", "Robot"]);
    assert!(!story.has("Fetching files"));
    assert!(story.messages().is_empty());
}

#[test]
fn a_built_in_scene_is_opened_when_its_characters_have_been_brought() {
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::OpenBuiltin("showcase"));
    assert_eq!(story.names(), ["Gem"]);
    assert_eq!(story.host.asked.len(), 4, "{:?}", story.host.asked);
    bring(&mut story);
    assert_eq!(story.names(), ["Robot", "Dog", "Plant", "Adult"]);
}

#[test]
fn a_character_that_cannot_be_brought_is_told_of_once_and_nothing_else_changes() {
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::InsertBuiltin("dog"));
    let error = Diagnostic::new(
        Path::new("builtin:characters/dog.obj"),
        "there is no network",
    );
    story.host.answer_asked(Err(error));
    story.settle();
    assert_eq!(story.names(), ["Gem"]);
    assert_eq!(story.messages().len(), 1);
    assert!(story.messages()[0].1.contains("there is no network"));
}

#[test]
fn what_is_cancelled_is_not_added_when_its_files_come_after_all() {
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::InsertBuiltin("dog"));
    story.click("Cancel");
    bring(&mut story);
    assert_eq!(story.names(), ["Gem"]);
}

#[test]
fn the_start_page_draws_its_pictures_as_their_files_come() {
    let mut story = without_some(&[]);
    assert!(!story.host.asked.is_empty());
    assert!(!story.has("Fetching files"), "nobody waits for them");
    for _ in 0..8 {
        bring(&mut story);
    }
    assert!(story.host.absent.lock().unwrap().is_empty());
}

fn no_network() -> Diagnostic {
    Diagnostic::new(
        Path::new("builtin:characters/robot.obj"),
        "there is no network",
    )
}

/// A story on a host that lacks the robot, with unsaved work of an earlier run that has one.
fn after_crash_with_robot() -> Story {
    let mut crashed = Story::start(&["builtin:robot"]);
    crashed.key_with(Modifiers::SHIFT, Key::C);
    crashed.wait(11.0);
    let host = MemoryHost {
        absent: without_some(&[]).host.absent,
        stored: crashed.host.stored,
        ..MemoryHost::default()
    };
    Story::start_at(host, &[])
}

#[test]
fn unsaved_work_whose_files_do_not_come_stays_and_is_offered_again() {
    let mut story = after_crash_with_robot();
    let kept = story.host.stored[&StorageKey::Autosave].clone();
    story.click("Restore");
    // Something else is done meanwhile, and the page is left.
    story.key_with(Modifiers::SHIFT, Key::S);
    story.wait(11.0);
    story.program.keep(&mut story.host);
    assert_eq!(story.host.stored[&StorageKey::Autosave], kept);
    story.host.answer_asked(Err(no_network()));
    story.settle();
    assert_eq!(story.host.stored[&StorageKey::Autosave], kept);
    story.click("Restore");
    story.click("Cancel");
    assert!(story.has("Restore"));
    story.click("Restore");
    bring(&mut story);
    assert_eq!(story.names(), ["Robot", "Cube"]);
}

#[test]
fn what_is_not_wanted_is_not_asked_about_again_when_the_files_have_come() {
    let mut story = without_some(&["builtin:gem"]);
    story.key_with(Modifiers::SHIFT, Key::C);
    ask(&mut story, Ask::OpenBuiltin("showcase"));
    story.click("Don't Save");
    bring(&mut story);
    assert_eq!(story.names(), ["Robot", "Dog", "Plant", "Adult"]);

    // What is changed while they come is.
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::OpenBuiltin("showcase"));
    story.key_with(Modifiers::SHIFT, Key::C);
    bring(&mut story);
    assert!(story.has("Don't Save"));
}

#[test]
fn a_file_that_cannot_be_had_does_not_stop_what_needs_others() {
    let mut story = without_some(&["builtin:gem"]);
    ask(&mut story, Ask::InsertBuiltin("robot"));
    ask(&mut story, Ask::InsertBuiltin("dog"));
    let robot = |path: &PathBuf| path.to_string_lossy().contains("robot");
    story
        .host
        .absent
        .lock()
        .unwrap()
        .retain(|path| !robot(path));
    story.host.answer_asked(Err(no_network()));
    story.settle();
    assert_eq!(story.names(), ["Gem", "Robot"]);
    assert_eq!(story.messages().len(), 1);
}
