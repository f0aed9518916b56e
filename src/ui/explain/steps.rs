//! The steps of the matrix stack, and what has been drawn after so many.

use super::Explained;
use crate::character::{Pose, SkeletalModel, WalkStep};
use crate::editor::Session;
use crate::math::MatrixStack;
use crate::ui::scene_places::Place;
use crate::ui::widgets::SHADE;
use egui::{Color32, Painter, Pos2, Stroke};
use glam::Mat4;

/// Seconds that a step lasts while the steps are played.
const PACE: f64 = 0.6;

/// What is done in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StackStep {
    /// The top times the joint's own transform goes on the stack.
    Push(usize),
    /// The joint is drawn with the top, which is its T.
    Draw(usize),
    /// The top is taken off.
    Pop(usize),
}

impl StackStep {
    pub(super) fn joint(self) -> usize {
        match self {
            Self::Push(joint) | Self::Draw(joint) | Self::Pop(joint) => joint,
        }
    }

    /// What is done, in words.
    pub(super) fn words(self, skeleton: &SkeletalModel) -> String {
        let name = &skeleton.joints()[self.joint()].name;
        match self {
            Self::Push(_) => {
                format!(
                    "push: multiply the top by {name}'s own transform and put the product on top"
                )
            }
            Self::Draw(_) => format!("draw {name} with the top, which is its T"),
            Self::Pop(_) => format!("pop: all that hangs on {name} is done, take its T off"),
        }
    }
}

/// All steps of a skeleton (assignment, "Matrix stack" and "Skeleton").
pub(super) fn steps_of(skeleton: &SkeletalModel) -> Vec<StackStep> {
    let mut steps = Vec::new();
    for step in skeleton.walk() {
        match step {
            WalkStep::Enter(joint) => {
                steps.extend([StackStep::Push(joint), StackStep::Draw(joint)]);
            }
            WalkStep::Leave(joint) => steps.push(StackStep::Pop(joint)),
        }
    }
    steps
}

/// The stack after the first `steps`, from the bottom up: joints, and the products up to each.
pub(super) fn stack_after(
    steps: &[StackStep],
    skeleton: &SkeletalModel,
    pose: &Pose,
) -> Vec<(usize, Mat4)> {
    let mut stack = MatrixStack::new();
    let mut entries = Vec::new();
    for step in steps {
        match *step {
            StackStep::Push(joint) => {
                stack.push(skeleton.parent_from_joint(joint, pose));
                entries.push((joint, stack.top()));
            }
            StackStep::Draw(_) => {}
            StackStep::Pop(_) => {
                stack.pop();
                entries.pop();
            }
        }
    }
    entries
}

/// How many steps have been done, and whether they go on by themselves.
#[derive(Clone, Debug, Default)]
pub(super) struct Stepper {
    pub done: usize,
    pub plays: bool,
    /// When the last step was done, in seconds of egui's clock.
    since: f64,
    /// The joint of that step.
    lit: Option<usize>,
}

impl Stepper {
    pub(super) fn lit(&self) -> Option<usize> {
        self.lit
    }

    /// Goes on by a step if one is due at the time `now`, and notes the joint of the last of
    /// `steps` that is done.
    pub(super) fn advance(&mut self, steps: &[StackStep], now: f64) {
        self.done = self.done.min(steps.len());
        if !self.plays {
            self.since = now;
        } else if now - self.since >= PACE {
            self.done = (self.done + 1).min(steps.len());
            self.since = now;
        }
        self.plays &= self.done < steps.len();
        let last = self.done.checked_sub(1).and_then(|last| steps.get(last));
        self.lit = last
            .map(|step| step.joint())
            .filter(|_| self.done < steps.len());
    }

    /// Seconds until the next step.
    pub(super) fn wait(&self, now: f64) -> Option<f64> {
        self.plays.then(|| (self.since + PACE - now).max(0.0))
    }
}

