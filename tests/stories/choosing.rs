//! Several files chosen together, as a page lets them be.

use super::Story;
use editor_core::editor::Severity;
use egui::{Key, Modifiers};

const CTRL: Modifiers = Modifiers::COMMAND;

/// An empty document, where files with a triangle and with nothing of use are.
fn with_files() -> Story {
    let mut story = Story::start(&[]);
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let files = [("flag.obj", triangle), ("torn.obj", "f 1 2 3\n")];
    let files = files.map(|(path, text)| (path.into(), text.into()));
    story.host.files.extend(files);
    story
}

#[test]
fn two_models_that_are_opened_together_are_both_there() {
    let mut story = with_files();
    story.key_with(CTRL, Key::O);
    let others = ["models/strip.skel", "models/strip.attach", "flag.obj"];
    story.host.choose_together("models/strip.obj", &others);
    story.settle();
    assert_eq!(story.names(), ["Strip", "Flag"]);
    assert!(story.messages().is_empty(), "{:?}", story.messages());
    assert!(story.host.title.contains("strip"), "{}", story.host.title);
    // The second is an import, which can be undone.
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Strip"]);
}

#[test]
fn a_scene_that_is_opened_with_a_model_has_it_added() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key_with(CTRL, Key::S);
    story.choose("models/one.scene");
    story.key_with(CTRL, Key::O);
    story
        .host
        .choose_together("models/one.scene", &["builtin:gem"]);
    story.settle();
    assert_eq!(story.names(), ["Strip", "Gem"]);
    assert!(story.program.is_modified());
}

#[test]
fn a_file_that_cannot_be_opened_leaves_its_place_to_the_next() {
    let mut story = with_files();
    story.key_with(Modifiers::SHIFT, Key::C);
    story.key_with(CTRL, Key::O);
    story.click("Don't Save");
    let others = ["models/strip.obj", "gone.obj", "flag.obj"];
    story.host.choose_together("torn.obj", &others);
    story.settle();
    assert_eq!(story.names(), ["Strip", "Flag"]);
    let told = story.messages();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told.iter()
            .all(|(severity, _)| *severity == Severity::Error)
    );
    assert!(told[0].1.starts_with("torn.obj") && told[1].1.starts_with("gone.obj"));
}

#[test]
fn nothing_is_added_where_unsaved_work_is_kept() {
    let mut story = with_files();
    story.key_with(CTRL, Key::O);
    // Something is begun while the dialog is open.
    story.key_with(Modifiers::SHIFT, Key::C);
    story
        .host
        .choose_together("models/strip.obj", &["flag.obj"]);
    story.settle();
    story.click("Cancel");
    assert_eq!(story.names(), ["Cube"]);
}

#[test]
fn all_shapes_that_are_chosen_together_are_imported() {
    let mut story = with_files();
    story.key_with(CTRL, Key::I);
    story
        .host
        .choose_together("flag.obj", &["models/strip.obj"]);
    story.settle();
    assert_eq!(story.names(), ["Flag", "Strip"]);
}

#[test]
fn what_is_chosen_beside_the_one_file_that_is_needed_is_told() {
    let mut story = Story::start(&["models/strip.obj"]);
    let pose = r#"{"joints": {"Elbow": [0, 0, 30]}}"#;
    for name in ["a.json", "b.json"] {
        story.host.files.insert(name.into(), pose.into());
    }
    story.click("Pose");
    story.click("Load Pose…");
    story.host.choose_together("a.json", &["b.json"]);
    story.settle();
    let told = story.messages();
    let told = told.iter().map(|(_, text)| *text);
    let told: Vec<&str> = told.filter(|text| text.contains("b.json")).collect();
    assert_eq!(told, ["Only a.json is used, not b.json"]);
}
