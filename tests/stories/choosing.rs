//! Several files chosen together, as a page lets them be, and archives, which hold several.

use super::{STRIP, Story};
use editor_core::editor::Severity;
use editor_core::io::to_zip;
use egui::{Key, Modifiers};
use std::path::{Path, PathBuf};

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
    assert_eq!(story.session().messages.fresh().len(), 2, "both are shown");
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

/// Drops files on the window, at the same time.
fn drop_together(story: &mut Story, paths: &[&str]) {
    for path in paths {
        story.host.drop_file(path);
    }
    story.settle();
}

#[test]
fn an_archive_that_was_saved_with_its_files_is_opened_when_it_is_dropped() {
    let mut story = with_files();
    story.host.drop_file("flag.obj");
    story.settle();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/mine.zip");
    story.host.files.remove(Path::new("flag.obj"));
    story.key_with(CTRL, Key::N);
    assert!(story.names().is_empty());
    drop_together(&mut story, &["out/mine.zip"]);
    assert_eq!(story.names(), ["Flag"]);
    assert!(
        story.host.title.contains("mine.zip"),
        "{}",
        story.host.title
    );
    // A model beside it is added, as beside a scene.
    drop_together(&mut story, &["models/strip.obj", "out/mine.zip"]);
    assert_eq!(story.names(), ["Flag", "Strip"]);
    let errors = story.messages().into_iter();
    let errors: Vec<_> = errors
        .filter(|(severity, _)| *severity == Severity::Error)
        .collect();
    assert!(errors.is_empty(), "{errors:?}");
}

/// A document without shapes beside `course.zip` with the strip's three files and a flag, in which no scene is.
fn with_archive_of_models() -> Story {
    let mut story = with_files();
    let flag = story.host.files.remove(Path::new("flag.obj"));
    let mut entries: Vec<(PathBuf, Vec<u8>)> = vec![("flag.obj".into(), flag.unwrap())];
    for (path, text) in STRIP {
        story.host.files.remove(Path::new(path));
        entries.push((path.into(), text.into()));
    }
    let zip = to_zip(&entries).unwrap();
    story.host.files.insert("course.zip".into(), zip);
    story
}

#[test]
fn models_in_an_archive_are_opened_as_if_they_were_chosen_together() {
    let mut story = with_archive_of_models();
    story.key_with(CTRL, Key::O);
    story.choose("course.zip");
    assert_eq!(story.names(), ["Flag", "Strip"]);
    assert_eq!(story.messages(), []);
    assert!(story.host.title.contains("flag"), "{}", story.host.title);
    // The archive that was handed out is not written over.
    story.key_with(CTRL, Key::S);
    assert_eq!(story.host.requests.last().unwrap().name, "flag.scene");
    story.host.dialog_is_open = false;
    story.click("File");
    story.click("Open Recent");
    assert!(story.has("course.zip"), "all of them are opened again");
}

#[test]
fn models_in_an_archive_that_is_dropped_are_added() {
    let mut story = with_archive_of_models();
    story.key_with(Modifiers::SHIFT, Key::C);
    drop_together(&mut story, &["course.zip"]);
    assert_eq!(story.names(), ["Cube", "Flag", "Strip"]);
    assert_eq!(story.messages(), []);
    story.type_into("Elbow Z", "30");
    assert!((story.degrees("Elbow").z - 30.0).abs() < 1e-4);
}

/// What the panel says of a mesh without joints.
const WITHOUT_JOINTS: &str = "This mesh has no joints. Those of a character are in the .skel and .attach beside its .obj: \
                              Insert ⏵ Import ⏵ Import Character… brings them along.";

#[test]
fn a_mesh_without_joints_says_how_a_character_is_opened() {
    let mesh = Story::start(&["builtin:gear"]);
    assert!(mesh.has_text(WITHOUT_JOINTS));
    let character = Story::start(&["models/strip.obj"]);
    assert!(!character.has_text(WITHOUT_JOINTS));
}

#[test]
fn the_mesh_of_a_character_that_is_imported_as_a_shape_is_said_to_be_without_its_bones() {
    let mut story = Story::start(&[]);
    story.key_with(CTRL, Key::I);
    story.choose("models/strip.obj");
    assert_eq!(story.names(), ["Strip"]);
    let told = "models/strip.obj: expected a shape, found a character: its bones are left out. Insert ⏵ Import ⏵ \
                Import Character… brings them along";
    assert_eq!(story.messages(), [(Severity::Warning, told)]);
    assert!(story.has_text(WITHOUT_JOINTS));
}
