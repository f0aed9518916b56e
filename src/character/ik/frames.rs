use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use glam::{DMat3, DVec3, EulerRot};

/// Where a joint is and how it is turned, in model space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointFrame {
    pub rotation: DMat3,
    pub origin: DVec3,
}

impl JointFrame {
    /// The space of the character, in which its roots lie.
    pub const MODEL: Self = Self {
        rotation: DMat3::IDENTITY,
        origin: DVec3::ZERO,
    };

    /// The frame of a child of this one under `pose`.
    pub fn child(&self, skeleton: &SkeletalModel, pose: &Pose, joint: usize) -> Self {
        let offset =
            skeleton.joints()[joint].offset.as_dvec3() + pose.root_offset(joint).as_dvec3();
        Self {
            rotation: self.rotation * matrix(pose.rotation(joint)),
            origin: self.origin + self.rotation * offset,
        }
    }
}

/// `Rx · Ry · Rz`, more exactly than [`Euler::to_mat3`].
pub(super) fn matrix(euler: Euler) -> DMat3 {
    let [x, y, z] = euler.radians.as_dvec3().to_array();
    DMat3::from_euler(EulerRot::XYZ, x, y, z)
}

/// The frame of a joint; `None` stands for the parent of a root.
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
