//! Ways of moving the camera that hands bring along from other programs.

use crate::interface::Editor;
use crate::interface::figure::figure;
use editor_core::character::Pose;
use editor_core::editor::{Edit, View};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{Camera, CharacterShape, NewShape, ShapeKind};
use editor_core::ui::Ask;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, pos2};
use glam::{Vec3, vec2};

const FROM: Pos2 = pos2(200.0, 300.0);

fn empty(navigation: &str) -> Editor {
    let mut editor = Editor::new();
    editor.harness.state_mut().gestures = true;
    editor.choose(&["View", "Navigation", navigation]);
    editor
}

/// Drags with a button over empty ground and returns the camera from before and after.
fn drag(
    editor: &mut Editor,
    button: PointerButton,
    modifiers: Modifiers,
    by: egui::Vec2,
) -> [Camera; 2] {
    let before = editor.session().view().camera;
    let press = |editor: &mut Editor, pressed, pos| {
        editor.harness.event(Event::PointerButton {
            pos,
            button,
            pressed,
            modifiers,
        });
        editor.settle();
    };
    editor.harness.event(Event::ModifiersChanged(modifiers));
    editor.harness.hover_at(FROM);
    editor.settle();
    press(editor, true, FROM);
    editor.harness.hover_at(FROM + by * 0.5);
    editor.settle();
    editor.harness.hover_at(FROM + by);
    editor.settle();
    press(editor, false, FROM + by);
    editor
        .harness
        .event(Event::ModifiersChanged(Modifiers::NONE));
    editor.settle();
    [before, editor.session().view().camera]
}

fn wheel(editor: &mut Editor, notches: f32) {
    editor.harness.hover_at(FROM);
    editor.harness.event(Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: egui::vec2(0.0, notches),
        modifiers: Modifiers::NONE,
        phase: egui::TouchPhase::Move,
    });
    editor.settle();
}

#[test]
fn in_the_course_left_moves_and_right_turns() {
    let mut editor = empty("As the course's editor");
    let by = egui::vec2(40.0, 20.0);
    let [mut before, after] = drag(&mut editor, PointerButton::Primary, Modifiers::NONE, by);
    before.pan(vec2(40.0, 20.0));
    assert!(after.target.distance(before.target) < 1e-5, "{after:?}");
    let [mut before, after] = drag(&mut editor, PointerButton::Secondary, Modifiers::NONE, by);
    before.turn(vec2(40.0, 20.0));
    assert!((after.theta - before.theta).abs() + (after.phi - before.phi).abs() < 1e-5);
    wheel(&mut editor, 2.0);
    assert_eq!(editor.session().view().camera.radius, 4.0);
}

#[test]
fn as_in_three_js_left_turns_the_scene_and_right_or_middle_moves_it() {
    let mut editor = empty("Orbit");
    let by = egui::vec2(40.0, 20.0);
    let [before, after] = drag(&mut editor, PointerButton::Primary, Modifiers::NONE, by);
    assert!(after.theta > before.theta && after.phi > before.phi);
    assert_eq!(after.target, before.target);
    for (button, modifiers) in [
        (PointerButton::Secondary, Modifiers::NONE),
        (PointerButton::Middle, Modifiers::NONE),
        (PointerButton::Primary, Modifiers::SHIFT),
    ] {
        let [before, after] = drag(&mut editor, button, modifiers, by);
        let height = editor.harness.state().view.height();
        let size = vec2(520.0, height);
        let moved = after.pixel(before.target, size).unwrap() - size * 0.5;
        assert!(moved.distance(vec2(40.0, 20.0)) < 0.1, "{button:?} {moved}");
        assert_eq!(after.theta, before.theta);
    }
    wheel(&mut editor, 1.0);
    wheel(&mut editor, -1.0);
    let radius = editor.session().view().camera.radius;
    assert!((radius - 5.0).abs() < 1e-4, "there and back: {radius}");
}

