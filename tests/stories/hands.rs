//! Hands and waists that are taken with the IK tool.

use super::Story;
use editor_core::math::Euler;
use egui::{Key, Modifiers, vec2};

#[test]
fn a_hand_that_is_taken_by_a_claw_raises_the_arm() {
    let mut story = Story::start(&["builtin:robot"]);
    let robot = &story.session().evaluated().shapes[0];
    let character = story.character();
    let joints = character.character.skeleton().joints();
    let index = |name: &str| {
        let mut names = joints.iter().map(|joint| &*joint.name);
        names.position(|known| known == name).expect("a joint")
    };
    let (jaw, shoulder) = (index("Left upper jaw"), index("Left shoulder"));
    let mut bones = character.character.bones().iter();
    let bone = bones.find(|bone| bone.joint == jaw).expect("a bone");
    let figure = robot.geometry.figure.as_ref().expect("a skeleton");
    let places = [0.5, 0.9].map(|part: f32| {
        let at = figure.model_from_joint[jaw].transform_point3(bone.tip * part);
        robot.world_from_model.transform_point3(at)
    });
    let before = character.pose().rotation(shoulder);
    story.key(Key::I);
    for at in places {
        let from = story.at(at);
        story.drag(from, from + vec2(60.0, -120.0));
        assert_ne!(story.character().pose().rotation(shoulder), before);
        story.key_with(Modifiers::COMMAND, Key::Z);
    }
}

#[test]
fn a_waist_that_is_pulled_takes_the_figure_along_and_never_turns_it_over() {
    let mut story = Story::start(&["builtin:robot"]);
    let robot = &story.session().evaluated().shapes[0];
    let joints = story.character().character.skeleton().joints();
    let torso = joints.iter().position(|joint| joint.name == "Torso");
    let torso = torso.expect("a joint");
    let figure = robot.geometry.figure.as_ref().expect("a skeleton");
    let waist = figure.model_from_joint[torso].w_axis.truncate();
    let waist = robot.world_from_model.transform_point3(waist);
    story.key(Key::I);
    let from = story.at(waist) - vec2(0.0, 4.0);
    story.drag(from, from + vec2(10.0, 30.0));
    let pose = story.character().pose();
    let turned = (0..torso + 1).filter(|&joint| pose.rotation(joint) != Euler::default());
    assert_eq!(turned.count(), 0);
    assert!(pose.root_offset(0).y < -0.02, "{}", pose.root_offset(0));
}
