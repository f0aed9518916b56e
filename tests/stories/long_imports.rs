//! Files whose reading takes its time: the program goes on meanwhile.

use super::{Story, started_before};
use crate::host::MemoryHost;
use editor_core::editor::{Edit, Severity};
use editor_core::program::{HostEvent, RunningJob};
use editor_core::scene::{Look, NewShape, ShapeKind};
use editor_core::ui::{Action, Ask};
use egui::{Key, Modifiers};
use std::fmt::Write;

/// An `.obj` file of some hundred kilobytes: a strip of triangles.
fn large() -> Vec<u8> {
    let mut text = String::new();
    for row in 0..5000 {
        let _ = writeln!(text, "v 0 {row} 0.25\nv 1 {row} 0.25");
    }
    for first in 1..9998 {
        let _ = writeln!(text, "f {first} {} {}", first + 1, first + 2);
    }
    text.into_bytes()
}

/// A scene with the large shape and a gem.
const SCENE: &str = r#"{"format": "editor-scene", "version": 1, "shapes": [
    {"source": "large.obj"}, {"source": "builtin:gem"}]}"#;

/// A story at a place where reading takes longer than anybody would wait.
fn slow(files: &[&str]) -> Story {
    let host = MemoryHost {
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, files);
    let more = [
        ("large.obj", large()),
        (
            "small.obj",
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(),
        ),
        ("broken.obj", b"v 0 0 0\nf 1 1 2\n".to_vec()),
        ("two.scene", SCENE.into()),
    ];
    let more = more.map(|(path, bytes)| (path.into(), bytes));
    story.host.files.extend(more);
    story.host.is_slow = true;
    story
}

/// Drops a file, and lets more time pass than it takes for progress to be shown.
fn drop_and_wait(story: &mut Story, path: &str) {
    story.host.drop_file(path);
    story.settle();
    story.wait(0.2);
}

fn finish(story: &mut Story) {
    while story.host.run_jobs() > 0 {
        story.settle();
    }
}

/// Begins the job that the program has started.
fn begin(story: &mut Story) -> RunningJob {
    story.host.jobs.pop().expect("a job was started").begin()
}

fn rotate_elbow(story: &mut Story, degrees: &str) {
    story.type_into("Elbow Z", degrees);
}

fn ask(story: &mut Story, ask: Ask) {
    let ask = vec![Action::Ask(ask)];
    story.program.carry_out(ask, &mut story.host);
    story.settle();
}

#[test]
fn a_long_import_shows_how_far_it_is_and_everything_else_goes_on() {
    let mut story = slow(&["models/strip.obj"]);
    story.host.drop_file("large.obj");
    story.settle();
    assert!(
        !story.has("Importing large.obj"),
        "a short one shows nothing"
    );
    story.wait(0.2);
    assert!(story.has("Importing large.obj"));
    assert_eq!(story.names(), ["Strip"]);

    let mut job = begin(&mut story);
    let mut told = Vec::new();
    let result = loop {
        if let Some(result) = job.step() {
            break result;
        }
        story.wait(0.2);
        let bar = story
            .node("Importing large.obj")
            .and_then(|bar| bar.numeric_value());
        told.push(bar.expect("the bar has a value"));
    };
    assert!(told.len() > 4 && told.is_sorted(), "{told:?}");
    assert!(told.first() < told.last(), "{told:?}");

    rotate_elbow(&mut story, "30");
    story.key_with(Modifiers::COMMAND, Key::S);
    story.choose("mine.scene");
    assert!(story.host.text("mine.scene").contains("30"));
    let steps = story.session().done_steps();

    story.host.events.push_back(HostEvent::Finished(result));
    story.settle();
    assert_eq!(story.names(), ["Strip", "Large"]);
    assert!(!story.has("Importing large.obj"));
    assert_eq!(story.session().done_steps(), steps + 1, "one step");
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(story.names(), ["Strip"]);
    assert_eq!(story.degrees("Elbow").z, 30.0);
}

#[test]
fn a_long_import_is_cancelled_by_its_button_or_esc_and_leaves_nothing() {
    for by_key in [false, true] {
        let mut story = slow(&["models/strip.obj"]);
        let selected = story.session().selected();
        drop_and_wait(&mut story, "large.obj");
        let mut job = begin(&mut story);
        assert!(job.step().is_none());
        if by_key {
            story.key(Key::Escape);
        } else {
            story.click("Cancel");
        }
        assert!(!story.has("Importing large.obj"));
        let told = "Cancelled: large.obj is not imported";
        assert_eq!(story.messages(), [(Severity::Info, told)]);
        let result = job.step().expect("it ends at its next step");
        story.host.events.push_back(HostEvent::Finished(result));
        story.settle();
        assert_eq!(story.names(), ["Strip"]);
        assert!(!story.program.is_modified() && !story.host.quits);
        assert_eq!(story.session().selected(), selected, "Esc did nothing else");
    }
}

