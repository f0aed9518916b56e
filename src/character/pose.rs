use super::{Joint, SkeletalModel};
use crate::math::Euler;
use glam::Vec3;
use std::collections::BTreeMap;

/// Pose of a character: rotations of its joints and translations of its roots, by joint index.
///
/// Setting a joint replaces what it had; nothing accumulates.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Pose {
    rotations: BTreeMap<usize, Euler>,
    root_offsets: BTreeMap<usize, Vec3>,
}

/// Reason why a pose does not fit a skeleton.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PoseError {
    /// No joint has this name or index.
    #[error("expected the name or index of a joint, found “{0}”")]
    NoSuchJoint(String),
    /// The joint is not a root, and only roots can be moved.
    #[error("expected a root joint, found “{0}”, which has a parent")]
    NotARoot(String),
}

impl Pose {
    /// The bind pose.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the rotation of `joint` to `Rx · Ry · Rz` in its parent's frame (assignment,
    /// "Sliders").
    #[doc(alias = "setJointTransform")]
    pub fn set_joint_transform(&mut self, joint: usize, rotation: Euler) {
        if rotation == Euler::ZERO {
            self.rotations.remove(&joint);
        } else {
            self.rotations.insert(joint, rotation);
        }
    }

    /// Rotation of `joint`; zero if it was never set.
    pub fn rotation(&self, joint: usize) -> Euler {
        self.rotations.get(&joint).copied().unwrap_or(Euler::ZERO)
    }

    /// Sets the translation of a root from its position at rest, in model space.
    pub fn set_root_offset(&mut self, root: usize, offset: Vec3) {
        if offset == Vec3::ZERO {
            self.root_offsets.remove(&root);
        } else {
            self.root_offsets.insert(root, offset);
        }
    }

    /// Estimated memory, in bytes.
    pub fn memory(&self) -> usize {
        /// Bytes of a node of a map, and the entries that it holds at least, but for the first.
        const NODE: usize = 16 + 11 * (size_of::<usize>() + size_of::<Euler>());
        const ENTRIES: usize = 5;
        let nodes = |entries: usize| entries.div_ceil(ENTRIES);
        let nodes = nodes(self.rotations.len()) + nodes(self.root_offsets.len());
        size_of::<Self>() + nodes * NODE
    }

    /// Translation of a root from its position at rest, in model space.
    pub fn root_offset(&self, joint: usize) -> Vec3 {
        self.root_offsets.get(&joint).copied().unwrap_or(Vec3::ZERO)
    }

    /// The same with what `other` has for these joints.
    pub fn with_joints_of(&self, other: &Self, joints: &[usize]) -> Self {
        let mut pose = self.clone();
        for &joint in joints {
            pose.set_joint_transform(joint, other.rotation(joint));
            pose.set_root_offset(joint, other.root_offset(joint));
        }
        pose
    }

    /// Whether `joint` differs from the bind pose.
    pub fn is_changed(&self, joint: usize) -> bool {
        self.rotations.contains_key(&joint) || self.root_offsets.contains_key(&joint)
    }

    /// Whether this is the bind pose.
    pub fn is_bind(&self) -> bool {
        self.rotations.is_empty() && self.root_offsets.is_empty()
    }

    /// Resets `joint` to rest.
    pub fn reset_joint(&mut self, joint: usize) {
        self.rotations.remove(&joint);
        self.root_offsets.remove(&joint);
    }

    /// Index of the joint that a pose file calls `name_or_index`: a name first, then a sid, then an
    /// index, also with `#` before it.
    ///
    /// # Errors
    /// If the skeleton has no such joint.
    pub fn find_joint(skeleton: &SkeletalModel, name_or_index: &str) -> Result<usize, PoseError> {
        let joints = skeleton.joints();
        let by_sid = |joint: &Joint| joint.sid.as_deref() == Some(name_or_index);
        joints
            .iter()
            .position(|joint| joint.name == name_or_index)
            .or_else(|| joints.iter().position(by_sid))
            .or_else(|| {
                name_or_index
                    .trim_start_matches('#')
                    .parse()
                    .ok()
                    .filter(|&index: &usize| index < joints.len())
            })
            .ok_or_else(|| PoseError::NoSuchJoint(name_or_index.to_owned()))
    }
}