#[test]
fn as_in_blender_the_middle_button_does_it_all() {
    let mut editor = empty("Blender");
    let by = egui::vec2(30.0, 20.0);
    let [before, after] = drag(&mut editor, PointerButton::Primary, Modifiers::NONE, by);
    assert_eq!(after, before);
    let [before, after] = drag(&mut editor, PointerButton::Middle, Modifiers::NONE, by);
    assert!(after.theta > before.theta && after.target == before.target);
    let [before, after] = drag(&mut editor, PointerButton::Middle, Modifiers::SHIFT, by);
    assert!(after.theta == before.theta && after.target != before.target);
    let [before, after] = drag(&mut editor, PointerButton::Middle, Modifiers::CTRL, by);
    assert!(after.radius > before.radius && after.target == before.target);
    let [before, after] = drag(&mut editor, PointerButton::Primary, Modifiers::ALT, by);
    assert!(after.theta > before.theta);
}

#[test]
fn in_blender_the_wheel_zooms_to_what_is_under_the_pointer_and_elsewhere_to_the_middle() {
    for (navigation, stays) in [("Blender", true), ("Orbit", false), ("Mannequin", false)] {
        let mut editor = empty(navigation);
        let before = editor.session().view().camera;
        let view = editor.harness.state().view;
        let [pixel, size] = [FROM - view.min, view.size()].map(|at| vec2(at.x, at.y));
        let under = before.point_at_target(pixel, size);
        assert!(under.z.abs() < 1e-5, "as far away as the target: {under}");
        wheel(&mut editor, 3.0);
        let now = editor.session().view().camera;
        assert!(now.radius < before.radius);
        let moved = now.pixel(under, size).unwrap().distance(pixel);
        assert_eq!(moved < 0.1, stays, "{navigation}: {moved}");
        assert_eq!(now.target == before.target, !stays, "{navigation}");
    }
}

#[test]
fn in_the_mannequin_keys_walk_and_r_puts_view_and_pose_back() {
    let mut editor = empty("Mannequin");
    let by = egui::vec2(0.0, 30.0);
    let [before, after] = drag(&mut editor, PointerButton::Secondary, Modifiers::NONE, by);
    assert!(after.radius > before.radius, "down is away");
    for (key, along) in [
        (Key::W, Vec3::NEG_Z),
        (Key::S, Vec3::Z),
        (Key::A, Vec3::NEG_X),
        (Key::D, Vec3::X),
        (Key::ArrowUp, Vec3::Y),
        (Key::ArrowDown, Vec3::NEG_Y),
    ] {
        let before = editor.session().view().camera.target;
        editor.key(key);
        let moved = editor.session().view().camera.target - before;
        let off = (moved.normalize_or_zero() - along).length();
        assert!(moved.length() >= 0.0999 && off < 1e-4, "{key:?} {moved}");
    }
    editor.add_character(figure());
    editor.type_into("Neck X", "30");
    assert!(!editor.character().pose().is_bind());
    editor.key(Key::R);
    assert_eq!(editor.session().view().camera, Camera::default());
    assert!(editor.character().pose().is_bind());
}

#[test]
fn the_keys_of_one_way_mean_nothing_in_the_others() {
    let mut editor = empty("Orbit");
    for key in [Key::W, Key::R, Key::D] {
        editor.key(key);
    }
    assert_eq!(editor.session().view().camera, Camera::default());
    editor.choose(&["File", "Built-in Scene", "Showcase"]);
    assert_eq!(editor.asked(), [Ask::OpenBuiltin("showcase")]);
}