#[test]
fn files_are_imported_one_after_the_other_and_a_broken_one_is_told_of() {
    let mut story = slow(&["models/strip.obj"]);
    for path in ["large.obj", "broken.obj", "small.obj"] {
        story.host.drop_file(path);
    }
    story.settle();
    story.wait(0.2);
    assert!(story.has("Importing large.obj, then 2 more"));
    finish(&mut story);
    assert_eq!(story.names(), ["Strip", "Large", "Small"]);
    let error = "broken.obj:2:7: expected a vertex from 1 to 1, found 2";
    let unused = "large.obj: 1 of its 10000 vertices is in no face, and left out";
    let told = [(Severity::Warning, unused), (Severity::Error, error)];
    assert_eq!(story.messages(), told);
}

#[test]
fn what_is_undone_meanwhile_stays_undone_and_the_import_is_a_step_of_its_own() {
    let mut story = slow(&["models/strip.obj"]);
    rotate_elbow(&mut story, "30");
    drop_and_wait(&mut story, "large.obj");
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(story.degrees("Elbow").z, 0.0);
    finish(&mut story);
    assert_eq!(story.names(), ["Strip", "Large"]);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(story.names(), ["Strip"]);
    assert_eq!(story.degrees("Elbow").z, 0.0);
}

#[test]
fn an_import_that_ends_in_the_middle_of_a_drag_waits_for_its_end() {
    let mut story = slow(&["models/strip.obj"]);
    drop_and_wait(&mut story, "large.obj");
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + egui::vec2(40.0, 0.0));
    finish(&mut story);
    assert_eq!(story.names(), ["Strip"]);
    assert!(story.session().is_in_gesture(), "the drag goes on");
    story.button(false);
    story.settle();
    assert_eq!(story.names(), ["Strip", "Large"]);
}

#[test]
fn a_new_document_and_another_that_is_opened_end_the_import_without_a_question() {
    for end in [Ask::New, Ask::OpenBuiltin("gem"), Ask::Quit] {
        let mut story = slow(&["models/strip.obj"]);
        drop_and_wait(&mut story, "large.obj");
        let quits = matches!(end, Ask::Quit);
        ask(&mut story, end);
        assert!(!story.has("Save"), "nothing is asked");
        finish(&mut story);
        assert!(!story.names().contains(&"Large"));
        assert_eq!(story.host.quits, quits);
    }
}

#[test]
fn a_scene_with_a_large_file_opens_as_a_whole_while_the_one_before_is_shown() {
    let mut story = slow(&["models/strip.obj"]);
    drop_and_wait(&mut story, "two.scene");
    assert!(story.has("Opening two.scene"));
    assert_eq!(story.names(), ["Strip"]);
    finish(&mut story);
    assert_eq!(story.names(), ["Large", "Gem"]);
    assert_eq!(story.host.title, "two.scene — Editor");
}

#[test]
fn what_is_changed_while_another_document_is_read_is_asked_about_before_it_is_shown() {
    let mut story = slow(&["models/strip.obj"]);
    drop_and_wait(&mut story, "two.scene");
    rotate_elbow(&mut story, "30");
    finish(&mut story);
    assert_eq!(story.degrees("Elbow").z, 30.0);
    assert!(story.has("Don't Save"), "the changes are asked about");
    story.click("Don't Save");
    assert_eq!(story.names(), ["Large", "Gem"]);
}

fn started_with_a_large_file() -> Story {
    let host = MemoryHost {
        stored: [started_before()].into(),
        files: [("large.obj".into(), large())].into(),
        is_slow: true,
        ..MemoryHost::default()
    };
    Story::start_at(host, &["large.obj"])
}

#[test]
fn what_the_program_is_started_with_comes_later_if_it_is_large() {
    let mut story = started_with_a_large_file();
    assert!(
        !story.has("Begin: Adult"),
        "there is no start page for a moment"
    );
    assert_eq!(story.session().view().look, Look::Studio);
    story.wait(0.2);
    assert!(story.has("Opening large.obj"));
    finish(&mut story);
    assert_eq!(story.names(), ["Large"]);
    assert!(!story.program.is_modified());
}

#[test]
fn what_is_begun_while_the_first_file_is_read_stays_beside_it() {
    let mut story = started_with_a_large_file();
    let cube = NewShape::new("Cube", ShapeKind::Cube);
    let insert = vec![Action::Edit(Edit::Insert(vec![cube]))];
    story.program.carry_out(insert, &mut story.host);
    finish(&mut story);
    assert_eq!(story.names(), ["Cube", "Large"]);
}

#[test]
fn unsaved_work_whose_reading_is_cancelled_is_offered_again() {
    let mut story = slow(&["models/strip.obj"]);
    rotate_elbow(&mut story, "30");
    story.wait(200.0);
    let mut host = MemoryHost {
        stored: std::mem::take(&mut story.host.stored),
        is_slow: true,
        ..MemoryHost::default()
    };
    host.files.extend(std::mem::take(&mut story.host.files));
    let mut story = Story::start_at(host, &[]);
    story.click("Restore");
    story.wait(0.2);
    story.click("Cancel");
    assert!(story.has("Restore"), "it is offered again");
    story.click("Restore");
    finish(&mut story);
    assert_eq!(story.names(), ["Strip"]);
    assert_eq!(story.degrees("Elbow").z, 30.0);
}
