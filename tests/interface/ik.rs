//! The IK tool: what is dragged comes to the pointer, a chain follows, and pins hold.

use crate::interface::{Editor, figure};
use editor_core::editor::View;
use editor_core::math::{Euler, Transform};
use editor_core::scene::{CharacterShape, IkPole, NewShape, ShapeId, ShapeKind};
use egui::{Key, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::kittest::NodeT;
use glam::Vec3;

const ROOT: usize = 0;
const LEFT_HIP: usize = 8;
const LEFT_LEG: usize = 9;
const LEFT_KNEE: usize = 10;
const LEFT_FOOT: usize = 11;
const LEFT_ELBOW: usize = 17;
const RIGHT_FOOT: usize = 7;

const STEP: Vec2 = vec2(25.0, -40.0);

impl Editor {
    fn can_unpin(&self) -> bool {
        !self
            .widget("Unpin All Joints")
            .accesskit_node()
            .is_disabled()
    }

    fn with_ik() -> Self {
        Self::with_hands(Key::I)
    }

    /// Where a joint of the selected character is in the world.
    fn joint_place(&self, joint: usize) -> Vec3 {
        let shape = self.session().evaluated().shape(self.shape().id);
        let shape = shape.expect("it is evaluated");
        let figure = shape.geometry.figure.as_ref().expect("a character");
        shape
            .world_from_model
            .transform_point3(figure.joints[joint])
    }

    /// Where it is in the window.
    fn joint_at(&self, joint: usize) -> Pos2 {
        self.place(self.joint_place(joint))
    }

    /// A point of the window on the bone between two joints, near the second.
    fn near(&self, joint: usize, from: usize) -> Pos2 {
        let (to, from) = (self.joint_at(joint), self.joint_at(from));
        from + (to - from) * 0.85
    }

    fn bring(&mut self, from: Pos2, by: Vec2) {
        self.press(from);
        for part in [0.3, 0.7, 1.0] {
            self.point(from + by * part);
        }
        self.release(from + by);
    }

    /// Lifts the left foot with a bend direction from the list: how far the knee is then before
    /// the foot, along +Z.
    fn bend_chosen(mut self, choice: &str) -> f32 {
        self.click("Bend direction");
        self.click(choice);
        let from = self.near(LEFT_FOOT, LEFT_KNEE);
        self.bring(from, vec2(0.0, -30.0));
        self.joint_place(LEFT_KNEE).z - self.joint_place(LEFT_FOOT).z
    }

    fn turned(&self) -> Vec<usize> {
        let pose = self.character().pose();
        let joints = 0..18;
        joints.filter(|&joint| pose.is_changed(joint)).collect()
    }

    fn pin(&mut self, joint: usize) {
        self.view(View::SelectJoint(Some(joint)));
        self.point(Pos2::new(30.0, 500.0));
        self.key(Key::P);
    }
}

#[test]
fn a_dragged_foot_comes_to_the_pointer_and_thigh_and_shin_follow() {
    let mut editor = Editor::with_ik();
    let (from, foot, hip) = (
        editor.near(LEFT_FOOT, LEFT_KNEE),
        editor.joint_at(LEFT_FOOT),
        editor.joint_place(LEFT_HIP),
    );
    let camera = editor.session().view().camera;
    editor.bring(from, STEP);
    let off = editor.joint_at(LEFT_FOOT) - (foot + STEP);
    assert!(off.length() < 0.1, "the foot is off by {off:?}");
    // The foot stays flat, for which it turns too.
    assert_eq!(editor.turned(), [LEFT_LEG, LEFT_KNEE, LEFT_FOOT]);
    assert_eq!(editor.joint_place(LEFT_HIP), hip);
    assert_eq!(editor.session().selected_joint(), Some(LEFT_FOOT));
    assert_eq!(editor.session().view().camera, camera);
    assert_ne!(editor.value("Left knee X"), "0°");
}

#[test]
fn it_comes_to_the_pointer_in_an_uneven_shape_and_from_every_side() {
    let mut editor = Editor::with_ik();
    let transform = Transform {
        position: Vec3::new(0.2, -0.1, 0.3),
        rotation: Euler::from_radians(Vec3::new(0.3, 0.5, -0.2)),
        scale: Vec3::new(0.8, 1.3, 1.1),
    };
    let id = editor.shape().id;
    editor.edit(editor_core::editor::Edit::SetTransform(id, transform));
    for yaw in [0.0, 0.35, -0.6] {
        let mut camera = editor.session().view().camera;
        camera.theta += yaw;
        editor.view(View::SetCamera(camera));
        let (from, foot) = (
            editor.near(LEFT_FOOT, LEFT_KNEE),
            editor.joint_at(LEFT_FOOT),
        );
        let by = vec2(6.0, -18.0);
        editor.point(from);
        let under = editor.session().hovered_joint();
        assert_eq!(under, Some(LEFT_FOOT), "{yaw}");
        editor.bring(from, by);
        let off = editor.joint_at(LEFT_FOOT) - (foot + by);
        assert!(off.length() < 0.1, "{yaw}: the foot is off by {off:?}");
    }
}

#[test]
fn esc_or_a_right_click_puts_the_pose_back() {
    for right in [false, true] {
        let mut editor = Editor::with_ik();
        editor.type_into("Left knee X", "30");
        let before = editor.character().pose().clone();
        let from = editor.near(LEFT_FOOT, LEFT_KNEE);
        editor.press(from);
        editor.point(from + STEP);
        assert_ne!(*editor.character().pose(), before);
        if right {
            editor.mouse(PointerButton::Secondary, true, from + STEP);
        } else {
            editor.key(Key::Escape);
        }
        editor.point(from - STEP);
        assert_eq!(*editor.character().pose(), before);
        editor.release(from);
        assert_eq!(*editor.character().pose(), before);
        assert!(editor.asked().is_empty(), "Esc did more than cancel");
    }
}

#[test]
fn as_many_joints_follow_as_the_chain_is_long() {
    let mut editor = Editor::with_ik();
    editor.type_into("Chain length", "1");
    editor.click("Keep the end's direction");
    let from = editor.near(LEFT_FOOT, LEFT_KNEE);
    editor.bring(from, STEP);
    assert_eq!(editor.turned(), [LEFT_KNEE]);

    let mut editor = Editor::with_ik();
    editor.type_into("Chain length", "3+1");
    editor.click("Keep the end's direction");
    editor.bring(from, STEP);
    assert_eq!(editor.turned(), [2, LEFT_HIP, LEFT_LEG, LEFT_KNEE]);
}

#[test]
fn the_knee_bends_to_where_it_is_told() {
    for (choice, sign) in [("front (+Z)", 1.0), ("back (−Z)", -1.0)] {
        let bend = Editor::with_ik().bend_chosen(choice);
        assert!(bend * sign > 0.05, "{choice}: {bend}");
    }
}

/// The figure turned round: what was its left is called its right.
fn looking_back() -> Editor {
    let names = editor_core::character::COURSE_JOINT_NAMES.map(|name| {
        if name.contains("Left") {
            name.replace("Left", "Right")
        } else {
            name.replace("Right", "Left")
        }
    });
    let names = names.each_ref().map(String::as_str);
    let mut editor = Editor::new();
    editor.add_character(figure::figure_called(&names));
    editor.harness.state_mut().gestures = true;
    editor.key(Key::I);
    editor
}

#[test]
fn in_the_list_of_bend_directions_keys_move_from_the_one_there_is_and_choose() {
    let mut editor = Editor::with_ik();
    let pose = editor.character().pose().clone();
    editor.click("Bend direction");
    for _ in 0..2 {
        editor.key(Key::ArrowDown);
    }
    editor.key(Key::Enter);
    assert_eq!(editor.character().ik.pole, IkPole::ALL[2]);
    assert!(!egui::Popup::is_any_open(&editor.harness.ctx));
    assert_eq!(editor.character().pose(), &pose);
}

#[test]
fn front_is_the_figures_own_wherever_it_looks() {
    for (choice, sign) in [("front (−Z)", -1.0), ("back (+Z)", 1.0)] {
        let bend = looking_back().bend_chosen(choice);
        assert!(bend * sign > 0.05, "{choice}: {bend}");
    }
    let mut editor = looking_back();
    editor.click("Bend direction");
    assert!(editor.has("left (−X)") && editor.has("right (+X)"));
}

#[test]
fn a_pinned_foot_that_gets_out_of_reach_is_said_to() {
    const SAID: &str = "2 pins are out of reach";
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_FOOT);
    editor.pin(RIGHT_FOOT);
    let root = editor.joint_at(ROOT);
    let from = root + (editor.joint_at(3) - root) * 0.2;
    let says = |editor: &Editor| editor.painted_over_view().iter().any(|text| text == SAID);
    editor.press(from);
    editor.point(from + vec2(0.0, 20.0));
    assert!(!says(&editor), "the feet hold");
    editor.point(from - vec2(0.0, 70.0));
    assert!(says(&editor), "{:?}", editor.painted_over_view());
    // The pins do not stay where nothing is: that is said once they have gone.
    editor.release(from - vec2(0.0, 70.0));
    let told = editor.last_told();
    let expected = "2 pins were out of reach, and hold where their joints are now";
    assert_eq!(told.as_deref(), Some(expected));
}

