use super::IkChain;
use super::bend::arc;
use super::frames::{JointFrame, frame, matrix};
use super::reach::reach;
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use glam::{DMat3, DVec3, Vec3};

/// What a chain is to do, in the character's model space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IkGoal {
    /// Where its end is wanted.
    pub target: Vec3,
    /// The direction that it bends to; without one it bends as it does.
    pub pole: Option<Vec3>,
    /// Whether the joint at its end stays turned in space as it is, rather than following the
    /// chain: a foot that stays flat. Nothing else than a joint can.
    pub keep_orientation: bool,
}

impl IkGoal {
    /// To get to `target`, and no more.
    pub fn to(target: Vec3) -> Self {
        Self {
            target,
            pole: None,
            keep_orientation: false,
        }
    }
}

/// What came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct IkSolution {
    /// The pose with the chain's joints turned; their angles are the nearest to those they had.
    pub pose: Pose,
    /// How far the end is from the target.
    pub off: f32,
}

impl IkChain {
    /// Turns the joints of the chain from how `pose` has them so that its end gets to the target;
    /// towards it, as far as they can, where it is out of reach.
    ///
    /// `None` if the goal is not finite, or the pose.
    pub fn solve(
        &self,
        skeleton: &SkeletalModel,
        pose: &Pose,
        goal: &IkGoal,
    ) -> Option<IkSolution> {
        if !goal.target.is_finite() {
            return None;
        }
        let parent = self.parent_frame(skeleton, pose);
        let first = parent.child(skeleton, pose, *self.joints().first()?);
        let links = self.links(skeleton, pose)?;
        let target = goal.target.as_dvec3() - first.origin;
        let pole = goal.pole.map(|pole| pole.as_dvec3());
        let pole = pole.filter(|pole| pole.is_finite());
        let normal = first.rotation * self.bend_normal();
        let reached = reach(&links, target, pole, normal);

        let mut turned = Turned {
            chain: self,
            skeleton,
            pose: pose.clone(),
            at: parent,
        };
        let mut wanted = first.origin;
        let mut next = 0;
        for place in 0..self.joints().len() {
            if links.places.get(next) != Some(&place) {
                turned.carry(place);
                continue;
            }
            wanted += links.lengths[next] * reached.directions[next];
            let before = if next == 0 {
                DMat3::from_quat(reached.turn)
            } else {
                DMat3::IDENTITY
            };
            turned.turn(place, before, wanted, normal);
            next += 1;
        }
        if let Some(end) = self.end().filter(|_| goal.keep_orientation) {
            let before = frame(skeleton, pose, Some(end));
            orient(skeleton, &mut turned.pose, end, before.rotation);
        }
        let end = self.end_position(skeleton, &turned.pose).as_dvec3();
        let off = end.distance(goal.target.as_dvec3()) as f32;
        off.is_finite().then_some(IkSolution {
            pose: turned.pose,
            off,
        })
    }
}

/// A chain on its way from one pose to another, from the first joint on.
struct Turned<'a> {
    chain: &'a IkChain,
    skeleton: &'a SkeletalModel,
    pose: Pose,
    /// The frame of the joint before.
    at: JointFrame,
}

impl Turned<'_> {
    /// Leaves a joint as it is in its parent's frame.
    fn carry(&mut self, place: usize) {
        let joint = self.chain.joints()[place];
        self.at = self.at.child(self.skeleton, &self.pose, joint);
    }

    /// Turns a joint by `before`, and then the shortest way so that its bone ends as near to
    /// `wanted` as it can. What was rounded in the angles before is made up for here.
    fn turn(&mut self, place: usize, before: DMat3, wanted: DVec3, normal: DVec3) {
        let joint = self.chain.joints()[place];
        let now = self.at.child(self.skeleton, &self.pose, joint);
        let rotation = before * now.rotation;
        let bone = rotation * self.chain.bone(self.skeleton, place);
        let to = (wanted - now.origin).try_normalize();
        let swing = match (bone.try_normalize(), to) {
            (Some(from), Some(to)) => DMat3::from_quat(arc(from, to, normal)),
            _ => DMat3::IDENTITY,
        };
        let in_parent = self.at.rotation.transpose() * swing * rotation;
        set(&mut self.pose, joint, in_parent);
        self.carry(place);
    }
}

/// Turns `joint` so that its frame is `rotation` in model space.
pub(super) fn orient(skeleton: &SkeletalModel, pose: &mut Pose, joint: usize, rotation: DMat3) {
    let parent = frame(skeleton, pose, skeleton.joints()[joint].parent);
    set(pose, joint, parent.rotation.transpose() * rotation);
}

/// Turns `joint` to `rotation` of its parent's frame. What already is as wanted keeps its angles
/// to the last digit.
fn set(pose: &mut Pose, joint: usize, rotation: DMat3) {
    let shown = pose.rotation(joint);
    if !matrix(shown).abs_diff_eq(rotation, 1e-9) {
        pose.set_joint_transform(joint, Euler::nearest(rotation.as_mat3(), shown));
    }
}
