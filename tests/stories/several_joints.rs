//! Several joints of a figure that are selected and turned together.

use super::Story;
use editor_core::editor::{Edit, View};
use editor_core::math::Euler;
use editor_core::scene::Camera;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers};
use glam::Vec3;

impl Story {
    /// Clicks with Shift held.
    fn add_by_click(&mut self, at: egui::Pos2) {
        self.frame(vec![Event::ModifiersChanged(Modifiers::SHIFT)]);
        self.point(at);
        for pressed in [true, false] {
            self.frame(vec![Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: Modifiers::SHIFT,
            }]);
        }
        self.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        self.settle();
    }

    fn joint(&self, name: &str) -> usize {
        let skeleton = self.character().character.skeleton();
        let mut joints = skeleton.joints().iter();
        joints.position(|joint| joint.name == name).unwrap()
    }
}

#[test]
fn of_several_joints_at_rest_no_less_is_said_than_of_one() {
    let mut story = Story::start(&["builtin:adult"]);
    story.click("Waist");
    let reasons = [
        (
            "The joint is turned as at rest.",
            "The joint is at rest. Esc deselects it; then this is about the character.",
        ),
        (
            "The joints are turned as at rest.",
            "The joints are at rest. Esc deselects them; then this is about the character.",
        ),
    ];
    for (angles, joint) in reasons {
        for (words, why) in [("reset angles of joint", angles), ("reset joint", joint)] {
            story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
            story.frame(vec![Event::Text(words.into())]);
            story.settle();
            assert!(story.has_text(why), "{words}: {why}");
            story.key(Key::Escape);
        }
        let chest = story.place("Chest");
        story.add_by_click(chest);
    }
}

#[test]
fn joints_that_are_added_in_the_list_turn_by_as_much_as_the_one_whose_number_is_changed() {
    let mut story = Story::start(&["builtin:adult"]);
    story.type_into("Chest X", "10");
    story.click("Waist");
    let chest = story.place("Chest");
    story.add_by_click(chest);
    let expected = ["Waist", "Chest"].map(|name| story.joint(name));
    assert_eq!(story.session().selected_joints(), expected);
    story.type_into("Waist X", "20");
    let degrees = |story: &Story, joint| story.degrees(joint).x;
    assert!((degrees(&story, "Waist") - 20.0).abs() < 1e-3);
    assert!((degrees(&story, "Chest") - 30.0).abs() < 1e-3);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(degrees(&story, "Waist"), 0.0, "one step");
    assert!((degrees(&story, "Chest") - 10.0).abs() < 1e-3);
    // One that is not among them is turned alone, and selected.
    story.type_into("Root X", "5");
    assert_eq!(story.session().selected_joints(), [story.joint("Root")]);
    assert_eq!(degrees(&story, "Waist"), 0.0);
}

#[test]
fn joints_that_are_added_in_the_view_turn_together_about_the_axis_that_is_typed() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let bone = |story: &Story, joint: &str, below: &str| {
        let places = story.character().character.skeleton().bind_positions();
        let [from, to] = [joint, below].map(|name| places[story.joint(name)]);
        story.at(from.lerp(to, 0.5))
    };
    let arm = bone(&story, "Left shoulder", "Left elbow");
    story.click_at(arm);
    let other = bone(&story, "Right shoulder", "Right elbow");
    story.add_by_click(other);
    let expected = ["Left shoulder", "Right shoulder"].map(|name| story.joint(name));
    assert_eq!(story.session().selected_joints(), expected);
    story.key(Key::R);
    for key in [Key::X, Key::Num3, Key::Num0, Key::Enter] {
        story.key(key);
    }
    for joint in ["Left shoulder", "Right shoulder"] {
        let degrees = story.degrees(joint);
        assert!(
            degrees.abs_diff_eq(Vec3::new(30.0, 0.0, 0.0), 1e-2),
            "{joint} {degrees}"
        );
    }
    // A click that misses with Shift loses none, and one without drops the joints alone.
    let beside = story.view().left_center() + egui::vec2(40.0, 60.0);
    story.add_by_click(beside);
    assert_eq!(story.session().selected_joints().len(), 2);
    story.click_at(beside);
    assert!(story.session().selected_joints().is_empty());
    assert!(story.session().selected().is_some());
    story.click_at(beside);
    assert!(story.session().selected().is_some(), "it is still posed");
    story.key(Key::Escape);
    assert_eq!(story.session().selected(), None);
}

