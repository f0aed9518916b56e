//! Importing a character and posing it, by sliders and by hand.

use super::{Story, differing};
use crate::collada::support::{instance, static_document, triangle};
use editor_core::editor::{Severity, View};
use editor_core::program::{Purpose, StorageKey};
use editor_core::scene::SkinningMethod;
use editor_core::scene::bones_in_world;
use editor_core::ui::Navigation;
use egui::{Key, Modifiers, Pos2, pos2, vec2};
use glam::Vec3;

/// Where the end of the bone of `joint` of the selected character is in the window.
fn end_of_bone(story: &Story, joint: usize) -> Pos2 {
    let session = story.session();
    let shape = session.evaluated().shape(story.shape().id).unwrap();
    let mut bones = bones_in_world(session.scene(), shape);
    let (.., end) = bones.find(|bone| bone.0 == joint).expect("a bone");
    story.at(end)
}

#[test]
fn a_character_is_skinned_with_dual_quaternions_until_it_is_undone() {
    let mut story = Story::start(&["models/strip.obj"]);
    let method = |story: &Story| {
        let shape = &story.session().scene().shapes()[0];
        let editor_core::scene::ShapeKind::Character(character) = &shape.kind else {
            panic!("expected a character");
        };
        character.skinning_method()
    };
    assert_eq!(method(&story), SkinningMethod::LinearBlend);
    story.click("Skinning");
    story.click("Dual Quaternion");
    assert_eq!(method(&story), SkinningMethod::DualQuaternion);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(method(&story), SkinningMethod::LinearBlend);
}

#[test]
fn a_character_is_imported_posed_by_a_slider_and_the_mesh_follows() {
    let mut story = Story::start(&[]);
    let empty = story.scene_picture();
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::I);
    let request = story.host.requests.last().unwrap().clone();
    assert_eq!(
        (request.purpose, request.folder),
        (Purpose::ImportCharacter, None)
    );
    story.choose("models/strip.obj");
    assert_eq!(story.names(), ["Strip"]);
    let imported = story.scene_picture();
    assert!(differing(&empty, &imported) > 500);

    let field = story.place("Elbow Z");
    story.drag(field, field + vec2(90.0, 0.0));
    assert_eq!(story.degrees("Elbow"), Vec3::new(0.0, 0.0, 90.0));
    // The upper edge, held by the elbow alone, is turned by 90° about (0, 1, 0).
    let shape = story.session().evaluated().shape(story.shape().id).unwrap();
    let corner = shape.geometry.positions()[4];
    assert!(
        corner.abs_diff_eq(Vec3::new(-1.0, 1.2, 0.0), 1e-5),
        "{corner}"
    );
    assert!(differing(&imported, &story.scene_picture()) > 500);

    // The folder of the chosen file is where the next dialog opens.
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::I);
    let folder = story.host.requests.last().unwrap().folder.clone();
    assert_eq!(folder, Some("models".into()));
    let kept = &story.host.stored[&StorageKey::Preferences];
    let kept: serde_json::Value = serde_json::from_slice(kept).unwrap();
    assert_eq!(kept["last_folder"], "models", "at the next start, too");
}

#[test]
fn one_broken_file_is_one_message_and_the_scene_stays_as_it_is() {
    let mut story = Story::start(&["models/strip.obj"]);
    let document = story.session().document();
    let broken = b"v 0 0 0\nf 1 2 3\n".to_vec();
    story.host.files.insert("broken.obj".into(), broken);
    story.host.drop_file("broken.obj");
    story.settle();
    let [(Severity::Error, message)] = story.messages()[..] else {
        panic!("{:?}", story.messages());
    };
    assert!(message.starts_with("broken.obj:2:5: expected"), "{message}");
    assert_eq!(story.names(), ["Strip"]);
    assert_eq!(story.session().document(), document);
}

