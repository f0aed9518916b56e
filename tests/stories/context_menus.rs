//! The menu that a right click in the view opens: for what is under the pointer, and only there.

use super::Story;
use editor_core::ui::Navigation;
use egui::{Event, Modifiers, PointerButton, Pos2, pos2};
use glam::Vec3;

impl Story {
    fn right_click(&mut self, pos: Pos2) {
        self.point(pos);
        for pressed in [true, false] {
            self.frame(vec![Event::PointerButton {
                pos,
                button: PointerButton::Secondary,
                pressed,
                modifiers: Modifiers::NONE,
            }]);
        }
        self.settle();
    }
}

#[test]
fn a_right_click_on_a_shape_selects_it_and_offers_what_is_done_with_it() {
    let mut story = Story::start(&[]);
    story.click("Insert");
    story.click("Cube");
    story.key(egui::Key::Escape);
    let cube = story.at(Vec3::ZERO);
    story.click_at(pos2(60.0, 500.0));
    assert_eq!(story.session().selected(), None);
    story.right_click(cube);
    assert!(story.session().selected().is_some());
    assert!(!story.has("Mirror Pose"), "it has none");
    story.click("Duplicate");
    assert_eq!(story.session().scene().shapes().len(), 2);
    assert!(!story.has("Hide Others"), "the menu is closed");
}

#[test]
fn a_row_of_the_list_has_the_menu_of_its_shape() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click_at(pos2(60.0, 500.0));
    assert_eq!(story.session().selected(), None);
    let row = story.place("[1] Strip (ID: 1)");
    story.right_click(row);
    assert!(story.session().selected().is_some());
    assert!(story.has("Mirror Pose") && story.has("Rename"));
}

#[test]
fn on_a_bone_that_is_posed_it_is_about_its_joint() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(egui::Key::B);
    story.key(egui::Key::F);
    let skeleton = story.character().character.skeleton();
    let joint = skeleton.joints().len() - 1;
    let at = skeleton.bind_positions()[joint];
    let at = story.at(at);
    story.right_click(at);
    assert!(story.session().selected_joint().is_some());
    assert!(story.has("Mirror Pose") && story.has("Reset Joint"));
    // Again, where rings lie over the bone by now.
    story.key(egui::Key::Escape);
    story.right_click(at);
    assert!(story.has("Mirror Pose"));
}

#[test]
fn one_item_of_the_menu_to_insert_is_lit_by_the_keyboard_or_by_the_pointer() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let focused = |story: &Story| {
        let update = story.widgets.as_ref().expect("widgets");
        let mut nodes = update.nodes.iter();
        let node = nodes.find(|(id, _)| *id == update.focus);
        node.and_then(|(_, node)| node.label().map(str::to_owned))
    };
    story.point(pos2(60.0, 300.0));
    story.key_with(Modifiers::SHIFT, egui::Key::A);
    story.settle();
    assert!(focused(&story).is_some_and(|label| label.starts_with("Cube")));
    let other = story.place("Sphere");
    story.point(other);
    story.settle();
    assert!(story.has("Sphere"));
    assert_eq!(
        focused(&story).filter(|label| label.starts_with("Cube")),
        None
    );
}

#[test]
fn beside_everything_it_is_about_the_scene_and_a_drag_of_the_camera_opens_none() {
    let mut story = Story::start(&["models/strip.obj"]);
    let beside = pos2(60.0, 500.0);
    story.right_click(beside);
    assert!(story.has("Fit All to View") && !story.has("Rename"));
    story.click("Insert Menu at Pointer");
    story.click("Cube");
    assert_eq!(story.names(), ["Strip", "Cube"]);
    story.right_click(beside);
    story.click_at(beside);
    assert!(!story.has("Fit All to View"));
    let before = story.session().view().camera;
    story.point(beside);
    for (pressed, at) in [(true, beside), (false, beside + egui::vec2(60.0, 0.0))] {
        story.point(at);
        story.frame(vec![Event::PointerButton {
            pos: at,
            button: PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        }]);
    }
    story.settle();
    assert_ne!(story.session().view().camera, before);
    assert!(!story.has("Fit All to View"));
}