#[test]
fn a_neck_led_away_from_its_root_says_that_pinned_feet_are_lifted_too() {
    const NECK: usize = 3;
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_FOOT);
    editor.pin(RIGHT_FOOT);
    let from = editor.near(NECK, ROOT);
    editor.press(from);
    editor.point(from + vec2(180.0, 60.0));
    let said = editor.painted_over_view();
    let both = |text: &String| {
        text.starts_with("out of reach by") && text.ends_with("; 2 pins are out of reach")
    };
    assert!(said.iter().any(both), "{said:?}");
}

#[test]
fn a_hand_too_small_for_its_fingers_is_taken_by_the_wrist() {
    const WRIST: usize = 2;
    const KNUCKLE: usize = 5;
    const FINGER: usize = 6;
    let mut editor = Editor::new();
    editor.add_character(figure::arm());
    editor.harness.state_mut().gestures = true;
    editor.key(Key::I);
    let wrist = editor.joint_at(WRIST);
    for (to, from) in [(FINGER, KNUCKLE), (KNUCKLE, WRIST)] {
        let at = editor.near(to, from);
        editor.bring(at, vec2(-15.0, -20.0));
        assert_eq!(
            editor.session().selected_joint(),
            Some(WRIST),
            "from {from}"
        );
        let off = editor.joint_at(WRIST) - (wrist + vec2(-15.0, -20.0));
        assert!(off.length() < 0.1, "{off:?}");
        editor.bring(editor.near(to, from), vec2(15.0, 20.0));
    }
    // Seen from near, each finger is its own.
    let mut camera = editor.session().view().camera;
    camera.target = editor.joint_place(WRIST);
    camera.radius *= 0.1;
    editor.view(View::SetCamera(camera));
    let at = editor.near(FINGER, KNUCKLE);
    editor.bring(at, vec2(-5.0, -10.0));
    assert_eq!(editor.session().selected_joint(), Some(FINGER));
}

