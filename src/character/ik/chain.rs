use super::bend;
use super::frames::{JointFrame, frame};
use super::links::Links;
use crate::character::{Pose, SkeletalModel};
use glam::{DVec3, Vec3};
use std::collections::BTreeSet;

/// Joints in a row, each the parent of the next, that turn to bring the end of the last one's
/// bone to a target. The first one stays where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct IkChain {
    joints: Vec<usize>,
    /// From the last joint to the end, in the last joint's frame.
    tip: Vec3,
    /// The joint that is the end, if one is.
    end: Option<usize>,
    /// About which the chain bends, in the frame of its first joint: remembered from the start of
    /// a gesture, for a chain that has been pulled straight does not show it any more.
    bend_normal: DVec3,
}

impl IkChain {
    /// The chain that brings `joint` itself to a target: the `length` joints above it, or fewer
    /// where a root or a joint of `fixed` comes before; what is fixed does not turn.
    ///
    /// `None` if there is no such joint, or no joint above it that can move it.
    pub fn to_joint(
        skeleton: &SkeletalModel,
        pose: &Pose,
        joint: usize,
        length: usize,
        fixed: &BTreeSet<usize>,
    ) -> Option<Self> {
        let described = skeleton.joints().get(joint)?;
        let last = described.parent.filter(|parent| !fixed.contains(parent))?;
        let mut chain = Self::with_end(skeleton, pose, last, described.offset, length, fixed)?;
        chain.end = Some(joint);
        Some(chain)
    }

    /// The chain that brings a point to a target which is fixed to the frame of `joint`, there at
    /// `tip`: this joint and those above it, `length` together, or fewer as in
    /// [`IkChain::to_joint`].
    ///
    /// `None` if there is no such joint, it is fixed, or none of the chain can move the point.
    pub fn to_point(
        skeleton: &SkeletalModel,
        pose: &Pose,
        joint: usize,
        tip: Vec3,
        length: usize,
        fixed: &BTreeSet<usize>,
    ) -> Option<Self> {
        let exists = joint < skeleton.joints().len() && !fixed.contains(&joint);
        exists.then(|| Self::with_end(skeleton, pose, joint, tip, length, fixed))?
    }

    fn with_end(
        skeleton: &SkeletalModel,
        pose: &Pose,
        last: usize,
        tip: Vec3,
        length: usize,
        fixed: &BTreeSet<usize>,
    ) -> Option<Self> {
        let above = |&joint: &usize| {
            let parent = skeleton.joints()[joint].parent;
            parent.filter(|parent| !fixed.contains(parent))
        };
        let mut joints: Vec<usize> = std::iter::successors(Some(last), above)
            .take(length.max(1))
            .collect();
        joints.reverse();
        let mut chain = Self {
            joints,
            tip,
            end: None,
            bend_normal: DVec3::ZERO,
        };
        chain.bend_normal = chain.find_bend_normal(skeleton, pose)?;
        Some(chain)
    }

    /// The joints that turn, the one nearest to the root first.
    pub fn joints(&self) -> &[usize] {
        &self.joints
    }

    /// The joint that is brought to the target, if it is a joint.
    pub fn end(&self) -> Option<usize> {
        self.end
    }

    /// Where the end is under `pose`, in model space.
    pub fn end_position(&self, skeleton: &SkeletalModel, pose: &Pose) -> Vec3 {
        let last = self.joints.last().copied();
        let last = frame(skeleton, pose, last);
        (last.origin + last.rotation * self.tip.as_dvec3()).as_vec3()
    }

    /// From a joint of the chain (by its place in the chain) to the next one or to the end, in
    /// the joint's frame.
    pub(super) fn bone(&self, skeleton: &SkeletalModel, place: usize) -> DVec3 {
        let next = self.joints.get(place + 1);
        let to = next.map_or(self.tip, |&joint| skeleton.joints()[joint].offset);
        to.as_dvec3()
    }

    /// See the field.
    pub(super) fn bend_normal(&self) -> DVec3 {
        self.bend_normal
    }

    /// The frame that the chain hangs on.
    pub(super) fn parent_frame(&self, skeleton: &SkeletalModel, pose: &Pose) -> JointFrame {
        let first = self.joints.first();
        let parent = first.and_then(|&joint| skeleton.joints()[joint].parent);
        frame(skeleton, pose, parent)
    }

    /// The links as they lie under `pose`; `None` if all are of no length, or one is not finite.
    pub(super) fn links(&self, skeleton: &SkeletalModel, pose: &Pose) -> Option<Links> {
        let mut at = self.parent_frame(skeleton, pose);
        let joints = self.joints.iter().enumerate();
        let bones = joints.map(|(place, &joint)| {
            at = at.child(skeleton, pose, joint);
            at.rotation * self.bone(skeleton, place)
        });
        let links = Links::new(&bones.collect::<Vec<_>>());
        links.is_sound().then_some(links)
    }

    fn find_bend_normal(&self, skeleton: &SkeletalModel, pose: &Pose) -> Option<DVec3> {
        let front = skeleton.facing().front().as_dvec3();
        let normal = bend::normal(&self.links(skeleton, pose)?, front);
        let parent = self.parent_frame(skeleton, pose);
        let first = parent.child(skeleton, pose, self.joints[0]);
        let local = first.rotation.transpose() * normal;
        local.is_finite().then_some(local)
    }
}
