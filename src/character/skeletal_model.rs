use super::{Facing, Joint, Pose, WalkStep};
use crate::math::MatrixStack;
use glam::{Mat4, Vec3};

/// Skeleton: a forest of joints with the transforms of its rest pose, the bind pose.
///
/// It never changes: poses are kept separately, and the current transforms are computed from both,
/// so there is no order of calls to remember.
#[derive(Clone, Debug)]
pub struct SkeletalModel {
    joints: Vec<Joint>,
    roots: Vec<usize>,
    children: Vec<Vec<usize>>,
    bind_joint_from_model: Vec<Mat4>,
    facing: Facing,
}

/// Reason why a list of joints is not a skeleton. Joint numbers are indices into the list.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkeletonError {
    /// There are no joints.
    #[error("expected at least one joint, found none")]
    Empty,
    /// A parent does not exist.
    #[error("joint {joint}: expected a parent below {count}, found {parent}")]
    BadParent {
        /// Index of the joint that names it.
        joint: usize,
        /// Index that it names.
        parent: usize,
        /// Number of joints.
        count: usize,
    },
    /// A joint is its own ancestor.
    #[error("joint {joint}: expected a tree, found a joint that is its own ancestor")]
    Cycle {
        /// Index of the first joint on the cycle.
        joint: usize,
    },
}

impl SkeletonError {
    /// Index of the joint at fault, if there is one.
    pub fn joint(&self) -> Option<usize> {
        match *self {
            Self::Empty => None,
            Self::BadParent { joint, .. } | Self::Cycle { joint } => Some(joint),
        }
    }
}

impl SkeletalModel {
    /// Builds the skeleton and its bind transforms. Parents may come after their children.
    ///
    /// # Errors
    /// If there are no joints, a parent does not exist, or a joint is its own ancestor.
    pub fn new(joints: Vec<Joint>) -> Result<Self, SkeletonError> {
        let count = joints.len();
        if count == 0 {
            return Err(SkeletonError::Empty);
        }
        let mut roots = Vec::new();
        let mut children = vec![Vec::new(); count];
        for (joint, parent) in joints.iter().map(|joint| joint.parent).enumerate() {
            match parent {
                None => roots.push(joint),
                Some(parent) if parent < count => children[parent].push(joint),
                Some(parent) => {
                    return Err(SkeletonError::BadParent {
                        joint,
                        parent,
                        count,
                    });
                }
            }
        }
        let mut model = Self {
            joints,
            roots,
            children,
            bind_joint_from_model: Vec::new(),
            facing: Facing::default(),
        };
        if let Some(joint) = model.first_on_a_cycle() {
            return Err(SkeletonError::Cycle { joint });
        }
        model.compute_bind_world_to_joint_transforms();
        model.facing = Facing::of(&model);
        Ok(model)
    }

    /// Joints, in the order of the file.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Indices of the joints without a parent, in the order of the file.
    pub fn roots(&self) -> &[usize] {
        &self.roots
    }

    /// Indices of the children of `joint`, in the order of the file.
    pub fn children(&self, joint: usize) -> &[usize] {
        &self.children[joint]
    }

    /// Direction in which the character faces at rest.
    pub fn facing(&self) -> Facing {
        self.facing
    }

    /// B⁻¹ of every joint: from model space to the joint's frame in the bind pose (assignment,
    /// `bindWorldToJointTransform`).
    pub fn bind_joint_from_model(&self) -> &[Mat4] {
        &self.bind_joint_from_model
    }

    /// T of every joint under `pose`: from the joint's frame to model space (assignment,
    /// `currentJointToWorldTransform`). Joints that the pose does not mention are at rest.
    #[doc(alias = "updateCurrentJointToWorldTransforms")]
    pub fn update_current_joint_to_world_transforms(&self, pose: &Pose) -> Vec<Mat4> {
        self.by_recursion(|joint| self.parent_from_joint(joint, pose))
    }

    /// `T · B⁻¹` of every joint: from the bind pose to the current pose, both in model space. The
    /// identity in the bind pose.
    pub fn palette(&self, current_model_from_joint: &[Mat4]) -> Vec<Mat4> {
        current_model_from_joint
            .iter()
            .zip(&self.bind_joint_from_model)
            .map(|(model_from_joint, joint_from_bind)| *model_from_joint * *joint_from_bind)
            .collect()
    }

    /// Positions of all joints at rest, in model space.
    pub fn bind_positions(&self) -> Vec<Vec3> {
        self.by_recursion(|joint| Mat4::from_translation(self.joints[joint].offset))
            .iter()
            .map(|model_from_joint| model_from_joint.w_axis.truncate())
            .collect()
    }

    #[doc(alias = "computeBindWorldToJointTransforms")]
    fn compute_bind_world_to_joint_transforms(&mut self) {
        self.bind_joint_from_model = self
            .by_recursion(|joint| Mat4::from_translation(self.joints[joint].offset))
            .iter()
            .map(Mat4::inverse)
            .collect();
    }

    /// The transform of `joint` from its frame to its parent's under `pose`, or to model space for a
    /// root: its offset, then its rotation on the right of it.
    pub fn parent_from_joint(&self, joint: usize, pose: &Pose) -> Mat4 {
        let offset = self.joints[joint].offset + pose.root_offset(joint);
        Mat4::from_translation(offset) * pose.rotation(joint).to_mat4()
    }

    /// `model_from_joint` of every joint, by traversing the forest with a matrix stack.
    fn by_recursion(&self, parent_from_joint: impl Fn(usize) -> Mat4) -> Vec<Mat4> {
        let mut model_from_joint = vec![Mat4::IDENTITY; self.joints.len()];
        let mut stack = MatrixStack::new();
        for step in self.walk() {
            match step {
                WalkStep::Enter(joint) => {
                    stack.push(parent_from_joint(joint));
                    model_from_joint[joint] = stack.top();
                }
                WalkStep::Leave(_) => stack.pop(),
            }
        }
        model_from_joint
    }

    fn first_on_a_cycle(&self) -> Option<usize> {
        let mut reached = vec![false; self.joints.len()];
        let mut open = self.roots.clone();
        while let Some(joint) = open.pop() {
            reached[joint] = true;
            open.extend(&self.children[joint]);
        }
        // No root is above a joint that was not reached, so going up long enough ends on a cycle.
        let up = |joint: usize| self.joints[joint].parent.unwrap_or(joint);
        let unreached = reached.iter().position(|&reached| !reached)?;
        let on_cycle = (0..self.joints.len()).fold(unreached, |joint, _| up(joint));
        let mut first = on_cycle;
        let mut joint = up(on_cycle);
        while joint != on_cycle {
            first = first.min(joint);
            joint = up(joint);
        }
        Some(first)
    }
}
