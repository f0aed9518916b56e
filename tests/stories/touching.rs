//! Fingers on a screen: of two whatever the first one began is put back, and both move the view; taps on numbers.

use super::Story;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers, Pos2, TouchDeviceId, TouchId, TouchPhase, pos2, vec2};
use glam::Vec3;

/// Fingers that lie on the screen, by number, the first of which is the pointer, as in browsers.
struct Hand {
    fingers: Vec<(u64, Pos2)>,
}

impl Hand {
    fn new() -> Self {
        Self {
            fingers: Vec::new(),
        }
    }

    fn touch(id: u64, phase: TouchPhase, pos: Pos2) -> Event {
        Event::Touch {
            device_id: TouchDeviceId(0),
            id: TouchId(id),
            phase,
            pos,
            force: None,
        }
    }

    /// The button of the pointer, which browsers press and release anew with each finger.
    fn button(&self, pressed: bool) -> Event {
        Event::PointerButton {
            pos: self.fingers[0].1,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    fn put_down(&mut self, story: &mut Story, id: u64, at: Pos2) {
        self.put_down_together(story, &[(id, at)]);
    }

    /// Puts fingers down that the browser tells of at once.
    fn put_down_together(&mut self, story: &mut Story, fingers: &[(u64, Pos2)]) {
        self.fingers.extend(fingers);
        let mut events = vec![self.button(true)];
        let touches = fingers.iter();
        events.extend(touches.map(|&(id, at)| Self::touch(id, TouchPhase::Start, at)));
        story.frame(events);
    }

    /// Moves all fingers by as much each, in steps.
    fn move_by(&mut self, story: &mut Story, ways: &[egui::Vec2]) {
        const STEPS: usize = 4;
        for _ in 0..STEPS {
            for (finger, way) in self.fingers.iter_mut().zip(ways) {
                finger.1 += *way / STEPS as f32;
            }
            let mut events = vec![Event::PointerMoved(self.fingers[0].1)];
            let touches = self.fingers.iter();
            events.extend(touches.map(|&(id, at)| Self::touch(id, TouchPhase::Move, at)));
            story.frame(events);
        }
    }

    fn lift(&mut self, story: &mut Story, id: u64) {
        let mut events = vec![self.button(false), Event::PointerGone];
        let index = self.fingers.iter().position(|finger| finger.0 == id);
        let (_, at) = self.fingers.remove(index.expect("it lies there"));
        events.push(Self::touch(id, TouchPhase::End, at));
        story.frame(events);
        story.settle();
    }

    fn lift_all(&mut self, story: &mut Story) {
        while let Some(&(id, _)) = self.fingers.last() {
            self.lift(story, id);
        }
    }
}

/// The strip with the Pose tool, and a place on the bone below its elbow.
fn with_bones() -> (Story, Pos2) {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::B);
    let bone = story.at(Vec3::new(0.0, 0.7, 0.0));
    (story, bone)
}

/// Distance of the eye from what it looks at.
fn distance(story: &Story) -> f32 {
    let camera = &story.session().view().camera;
    camera.eye().distance(camera.target)
}

#[test]
fn a_finger_that_comes_to_another_on_a_bone_zooms_instead_of_posing() {
    for moves_before in [true, false] {
        let (mut story, bone) = with_bones();
        let (document, before) = (story.session().document(), distance(&story));
        let mut hand = Hand::new();
        hand.put_down(&mut story, 1, bone);
        if moves_before {
            hand.move_by(&mut story, &[vec2(30.0, 0.0)]);
            assert_ne!(story.session().document(), document, "one finger poses");
        }
        hand.put_down(&mut story, 2, bone + vec2(80.0, 40.0));
        assert_eq!(story.session().document(), document, "it is put back");
        hand.move_by(&mut story, &[vec2(-60.0, 0.0), vec2(60.0, 0.0)]);
        assert!(distance(&story) < before * 0.9, "{moves_before}");
        // The one that stays does nothing, nor do others until all are lifted.
        hand.lift(&mut story, 1);
        hand.move_by(&mut story, &[bone - hand.fingers[0].1]);
        let camera = story.session().view().camera;
        hand.move_by(&mut story, &[vec2(0.0, 50.0)]);
        assert_eq!(story.session().view().camera, camera);
        hand.put_down(&mut story, 3, bone + vec2(0.0, 90.0));
        hand.move_by(&mut story, &[vec2(40.0, 0.0), vec2(40.0, 0.0)]);
        assert_ne!(story.session().view().camera, camera, "both move it again");
        hand.lift_all(&mut story);
        assert_eq!(story.session().document(), document, "{moves_before}");
        assert!(story.session().done_steps() == 0 && !story.session().is_in_gesture());
        // One finger poses again.
        let bone = story.at(Vec3::new(0.0, 0.3, 0.0));
        hand.put_down(&mut story, 4, bone);
        hand.move_by(&mut story, &[vec2(30.0, 0.0)]);
        hand.lift_all(&mut story);
        assert_ne!(story.session().document(), document);
    }
}

#[test]
fn two_fingers_that_come_at_once_do_not_pose() {
    let (mut story, bone) = with_bones();
    // An earlier tap was elsewhere.
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, pos2(5.0, 620.0));
    hand.lift_all(&mut story);
    let (document, before) = (story.session().document(), distance(&story));
    hand.put_down_together(&mut story, &[(2, bone), (3, bone + vec2(60.0, 0.0))]);
    hand.move_by(&mut story, &[vec2(-60.0, 0.0), vec2(60.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_eq!(story.session().document(), document);
    assert!(distance(&story) < before * 0.9);
}

#[test]
fn a_second_finger_puts_back_what_a_handle_has_moved() {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::SHIFT, Key::C);
    story.key(Key::W);
    let (document, done) = (story.session().document(), story.session().done_steps());
    // The square in the middle of the arrows.
    let handle = story.at(story.shape().placement.transform.position);
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, handle);
    hand.move_by(&mut story, &[vec2(40.0, 0.0)]);
    assert_ne!(story.session().document(), document);
    hand.put_down(&mut story, 2, handle + vec2(90.0, -40.0));
    hand.move_by(&mut story, &[vec2(20.0, 0.0), vec2(20.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_eq!(story.session().document(), document);
    assert_eq!(story.session().done_steps(), done);
}

#[test]
fn a_second_finger_puts_the_camera_back_that_the_first_has_turned() {
    let mut story = Story::start(&["models/strip.obj"]);
    let beside = story.view().left_top() + vec2(60.0, 120.0);
    let camera = story.session().view().camera;
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, beside);
    hand.move_by(&mut story, &[vec2(40.0, 10.0)]);
    assert_ne!(story.session().view().camera, camera);
    hand.put_down(&mut story, 2, beside + vec2(150.0, 0.0));
    assert_eq!(story.session().view().camera, camera);
    hand.move_by(&mut story, &[vec2(0.0, 30.0), vec2(0.0, 30.0)]);
    let moved = story.session().view().camera;
    assert_eq!(moved.forward(), camera.forward(), "not turned");
    assert_ne!(moved, camera);
    hand.lift_all(&mut story);
    assert_eq!(story.session().view().camera, moved);
}

#[test]
fn a_second_finger_ends_a_box_without_selecting_by_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let selected = |story: &Story| story.session().selected_shapes().count();
    let view = story.view();
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, view.left_top() + vec2(60.0, 120.0));
    hand.move_by(&mut story, &[vec2(30.0, 30.0)]);
    let before = selected(&story);
    let zoom = distance(&story);
    hand.put_down(&mut story, 2, view.center());
    hand.move_by(&mut story, &[vec2(-30.0, 0.0), vec2(80.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_eq!(selected(&story), before);
    assert!(distance(&story) < zoom * 0.95);
}

#[test]
fn a_finger_in_the_view_leaves_a_number_to_the_one_that_drags_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    let field = story.place("Elbow Z");
    let camera = story.session().view().camera;
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, field);
    hand.move_by(&mut story, &[vec2(20.0, 0.0)]);
    let middle = story.view().center();
    hand.put_down(&mut story, 2, middle);
    hand.move_by(&mut story, &[vec2(20.0, 0.0), vec2(0.0, 40.0)]);
    hand.lift_all(&mut story);
    assert_ne!(story.degrees("Elbow").z, 0.0);
    assert_eq!(story.session().view().camera, camera);
}

#[test]
fn a_finger_that_goes_up_over_the_numbers_scrolls_their_list_and_one_that_goes_aside_turns_a_joint()
{
    let mut story = Story::start(&["builtin:adult"]);
    let number = story.place("Waist X");
    let scrolled = |story: &Story| number.y - story.place("Waist X").y;
    for (way, turns) in [(vec2(8.0, -60.0), false), (vec2(40.0, -8.0), true)] {
        let at = story.place("Waist X");
        let before = (scrolled(&story), story.degrees("Waist"));
        let mut hand = Hand::new();
        hand.put_down(&mut story, 1, at);
        hand.move_by(&mut story, &[way]);
        hand.lift_all(&mut story);
        let after = (scrolled(&story), story.degrees("Waist"));
        assert_eq!(after.1 != before.1, turns, "{way}");
        assert_eq!(after.0 > before.0 + 20.0, !turns, "{way}");
    }
}

#[test]
fn move_with_pointer_chooses_the_tool_for_a_finger_which_is_nowhere_yet() {
    let mut story = Story::start(&["builtin:robot"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let at = story.view().center();
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, at);
    hand.lift_all(&mut story);
    let place = |story: &Story| {
        let offset = story.character().pose().root_offset(0);
        (story.session().scene().shapes()[0].placement, offset)
    };
    let before = place(&story);
    story.key(Key::G);
    hand.put_down(&mut story, 1, at + vec2(60.0, 0.0));
    assert_eq!(place(&story), before, "it does not jump to the finger");
    hand.lift_all(&mut story);
    hand.put_down(&mut story, 1, at);
    hand.move_by(&mut story, &[vec2(40.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_ne!(place(&story), before);
}

#[test]
fn what_is_said_while_a_finger_holds_something_needs_neither_keys_nor_buttons() {
    let (mut story, bone) = with_bones();
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, bone);
    hand.move_by(&mut story, &[vec2(30.0, 0.0)]);
    assert!(story.has_text("A second finger cancels"));
    hand.lift_all(&mut story);
    let next = "Drag a bone to turn it · One finger turns the scene · two move it and zoom";
    assert!(story.has_text(next));
}

#[test]
fn a_double_tap_on_a_number_leaves_all_of_it_selected() {
    // Fingers are slower than a mouse, and seldom hit the same point twice.
    for (pause, aside) in [(0.05, 0.0), (0.25, 8.0), (0.45, 3.0)] {
        let mut story = Story::start(&["models/strip.obj"]);
        story.type_into("Elbow Z", "-28.923");
        let field = story.place("Elbow Z");
        let mut hand = Hand::new();
        for x in [0.0, aside] {
            hand.put_down(&mut story, 1, field + vec2(x, 0.0));
            hand.lift_all(&mut story);
            story.wait(pause);
        }
        story.frame(vec![Event::Text("30".to_owned())]);
        story.key(Key::Enter);
        let z = story.degrees("Elbow").z;
        assert!((z - 30.0).abs() < 1e-3, "{z} after a pause of {pause} s");
    }
}

#[test]
fn a_tap_some_time_after_the_first_puts_the_cursor_into_the_number() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "12");
    let field = story.place("Elbow Z");
    let mut hand = Hand::new();
    for _ in 0..2 {
        hand.put_down(&mut story, 1, field + vec2(14.0, 0.0));
        hand.lift_all(&mut story);
        story.wait(2.0);
    }
    story.frame(vec![Event::Text("3".to_owned())]);
    story.key(Key::Enter);
    let z = story.degrees("Elbow").z;
    assert!((z - 3.0).abs() > 1.0, "not in the place of the number: {z}");
}

#[test]
fn the_tap_that_closes_a_menu_does_nothing_else() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.size = (412, 780);
    story.settle();
    let selected = story.session().selected();
    assert!(selected.is_some());
    let mut hand = Hand::new();
    let help = story.place("Help");
    let ground = story.view().left_bottom() + vec2(60.0, -40.0);
    for at in [help, ground] {
        hand.put_down(&mut story, 1, at);
        story.wait(0.1);
        hand.lift_all(&mut story);
        story.wait(1.5);
    }
    assert!(!story.has_text("About"), "the menu is closed");
    assert_eq!(story.session().selected(), selected);
}

#[test]
fn a_finger_that_rests_on_a_bone_before_it_moves_turns_it() {
    let (mut story, bone) = with_bones();
    let document = story.session().document();
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, bone);
    story.wait(0.9);
    let lit = story.session().hovered_bone();
    assert!(lit.is_some(), "what it holds lights up");
    hand.lift_all(&mut story);
    assert_eq!(story.session().done_steps(), 0, "the rest alone is no step");
    assert!(story.has("Mirror Pose"), "it is the right click");
    hand.put_down(&mut story, 1, pos2(60.0, 620.0));
    hand.lift_all(&mut story);
    assert!(!story.has("Mirror Pose"));
    hand.put_down(&mut story, 1, bone);
    story.wait(0.9);
    hand.move_by(&mut story, &[vec2(30.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_ne!(story.session().document(), document);
    assert_eq!(story.session().done_steps(), 1);
    let camera = story.session().view().camera;
    hand.put_down(&mut story, 1, pos2(60.0, 620.0));
    story.wait(0.9);
    hand.move_by(&mut story, &[vec2(30.0, 0.0)]);
    hand.lift_all(&mut story);
    assert_ne!(story.session().view().camera, camera);
}

#[test]
fn on_a_machine_for_fingers_rows_and_buttons_are_higher() {
    let mut story = Story::start(&["builtin:adult"]);
    let heights = |story: &Story| {
        ["Hide Adult", "Waist X", "Position X"].map(|label| {
            let bounds = story.node(label).and_then(egui::accesskit::Node::bounds);
            let bounds = bounds.expect("its place");
            bounds.y1 - bounds.y0
        })
    };
    let before = heights(&story);
    story.program.ui_mut().has_fingers_first = true;
    story.settle();
    for (before, after) in before.into_iter().zip(heights(&story)) {
        assert!(after >= before + 6.0, "{before} {after}");
    }
}

#[test]
fn a_long_press_beside_a_bone_opens_the_menu_of_the_bone_that_it_lights_up() {
    let (mut story, bone) = with_bones();
    let mut hand = Hand::new();
    hand.put_down(&mut story, 1, bone + vec2(18.0, 0.0));
    story.wait(1.0);
    story.settle();
    hand.lift_all(&mut story);
    assert!(story.has("Reset Joint") && !story.has("Fit All to View"));
    assert!(story.session().selected_joint().is_some());
}

#[test]
fn a_swipe_over_the_list_of_shapes_scrolls_it_and_moves_no_shape() {
    let mut story = Story::start(&["builtin:showcase"]);
    for _ in 0..6 {
        story.key_with(Modifiers::SHIFT, Key::C);
    }
    story.size = (412, 780);
    story.settle();
    let mut hand = Hand::new();
    let handle = story.place("Shape Panel");
    hand.put_down(&mut story, 1, handle);
    hand.lift_all(&mut story);
    let row = "[4] Adult (ID: 4)";
    let (names, before) = (story.names().join(" "), story.place(row));
    hand.put_down(&mut story, 1, before);
    hand.move_by(&mut story, &[vec2(0.0, -20.0)]);
    hand.move_by(&mut story, &[vec2(0.0, -30.0)]);
    hand.lift_all(&mut story);
    assert_eq!(story.names().join(" "), names);
    let after = story.place(row);
    assert!(after.y < before.y - 20.0, "{before} {after}");
}

#[test]
fn the_first_help_leaves_the_figure_free_above_the_sheet() {
    let mut story = Story::start(&["builtin:robot"]);
    story.program.ui_mut().first_help = true;
    story.size = (412, 780);
    story.settle();
    assert!(story.has("Close help"));
    story.click("Shape Panel");
    assert!(!story.has("Close help"));
}

#[test]
fn menus_with_rows_for_fingers_scroll_where_they_are_higher_than_the_window() {
    for height in [560, 700, 780, 860, 1000] {
        let mut story = Story::start(&["builtin:robot"]);
        story.program.ui_mut().has_fingers_first = true;
        story.size = (412, height);
        story.settle();
        story.click("Edit");
        let top = story.place("Undo");
        assert!(top.y > 30.0, "{height}: {top} is not below the bar");
        story.point(top + vec2(0.0, 120.0));
        for _ in 0..30 {
            story.frame(vec![Event::MouseWheel {
                unit: egui::MouseWheelUnit::Point,
                delta: vec2(0.0, -60.0),
                phase: TouchPhase::Move,
                modifiers: Modifiers::NONE,
            }]);
        }
        story.settle();
        let last = story.place("Preferences…");
        assert!(last.y < height as f32, "{height}: {last}");
    }
}
