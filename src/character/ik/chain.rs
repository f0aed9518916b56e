use super::links::{Links, arc, bend_normal, reach};
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use glam::{DMat3, DVec3, Vec3};
use std::collections::BTreeSet;

/// Chain of joints, each the parent of the next, that turn to move the end of the last one's bone
/// to a target. The first joint does not move.
#[derive(Clone, Debug, PartialEq)]
pub struct IkChain {
    joints: Vec<usize>,
    /// End of the chain, in the last joint's frame.
    tip: Vec3,
    /// Index of the joint at the end, if there is one.
    end: Option<usize>,
    /// Axis about which the chain bends, in the frame of its first joint: kept from the start of a
    /// gesture, since it cannot be found in a chain that has been pulled straight.
    bend_normal: DVec3,
}

impl IkChain {
    /// Chain with `joint` at its end: the `length` joints above it, or fewer if a root or a joint
    /// of `fixed`, which does not turn, comes first.
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

    /// Chain with the point `tip` in the frame of `joint` at its end: this joint and those above
    /// it, `length` in all, or fewer as in [`IkChain::to_joint`].
    ///
    /// `None` if there is no such joint, it is fixed, or no joint of the chain can move the point.
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

    /// Indices of the joints that turn, the one nearest to the root first.
    pub fn joints(&self) -> &[usize] {
        &self.joints
    }

    /// Index of the joint at the end, if there is one.
    pub fn end(&self) -> Option<usize> {
        self.end
    }

    /// Position of the end under `pose`, in model space.
    pub fn end_position(&self, skeleton: &SkeletalModel, pose: &Pose) -> Vec3 {
        let last = self.joints.last().copied();
        let last = frame(skeleton, pose, last);
        (last.origin + last.rotation * self.tip.as_dvec3()).as_vec3()
    }

    /// Vector from a joint of the chain, by its index in the chain, to the next one or to the end,
    /// in the joint's frame.
    fn bone(&self, skeleton: &SkeletalModel, place: usize) -> DVec3 {
        let next = self.joints.get(place + 1);
        let to = next.map_or(self.tip, |&joint| skeleton.joints()[joint].offset);
        to.as_dvec3()
    }

    /// Frame of the parent of the first joint.
    fn parent_frame(&self, skeleton: &SkeletalModel, pose: &Pose) -> JointFrame {
        let first = self.joints.first();
        let parent = first.and_then(|&joint| skeleton.joints()[joint].parent);
        frame(skeleton, pose, parent)
    }

    /// Links under `pose`, in model space; `None` if all have no length, or one is not finite.
    fn links(&self, skeleton: &SkeletalModel, pose: &Pose) -> Option<Links> {
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
        let normal = bend_normal(&self.links(skeleton, pose)?, front);
        let parent = self.parent_frame(skeleton, pose);
        let first = parent.child(skeleton, pose, self.joints[0]);
        let local = first.rotation.transpose() * normal;
        local.is_finite().then_some(local)
    }
}

/// Goal of a chain, in model space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IkGoal {
    /// Position for the end of the chain.
    pub target: Vec3,
    /// Direction in which the chain bends; without one it bends as it does.
    pub pole: Option<Vec3>,
    /// Whether the joint at the end keeps its orientation in model space, rather than following the
    /// chain, as a foot that stays flat. Without effect if the end is no joint.
    pub keep_orientation: bool,
}

impl IkGoal {
    /// Goal to reach `target`, without pole or orientation.
    pub fn to(target: Vec3) -> Self {
        Self {
            target,
            pole: None,
            keep_orientation: false,
        }
    }
}

/// Result of solving a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct IkSolution {
    /// Pose with the chain's joints turned; their angles are the nearest to those they had.
    pub pose: Pose,
    /// Distance of the end from the target, in model space.
    pub off: f32,
}

impl IkChain {
    /// Turns the joints of the chain, starting from `pose`, so that its end reaches the target, or
    /// points at it where it is out of reach.
    ///
    /// `None` if the goal or the pose is not finite.
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
        let normal = first.rotation * self.bend_normal;
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

/// Chain whose joints are turned one after the other, the first one first.
struct Turned<'a> {
    chain: &'a IkChain,
    skeleton: &'a SkeletalModel,
    pose: Pose,
    /// Frame of the parent of the next joint.
    at: JointFrame,
}

impl Turned<'_> {
    /// Goes on to the next joint without turning this one in its parent's frame.
    fn carry(&mut self, place: usize) {
        let joint = self.chain.joints()[place];
        self.at = self.at.child(self.skeleton, &self.pose, joint);
    }

    /// Turns a joint by `before`, and then by the shortest rotation that points its bone at
    /// `wanted`, which also corrects the rounding of the angles before it.
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

/// Turns `joint` so that its orientation is `rotation` in model space.
pub(super) fn orient(skeleton: &SkeletalModel, pose: &mut Pose, joint: usize, rotation: DMat3) {
    let parent = frame(skeleton, pose, skeleton.joints()[joint].parent);
    set(pose, joint, parent.rotation.transpose() * rotation);
}

/// Sets the rotation of `joint` in its parent's frame. If it already is `rotation`, its angles do
/// not change at all.
fn set(pose: &mut Pose, joint: usize, rotation: DMat3) {
    let shown = pose.rotation(joint);
    if !shown.to_dmat3().abs_diff_eq(rotation, 1e-9) {
        pose.set_joint_transform(joint, Euler::nearest(rotation.as_mat3(), shown));
    }
}

/// Position and orientation of a joint, in model space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointFrame {
    pub rotation: DMat3,
    pub origin: DVec3,
}

impl JointFrame {
    /// Frame of model space, in which the roots are.
    const MODEL: Self = Self {
        rotation: DMat3::IDENTITY,
        origin: DVec3::ZERO,
    };

    /// Frame of `joint`, a child of this one, under `pose`.
    fn child(&self, skeleton: &SkeletalModel, pose: &Pose, joint: usize) -> Self {
        let offset =
            skeleton.joints()[joint].offset.as_dvec3() + pose.root_offset(joint).as_dvec3();
        Self {
            rotation: self.rotation * pose.rotation(joint).to_dmat3(),
            origin: self.origin + self.rotation * offset,
        }
    }
}

/// Frame of a joint under `pose`; `None` stands for the parent of a root.
pub(super) fn frame(skeleton: &SkeletalModel, pose: &Pose, joint: Option<usize>) -> JointFrame {
    let parent = |&joint: &usize| skeleton.joints()[joint].parent;
    let mut ancestors: Vec<usize> = std::iter::successors(joint, parent).collect();
    ancestors.reverse();
    ancestors
        .into_iter()
        .fold(JointFrame::MODEL, |frame, joint| {
            frame.child(skeleton, pose, joint)
        })
}
