//! Taking steps back, and doing them again.

use super::{Story, differing};
use egui::{Event, Key, Modifiers, vec2};
use glam::Vec3;

const CTRL: Modifiers = Modifiers::COMMAND;

/// Steps since the document was opened, oldest first.
fn steps(story: &Story) -> Vec<&str> {
    story.session().steps().collect()
}

fn done(story: &Story) -> usize {
    story.session().done_steps()
}

/// A strip whose elbow was turned by a slider, by 90°.
fn with_bent_elbow() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    let field = story.place("Elbow Z");
    story.drag(field, field + vec2(90.0, 0.0));
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0);
    story
}

#[test]
fn the_drag_of_a_slider_is_one_step_that_is_undone_and_done_again() {
    let mut story = Story::start(&["models/strip.obj"]);
    let first = story.scene_picture();
    let field = story.place("Elbow Z");
    story.drag(field, field + vec2(90.0, 0.0));
    let bent = story.scene_picture();
    assert_eq!(steps(&story), ["Rotate Elbow"]);

    story.key_with(CTRL, Key::Z);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    assert_eq!(differing(&first, &story.scene_picture()), 0);
    story.key_with(CTRL | Modifiers::SHIFT, Key::Z);
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0);
    assert_eq!(differing(&bent, &story.scene_picture()), 0);
    story.key_with(CTRL, Key::Z);
    story.key_with(CTRL, Key::Y);
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0);
}

#[test]
fn a_document_that_is_as_it_was_opened_has_nothing_unsaved() {
    let mut story = with_bent_elbow();
    assert!(story.program.is_modified());
    let field = story.place("Elbow Z");
    story.drag(field, field - vec2(90.0, 0.0));
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    assert_eq!(done(&story), 2);
    assert!(!story.program.is_modified());
    story.key_with(CTRL, Key::Z);
    assert!(story.program.is_modified());
}

#[test]
fn the_edit_menu_names_the_step() {
    let mut story = with_bent_elbow();
    story.click("Edit");
    // Names for assistive technology stay the same, whatever is undone.
    story.click("Undo");
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    story.click("Edit");
    story.click("Redo");
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0);
}

#[test]
fn a_click_in_the_history_goes_to_that_step() {
    let mut story = with_bent_elbow();
    let field = story.place("Hip X");
    story.drag(field, field + vec2(30.0, 0.0));
    story.key_with(Modifiers::SHIFT, Key::C);
    story.click("Edit");
    story.click("History");
    story.click("Rotate Elbow");
    assert_eq!((done(&story), story.names()), (1, vec!["Strip"]));
    assert_eq!(story.degrees("Hip"), Vec3::ZERO);
    story.click("Insert Cube");
    assert_eq!((done(&story), story.names()), (3, vec!["Strip", "Cube"]));
    story.click("Document as it was opened");
    assert_eq!((done(&story), story.degrees("Elbow")), (0, Vec3::ZERO));
}

#[test]
fn ctrl_z_in_the_middle_of_a_drag_takes_back_that_drag_alone() {
    let mut story = with_bent_elbow();
    let field = story.place("Hip X");
    story.press_and_drag(field, field + vec2(30.0, 0.0));
    assert_eq!(story.degrees("Hip").x, 30.0);
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.degrees("Hip"), Vec3::ZERO);
    let further = field + vec2(50.0, 0.0);
    story.point(further);
    story.button(false);
    story.settle();
    assert_eq!(story.degrees("Hip"), Vec3::ZERO, "the rest of the drag");
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0);
    assert_eq!(done(&story), 1);
}