#[test]
fn a_bone_of_another_character_that_is_added_by_a_click_is_the_only_one_which_is_told() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.host.drop_file("builtin:robot");
    story.settle();
    story.key(Key::J);
    let [adult, robot] = [0, 1].map(|index| story.session().scene().shapes()[index].id);
    let of_adult = vec![View::Select(Some(adult)), View::SelectJoints(vec![3])];
    for view in of_adult {
        story.program.session_mut().look(view);
    }
    story.settle();
    let of_robot = story.session().evaluated().shape(robot).unwrap();
    let head = of_robot.world_from_model.transform_point3(
        story
            .session()
            .scene()
            .character(robot)
            .unwrap()
            .character
            .skeleton()
            .bind_positions()[2],
    );
    let at = story.at(head);
    story.add_by_click(at);
    assert_eq!(story.session().selected(), Some(robot));
    assert_eq!(story.session().selected_joints().len(), 1);
    let (_, told) = *story.messages().last().expect("it says why");
    assert!(
        told.starts_with("Joints of one character at a time"),
        "{told}"
    );
}

#[test]
fn of_a_selected_chain_the_topmost_joint_alone_turns_as_in_blender() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let chain = ["Chest", "Waist"];
    story.click(chain[0]);
    let below = story.place(chain[1]);
    story.add_by_click(below);
    assert_eq!(
        story.session().selected_joint(),
        Some(story.joint(chain[1])),
        "the one below is the active one"
    );
    for key in [Key::R, Key::X, Key::Num3, Key::Num0, Key::Enter] {
        story.key(key);
    }
    let expected = [Vec3::new(30.0, 0.0, 0.0), Vec3::ZERO];
    for (joint, expected) in chain.iter().zip(expected) {
        let degrees = story.degrees(joint);
        assert!(degrees.abs_diff_eq(expected, 1e-2), "{joint} {degrees}");
    }
    // In the others each turns, as fingers curl.
    story.program.ui_mut().set_navigation(Navigation::Orbit);
    story.type_into("Waist X", "20");
    assert!((story.degrees(chain[0]).x - 50.0).abs() < 1e-2);
}

#[test]
fn with_no_joint_selected_a_key_says_so_and_leaves_the_figure_that_is_posed() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    story.click("Waist");
    story.key_with(Modifiers::ALT, Key::A);
    let before = story.session().document();
    for key in [Key::R, Key::G] {
        story.key(key);
        let (_, said) = *story.messages().last().expect("it says why");
        assert!(said.starts_with("No joint is selected"), "{said}");
    }
    story.key(Key::S);
    let (_, said) = *story.messages().last().unwrap();
    assert!(said.starts_with("A bone only turns"), "{said}");
    assert_eq!(story.session().document(), before);
    assert!(!story.session().is_in_gesture());
    // Nor is the whole figure put back.
    story.type_into("Rotation Y", "40");
    let before = story.session().document();
    story.key_with(Modifiers::ALT, Key::R);
    let (_, said) = *story.messages().last().unwrap();
    assert!(
        said.starts_with("No joint is selected to be put back"),
        "{said}"
    );
    assert_eq!(story.session().document(), before);
    story.key(Key::V);
    story.key_with(Modifiers::ALT, Key::R);
    assert_ne!(story.session().document(), before);
    story.key(Key::G);
    assert!(story.session().is_in_gesture(), "the character is moved");
}

