//! Figures that are turned and scaled, and the ground that they stand on.

use super::Story;
use editor_core::editor::Edit;
use editor_core::math::Euler;
use editor_core::ui::Navigation;
use egui::{Key, Modifiers};
use glam::Vec3;

const TURN: &[Key] = &[Key::R, Key::Z, Key::Num4, Key::Num5, Key::Enter];
const TURN_OVER: &[Key] = &[Key::R, Key::X, Key::Num9, Key::Num0, Key::Enter];
const HALVE: &[Key] = &[Key::S, Key::Period, Key::Num5, Key::Enter];

impl Story {
    /// One figure in the *Blender* navigation, with the pointer over the view.
    fn with_figure_in_blender(file: &str) -> Self {
        let mut story = Self::start(&[file]);
        story.program.ui_mut().set_navigation(Navigation::Blender);
        story.point(story.view().center());
        story
    }

    fn type_keys(&mut self, keys: &[Key]) {
        for &key in keys {
            self.key(key);
        }
    }

    fn origin(&self) -> Vec3 {
        self.shape().placement.transform.position
    }

    /// Height of the lowest vertex of the selected figure, in the world.
    fn lowest_vertex(&self) -> f32 {
        let shown = self.session().evaluated().shape(self.shape().id).unwrap();
        let positions = shown.geometry.positions().iter();
        let heights = positions.map(|&at| shown.world_from_model.transform_point3(at).y);
        heights.fold(f32::INFINITY, f32::min)
    }
}

#[test]
fn a_figure_that_is_turned_and_scaled_is_back_on_its_ground_once_both_are_put_back() {
    for file in [
        "builtin:humanoid",
        "builtin:lizard",
        "builtin:adult",
        "models/strip.obj",
    ] {
        let mut story = Story::with_figure_in_blender(file);
        let (before, ground) = (story.origin(), story.lowest_vertex());
        for turn in [TURN, TURN_OVER] {
            for back in [[Key::R, Key::S], [Key::S, Key::R]] {
                story.type_keys(turn);
                story.type_keys(HALVE);
                for key in back {
                    story.key_with(Modifiers::ALT, key);
                }
                let off = story.origin().distance(before);
                assert!(off < 1e-5, "{file} {turn:?} {back:?}: {off}");
            }
        }
        // Between the two it stands where it stood, half as large.
        story.type_keys(TURN);
        story.type_keys(HALVE);
        story.key_with(Modifiers::ALT, Key::R);
        let off = story.lowest_vertex() - ground;
        assert!(off.abs() < 1e-5, "{file}: {off}");
    }
}

#[test]
fn a_figure_that_is_turned_about_its_feet_is_scaled_about_them_and_not_about_a_corner_in_the_air() {
    let mut story = Story::with_figure_in_blender("builtin:lizard");
    let ground = story.lowest_vertex();
    story.type_keys(TURN);
    let below = story.lowest_vertex() - ground;
    assert!(below < -0.01, "{below}");
    story.type_keys(HALVE);
    let off = story.lowest_vertex() - ground - 0.5 * below;
    assert!(off.abs() < 1e-5, "{off}");
}

#[test]
fn a_figure_that_is_laid_on_the_ground_in_a_pose_stays_there_with_its_lowest_vertex() {
    let mut story = Story::with_figure_in_blender("builtin:adult");
    let ground = story.lowest_vertex();
    let (shape, skeleton) = (story.shape().id, story.character().character.skeleton());
    let mut joints = skeleton.joints().iter();
    let joint = joints.position(|joint| joint.name == "Chest");
    let edit = Edit::SetJointTransform {
        shape,
        joint: joint.expect("a joint"),
        rotation: Euler::from_degrees(Vec3::X * 40.0),
    };
    story.program.session_mut().edit(edit).unwrap();
    story.settle();
    story.type_keys(TURN_OVER);
    let mut lying = story.shape().placement.transform;
    lying.position.y += ground - story.lowest_vertex();
    let edit = Edit::SetTransform(story.shape().id, lying);
    story.program.session_mut().edit(edit).unwrap();
    story.settle();
    assert!(story.origin().y.abs() > 0.1, "{}", story.origin());
    story.point(story.view().center());
    story.type_keys(HALVE);
    let off = story.lowest_vertex() - ground;
    assert!(off.abs() < 1e-5, "{off}");
    assert_ne!(story.shape().placement.transform.rotation, Euler::ZERO);
}
