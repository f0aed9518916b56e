use super::SkeletalModel;
use crate::geometry::cuboid_from_unit;
use glam::{Mat4, Vec3};

/// A skeleton's joints and bones as they stand in one pose, for drawing and picking
/// (assignment, "Stick figure").
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StickFigure {
    /// Position of each joint, in model space, by joint index.
    pub joints: Vec<Vec3>,
    /// From each joint's frame to model space, by joint index.
    pub model_from_joint: Vec<Mat4>,
    /// The bones, ordered by the joint at their far end.
    pub bones: Vec<Bone>,
}

/// The piece of a skeleton between a joint and its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// The joint that turns the bone: the near end's.
    pub joint: usize,
    /// The joint at the far end.
    pub child: usize,
    /// Near end, in model space.
    pub start: Vec3,
    /// Far end, in model space.
    pub end: Vec3,
}

impl Bone {
    /// Places a unit cuboid on the bone, see [`cuboid_from_unit`]; `None` at zero length.
    pub fn model_from_unit(&self, half_width: f32) -> Option<Mat4> {
        cuboid_from_unit(self.start, self.end, half_width)
    }
}

impl StickFigure {
    /// The figure of `skeleton` whose joints stand at `model_from_joint`, one a joint.
    pub fn new(skeleton: &SkeletalModel, model_from_joint: &[Mat4]) -> Self {
        let joints: Vec<Vec3> = model_from_joint
            .iter()
            .map(|matrix| matrix.w_axis.truncate())
            .collect();
        let bones = skeleton
            .joints()
            .iter()
            .enumerate()
            .filter_map(|(child, joint)| {
                let parent = joint.parent?;
                Some(Bone {
                    joint: parent,
                    child,
                    start: joints[parent],
                    end: joints[child],
                })
            })
            .collect();
        Self {
            joints,
            model_from_joint: model_from_joint.to_vec(),
            bones,
        }
    }
}