#[test]
fn joints_that_are_selected_together_are_pinned_together_and_one_alone_is_led() {
    let mut editor = Editor::with_ik();
    editor.view(View::SelectJoint(Some(LEFT_FOOT)));
    editor.view(View::ToggleJoint(RIGHT_FOOT));
    let pins = |editor: &Editor| -> Vec<usize> {
        let id = editor.shape().id;
        let character = editor.session().scene().character(id).unwrap();
        character.ik.pins.iter().copied().collect()
    };
    editor.key(Key::P);
    assert_eq!(pins(&editor), [RIGHT_FOOT, LEFT_FOOT]);
    editor.click("Pin Joint");
    assert_eq!(pins(&editor), [0; 0]);
    editor.pin(LEFT_FOOT);
    editor.view(View::SelectJoint(Some(LEFT_FOOT)));
    editor.view(View::ToggleJoint(RIGHT_FOOT));
    editor.key(Key::P);
    assert_eq!(pins(&editor), [RIGHT_FOOT, LEFT_FOOT], "all of them, again");
    // The label is about the one that comes along.
    let foot = editor.joint_at(RIGHT_FOOT);
    editor.press(editor.near(RIGHT_FOOT, 6));
    editor.point(foot + STEP);
    let painted = editor.painted_over_view();
    assert!(
        !painted.iter().any(|text| text == "2 joints"),
        "{painted:?}"
    );
}

