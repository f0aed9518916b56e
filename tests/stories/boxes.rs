//! Shapes selected by a box, control points deleted, and copies beside copies.

use super::Story;
use editor_core::editor::Severity;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers, PointerButton};
use glam::Vec3;

/// A cube, a sphere and a pyramid from left to right, seen from the front; nothing is selected.
fn in_a_row(navigation: Navigation) -> Story {
    let mut story = Story::start(&[]);
    for (key, x) in [(Key::C, "-1.5"), (Key::S, "0"), (Key::P, "1.5")] {
        story.key_with(Modifiers::SHIFT, key);
        story.type_into("Position X", x);
    }
    story.program.ui_mut().set_navigation(navigation);
    if navigation != Navigation::Mannequin {
        story.key(Key::Num1);
    }
    story.key(Key::Escape);
    assert!(selected(&story).is_empty());
    story
}

fn selected(story: &Story) -> String {
    let shapes = story.session().selected_shapes();
    let names: Vec<&str> = shapes.map(|shape| &*shape.name).collect();
    names.join(" ")
}

/// Drags with modifiers from one place in the world to another.
fn drag_with(story: &mut Story, modifiers: Modifiers, from: f32, to: f32) {
    let from = story.at(Vec3::new(from, 0.9, 0.0));
    let to = story.at(Vec3::new(to, -0.9, 0.0));
    story.frame(vec![Event::ModifiersChanged(modifiers)]);
    story.press_and_drag(from, to);
    story.frame(vec![Event::PointerButton {
        pos: to,
        button: PointerButton::Primary,
        pressed: false,
        modifiers,
    }]);
    story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
    story.settle();
}

#[test]
fn a_left_drag_in_the_blender_navigation_selects_what_is_in_the_box() {
    let mut story = in_a_row(Navigation::Blender);
    let (camera, document) = (story.session().view().camera, story.session().document());
    drag_with(&mut story, Modifiers::NONE, -2.1, 0.2);
    assert_eq!(selected(&story), "Cube Sphere");
    assert_eq!(story.session().view().camera, camera, "the camera stays");
    drag_with(&mut story, Modifiers::SHIFT, 1.4, 2.1);
    assert_eq!(selected(&story), "Cube Sphere Pyramid", "Shift adds");
    drag_with(&mut story, Modifiers::COMMAND, -0.2, 0.2);
    assert_eq!(selected(&story), "Cube Pyramid", "Ctrl takes out");
    drag_with(&mut story, Modifiers::NONE, -0.85, -0.65);
    assert_eq!(selected(&story), "", "an empty box");
    assert_eq!(story.session().document(), document, "no edit");
}

#[test]
fn in_every_navigation_q_lets_the_next_left_drag_draw_a_box_and_only_that() {
    for navigation in Navigation::ALL {
        let mut story = in_a_row(navigation);
        let camera = story.session().view().camera;
        story.key(Key::Q);
        drag_with(&mut story, Modifiers::NONE, -0.4, 2.1);
        assert_eq!(selected(&story), "Sphere Pyramid", "{navigation:?}");
        assert_eq!(story.session().view().camera, camera, "{navigation:?}");
        if navigation != Navigation::Blender {
            drag_with(&mut story, Modifiers::NONE, -2.1, -0.8);
            assert_ne!(story.session().view().camera, camera, "{navigation:?}");
            assert_eq!(selected(&story), "Sphere Pyramid", "{navigation:?}");
        }
    }
}

#[test]
fn a_box_is_seen_while_it_is_drawn_and_esc_cancels_it() {
    let mut story = in_a_row(Navigation::Blender);
    let (from, to) = (Vec3::new(-2.1, 1.2, 0.0), Vec3::new(2.1, -1.2, 0.0));
    let (from, to) = (story.at(from), story.at(to));
    story.point(to);
    story.settle();
    let before = story.picture();
    story.press_and_drag(from, to);
    assert!(super::differing(&before, &story.picture()) > 10_000);
    story.key(Key::Escape);
    story.button(false);
    story.settle();
    assert_eq!(selected(&story), "");
    story.key(Key::Q);
    story.key(Key::Escape);
    story.program.ui_mut().set_navigation(Navigation::Orbit);
    drag_with(&mut story, Modifiers::NONE, -2.1, 2.1);
    assert_eq!(selected(&story), "", "Esc also takes back the key");
}

#[test]
fn delete_after_a_click_on_a_control_point_deletes_that_point_alone() {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::SHIFT, Key::N);
    story.key(Key::Num1);
    let points = |story: &Story| {
        let set = story.session().scene().curve(story.shape().id).unwrap();
        set.curves().curve(0).unwrap().control_points().to_vec()
    };
    story.click("Add behind 1. curve point 4");
    let before = points(&story);
    assert_eq!(before.len(), 5);
    let second = story.at(before[1]);
    story.click_at(second);
    story.key(Key::Delete);
    assert_eq!(points(&story), [&before[..1], &before[2..]].concat());
    assert_eq!(story.names().len(), 1, "the shape is still there");

    let second = story.at(points(&story)[1]);
    story.click_at(second);
    story.key(Key::Delete);
    assert_eq!(points(&story).len(), 4);
    let (severity, text) = *story.messages().last().expect("it says why");
    assert!(
        severity == Severity::Info && text.contains("cannot have fewer points"),
        "{text}"
    );
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&story), before);

    story.click("[1] B-Spline Curve (ID: 1)");
    story.key(Key::Delete);
    assert!(story.names().is_empty(), "the shape was clicked last");
}

#[test]
fn a_second_duplicate_stands_beside_the_first() {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::SHIFT, Key::C);
    for copies in 1..=3 {
        story.wait(1.0);
        story.click("[1] Cube (ID: 1)");
        story.key_with(Modifiers::COMMAND, Key::D);
        let x = story.shape().placement.transform.position.x;
        assert!(
            (x - 1.1 * copies as f32).abs() < 1e-4,
            "copy {copies} at {x}"
        );
    }
}