#[test]
fn an_arrow_key_that_is_held_is_one_step() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("Elbow Z");
    let arrow = |pressed, repeat| Event::Key {
        key: Key::ArrowUp,
        physical_key: None,
        pressed,
        repeat,
        modifiers: Modifiers::NONE,
    };
    for repeat in [false, true, true, true, true] {
        story.frame(vec![arrow(true, repeat)]);
    }
    story.frame(vec![arrow(false, false)]);
    story.settle();
    assert!(story.degrees("Elbow").abs_diff_eq(Vec3::Z * 5.0, 1e-4));
    assert_eq!(steps(&story), ["Rotate Elbow"]);
    story.frame(vec![arrow(true, false)]);
    story.frame(vec![arrow(false, false)]);
    story.settle();
    assert_eq!(done(&story), 2, "pressed again, it is another");
}

#[test]
fn delete_resets_the_selected_joint_with_the_pose_tool_and_deletes_the_shape_otherwise() {
    let mut story = with_bent_elbow();
    story.click("Elbow");
    assert_eq!(story.session().selected_joint(), Some(2));
    story.key(Key::B);
    story.key(Key::Delete);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    assert_eq!(story.names(), ["Strip"]);
    story.key(Key::Delete);
    assert_eq!(
        story.names(),
        ["Strip"],
        "a joint at rest protects its shape, too"
    );
    story.key(Key::V);
    story.key(Key::Delete);
    assert!(story.names().is_empty());
    story.key_with(CTRL, Key::Z);
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.degrees("Elbow"), Vec3::Z * 90.0, "with its pose");
}

#[test]
fn a_shape_is_renamed_in_the_list_by_a_double_click_or_by_the_menu() {
    let mut story = with_bent_elbow();
    let row = story.place("[1] Strip (ID: 1)");
    story.point(row);
    for _ in 0..2 {
        story.button(true);
        story.button(false);
    }
    story.settle();
    story.frame(vec![Event::Text("Arm".into())]);
    story.key(Key::Enter);
    assert_eq!(story.names(), ["Arm"]);
    assert_eq!(steps(&story), ["Rotate Elbow", "Rename to Arm"]);

    story.click("Edit");
    story.click("Rename");
    story.frame(vec![Event::Text("Leg".into())]);
    story.key(Key::Escape);
    assert_eq!(story.names(), ["Arm"], "Esc leaves it");
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Strip"]);
}

#[test]
fn a_shape_is_dragged_to_another_place_in_the_list() {
    let mut story = Story::start(&[]);
    for key in [Key::C, Key::S, Key::P] {
        story.key_with(Modifiers::SHIFT, key);
    }
    assert_eq!(story.names(), ["Cube", "Sphere", "Pyramid"]);
    let first = story.place("[1] Cube (ID: 1)");
    let last = story.place("[3] Pyramid (ID: 3)");
    story.drag(first, last + vec2(0.0, 4.0));
    assert_eq!(story.names(), ["Sphere", "Pyramid", "Cube"]);
    assert_eq!(steps(&story).last(), Some(&"Reorder shapes"));
    let top = story.place("[1] Sphere (ID: 2)");
    let last = story.place("[3] Cube (ID: 1)");
    story.drag(last, top - vec2(0.0, 4.0));
    assert_eq!(story.names(), ["Cube", "Sphere", "Pyramid"]);
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Sphere", "Pyramid", "Cube"]);
}

#[test]
fn no_other_key_works_in_the_middle_of_a_drag() {
    let mut story = with_bent_elbow();
    let field = story.place("Hip X");
    story.press_and_drag(field, field + vec2(30.0, 0.0));
    story.key(Key::Delete);
    story.key_with(CTRL, Key::D);
    assert_eq!(story.names(), ["Strip"]);
    assert!(story.session().is_in_gesture());
    story.button(false);
    story.settle();
    assert_eq!(steps(&story), ["Rotate Elbow", "Rotate Hip"]);
}

#[test]
fn a_double_click_on_a_number_selects_all_of_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Position X", "0.3");
    let field = story.place("Position X");
    story.point(field);
    for _ in 0..2 {
        story.button(true);
        story.button(false);
    }
    story.settle();
    story.frame(vec![Event::Text("0.75".into())]);
    story.key(Key::Enter);
    assert_eq!(story.shape().placement.transform.position.x, 0.75);
}