#[test]
fn pinned_feet_stay_while_the_root_is_dragged() {
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_FOOT);
    editor.pin(RIGHT_FOOT);
    let feet = [LEFT_FOOT, RIGHT_FOOT].map(|foot| editor.joint_place(foot));
    let root = editor.joint_at(ROOT);
    // On the bone from the root to the neck, near the root.
    let neck = editor.joint_at(3);
    let from = root + (neck - root) * 0.2;
    let by = vec2(8.0, 25.0);
    editor.bring(from, by);
    let off = editor.joint_at(ROOT) - (root + by);
    assert!(off.length() < 0.1, "the root is off by {off:?}");
    for (foot, was) in [LEFT_FOOT, RIGHT_FOOT].into_iter().zip(feet) {
        let off = editor.joint_place(foot).distance(was);
        assert!(off < 1e-4, "a foot slid by {off}");
    }

    editor.click("Unpin All Joints");
    let from = {
        let (root, neck) = (editor.joint_at(ROOT), editor.joint_at(3));
        root + (neck - root) * 0.2
    };
    editor.bring(from, by);
    let slid = editor.joint_place(LEFT_FOOT).distance(feet[0]);
    assert!(slid > 0.05, "the foot is still pinned");
}

#[test]
fn of_joints_in_one_place_the_uppermost_is_taken() {
    let mut editor = Editor::with_ik();
    // The chest lies where the root does, so that nothing could move it but the root.
    let (chest, waist) = (editor.joint_at(1), editor.joint_at(2));
    let from = chest + (waist - chest) * 0.2;
    editor.bring(from, STEP);
    assert_eq!(editor.session().selected_joint(), Some(ROOT));
    let off = editor.joint_at(ROOT) - (chest + STEP);
    assert!(off.length() < 0.1, "the root is off by {off:?}");
    assert_eq!(editor.turned(), [ROOT], "moved and not turned");
}

#[test]
fn below_a_pin_nothing_moves_and_neither_does_the_camera() {
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_KNEE);
    let camera = editor.session().view().camera;
    let from = editor.near(LEFT_FOOT, LEFT_KNEE);
    editor.bring(from, STEP);
    assert!(editor.turned().is_empty(), "{:?}", editor.turned());
    assert_eq!(editor.session().view().camera, camera);
    // Pressed again, the key lets go.
    editor.pin(LEFT_KNEE);
    editor.bring(from, STEP);
    assert!(!editor.turned().is_empty());
}

#[test]
fn the_status_line_says_what_is_under_the_pointer_and_what_it_would_do() {
    let mut editor = Editor::with_ik();
    let at = editor.near(LEFT_FOOT, LEFT_KNEE);
    editor.point(at);
    assert!(editor.has("Drag to bring it somewhere, the chain follows · P pins"));
    editor.key(Key::P);
    assert!(editor.has("Pinned: stays while others are dragged · P unpins"));
    editor.key(Key::P);
    editor.pin(LEFT_KNEE);
    editor.point(at);
    assert!(editor.has("A pin above holds it"));
}

