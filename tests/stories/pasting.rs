//! Poses that go by the clipboard from one character to another, with other joints.

use super::Story;
use editor_core::editor::{Edit, View};
use editor_core::math::Euler;
use editor_core::scene::ShapeId;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers};
use glam::Vec3;

impl Story {
    /// An adult and a robot, which share most joints, but not the adult's Waist and the robot's Antenna; posed in the
    /// *Blender* navigation, with the left elbow of the adult turned.
    fn with_adult_and_robot() -> (Self, ShapeId, ShapeId) {
        let mut story = Self::start(&["builtin:adult"]);
        story.host.drop_file("builtin:robot");
        story.settle();
        let shapes = story.session().scene().shapes();
        let [adult, robot] = [shapes[0].id, shapes[1].id];
        story.program.ui_mut().set_navigation(Navigation::Blender);
        story.key(Key::J);
        story.turn_joint(adult, "Left elbow", 50.0);
        (story, adult, robot)
    }

    fn turn_joint(&mut self, shape: ShapeId, name: &str, z: f32) {
        self.select_joints(shape, &[]);
        let edit = Edit::SetJointTransform {
            shape,
            joint: self.joint_named(name),
            rotation: Euler::from_degrees(Vec3::Z * z),
        };
        self.program.session_mut().edit(edit).expect("an angle");
    }

    fn joint_named(&self, name: &str) -> usize {
        let joints = self.character().character.skeleton().joints();
        let mut joints = joints.iter();
        joints
            .position(|joint| joint.name == name)
            .expect("a joint")
    }

    fn select_joints(&mut self, shape: ShapeId, names: &[&str]) {
        self.program.session_mut().look(View::Select(Some(shape)));
        let joints = names.iter().map(|name| self.joint_named(name)).collect();
        self.program.session_mut().look(View::SelectJoints(joints));
        self.settle();
    }

    fn select_all_joints(&mut self, shape: ShapeId) {
        self.program.session_mut().look(View::Select(Some(shape)));
        let joints = self.character().character.skeleton().joints().len();
        let all = View::SelectJoints((0..joints).collect());
        self.program.session_mut().look(all);
        self.settle();
    }

    fn copy(&mut self) {
        self.frame(vec![Event::Copy]);
        self.settle();
    }

    fn paste(&mut self) {
        let text = self.host.clipboard.clone();
        self.frame(vec![Event::ModifiersChanged(Modifiers::COMMAND)]);
        self.frame(vec![Event::Paste(text)]);
        self.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        self.settle();
    }

    fn last_told(&self) -> &str {
        self.messages().last().expect("a message").1
    }
}

#[test]
fn what_was_copied_with_all_joints_goes_onto_all_of_these_names_whatever_a_click_has_selected() {
    let (mut story, adult, robot) = Story::with_adult_and_robot();
    for (joint, z) in [("Right elbow", 30.0), ("Antenna", 40.0)] {
        story.turn_joint(robot, joint, z);
    }
    story.select_all_joints(adult);
    story.copy();
    assert_eq!(story.last_told(), "Copied the pose of Adult");
    story.select_joints(robot, &["Antenna"]);
    story.paste();
    let turned = ["Left elbow", "Right elbow", "Antenna"].map(|it| story.degrees(it).z.round());
    assert_eq!(turned, [50.0, 0.0, 40.0]);
    let told = story.last_told();
    assert!(told.ends_with("joints, as copied"), "{told}");
}

#[test]
fn of_joints_that_were_copied_those_are_told_that_the_other_character_does_not_have() {
    let (mut story, adult, robot) = Story::with_adult_and_robot();
    story.turn_joint(adult, "Waist", 20.0);
    story.select_all_joints(adult);
    story.copy();
    story.select_joints(robot, &[]);
    story.paste();
    let told = story.last_told();
    let without = "joints, without Waist, which this character does not have";
    assert!(told.ends_with(without), "{told}");
    // What is at rest is not missed.
    story.turn_joint(adult, "Waist", 0.0);
    story.select_all_joints(adult);
    story.copy();
    story.turn_joint(robot, "Left elbow", 10.0);
    story.paste();
    assert!(story.last_told().ends_with("joints, as copied"));
}

#[test]
fn a_pose_that_goes_back_onto_its_own_character_is_no_step() {
    let (mut story, adult, _) = Story::with_adult_and_robot();
    story.turn_joint(adult, "Left elbow", 37.123_456);
    story.copy();
    let steps = story.session().steps().count();
    story.paste();
    assert_eq!(story.last_told(), "Adult has this pose already");
    assert_eq!(story.session().steps().count(), steps);
}

#[test]
fn a_selected_joint_that_the_pose_lacks_stays_as_it_is_and_nothing_claims_otherwise() {
    let (mut story, adult, robot) = Story::with_adult_and_robot();
    story.turn_joint(robot, "Antenna", 40.0);
    story.select_joints(adult, &[]);
    story.copy();
    story.select_joints(robot, &["Antenna"]);
    let before = story.session().document();
    story.paste();
    assert_eq!(story.session().document(), before);
    assert_eq!(
        story.last_told(),
        "Nothing is pasted: the pose has no Antenna"
    );
    // Beside one that it has, that one alone gets it.
    story.select_joints(robot, &["Antenna", "Left elbow"]);
    story.paste();
    let turned = ["Left elbow", "Antenna"].map(|it| story.degrees(it).z.round());
    assert_eq!(turned, [50.0, 40.0]);
    let told = "Pasted onto Left elbow alone; the pose has no Antenna";
    assert_eq!(story.last_told(), told);
}