#[test]
fn a_file_with_several_shapes_brings_in_all_of_them_and_selects_the_last() {
    let mut story = Story::start(&["builtin:gem"]);
    let other = format!("<node name=\"M\">{}</node></visual_scene>", instance("g"));
    let both = static_document(&triangle("g")).replace("</visual_scene>", &other);
    story.host.files.insert("two.dae".into(), both.into_bytes());
    story.host.drop_file("two.dae");
    story.settle();
    assert_eq!(story.names(), ["Gem", "Two N", "Two M"]);
    assert_eq!(story.shape().name, "Two M");
    assert_eq!(story.messages(), []);
}

#[test]
fn dragging_one_angle_leaves_the_others_exactly_as_they_were_given() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Y", "-30");
    let given = story.character().pose().rotation(2).radians.y;
    assert_eq!(given, -30.0_f32.to_radians());
    let field = story.place("Elbow X");
    story.drag(field, field + vec2(12.0, 0.0));
    let angles = story.character().pose().rotation(2).radians;
    assert_eq!(angles.y, given);
    assert_eq!(angles.x, 12.0_f32.to_radians());
    // Past the end of the circle an angle goes on.
    let field = story.place("Elbow Y");
    story.drag(field, field + vec2(-10.0, 0.0));
    assert!((story.degrees("Elbow").y + 40.0).abs() < 1e-4);
    story.click("Pose");
    story.click("Save Pose…");
    story.choose("bent.json");
    let text = story.host.text("bent.json");
    assert!(text.contains("\"Elbow\": [12, -40, 0]"), "{text}");
}

#[test]
fn a_slider_that_is_cancelled_puts_everything_back_as_if_it_had_not_been_touched() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Y", "330");
    let (document, pose) = (story.session().document(), story.character().pose().clone());
    let field = story.place("Elbow Y");
    story.press_and_drag(field, field + vec2(45.0, 0.0));
    assert!(story.session().is_in_gesture());
    assert_ne!(story.character().pose(), &pose);
    story.key(Key::Escape);
    assert!(!story.session().is_in_gesture() && !story.host.quits);
    assert_eq!(story.character().pose(), &pose);
    assert_eq!(story.session().document(), document);
    story.button(false);
    story.settle();
    assert_eq!(story.character().pose(), &pose);
}

#[test]
fn a_bone_is_dragged_by_hand_and_the_gesture_is_kept_or_cancelled() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F);
    story.key(Key::B);
    let (document, before) = (story.session().document(), story.scene_picture());
    let tip = end_of_bone(&story, 2) + vec2(0.0, 6.0);
    story.press_and_drag(tip, tip + vec2(80.0, 40.0));
    assert!(story.session().is_in_gesture());
    assert!(story.degrees("Elbow").length() > 20.0);
    story.key(Key::Escape);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    assert_eq!(story.session().document(), document);
    story.button(false);
    story.point(pos2(5.0, 300.0));
    story.settle();

    story.drag(tip, tip + vec2(80.0, 40.0));
    assert!(!story.session().is_in_gesture());
    assert!(story.degrees("Elbow").length() > 20.0);
    assert_eq!(story.degrees("Root"), Vec3::ZERO);
    assert_ne!(story.session().document(), document);
    assert!(differing(&before, &story.scene_picture()) > 500);
}

#[test]
fn a_built_in_pose_is_chosen_from_those_of_the_character() {
    let mut story = Story::start(&["builtin:robot"]);
    story.click("Pose");
    story.click("Built-in Pose");
    assert!(!story.has("Wave"), "it is one of the adult");
    story.click("Greet");
    assert!(!story.character().pose().is_bind());
    assert_eq!(story.messages(), []);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert!(story.character().pose().is_bind());
}