#[test]
fn where_the_root_is_selected_with_other_joints_g_moves_it_as_in_blender() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let root = story.joint("Root");
    let moved = |story: &mut Story| {
        let before = story.character().pose().root_offset(root);
        story.keys(&[Key::G, Key::X, Key::Num2, Key::Enter]);
        let pose = story.character().pose();
        assert_eq!(pose.rotation(root), Euler::ZERO);
        pose.root_offset(root) - before
    };
    story.key(Key::A);
    assert!(moved(&mut story).abs_diff_eq(Vec3::X * 2.0, 1e-4));
    // Whichever of them is the active one.
    story.click("Root");
    let below = story.place("Left hip");
    story.add_by_click(below);
    assert_eq!(
        story.session().selected_joint(),
        Some(story.joint("Left hip"))
    );
    assert!(moved(&mut story).abs_diff_eq(Vec3::X * 2.0, 1e-4));
    // Of a forest all roots are moved, if all are selected.
    let mut story = Story::start(&["builtin:creature"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    story.key(Key::A);
    story.keys(&[Key::G, Key::X, Key::Num2, Key::Enter]);
    let character = story.character();
    let roots = character.character.skeleton().roots();
    assert!(roots.len() > 1);
    for &root in roots {
        let offset = character.pose().root_offset(root);
        assert!((offset.length() - 2.0).abs() < 1e-3, "{root}: {offset}");
    }
}

#[test]
fn while_a_figure_is_posed_a_box_and_select_all_are_about_its_joints() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let all = story.character().character.skeleton().joints().len();
    story.key(Key::A);
    assert_eq!(story.session().selected_joints().len(), all);
    story.key_with(Modifiers::ALT, Key::A);
    assert!(story.session().selected_joints().is_empty());
    assert!(story.session().selected().is_some());
    let places = story.character().character.skeleton().bind_positions();
    let elbow = story.at(places[story.joint("Left elbow")]);
    let at = |x: f32, y: f32| elbow + egui::vec2(x, y);
    // From beside the figure over its lower arm.
    story.drag(at(120.0, -40.0), at(4.0, 60.0));
    assert_eq!(
        story.session().selected_joints(),
        [story.joint("Left elbow")]
    );
    story.key(Key::R);
    for key in [Key::X, Key::Num2, Key::Num0, Key::Enter] {
        story.key(key);
    }
    assert!(story.degrees("Left elbow").length() > 1.0);
    story.key(Key::A);
    story.key_with(Modifiers::ALT, Key::R);
    assert_eq!(
        story.degrees("Left elbow"),
        Vec3::ZERO,
        "all of them are put back"
    );
    // All of a figure that is turned turns as a whole, and does not curl up.
    for key in [Key::R, Key::X, Key::Num2, Key::Num0, Key::Enter] {
        story.key(key);
    }
    let pose = story.character().pose().clone();
    let turned = (0..all).filter(|&joint| pose.rotation(joint) != Euler::ZERO);
    assert_eq!(turned.collect::<Vec<_>>(), [story.joint("Root")]);
}

#[test]
fn delete_beside_all_joints_does_not_take_the_figure_that_is_posed() {
    for tool in [Key::B, Key::I] {
        let mut story = Story::start(&["builtin:robot"]);
        story.key(tool);
        story.key(Key::Delete);
        assert_eq!(story.names(), ["Robot"]);
        assert!(story.has_text(
            "No joint is selected to be put back. The Select tool (V) deletes the character"
        ));
        story.key(Key::V);
        story.key(Key::Delete);
        assert!(story.names().is_empty());
    }
}

#[test]
fn delete_with_a_tool_that_poses_is_about_joints_though_a_row_of_the_list_was_clicked_before() {
    for (tool, key) in [(Key::J, Key::X), (Key::I, Key::Delete)] {
        let mut story = Story::start(&["builtin:robot"]);
        story.program.ui_mut().set_navigation(Navigation::Blender);
        story.click("[1] Robot (ID: 1)");
        story.key(tool);
        story.key(key);
        assert_eq!(story.names(), ["Robot"], "{:?}", story.messages());
        let (_, said) = *story.messages().last().expect("it says why");
        assert!(said.starts_with("No joint is selected"), "{said}");
        // A row that is clicked with the tool means the shape.
        story.wait(1.0);
        story.click("[1] Robot (ID: 1)");
        story.key(key);
        assert!(story.names().is_empty());
    }
}

