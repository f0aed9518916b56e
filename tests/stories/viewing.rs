//! A scene without panels, as other pages show it.

use super::{Story, differing, started_before};
use crate::host::MemoryHost;
use editor_core::editor::Severity;
use editor_core::program::Options;
use egui::{Key, Modifiers};
use glam::Vec3;

/// A story in a page that shows a scene without panels.
fn without_panels(files: &[&str]) -> Story {
    let options = Options {
        is_viewer: true,
        ..Options::default()
    };
    let host = MemoryHost {
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    Story::start_with(host, options, files)
}

#[test]
fn a_scene_without_panels_can_be_turned_and_reset() {
    let mut story = without_panels(&["builtin:robot"]);
    assert!(!story.has("File") && !story.has("Joint Rotations (x, y, z)"));
    let before = story.session().view().camera;
    let corner = story.view().left_bottom() + egui::vec2(30.0, -30.0);
    story.drag(corner, corner + egui::vec2(90.0, 0.0));
    assert_ne!(story.session().view().camera, before);
    story.key_with(Modifiers::NONE, Key::Delete);
    assert_eq!(story.names(), ["Robot"], "keys mean nothing");
    story.click("Reset");
    assert_eq!(story.session().view().camera, before);
}

#[test]
fn a_bone_is_lit_under_the_pointer_before_anything_was_dragged() {
    let mut story = without_panels(&["models/strip.obj"]);
    let beside = story.view().left_bottom() + egui::vec2(30.0, -30.0);
    story.point(beside);
    story.settle();
    let before = story.picture();
    let bone = story.at(Vec3::new(0.0, 0.7, 0.0));
    story.point(bone);
    story.settle();
    assert!(differing(&before, &story.picture()) > 100);
}

#[test]
fn arrow_keys_roll_the_bone_under_the_pointer() {
    let mut story = without_panels(&["models/strip.obj"]);
    let document = story.session().document();
    story.key(Key::ArrowRight);
    assert_eq!(story.session().document(), document, "there is none");
    let bone = story.at(Vec3::new(0.0, 0.7, 0.0));
    story.point(bone);
    story.settle();
    story.key(Key::ArrowRight);
    assert_ne!(story.session().document(), document);
    story.key(Key::ArrowLeft);
    let session = story.session();
    let character = session.scene().character(session.scene().shapes()[0].id);
    let pose = character.expect("a character").pose();
    for joint in 0..3 {
        assert!(pose.rotation(joint).degrees().length() < 1e-3, "{joint}");
    }
}

#[test]
fn a_scene_without_panels_tells_what_is_wrong() {
    let mut story = without_panels(&["missing.obj"]);
    let told = "Dismiss: missing.obj: there is no such file";
    assert!(story.has(told));
    story.wait(3600.0);
    assert!(story.has(told), "nothing else says why it is empty");
    for text in ["a", "b", "c", "d"] {
        let messages = &mut story.program.session_mut().messages;
        messages.tell(Severity::Warning, text);
        story.settle();
    }
    assert!(story.has(told), "nor do newer messages take its place");
}

#[test]
fn nothing_takes_the_place_of_files_that_could_not_be_had() {
    let names = |asks_for_files| {
        let options = Options {
            asks_for_files,
            is_viewer: true,
            ..Options::default()
        };
        let story = Story::start_with(MemoryHost::default(), options, &[]);
        story.names().len()
    };
    assert_eq!(names(true), 0);
    assert_eq!(names(false), 4, "the showcase");
}