#[test]
fn the_window_about_the_keys_tells_the_gestures_of_the_chosen_way() {
    let mut editor = empty("Blender");
    editor.key(Key::F1);
    assert!(editor.has("Middle drag in the view") && !editor.has("W, S"));
    editor.key(Key::Escape);
    editor.choose(&["View", "Navigation", "Mannequin"]);
    editor.key(Key::F1);
    assert!(editor.has("W, S") && editor.has("Reset View and Pose"));
    assert!(
        editor.has("Mannequin 2: Chain") && !editor.has("View from +Z (Front)"),
        "1 and 2 open scenes"
    );
}

#[test]
fn the_window_about_the_keys_tells_the_gestures_of_every_tool() {
    let mut editor = Editor::new();
    editor.key(Key::F1);
    for gesture in [
        "IK: drag a bone",
        "IK: drag the root",
        "Drag a ring",
        "Drag an arrow or a square",
    ] {
        assert!(editor.has(gesture), "{gesture}");
    }
}

#[test]
fn over_a_shape_the_status_line_names_the_button_that_turns() {
    for (navigation, turns) in [
        ("As the course's editor", "right drag turns the camera"),
        ("Orbit", "left drag turns the scene"),
        ("Mannequin", "left drag turns the scene"),
        ("Blender", "middle drag turns the scene"),
    ] {
        let mut editor = empty(navigation);
        editor.choose(&["Insert", "Sphere"]);
        let sphere = editor.shape().id;
        editor.choose(&["Insert", "Cube"]);
        editor.harness.state_mut().hovered_shape = Some(sphere);
        editor.settle();
        let said = format!("Click to select it · {turns}");
        assert!(editor.has(&said), "{navigation}");
        // Only then a drag on one of its points moves that.
        editor.choose(&["Insert", "Circle"]);
        let circle = editor.shape().id;
        editor.choose(&["Insert", "Cube"]);
        editor.harness.state_mut().hovered_shape = Some(circle);
        editor.settle();
        let next = "Click to select it, then drag its control points";
        assert!(editor.has(next), "{navigation}");
        editor.harness.state_mut().hovered_shape = Some(sphere);
        editor.click("Move Tool");
        assert!(editor.has("Drag to move it · Ctrl snaps"), "{navigation}");
    }
}

#[test]
fn saving_by_key_does_not_walk_whichever_key_is_released_first() {
    let mut editor = empty("Mannequin");
    let s = |pressed, modifiers| Event::Key {
        key: Key::S,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    };
    // Both in one frame, as a fast hand does it.
    let none = Modifiers::NONE;
    frame(&mut editor, &[s(true, Modifiers::COMMAND), s(false, none)]);
    // Ctrl comes up before S.
    frame(&mut editor, &[s(true, Modifiers::COMMAND)]);
    frame(&mut editor, &[]);
    frame(&mut editor, &[]);
    frame(&mut editor, &[s(false, none)]);
    assert_eq!(editor.session().view().camera, Camera::default());
    frame(&mut editor, &[s(true, none), s(false, none)]);
    assert_ne!(editor.session().view().camera, Camera::default());
}

/// Shows one frame in which `events` happen.
fn frame(editor: &mut Editor, events: &[Event]) {
    events
        .iter()
        .for_each(|event| editor.harness.event(event.clone()));
    editor.harness.step();
}

#[test]
fn keys_with_shift_are_commands_and_do_not_walk() {
    let mut editor = empty("Mannequin");
    for key in [Key::S, Key::W, Key::ArrowUp, Key::ArrowLeft] {
        editor.key_with(Modifiers::SHIFT, key);
    }
    assert_eq!(editor.session().view().camera, Camera::default());
    assert_eq!(editor.shape().name, "Sphere", "Shift and S");
}

#[test]
fn in_the_mannequin_left_and_right_turn_the_camera_to_that_side() {
    let mut editor = empty("Mannequin");
    for (key, side) in [(Key::ArrowRight, 1.0), (Key::ArrowLeft, -1.0)] {
        editor.key(Key::R);
        editor.key(key);
        let camera = editor.session().view().camera;
        assert!(camera.eye().x * side > 0.3, "{key:?} {}", camera.eye());
        assert_eq!((camera.target, camera.phi), (Vec3::ZERO, 0.0));
    }
}