#[test]
fn arrow_keys_roll_the_bone_that_was_dragged_last_until_the_pointer_moves() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Mannequin);
    story.key(Key::B);
    let rotations = |story: &Story| [0, 1, 2].map(|joint| story.character().pose().rotation(joint));
    let changed =
        |a: [Euler; 3], b: [Euler; 3]| (0..3).filter(|&at| a[at] != b[at]).collect::<Vec<_>>();
    let before = rotations(&story);
    let bone = story.at(Vec3::new(0.0, 0.7, 0.0));
    // Far from all bones.
    story.drag(bone, bone + egui::vec2(150.0, 40.0));
    let dragged = rotations(&story);
    story.key(Key::ArrowRight);
    let rolled = rotations(&story);
    assert_eq!(changed(before, dragged).len(), 1);
    assert_eq!(changed(dragged, rolled), changed(before, dragged));
    story.point(story.view().left_top() + egui::vec2(30.0, 200.0));
    story.key(Key::ArrowRight);
    assert_eq!(rotations(&story), rolled);
}

#[test]
fn a_bone_that_was_clicked_is_rolled_and_dragged_where_a_ring_runs_along_it() {
    for navigation in [Navigation::Mannequin, Navigation::Course] {
        let mut story = Story::start(&["models/strip.obj"]);
        story.program.ui_mut().set_navigation(navigation);
        story.key(Key::B);
        let front = Camera {
            target: Vec3::Y,
            ..Camera::default()
        };
        (story.program.session_mut()).look(View::SetCamera(front));
        let camera = story.session().view().camera;
        let hip = story.at(Vec3::ZERO);
        // Up along the bone, where the ring about X is seen edge-on.
        let bone = hip - egui::vec2(0.0, 35.0);
        story.click_at(bone);
        let joint = story.session().selected_joint().expect("it is selected");
        let turned = |story: &Story| {
            let radians = story.character().pose().rotation(joint).radians;
            radians * 180.0 / std::f32::consts::PI
        };
        story.key(Key::ArrowLeft);
        assert_eq!(story.session().view().camera, camera);
        let rolled = turned(&story);
        assert!(rolled.y.abs() > 1.0, "{navigation:?} {rolled}");
        story.key_with(Modifiers::COMMAND, Key::Z);
        story.drag(bone, bone + egui::vec2(35.0, 35.0));
        let dragged = turned(&story);
        // About the line of sight, which is not quite along Z there.
        let is_of_sight = (dragged.z + 90.0).abs() < 6.0 && dragged.x.abs() < 15.0;
        assert!(is_of_sight, "{navigation:?} {dragged}");
        // Where it runs along no bone, the ring is taken.
        story.key_with(Modifiers::COMMAND, Key::Z);
        story.click_at(bone);
        let beyond = hip + egui::vec2(0.0, 35.0);
        story.drag(beyond, beyond + egui::vec2(0.0, 20.0));
        let dragged = turned(&story);
        assert!(
            dragged.x.abs() > 10.0 && dragged.z.abs() < 1e-3,
            "{dragged}"
        );
    }
}

#[test]
fn a_click_on_a_bone_below_a_ring_selects_it_as_well() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::B);
    let front = Camera {
        target: Vec3::Y,
        ..Camera::default()
    };
    (story.program.session_mut()).look(View::SetCamera(front));
    let hip = story.at(Vec3::ZERO);
    story.click_at(hip - egui::vec2(0.0, 35.0));
    let first = story.session().selected_joint().expect("it is selected");
    // The tip of the strip is at the ring about the line of sight, brought there by the camera.
    let elbow = story.at(Vec3::Y);
    let reach = 80.0 / hip.distance(elbow);
    let nearer = Camera {
        radius: front.radius / (reach * 0.8),
        ..front
    };
    (story.program.session_mut()).look(View::SetCamera(nearer));
    story.settle();
    let (hip, elbow) = (story.at(Vec3::ZERO), story.at(Vec3::Y));
    let on_ring = hip + (elbow - hip).normalized() * 88.0;
    story.point(on_ring);
    story.add_by_click(on_ring);
    assert_ne!(story.session().selected_joints(), [first]);
    assert_eq!(story.session().selected_joints().len(), 2);
}