const DRAWN: Color32 = Color32::from_rgb(0x56, 0xb4, 0xe9);

/// Paints the joints that have been drawn, with lines to those that they hang on.
pub(super) fn paint_drawn(
    painter: &Painter,
    place: Place,
    session: &Session,
    explained: &Explained,
    stepper: &Stepper,
) {
    let Some(figure) = &explained.evaluated.geometry.figure else {
        return;
    };
    let screen = place.screen(session);
    let world = explained.evaluated.world_from_model;
    let at = |joint: usize| -> Option<Pos2> {
        let world = world.transform_point3(*figure.joints.get(joint)?);
        Some(place.position(screen.pixel(world)?))
    };
    let skeleton = explained.shape.character.skeleton();
    let steps = steps_of(skeleton);
    let done = &steps[..stepper.done.min(steps.len())];
    let drawn = done.iter().filter_map(|step| match step {
        StackStep::Draw(joint) => Some(*joint),
        _ => None,
    });
    for joint in drawn {
        let Some(own) = at(joint) else {
            continue;
        };
        if let Some(parent) = skeleton.joints()[joint].parent.and_then(at) {
            painter.line_segment([parent, own], Stroke::new(4.0, SHADE));
            painter.line_segment([parent, own], Stroke::new(2.0, DRAWN));
        }
        painter.circle_filled(own, 5.0, SHADE);
        painter.circle_filled(own, 3.5, DRAWN);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;
    use crate::math::Euler;
    use glam::Vec3;

    /// 0 → {1 → 2, 3}, all turned.
    fn posed() -> (SkeletalModel, Pose) {
        let parents = [None, Some(0), Some(1), Some(0)];
        let joints = parents.map(|parent| Joint {
            parent,
            offset: Vec3::new(0.5, 1.0, -0.25),
            ..Joint::default()
        });
        let mut pose = Pose::new();
        for joint in 0..4 {
            let degrees = Vec3::new(10.0, 20.0, 30.0) * (joint + 1) as f32;
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        (SkeletalModel::new(joints.to_vec()).unwrap(), pose)
    }

    #[test]
    fn each_joint_is_drawn_once_with_its_t_on_top_of_those_above_it() {
        let (skeleton, pose) = posed();
        let model_from_joint = skeleton.update_current_joint_to_world_transforms(&pose);
        let steps = steps_of(&skeleton);
        let mut drawn = Vec::new();
        for (index, step) in steps.iter().enumerate() {
            let stack = stack_after(&steps[..=index], &skeleton, &pose);
            if let StackStep::Draw(joint) = *step {
                drawn.push(joint);
                let mut path: Vec<usize> =
                    std::iter::successors(Some(joint), |&joint| skeleton.joints()[joint].parent)
                        .collect();
                path.reverse();
                let exact = path.iter().map(|&joint| (joint, model_from_joint[joint]));
                assert_eq!(stack, exact.collect::<Vec<_>>());
            }
        }
        assert_eq!(drawn, [0, 1, 2, 3]);
        assert_eq!(stack_after(&steps, &skeleton, &pose), []);
    }

    #[test]
    fn while_it_plays_a_step_is_done_whenever_one_is_due_and_it_stops_at_the_end() {
        let (skeleton, _) = posed();
        let steps = steps_of(&skeleton);
        let mut stepper = Stepper::default();
        stepper.advance(&steps, 5.0);
        assert_eq!((stepper.done, stepper.wait(5.0)), (0, None));
        stepper.plays = true;
        stepper.advance(&steps, 5.1);
        assert_eq!(stepper.done, 0);
        for step in 1..=steps.len() {
            stepper.advance(&steps, 5.0 + step as f64);
            assert_eq!(stepper.done, step);
            let joint = steps[step - 1].joint();
            assert_eq!(stepper.lit(), (step < steps.len()).then_some(joint));
        }
        assert!(!stepper.plays);
    }
}
