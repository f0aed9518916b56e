//! Resetting, mirroring, copying and keeping poses.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::scene::NewShape;
use editor_core::scene::ShapeKind;
use editor_core::ui::{Ask, Navigation};
use egui::{Event, Key, Modifiers};
use glam::Vec3;

const NECK: usize = 3;
const RIGHT_ELBOW: usize = 14;
const LEFT_ELBOW: usize = 17;

/// Presses the key that pastes, with what is on the clipboard.
fn paste(editor: &mut Editor, modifiers: Modifiers) {
    let pasted = Event::Paste("{}".into());
    editor.harness.event_modifiers(pasted, modifiers);
    editor.settle();
}

fn posed() -> Editor {
    let mut editor = Editor::with_figure();
    editor.type_into("Neck Y", "20");
    editor.type_into("Left elbow Z", "50");
    editor
}

#[test]
fn alt_r_puts_the_selected_joint_back_and_with_shift_all() {
    let mut editor = posed();
    editor.view(View::SelectJoint(Some(NECK)));
    editor.key_with(Modifiers::ALT, Key::R);
    assert_eq!(editor.joint(NECK), Vec3::ZERO);
    assert!((editor.joint(LEFT_ELBOW).z - 50.0).abs() < 1e-3);
    editor.key_with(Modifiers::ALT | Modifiers::SHIFT, Key::R);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn mirroring_exchanges_left_and_right_and_twice_is_nothing() {
    let mut editor = posed();
    let before = editor.character().pose().clone();
    editor.choose(&["Pose", "Mirror Pose"]);
    let turned = Vec3::new(0.0, 0.0, 310.0);
    assert!(editor.joint(RIGHT_ELBOW).abs_diff_eq(turned, 1e-3));
    assert_eq!(editor.joint(LEFT_ELBOW), Vec3::ZERO);
    assert!((editor.joint(NECK).y - 340.0).abs() < 1e-3);
    editor.key(Key::M);
    assert_eq!(editor.character().pose(), &before);
}

#[test]
fn a_joint_is_mirrored_onto_the_other_side_and_stays_itself() {
    let mut editor = posed();
    let says = |editor: &Editor, text: &str| {
        let painted = editor.painted();
        painted.iter().any(|(painted, _)| painted.contains(text))
    };
    let mirror = |editor: &mut Editor| editor.key_with(Modifiers::SHIFT, Key::M);
    editor.view(View::SelectJoint(Some(LEFT_ELBOW)));
    editor.choose(&["Pose", "Mirror onto Other Side"]);
    let mirrored = Vec3::new(0.0, 0.0, 310.0);
    assert!(editor.joint(RIGHT_ELBOW).abs_diff_eq(mirrored, 1e-3));
    assert!((editor.joint(LEFT_ELBOW).z - 50.0).abs() < 1e-3);
    assert!((editor.joint(NECK).y - 20.0).abs() < 1e-3);
    let before = editor.character().pose().clone();
    for (joints, why) in [
        (vec![], "No joint is selected"),
        (vec![NECK], "none on the other side"),
        (vec![LEFT_ELBOW, RIGHT_ELBOW], "both sides are selected"),
    ] {
        editor.view(View::SelectJoint(None));
        editor.view(View::SelectJoints(joints));
        mirror(&mut editor);
        assert!(says(&editor, why), "{why}");
        assert_eq!(editor.character().pose(), &before);
    }
}

#[test]
fn in_the_blender_navigation_a_pose_is_pasted_onto_the_selected_joints() {
    let mut editor = posed();
    let id = editor.shape().id;
    let mut asked_by = |navigation: Navigation, joints: Vec<usize>| {
        let ui = &mut editor.harness.state_mut().state;
        ui.set_navigation(navigation);
        editor.click("Pose Tool");
        editor.view(View::SelectJoint(None));
        editor.view(View::SelectJoints(joints));
        let before = editor.asked().len();
        paste(&mut editor, Modifiers::COMMAND);
        paste(&mut editor, Modifiers::COMMAND | Modifiers::SHIFT);
        editor.asked()[before..].to_vec()
    };
    let whole = [Ask::Paste, Ask::PastePoseMirrored(id)];
    assert_eq!(asked_by(Navigation::Course, vec![LEFT_ELBOW]), whole);
    assert_eq!(asked_by(Navigation::Blender, vec![]), whole);
    assert_eq!(asked_by(Navigation::Blender, (0..18).collect()), whole);
    let onto = |mirrored| Ask::PastePoseOnto {
        shape: id,
        joints: vec![LEFT_ELBOW],
        mirrored,
    };
    let asked = asked_by(Navigation::Blender, vec![LEFT_ELBOW]);
    assert_eq!(asked, [onto(false), onto(true)]);
}

#[test]
fn copy_and_paste_ask_for_the_clipboard() {
    let mut editor = posed();
    let id = editor.shape().id;
    editor.choose(&["Pose", "Copy Pose"]);
    editor.choose(&["Pose", "Paste Pose"]);
    editor.harness.event(Event::Copy);
    editor.settle();
    paste(&mut editor, Modifiers::COMMAND);
    paste(&mut editor, Modifiers::COMMAND | Modifiers::SHIFT);
    editor.choose(&["Pose", "Paste Pose Mirrored"]);
    // egui reports these as copying and pasting, too.
    let with_alt = Modifiers::COMMAND | Modifiers::ALT;
    editor.harness.event_modifiers(Event::Copy, with_alt);
    editor.settle();
    paste(&mut editor, with_alt);
    // With the Pose tool, the same keys are about the pose.
    editor.key(Key::B);
    editor.harness.event(Event::Copy);
    editor.settle();
    let asked = [
        Ask::CopyPose {
            shape: id,
            joints: Vec::new(),
        },
        Ask::PastePose(id),
        Ask::CopyShapes,
        Ask::Paste,
        Ask::PastePoseMirrored(id),
        Ask::PastePoseMirrored(id),
        Ask::CopyPose {
            shape: id,
            joints: Vec::new(),
        },
        Ask::PastePose(id),
        Ask::CopyPose {
            shape: id,
            joints: Vec::new(),
        },
    ];
    assert_eq!(editor.asked(), asked);
}

#[test]
fn what_is_pasted_into_a_field_is_no_pose() {
    let mut editor = posed();
    editor.begin_typing("Position X", "1");
    editor.harness.event(Event::Paste("2".into()));
    editor.settle();
    assert!(editor.asked().is_empty());
}

#[test]
fn poses_are_kept_taken_on_saved_and_forgotten() {
    let mut editor = posed();
    let id = editor.shape().id;
    let first = editor.character().pose().clone();
    editor.choose(&["Pose", "Keep Pose"]);
    editor.type_into("Chest X", "15");
    editor.click("Poses (1)");
    editor.begin_typing("Name of the pose", "Bow");
    assert!(editor.has("Keep") && !editor.has("Replace"));
    editor.key(Key::Enter);
    editor.begin_typing("Name of the pose", "Bow");
    assert!(editor.has("Replace"), "it is told before");
    editor.key(Key::Escape);
    let names: Vec<_> = editor
        .character()
        .poses()
        .iter()
        .map(|kept| kept.name.clone())
        .collect();
    assert_eq!(names, ["Pose 1", "Bow"]);
    editor.click("Pose 1");
    assert_eq!(editor.character().pose(), &first);
    editor.click("Save Bow");
    assert_eq!(editor.asked(), [Ask::SavePose(id, Some(1))]);
    editor.click("Forget Pose 1");
    assert!(!editor.has("Pose 1"));
    assert_eq!(editor.character().poses().len(), 1);
}

#[test]
fn a_heading_is_unfolded_and_folded_by_a_click_anywhere_in_its_row() {
    let mut editor = posed();
    for (heading, inside) in [("Poses", "Name of the pose"), ("Skinning", "Linear Blend")] {
        editor.reveal(heading);
        for is_unfolded in [true, false] {
            let row = editor.widget(heading).rect();
            let at = egui::pos2(row.right() + 60.0, row.center().y);
            editor.harness.hover_at(at);
            editor.harness.drag_at(at);
            editor.harness.drop_at(at);
            editor.wait();
            assert_eq!(editor.has(inside), is_unfolded, "{heading}");
        }
    }
}

#[test]
fn a_pose_kept_under_a_name_that_is_taken_replaces_it() {
    let mut editor = posed();
    let id = editor.shape().id;
    for degrees in ["10", "30"] {
        editor.type_into("Neck Y", degrees);
        let name = "Nod".to_owned();
        editor.edit(Edit::KeepPose { shape: id, name });
    }
    let kept = editor.character().poses();
    assert_eq!(kept.len(), 1);
    assert!((kept[0].pose.rotation(NECK).degrees().y - 30.0).abs() < 1e-3);
}

#[test]
fn without_a_character_nothing_about_poses_can_be_chosen() {
    let mut editor = Editor::new();
    editor.edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]));
    editor.key(Key::B);
    for key in [Key::K, Key::P] {
        editor.key_with(Modifiers::COMMAND, key);
    }
    for key in [Key::C, Key::V] {
        editor.key_with(Modifiers::COMMAND | Modifiers::ALT, key);
    }
    editor.key(Key::M);
    assert!(editor.asked().is_empty());
}