#[test]
fn taps_of_an_arrow_key_roll_one_bone_in_one_step_whatever_they_swing_under_the_pointer() {
    let mut story = Story::start(&["builtin:adult"]);
    story.key(Key::B);
    let places = story.character().character.skeleton().bind_positions();
    let at = |story: &Story, joint: &str| places[story.joint(joint)];
    // The arm swings about the shoulder, whose own bone the pointer rests on.
    let from = at(&story, "Left shoulder").lerp(at(&story, "Left elbow"), 0.5);
    let arm = story.at(from);
    story.drag(arm, arm + egui::vec2(-60.0, -120.0));
    let chest = at(&story, "Chest").lerp(at(&story, "Neck"), 0.4);
    let chest = story.at(chest);
    story.point(chest);
    let hovered = story.session().hovered_joint().expect("a bone");
    let before = story.character().pose().clone();
    let steps = story.session().steps().len();
    for _ in 0..40 {
        story.key(Key::ArrowRight);
    }
    let after = story.character().pose().clone();
    let joints = 0..places.len();
    let changed: Vec<usize> = joints
        .filter(|&joint| before.rotation(joint) != after.rotation(joint))
        .collect();
    assert_eq!(changed, [hovered]);
    assert_eq!(story.session().steps().len(), steps + 1);
    // Another edit in between ends that step.
    story.key(Key::M);
    story.key(Key::ArrowRight);
    assert_eq!(story.session().steps().len(), steps + 3);
    for _ in 0..3 {
        story.key_with(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(story.character().pose(), &before);
}

#[test]
fn a_pose_that_is_pasted_mirrored_onto_a_selected_joint_leaves_that_and_all_others_as_they_are() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let shape = story.shape().id;
    let left = story.joint("Left elbow");
    for (joint, degrees) in [
        (story.joint("Neck"), Vec3::Y * 20.0),
        (left, Vec3::Z * 50.0),
    ] {
        let rotation = Euler::from_degrees(degrees);
        let edit = Edit::SetJointTransform {
            shape,
            joint,
            rotation,
        };
        story.program.session_mut().edit(edit).expect("an angle");
    }
    let session = story.program.session_mut();
    session.look(View::SelectJoints(vec![left]));
    story.settle();
    let steps = story.session().steps().len();
    story.frame(vec![Event::Copy]);
    story.settle();
    let text = story.host.clipboard.clone();
    story.frame(vec![Event::ModifiersChanged(
        Modifiers::COMMAND | Modifiers::SHIFT,
    )]);
    story.frame(vec![Event::Paste(text)]);
    story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
    story.settle();
    let elbows = ["Left elbow", "Right elbow"].map(|joint| story.degrees(joint).z);
    assert!(
        (elbows[0] - 50.0).abs() < 1e-3 && (elbows[1] + 50.0).abs() < 1e-3,
        "{elbows:?}"
    );
    assert!((story.degrees("Neck").y - 20.0).abs() < 1e-3);
    assert_eq!(story.session().steps().len(), steps + 1);
    let (_, told) = *story.messages().last().unwrap();
    assert_eq!(told, "Pasted mirrored onto Right elbow alone, as copied");
}

#[test]
fn of_selected_bones_these_alone_are_copied_and_pasted_in_the_blender_navigation() {
    let mut story = Story::start(&["builtin:adult"]);
    story.host.drop_file("builtin:adult");
    story.settle();
    let shapes: Vec<_> = story.session().scene().shapes().to_vec();
    let [first, second] = [shapes[0].id, shapes[1].id];
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let [left, right] = ["Left elbow", "Right elbow"].map(|joint| story.joint(joint));
    let turn = |story: &mut Story, shape, joint, z: f32| {
        let rotation = Euler::from_degrees(Vec3::Z * z);
        let edit = Edit::SetJointTransform {
            shape,
            joint,
            rotation,
        };
        story.program.session_mut().edit(edit).expect("an angle");
    };
    let select = |story: &mut Story, shape, joints: Vec<usize>| {
        let session = story.program.session_mut();
        session.look(View::Select(Some(shape)));
        session.look(View::SelectJoints(joints));
        story.settle();
    };
    let paste = |story: &mut Story| {
        let text = story.host.clipboard.clone();
        story.frame(vec![Event::ModifiersChanged(Modifiers::COMMAND)]);
        story.frame(vec![Event::Paste(text)]);
        story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        story.settle();
    };
    let elbows =
        |story: &Story| ["Left elbow", "Right elbow"].map(|it| story.degrees(it).z.round());
    turn(&mut story, first, left, 50.0);
    select(&mut story, first, vec![left]);
    story.frame(vec![Event::Copy]);
    story.settle();
    let told = story.messages().last().unwrap().1.to_owned();
    assert_eq!(
        told,
        "Copied the pose of Left elbow alone; with no joint selected, of all"
    );
    // What has been done to other joints since stays, whatever is selected.
    turn(&mut story, first, right, 20.0);
    turn(&mut story, first, left, 5.0);
    for selected in [vec![], vec![right]] {
        select(&mut story, first, selected);
        paste(&mut story);
        assert_eq!(elbows(&story), [50.0, 20.0]);
    }
    // Another character gets it at the joint of the same name.
    turn(&mut story, second, right, 30.0);
    select(&mut story, second, vec![]);
    paste(&mut story);
    assert_eq!(elbows(&story), [50.0, 30.0]);
    // One without such a joint says so, and stays as it is.
    story.host.drop_file("builtin:robot");
    story.settle();
    let robot = story.session().scene().shapes()[2].id;
    let antenna = story.joint("Antenna");
    for joint in [antenna, story.joint("Left elbow")] {
        turn(&mut story, robot, joint, 40.0);
    }
    select(&mut story, robot, vec![antenna]);
    story.frame(vec![Event::Copy]);
    select(&mut story, second, vec![]);
    let before = story.session().document();
    paste(&mut story);
    let (_, told) = *story.messages().last().expect("why nothing is pasted");
    assert_eq!(
        told,
        "The pose on the clipboard is of joints that this character does not have"
    );
    assert_eq!(story.session().document(), before);
    // With no joint selected when it is copied, all of it is.
    select(&mut story, first, vec![]);
    story.frame(vec![Event::Copy]);
    select(&mut story, second, vec![]);
    paste(&mut story);
    assert_eq!(elbows(&story), [50.0, 20.0]);
}

#[test]
fn a_pose_that_is_pasted_mirrored_while_the_other_side_is_selected_goes_there() {
    let mut story = Story::start(&["builtin:adult"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let shape = story.shape().id;
    let [left, right] = ["Left elbow", "Right elbow"].map(|joint| story.joint(joint));
    let rotation = Euler::from_degrees(Vec3::Z * 50.0);
    let edit = Edit::SetJointTransform {
        shape,
        joint: left,
        rotation,
    };
    story.program.session_mut().edit(edit).expect("an angle");
    let elbows =
        |story: &Story| ["Left elbow", "Right elbow"].map(|it| story.degrees(it).z.round());
    // Selected when it is copied, and when it is pasted.
    for (copied, pasted) in [(left, right), (left, left), (right, right)] {
        let select = |story: &mut Story, joint| {
            let session = story.program.session_mut();
            session.look(View::SelectJoint(Some(joint)));
            story.settle();
        };
        select(&mut story, copied);
        story.frame(vec![Event::Copy]);
        story.settle();
        let text = story.host.clipboard.clone();
        select(&mut story, pasted);
        let both = Modifiers::COMMAND | Modifiers::SHIFT;
        story.frame(vec![Event::ModifiersChanged(both)]);
        story.frame(vec![Event::Paste(text)]);
        story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        story.settle();
        // With the right one selected both times the left one gets its rest.
        let expected = match (copied, pasted) {
            (copied, _) if copied == left => [50.0, -50.0],
            _ => [0.0, 0.0],
        };
        assert_eq!(elbows(&story), expected, "{copied} {pasted}");
        story.key_with(Modifiers::COMMAND, Key::Z);
    }
}