#[test]
fn what_was_let_go_is_no_longer_at_hand_with_another_tool_or_other_joints() {
    let says = |editor: &Editor| {
        [
            "Drag to bring it somewhere, the chain follows · P pins",
            "Drag to turn it · Left, Right roll · Ctrl snaps · click for rings",
        ]
        .map(|text| editor.has(text))
    };
    // Far out of reach, so that nothing is below the pointer.
    let dragged_away = || {
        let mut editor = Editor::with_ik();
        let from = editor.on_bone(LEFT_ELBOW);
        let to = from + vec2(150.0, 60.0);
        editor.press(from);
        editor.point(to);
        editor.mouse(PointerButton::Primary, false, to);
        assert_eq!(says(&editor), [true, false]);
        editor
    };
    let mut editor = dragged_away();
    editor.view(View::SelectJoint(None));
    assert_eq!(says(&editor), [false; 2]);
    assert_eq!(editor.session().hovered_joint(), None);
    let mut editor = dragged_away();
    editor.key(Key::B);
    assert_eq!(says(&editor), [false; 2]);
    assert_eq!(editor.session().hovered_joint(), None);
}

#[test]
fn pins_of_a_deleted_character_are_forgotten() {
    let mut editor = Editor::with_ik();
    editor.add_character(figure::figure());
    editor.pin(LEFT_FOOT);
    assert!(editor.can_unpin());
    // While a joint is selected, the key is about that.
    editor.key(Key::Delete);
    editor.settle();
    assert!(editor.can_unpin());
    editor.key(Key::Escape);
    editor.key(Key::V);
    editor.key(Key::Delete);
    editor.key(Key::I);
    editor.settle();
    assert!(!editor.can_unpin());
}

#[test]
fn pins_and_folds_do_not_go_over_to_the_next_scene_though_its_ids_start_again() {
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_FOOT);
    editor.click("Fold Root");
    assert!(editor.can_unpin() && !editor.has("Left elbow"));
    let session = editor.harness.state_mut().program.session_mut();
    let view = *session.view();
    let character = session.scene().character(ShapeId(1)).expect("a character");
    let again = CharacterShape::new(character.character.clone());
    let shape = NewShape::new("Model1", ShapeKind::Character(again));
    session.open(vec![shape], view);
    editor.settle();
    assert!(!editor.can_unpin());
    assert!(editor.has("Left elbow"));
}

/// Places of the bar of tools where nothing can be pressed: a button that is grey, and above it.
fn nowhere_in_the_bar(editor: &Editor) -> [Pos2; 2] {
    let grey = editor.widget("Unpin All Joints").rect().center();
    [grey, grey - vec2(0.0, 26.0)]
}

#[test]
fn a_click_between_the_tools_does_not_go_through_to_the_scene() {
    let mut editor = Editor::with_ik();
    for at in nowhere_in_the_bar(&editor) {
        editor.click_at(at);
        assert!(editor.session().selected().is_some(), "deselected at {at}");
    }
}

#[test]
fn a_drag_that_begins_between_the_tools_does_not_move_the_camera() {
    let mut editor = Editor::with_ik();
    let camera = editor.session().view().camera;
    for at in nowhere_in_the_bar(&editor) {
        editor.bring(at, vec2(10.0, 60.0));
        assert_eq!(editor.session().view().camera, camera, "{at}");
    }
}

#[test]
fn the_joint_under_the_pointer_is_pinned_before_the_selected_one() {
    let mut editor = Editor::with_ik();
    editor.view(View::SelectJoint(Some(LEFT_KNEE)));
    let at = editor.near(LEFT_FOOT, LEFT_KNEE);
    editor.point(at);
    editor.key(Key::P);
    assert!(editor.has("Pinned: stays while others are dragged · P unpins"));
}

#[test]
fn pins_of_one_character_do_not_hold_another() {
    let mut editor = Editor::with_ik();
    editor.pin(LEFT_KNEE);
    editor.add_character(figure::figure());
    editor.type_into("Position X", "0.8");
    let from = editor.near(LEFT_FOOT, LEFT_KNEE);
    editor.bring(from, STEP);
    assert_eq!(editor.turned(), [LEFT_LEG, LEFT_KNEE, LEFT_FOOT]);
}