#[test]
fn a_pose_goes_over_the_clipboard_from_one_character_to_another() {
    let mut story = Story::start(&["models/strip.obj", "models/strip.obj"]);
    story.type_into("Elbow Z", "45/2");
    story.key(Key::B);
    story.key_with(Modifiers::COMMAND, Key::C);
    let copied: serde_json::Value = serde_json::from_str(&story.host.clipboard).unwrap();
    assert_eq!(copied["joints"]["Elbow"][2], 22.5);

    let first = story.session().scene().shapes()[0].id;
    let second = story.shape().id;
    story
        .program
        .session_mut()
        .look(editor_core::editor::View::Select(Some(first)));
    story.settle();
    story.key_with(Modifiers::COMMAND, Key::V);
    assert_eq!(story.shape().id, first);
    assert_eq!(story.degrees("Elbow"), Vec3::new(0.0, 0.0, 22.5));
    assert_ne!(first, second);

    for (clipboard, severity, told) in [
        (
            "{\"joints\": 3}",
            Severity::Error,
            "clipboard:1:12: expected",
        ),
        (
            "no pose",
            Severity::Warning,
            "There are no shapes and no pose",
        ),
    ] {
        story.host.clipboard = clipboard.into();
        story.key_with(Modifiers::COMMAND, Key::V);
        let (said, text) = *story.messages().last().unwrap();
        assert_eq!(said, severity);
        assert!(text.starts_with(told), "{text}");
        assert_eq!(story.degrees("Elbow"), Vec3::new(0.0, 0.0, 22.5));
    }
}

#[test]
fn deleting_a_shape_selects_the_one_that_takes_its_place() {
    let mut story = Story::start(&["models/strip.obj", "builtin:gem", "builtin:gear"]);
    let gem = story.session().scene().shapes()[1].id;
    story
        .program
        .session_mut()
        .look(editor_core::editor::View::Select(Some(gem)));
    story.settle();
    story.key(Key::Delete);
    assert_eq!(story.names(), ["Strip", "Gear"]);
    assert_eq!(story.shape().name, "Gear");
    story.key(Key::Delete);
    assert_eq!(story.shape().name, "Strip");
    story.key(Key::Delete);
    assert_eq!(story.session().selected(), None);
}

#[test]
fn hovering_changes_what_is_marked_and_not_the_document() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F);
    story.key(Key::B);
    let document = story.session().document();
    story.point(end_of_bone(&story, 2));
    story.settle();
    assert_eq!(story.session().hovered_joint(), Some(2));
    assert_eq!(story.session().document(), document);
    assert_eq!(story.host.cursor, Some(egui::CursorIcon::Grab));
    story.point(pos2(5.0, 300.0));
    story.settle();
    assert_eq!(story.session().hovered_joint(), None);
    assert_eq!(story.host.cursor, Some(egui::CursorIcon::Default));
}

/// The right arrow key, as it goes down, repeats or goes up.
fn right(pressed: bool, repeat: bool) -> egui::Event {
    egui::Event::Key {
        key: Key::ArrowRight,
        physical_key: None,
        pressed,
        repeat,
        modifiers: egui::Modifiers::NONE,
    }
}

#[test]
fn a_held_key_that_turns_the_camera_rolls_no_bone_that_comes_below_the_pointer() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Mannequin);
    story.key(Key::F);
    story.click("Pose Tool");
    let bone = end_of_bone(&story, 2) + vec2(0.0, 6.0);
    story.point(bone - vec2(150.0, 0.0));
    story.settle();
    assert_eq!(story.session().hovered_joint(), None);
    let camera = story.session().view().camera;
    story.frame(vec![right(true, false)]);
    // As if the bone had come there.
    story.point(bone);
    story.frame(Vec::new());
    assert_eq!(story.session().hovered_joint(), Some(2));
    for _ in 0..5 {
        story.frame(vec![right(true, true)]);
    }
    assert_ne!(story.session().view().camera, camera);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    story.frame(vec![right(false, false)]);
    story.program.session_mut().look(View::SetCamera(camera));
    story.settle();
    story.point(bone);
    story.settle();
    story.frame(vec![right(true, false)]);
    story.frame(vec![right(false, false)]);
    assert_ne!(story.degrees("Elbow"), Vec3::ZERO, "pressed anew, over it");
}

