//! Shapes moved, turned and scaled in the view: by keys with typed numbers, by rings and handles.

use super::Story;
use crate::keyboard;
use editor_core::character::Pose;
use editor_core::editor::{Edit, View};
use editor_core::math::Transform;
use editor_core::program::HostEvent;
use editor_core::scene::ShapeId;
use editor_core::ui::{Action, Navigation};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use glam::Vec3;

impl Story {
    /// A cube seen from the front, in the Blender navigation, with the pointer beside it.
    fn with_cube_in_blender() -> Self {
        let mut story = Self::start(&[]);
        story.key_with(Modifiers::SHIFT, Key::C);
        story.program.ui_mut().set_navigation(Navigation::Blender);
        story.key(Key::Num1);
        let beside = story.at(Vec3::new(1.0, 0.5, 0.0));
        story.point(beside);
        story
    }

    pub fn keys(&mut self, keys: &[Key]) {
        for &key in keys {
            self.key(key);
        }
    }

    fn transform(&self) -> Transform {
        self.shape().placement.transform
    }

    fn done(&self) -> Option<&str> {
        self.session().steps().nth(self.session().done_steps() - 1)
    }

    fn press(&mut self, button: PointerButton, pressed: bool, at: Pos2) {
        self.frame(vec![Event::PointerButton {
            pos: at,
            button,
            pressed,
            modifiers: Modifiers::NONE,
        }]);
    }
}

#[test]
fn g_x_2_enter_moves_by_exactly_2_along_x_in_one_step() {
    let mut story = Story::with_cube_in_blender();
    let before = story.session().done_steps();
    story.keys(&[Key::G, Key::X, Key::Num2, Key::Enter]);
    assert_eq!(story.transform().position, Vec3::X * 2.0);
    assert_eq!(story.session().done_steps(), before + 1);
    assert_eq!(story.done(), Some("Move Cube"));
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(story.transform().position, Vec3::ZERO);
}

#[test]
fn along_a_floor_that_is_seen_from_its_edge_a_shape_follows_sideways_wherever_the_pointer_begins() {
    for y in [0.9, 0.0, -0.9] {
        let mut story = Story::with_cube_in_blender();
        let from = story.at(Vec3::new(1.0, y, 0.0));
        story.point(from);
        story.key(Key::G);
        story.key_with(Modifiers::SHIFT, Key::Y);
        let to = story.at(Vec3::new(1.6, y - 0.3, 0.0));
        story.point(to);
        let moved = story.transform().position;
        assert!(
            (moved.x - 0.6).abs() < 1e-2 && moved.y == 0.0,
            "{y}: {moved}"
        );
        assert!(moved.z.abs() < 0.1, "{y}: {moved}");
    }
}

