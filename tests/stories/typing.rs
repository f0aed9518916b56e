//! Keys that come faster than frames: each does what it would alone.

use super::Story;
use crate::keyboard;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers};
use glam::Vec3;

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Presses and releases of keys, with their text, as a keyboard sends them.
fn presses(keys: &[(Modifiers, Key)]) -> Vec<Event> {
    let of_key = |&(modifiers, key): &(Modifiers, Key)| {
        let mut events = vec![Event::ModifiersChanged(modifiers)];
        events.extend(keyboard::press(key, modifiers));
        events.extend([
            keyboard::key(key, false, modifiers),
            Event::ModifiersChanged(NONE),
        ]);
        events
    };
    keys.iter().flat_map(of_key).collect()
}

impl Story {
    fn with_cube() -> Self {
        let mut story = Self::start(&[]);
        story.key_with(Modifiers::SHIFT, Key::C);
        story
    }

    fn at_once(&mut self, keys: &[(Modifiers, Key)]) {
        self.frame(presses(keys));
        self.settle();
    }

    fn position(&self) -> Vec3 {
        self.shape().placement.transform.position
    }
}

#[test]
fn g_x_7_enter_in_one_frame_moves_by_7_along_x() {
    let mut story = Story::with_cube();
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let beside = story.at(Vec3::new(1.0, 0.5, 0.0));
    story.point(beside);
    let keys = [Key::G, Key::X, Key::Num7, Key::Enter];
    story.at_once(&keys.map(|key| (NONE, key)));
    assert_eq!(story.names(), ["Cube"], "X has not deleted it");
    assert_eq!(story.position(), Vec3::X * 7.0);
    story.at_once(&[(CTRL, Key::Z), (NONE, Key::X)]);
    assert!(story.names().is_empty(), "X alone deletes");
}

#[test]
fn shift_d_x_2_in_one_frame_moves_the_copy_by_2_along_x_from_its_place() {
    let mut story = Story::with_cube();
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let beside = story.at(Vec3::new(1.0, 0.5, 0.0));
    story.point(beside);
    let keys = [Key::X, Key::Num2, Key::Enter].map(|key| (NONE, key));
    story.at_once(&[&[(Modifiers::SHIFT, Key::D)], &keys[..]].concat());
    assert_eq!(
        story.names(),
        ["Cube", "Cube"],
        "X has not deleted the copy"
    );
    assert_eq!(story.position(), Vec3::X * 2.0);
    story.key_with(Modifiers::SHIFT, Key::D);
    story.key(Key::Escape);
    assert_eq!(story.names().len(), 3, "Esc ends the movement alone");
    assert_eq!(story.session().done_steps(), 3);
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names().len(), 2, "the copy that stayed");
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Cube"], "the copy and its movement");
    assert_eq!(story.position(), Vec3::ZERO);
    story.key_with(CTRL.plus(Modifiers::SHIFT), Key::Z);
    assert_eq!((story.names().len(), story.position()), (2, Vec3::X * 2.0));
}

#[test]
fn the_view_stands_still_when_a_copy_of_what_it_hardly_shows_is_moved() {
    let mut story = Story::with_cube();
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.type_into("Position X", "40");
    let camera = story.session().view().camera;
    let middle = story.view().center();
    story.point(middle);
    story.key_with(Modifiers::SHIFT, Key::D);
    story.key(Key::Enter);
    assert_eq!(story.names().len(), 2);
    assert_eq!(story.session().view().camera, camera);
}

#[test]
fn g_moves_also_what_is_behind_the_camera() {
    let mut story = Story::with_cube();
    story.program.ui_mut().set_navigation(Navigation::Blender);
    for axis in ["X", "Y", "Z"] {
        story.type_into(&format!("Position {axis}"), "20");
    }
    let view = story.view();
    story.point(view.center());
    let keys = [Key::G, Key::X, Key::Num2, Key::Enter];
    story.at_once(&keys.map(|key| (NONE, key)));
    assert_eq!(story.names(), ["Cube"], "X has not deleted it");
    assert_eq!(story.position(), Vec3::new(22.0, 20.0, 20.0));
}

#[test]
fn ctrl_and_z_in_a_name_knows_nothing_of_an_earlier_name() {
    let mut story = Story::with_cube();
    for name in ["Uno", "Dos"] {
        story.click("Edit");
        story.click("Rename");
        story.frame(vec![Event::Text(name.into())]);
        if name == "Dos" {
            story.at_once(&[(CTRL, Key::Z)]);
        }
        story.key(Key::Enter);
        story.wait(3.0);
        assert_eq!(story.names(), ["Uno"]);
    }
}

#[test]
fn tab_goes_to_the_next_number_before_what_is_typed_after_it() {
    let mut story = Story::with_cube();
    story.click("Position X");
    let keys = [
        Key::Num1,
        Key::Tab,
        Key::Num2,
        Key::Tab,
        Key::Num3,
        Key::Enter,
    ];
    story.at_once(&keys.map(|key| (NONE, key)));
    assert_eq!(story.position(), Vec3::new(1.0, 2.0, 3.0));
}

#[test]
fn tab_goes_through_the_angles_of_one_joint_and_on_to_the_next() {
    let mut story = Story::start(&["builtin:adult"]);
    let camera = story.session().view().camera;
    story.click("Right knee X");
    for text in ["20", "5", "6", "7"] {
        story.frame(vec![Event::Text(text.to_owned())]);
        story.key(Key::Tab);
    }
    let degrees = |story: &Story, joint| story.degrees(joint).round();
    assert_eq!(degrees(&story, "Right knee"), Vec3::new(20.0, 5.0, 6.0));
    assert_eq!(degrees(&story, "Right foot"), Vec3::new(7.0, 0.0, 0.0));
    assert_eq!(story.session().view().camera, camera, "7 is no view");
}

#[test]
fn ctrl_and_z_after_a_number_takes_back_what_was_typed_however_fast() {
    let keys = [(NONE, Key::Num7), (CTRL, Key::Z)];
    for pause in [None, Some(0.0), Some(0.3), Some(3.0)] {
        let mut story = Story::with_cube();
        story.type_into("Position X", "4");
        let steps = story.session().done_steps();
        story.click("Position X");
        match pause {
            None => story.at_once(&keys),
            Some(seconds) => {
                for key in keys {
                    story.at_once(&[key]);
                    story.wait(seconds);
                }
            }
        }
        story.key(Key::Enter);
        assert_eq!(story.position(), Vec3::X * 4.0, "after {pause:?} s");
        assert_eq!(story.session().done_steps(), steps, "after {pause:?} s");
        // With nothing typed, it is the document's.
        story.click("Position X");
        story.at_once(&[(CTRL, Key::Z)]);
        assert_eq!(story.position(), Vec3::ZERO, "after {pause:?} s");
    }
}