#[test]
fn up_and_down_move_along_the_worlds_axis_however_the_camera_looks() {
    let mut editor = empty("Mannequin");
    let mut camera = Camera::default();
    camera.turn(vec2(0.0, -160.0));
    editor.view(View::SetCamera(camera));
    editor.key(Key::ArrowUp);
    let moved = editor.session().view().camera.target;
    assert!(
        moved.y > 0.099 && moved.with_y(0.0) == Vec3::ZERO,
        "{moved}"
    );
}

#[test]
fn in_the_course_a_drag_upward_moves_along_the_worlds_axis_from_above_too() {
    let mut editor = empty("As the course's editor");
    let mut camera = Camera::default();
    camera.turn(vec2(0.0, -160.0));
    editor.view(View::SetCamera(camera));
    let by = egui::vec2(0.0, 50.0);
    let [_, after] = drag(&mut editor, PointerButton::Primary, Modifiers::NONE, by);
    let expected = Vec3::Y * 0.5;
    assert!(after.target.abs_diff_eq(expected, 1e-5), "{}", after.target);
}

#[test]
fn esc_puts_the_camera_back_to_before_the_drag_however_long_that_was() {
    let mut editor = empty("As the course's editor");
    editor.harness.hover_at(FROM);
    editor.harness.drag_at(FROM);
    for right in [40.0, 90.0, 140.0] {
        editor.harness.hover_at(FROM + egui::vec2(right, 0.0));
        editor.settle();
    }
    assert!(editor.session().view().camera.target.x < -1.0);
    editor.key(Key::Escape);
    assert_eq!(editor.session().view().camera, Camera::default());
}

#[test]
fn a_short_stroke_over_a_touchpad_is_less_than_a_notch_of_the_wheel() {
    let mut editor = empty("As the course's editor");
    editor.harness.hover_at(FROM);
    editor.harness.event(Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, 10.0),
        modifiers: Modifiers::NONE,
        phase: egui::TouchPhase::Move,
    });
    editor.settle();
    let radius = editor.session().view().camera.radius;
    assert!(radius > 4.5 && radius < 5.0, "{radius}");
}

#[test]
fn r_puts_characters_back_to_where_and_as_they_were_opened() {
    let mut editor = empty("Mannequin");
    let mut pose = Pose::new();
    pose.set_joint_transform(1, Euler::from_degrees(Vec3::new(20.0, 0.0, 0.0)));
    let mut character = CharacterShape::new(figure());
    character.set_pose(pose.clone());
    let mut posed = NewShape::new("Posed", ShapeKind::Character(character));
    posed.placement.transform.position = Vec3::X;
    editor.edit(Edit::Open(vec![posed]));
    let opened = editor.session().document();
    let shape = editor.shape().id;
    editor.edit(Edit::ResetPose(shape));
    let elsewhere = Transform {
        position: Vec3::Y,
        ..editor.shape().placement.transform
    };
    editor.edit(Edit::SetTransform(shape, elsewhere));
    assert_ne!(editor.session().document(), opened);
    editor.key(Key::R);
    assert_eq!(editor.shape().placement.transform.position, Vec3::X);
    assert_eq!(*editor.character().pose(), pose);
    assert_eq!(editor.session().document(), opened, "nothing is unsaved");
}

#[test]
fn r_puts_every_character_back_to_rest() {
    let mut editor = empty("Mannequin");
    for _ in 0..3 {
        editor.add_character(figure());
        editor.type_into("Neck X", "30");
        editor.type_into("Root Offset Y", "2");
    }
    editor.key(Key::R);
    let scene = editor.session().scene();
    for shape in scene.shapes() {
        let character = scene.character(shape.id).expect("a character");
        assert!(character.pose().is_bind(), "{}", shape.id);
    }
}