#[test]
fn a_bone_that_is_rolled_by_a_held_key_is_one_step() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F);
    story.key(Key::B);
    let bone = end_of_bone(&story, 2) + vec2(0.0, 6.0);
    story.point(bone);
    story.settle();
    let (steps, camera) = (story.session().done_steps(), story.session().view().camera);
    story.frame(vec![right(true, false)]);
    for _ in 0..10 {
        story.frame(Vec::new());
        story.frame(vec![right(true, true)]);
    }
    story.frame(vec![right(false, false)]);
    story.settle();
    assert_eq!(story.session().done_steps(), steps + 1);
    assert!(story.degrees("Elbow").length() > 10.0);
    assert_eq!(story.session().view().camera, camera);
    // The panel shows its numbers, as of one that was dragged.
    let joints = story.character().character.skeleton().joints();
    let elbow = joints.iter().position(|joint| joint.name == "Elbow");
    assert_eq!(story.session().selected_joint(), elbow);
}

#[test]
fn what_was_wrong_with_a_pose_file_is_not_told_any_longer_once_another_one_is_loaded() {
    let mut story = Story::start(&["models/strip.obj"]);
    let pose = br#"{"joints": {"Elbow": [0, 0, 40]}}"#;
    story.host.files.insert("right.json".into(), pose.to_vec());
    story
        .host
        .files
        .insert("wrong.json".into(), b"{\"joints\": 7}".to_vec());
    let ctrl_alt = Modifiers::COMMAND.plus(Modifiers::ALT);
    let errors = |story: &Story| {
        let fresh = story.session().messages.fresh().iter();
        fresh.filter(|it| it.severity == Severity::Error).count()
    };
    for _ in 0..2 {
        story.key_with(ctrl_alt, Key::P);
        story.choose("wrong.json");
        assert_eq!(errors(&story), 1, "{:?}", story.messages());
    }
    story.key_with(ctrl_alt, Key::P);
    story.choose("right.json");
    assert_eq!(errors(&story), 0, "{:?}", story.messages());
    assert!((story.degrees("Elbow").z - 40.0).abs() < 1e-4);
    let history = story.session().messages.history().iter();
    assert_eq!(
        history.filter(|it| it.severity == Severity::Error).count(),
        2
    );
}

#[test]
fn a_bone_that_is_grabbed_at_its_joint_points_to_the_pointer() {
    let mut story = Story::start(&["builtin:robot"]);
    story.click("Pose Tool");
    // Its elbow, and the end of the forearm.
    let ends = |story: &Story| {
        let session = story.session();
        let shape = session.evaluated().shape(story.shape().id).unwrap();
        let character = session.scene().character(shape.id).unwrap();
        let joints = character.character.skeleton().joints();
        let elbow = joints.iter().position(|joint| joint.name == "Left elbow");
        let mut bones = bones_in_world(session.scene(), shape);
        let (_, joint, tip) = bones.find(|bone| Some(bone.0) == elbow).unwrap();
        [story.at(joint), story.at(tip)]
    };
    let [joint, tip] = ends(&story);
    let along = (tip - joint).normalized();
    // Beside the joint, where every pixel is another direction.
    for beside in [along * 2.0, along * 3.0 + along.rot90() * 2.0] {
        for to in [vec2(20.0, 60.0), vec2(-30.0, 40.0), vec2(5.0, -50.0)] {
            story.drag(joint + beside, joint + to);
            let [at, tip] = ends(&story);
            assert!((at - joint).length() < 0.5, "the joint stays");
            let cosine = (tip - at).normalized().dot(to.normalized());
            assert!(cosine > 0.999, "{beside} to {to}: {cosine}");
            story.key_with(Modifiers::COMMAND, Key::Z);
        }
        // A hand that trembles there turns nothing.
        let before = ends(&story);
        story.drag(joint + beside, joint - beside);
        assert_eq!(ends(&story), before);
    }
}
