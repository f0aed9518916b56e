//! Navigations: that of a document, that of the user, and keys of one that is not in use.

use super::Story;
use crate::host::MemoryHost;
use editor_core::editor::Severity;
use editor_core::program::StorageKey;
use editor_core::scene::{Look, ShapeKind};
use editor_core::ui::Navigation;
use egui::{Key, Modifiers};

const CTRL: Modifiers = Modifiers::COMMAND;

/// Moves the pointer onto a bone of the first character.
fn point_at_a_bone(story: &mut Story) {
    let evaluated = &story.session().evaluated().shapes[0];
    let shape = &story.session().scene().shapes()[0];
    let ShapeKind::Character(character) = &shape.kind else {
        panic!("{} is no character", shape.name);
    };
    let skeleton = character.character.skeleton();
    let joints = skeleton.update_current_joint_to_world_transforms(character.pose());
    let bones = character.character.bones().iter();
    let (start, end) = bones.filter_map(|bone| bone.ends(&joints)).next().unwrap();
    let middle = evaluated
        .world_from_model
        .transform_point3((start + end) / 2.0);
    let at = story.at(middle);
    story.point(at);
    story.settle();
}

#[test]
fn a_scene_of_the_mannequin_that_is_opened_by_name_has_its_bones_digits_and_arrows() {
    let mut story = Story::start(&["builtin:mannequin-1"]);
    assert_eq!(story.session().view().look, Look::Mannequin);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
    point_at_a_bone(&mut story);
    assert!(story.session().hovered_bone().is_some(), "no bone is lit");
    let before = story.session().view().camera;
    story.key(Key::ArrowUp);
    assert_ne!(story.session().view().camera, before, "arrows do nothing");
    let opened = story.session().opened();
    story.key(Key::Num2);
    assert_ne!(story.session().opened(), opened, "digits do nothing");
    let told = "Opened Mannequin 2: Chain in the place of mannequin-1";
    assert_eq!(story.messages(), [(Severity::Info, told)]);

    // What is opened afterwards is not navigated like that, since nobody has chosen it.
    story.host.drop_file("builtin:scenes/turned.scene");
    story.settle();
    assert_eq!(story.program.ui_mut().navigation, Navigation::Course);
    let stored = story.host.stored[&StorageKey::Preferences].clone();
    let stored: serde_json::Value = serde_json::from_slice(&stored).unwrap();
    assert_eq!(stored["navigation"], serde_json::Value::Null);
}

#[test]
fn a_model_that_is_opened_after_a_scene_of_the_mannequin_is_seen_and_held_as_in_it() {
    let mut story = Story::start(&["builtin:mannequin-1"]);
    story.key_with(CTRL, Key::O);
    story.choose("builtin:humanoid");
    assert_eq!(story.session().view().look, Look::Mannequin);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
    // A new document is nobody's.
    story.key_with(CTRL, Key::N);
    assert_eq!(story.session().view().look, Look::Studio);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Course);
}

#[test]
fn every_look_can_be_chosen_from_the_switch_of_looks() {
    let mut story = Story::start(&["builtin:mannequin-1"]);
    for (button, look) in [
        ("Studio look", Look::Studio),
        ("Course look", Look::Course),
        ("Mannequin look", Look::Mannequin),
    ] {
        story.click(button);
        assert_eq!(story.session().view().look, look);
    }
}

#[test]
fn the_hands_of_the_virtual_mannequin_go_with_its_look_unless_others_were_chosen() {
    let mut story = Story::start(&["builtin:humanoid"]);
    story.click("Mannequin look");
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
    point_at_a_bone(&mut story);
    assert!(story.session().hovered_bone().is_some(), "no bone is lit");
    story.click("Studio look");
    assert_eq!(story.program.ui_mut().navigation, Navigation::Course);
    // In a scene of the Mannequin they stay in every look.
    let mut story = Story::start(&["builtin:mannequin-1"]);
    story.click("Studio look");
    assert_eq!(story.program.ui_mut().navigation, Navigation::Mannequin);
    let stored = br#"{"started_before": true, "navigation": "orbit"}"#.to_vec();
    let host = MemoryHost {
        stored: [(StorageKey::Preferences, stored)].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &["builtin:humanoid"]);
    story.click("Mannequin look");
    assert_eq!(story.program.ui_mut().navigation, Navigation::Orbit);
}

#[test]
fn a_navigation_that_was_chosen_stays_and_tells_where_the_keys_of_the_mannequin_work() {
    let stored = br#"{"started_before": true, "navigation": "orbit"}"#.to_vec();
    let host = MemoryHost {
        stored: [(StorageKey::Preferences, stored)].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &["builtin:mannequin-1"]);
    assert_eq!(story.program.ui_mut().navigation, Navigation::Orbit);
    let opened = story.session().opened();
    for key in [Key::Num2, Key::ArrowUp] {
        story.key(key);
    }
    assert_eq!(story.session().opened(), opened);
    let told = story.messages();
    assert_eq!(told.len(), 1, "once is enough: {told:?}");
    assert!(
        told[0].1.ends_with("View ⏵ Navigation ⏵ Mannequin"),
        "{told:?}"
    );
    // Other scenes are not meant by these keys.
    let mut story = Story::start(&["builtin:robot"]);
    story.key(Key::Num2);
    assert!(story.messages().is_empty());
}