#[test]
fn a_figure_that_is_scaled_stays_on_the_ground_of_the_others() {
    let mut story = Story::start(&["builtin:showcase"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let bounds = |story: &Story| {
        let session = story.session();
        let shown = session.evaluated().shape(story.shape().id);
        shown.expect("a figure").world_bounds()
    };
    let before = bounds(&story);
    story.point(story.view().center());
    story.keys(&[Key::S, Key::Num2, Key::Enter]);
    let after = bounds(&story);
    assert!((after.min.y - before.min.y).abs() < 1e-4, "{after:?}");
    assert!((after.size().y / before.size().y - 2.0).abs() < 1e-4);
    // So it does with *Reset Scale*, and by numbers.
    story.key_with(Modifiers::ALT, Key::S);
    assert!((bounds(&story).min.y - before.min.y).abs() < 1e-4);
    assert!((bounds(&story).size().y - before.size().y).abs() < 1e-4);
    for scale in ["0.5", "1.5", "1"] {
        story.type_into("Uniform Scale", scale);
        let now = bounds(&story).min.y;
        assert!((now - before.min.y).abs() < 1e-4, "{scale}: {now}");
    }
    // Without a ground it grows about its origin.
    story.key(Key::F2);
    let position = story.transform().position;
    story.keys(&[Key::S, Key::Num2, Key::Enter]);
    assert_eq!(story.transform().position, position);
}

#[test]
fn a_sign_over_a_digit_on_the_keyboard_is_that_sign_and_no_digit() {
    let mut story = Story::with_cube_in_blender();
    story.keys(&[Key::G, Key::X, Key::Num3]);
    let times = keyboard::key(Key::Num8, true, Modifiers::SHIFT);
    story.frame(vec![times, Event::Text("*".to_owned())]);
    story.keys(&[Key::Num2, Key::Enter]);
    assert_eq!(story.transform().position, Vec3::X * 6.0);
}

#[test]
fn a_question_ends_a_movement_which_does_not_follow_the_pointer_to_the_answer() {
    let mut story = Story::with_cube_in_blender();
    story.key(Key::G);
    let from = story.at(Vec3::new(1.0, 0.5, 0.0));
    story.point(from + vec2(30.0, 0.0));
    let moved = story.transform();
    assert!(moved.position.x > 0.05, "{moved:?}");
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    story.point(from + vec2(300.0, 120.0));
    story.click("Cancel");
    assert_eq!(story.transform(), moved);
    story.point(from);
    assert_eq!(story.transform(), moved, "it goes on after the question");
    assert_eq!(story.done(), Some("Move Cube"));
}

#[test]
fn r_z_45_and_s_y_half_do_exactly_that() {
    let mut story = Story::with_cube_in_blender();
    story.keys(&[Key::R, Key::Z, Key::Num4, Key::Num5, Key::Enter]);
    let degrees = story.transform().rotation.degrees();
    assert!(degrees.abs_diff_eq(Vec3::Z * 45.0, 1e-4), "{degrees}");
    assert_eq!(story.done(), Some("Rotate Cube"));
    story.keys(&[
        Key::S,
        Key::Y,
        Key::Num0,
        Key::Period,
        Key::Num5,
        Key::Enter,
    ]);
    assert_eq!(story.transform().scale, Vec3::new(1.0, 0.5, 1.0));
    assert_eq!(story.done(), Some("Scale Cube"));
    story.keys(&[Key::S, Key::Num2, Key::Enter]);
    assert_eq!(story.transform().scale, Vec3::new(2.0, 1.0, 2.0));
    story.keys(&[Key::S, Key::Num0, Key::Enter]);
    assert!(story.transform().scale.min_element() > 0.0, "never nothing");
}

#[test]
fn a_turn_that_is_typed_without_an_axis_is_clockwise_in_the_picture_as_in_blender() {
    let mut story = Story::with_cube_in_blender();
    story.keys(&[Key::R, Key::Num3, Key::Num0, Key::Enter]);
    let degrees = story.transform().rotation.degrees();
    assert!(degrees.abs_diff_eq(Vec3::Z * -30.0, 1e-3), "{degrees}");
    story.keys(&[Key::R, Key::Num9, Key::Num0, Key::Minus, Key::Enter]);
    let degrees = story.transform().rotation.degrees();
    assert!(degrees.abs_diff_eq(Vec3::Z * 60.0, 1e-3), "{degrees}");
}

#[test]
fn an_axis_pressed_again_is_the_shape_s_own_and_backspace_corrects() {
    let mut story = Story::with_cube_in_blender();
    story.type_into("Rotation Z", "90");
    let beside = story.at(Vec3::new(1.0, 0.5, 0.0));
    story.point(beside);
    story.keys(&[
        Key::G,
        Key::X,
        Key::X,
        Key::Num3,
        Key::Backspace,
        Key::Num1,
        Key::Enter,
    ]);
    let position = story.transform().position;
    assert!(position.abs_diff_eq(Vec3::Y, 1e-6), "{position}");
}

#[test]
fn after_g_the_shape_follows_the_pointer_without_a_button_until_a_click() {
    let mut story = Story::with_cube_in_blender();
    let (from, to) = (
        story.at(Vec3::new(1.0, 0.5, 0.0)),
        story.at(Vec3::new(1.6, 0.1, 0.0)),
    );
    story.key(Key::G);
    story.point(to);
    story.settle();
    let moved = Vec3::new(0.6, -0.4, 0.0);
    assert!(story.transform().position.abs_diff_eq(moved, 1e-3));
    let document = story.session().document();
    story.click_at(to);
    assert_eq!(
        story.session().document(),
        document,
        "the click only ends it"
    );
    assert_eq!(story.shape().name, "Cube", "and deselects nothing");
    story.point(from);
    story.settle();
    assert!(story.transform().position.abs_diff_eq(moved, 1e-3));
}

#[test]
fn esc_and_a_right_click_put_everything_back_with_its_revision() {
    for key in [Key::G, Key::R, Key::S] {
        for by_esc in [true, false] {
            let mut story = Story::with_cube_in_blender();
            let (document, before) = (story.session().document(), story.transform());
            story.key(key);
            let at = story.at(Vec3::new(0.2, 1.0, 0.0));
            story.point(at);
            story.settle();
            assert_ne!(story.transform(), before, "{key:?}");
            if by_esc {
                story.key(Key::Escape);
            } else {
                story.press(PointerButton::Secondary, true, at);
                story.press(PointerButton::Secondary, false, at);
                story.settle();
            }
            assert_eq!(story.transform(), before, "{key:?}");
            assert_eq!(story.session().document(), document, "{key:?}");
            assert_eq!(story.shape().name, "Cube", "it stays selected");
            assert!(!story.has("Hide Others"), "and no menu opens");
        }
    }
}

#[test]
fn with_shift_a_shape_follows_by_a_tenth_of_the_way() {
    let mut story = Story::with_cube_in_blender();
    let [first, then] = [1.5, 2.5].map(|x| story.at(Vec3::new(x, 0.5, 0.0)));
    story.key(Key::G);
    story.point(first);
    story.frame(vec![Event::ModifiersChanged(Modifiers::SHIFT)]);
    story.point(then);
    story.settle();
    let moved = story.transform().position;
    assert!(moved.abs_diff_eq(Vec3::X * 0.6, 2e-3), "{moved}");
}

#[test]
fn in_the_other_navigations_keys_choose_the_tools_and_the_pointer_waits_for_a_handle() {
    for navigation in [Navigation::Course, Navigation::Orbit] {
        let mut story = Story::with_cube_in_blender();
        story.program.ui_mut().set_navigation(navigation);
        let before = story.transform();
        for (key, tool) in [
            (Key::W, "Move Tool"),
            (Key::E, "Rotate Tool"),
            (Key::R, "Scale Tool"),
        ] {
            story.key(key);
            let node = story.node(tool).expect("a button");
            let on = egui::accesskit::Toggled::True;
            assert!(
                node.is_selected() == Some(true) || node.toggled() == Some(on),
                "{tool}"
            );
            let away = story.at(Vec3::new(-1.0, -1.0, 0.0));
            story.point(away);
            story.settle();
            assert_eq!(story.transform(), before);
        }
    }
}

#[test]
fn a_ring_turns_and_a_handle_scales_and_a_number_typed_meanwhile_counts() {
    let mut story = Story::with_cube_in_blender();
    story.key(Key::E);
    // The ring about Z faces the eye, 72 points from the middle.
    let middle = story.at(Vec3::ZERO);
    let on_ring = |degrees: f32| middle + 72.0 * egui::Vec2::angled(-degrees.to_radians());
    story.drag(on_ring(30.0), on_ring(120.0));
    let degrees = story.transform().rotation.degrees();
    assert!(degrees.abs_diff_eq(Vec3::Z * 90.0, 1.0), "{degrees}");
    story.type_into("Rotation Z", "90");
    story.press_and_drag(on_ring(30.0), on_ring(60.0));
    story.keys(&[Key::Minus, Key::Num9, Key::Num0]);
    story.key(Key::Enter);
    story.button(false);
    story.settle();
    let degrees = story.transform().rotation.degrees();
    assert!(degrees.abs_diff_eq(Vec3::ZERO, 1e-3), "{degrees}");

    story.program.ui_mut().set_navigation(Navigation::Course);
    story.key(Key::R);
    let right = middle + vec2(84.0, 0.0);
    story.drag(right, middle + vec2(168.0, 0.0));
    let scale = story.transform().scale;
    assert!(scale.abs_diff_eq(Vec3::new(2.0, 1.0, 1.0), 5e-2), "{scale}");
    assert!(!story.shape().placement.uniform_scaling);
    story.drag(middle, middle + vec2(0.0, -72.0));
    let twice = story.transform().scale;
    assert!(twice.abs_diff_eq(scale * 2.0, 5e-2), "{twice}");
}

#[test]
fn all_that_is_selected_turns_and_grows_about_its_middle() {
    let mut story = Story::with_cube_in_blender();
    story.key_with(Modifiers::SHIFT, Key::A);
    story.click("Sphere");
    story.type_into("Position X", "2");
    story.key_with(Modifiers::COMMAND, Key::A);
    assert_eq!(story.shape().name, "Sphere");
    story.keys(&[Key::R, Key::Z, Key::Num9, Key::Num0, Key::Enter]);
    let cube = |story: &Story| {
        let cube = story.session().scene().shape(ShapeId(1)).unwrap();
        cube.placement.transform
    };
    assert!(
        cube(&story)
            .position
            .abs_diff_eq(Vec3::new(1.0, -1.0, 0.0), 1e-5)
    );
    assert!((cube(&story).rotation.degrees().z - 90.0).abs() < 1e-3);
    let sphere = story.transform().position;
    assert!(
        sphere.abs_diff_eq(Vec3::new(1.0, 1.0, 0.0), 1e-5),
        "{sphere}"
    );
    assert_eq!(story.done(), Some("Rotate 2 shapes"));
    story.keys(&[Key::S, Key::Num3, Key::Enter]);
    assert!(
        cube(&story)
            .position
            .abs_diff_eq(Vec3::new(1.0, -3.0, 0.0), 1e-5)
    );
    assert_eq!(cube(&story).scale, Vec3::splat(3.0));
    story.key_with(Modifiers::COMMAND, Key::Z);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(cube(&story).position, Vec3::ZERO);
}

#[test]
fn with_the_pose_tool_r_turns_the_selected_joint_about_its_axis() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let elbow = Action::View(View::SelectJoint(Some(2)));
    story.program.carry_out(vec![elbow], &mut story.host);
    let beside = story.view().center() + vec2(80.0, 30.0);
    story.point(beside);
    story.keys(&[Key::R, Key::Z, Key::Num3, Key::Num0, Key::Enter]);
    let degrees = story.degrees("Elbow");
    assert!(degrees.abs_diff_eq(Vec3::Z * 30.0, 1e-3), "{degrees}");
    assert_eq!(story.done(), Some("Rotate Elbow"));
    let id = story.shape().id;
    let rest = Action::Edit(Edit::SetPose(id, Pose::new()));
    story.program.carry_out(vec![rest], &mut story.host);
    story.keys(&[Key::R, Key::X]);
    story.key(Key::Escape);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
}

#[test]
fn a_locked_or_missing_selection_is_not_taken_and_x_deletes_none_of_it() {
    let mut story = Story::with_cube_in_blender();
    story.key_with(Modifiers::SHIFT, Key::L);
    let document = story.session().document();
    story.keys(&[Key::G, Key::X, Key::Num2, Key::Enter]);
    assert_eq!(story.session().document(), document);
    assert_eq!(story.transform().position, Vec3::ZERO);
    let told = |story: &Story| story.messages().last().unwrap().1.to_owned();
    assert_eq!(told(&story), "The selected shape is hidden or locked");
    story.wait(4.0);
    story.key(Key::X);
    assert!(told(&story).starts_with("X deletes nothing that is locked"));
    assert_eq!(story.session().document(), document);

    story.key_with(Modifiers::SHIFT, Key::L);
    story.key(Key::Escape);
    assert_eq!(story.session().selected(), None);
    let document = story.session().document();
    story.keys(&[Key::G, Key::X, Key::Num2, Key::Enter]);
    assert_eq!(story.session().document(), document);
    assert_eq!(story.names(), ["Cube"]);
}

#[test]
fn ctrl_and_q_in_the_middle_of_a_movement_asks_about_it() {
    let mut story = Story::with_cube_in_blender();
    story.keys(&[Key::G, Key::X, Key::Num7]);
    story.key_with(Modifiers::COMMAND, Key::Q);
    assert!(story.has("Don't Save") && !story.host.quits);
}
