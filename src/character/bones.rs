use super::{Attachments, SkeletalModel};
use crate::geometry::cuboid_from_unit;
use glam::{Mat4, Vec3};

/// Joints and bones of a skeleton in one pose, for drawing and picking (assignment, "Stick
/// figure").
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StickFigure {
    /// Position of each joint, in model space, by joint index.
    pub joints: Vec<Vec3>,
    /// Matrices from each joint's frame to model space, by joint index.
    pub model_from_joint: Vec<Mat4>,
    /// The bones, ordered by the joint at their far end.
    pub bones: Vec<Bone>,
}

/// Bone of a stick figure: the segment between a joint and its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// Index of the joint that turns the bone, at the near end.
    pub joint: usize,
    /// Index of the joint at the far end.
    pub child: usize,
    /// Near end, in model space.
    pub start: Vec3,
    /// Far end, in model space.
    pub end: Vec3,
}

impl Bone {
    /// Transform that places a unit cuboid on the bone, see [`cuboid_from_unit`]; `None` at zero
    /// length.
    pub fn model_from_unit(&self, half_width: f32) -> Option<Mat4> {
        cuboid_from_unit(self.start, self.end, half_width)
    }
}

impl StickFigure {
    /// Figure of `skeleton` with the joints' frames at `model_from_joint`, one per joint.
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

/// Length of a bone by that of what it moves below which it is a stub.
const STUB: f32 = 0.125;

/// Weight above which a joint dominates a vertex.
const DOMINANT: f32 = 0.5;

/// Bone that can be grabbed: from a joint to a point that is fixed to the joint's frame.
///
/// Unlike the bones of a [`StickFigure`], which run from joint to joint, these reach to the ends of
/// head, hands and feet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointBone {
    /// Index of the joint that turns the bone.
    pub joint: usize,
    /// End of the bone, in the joint's frame; never zero.
    pub tip: Vec3,
}

impl JointBone {
    /// Both ends in model space, with the joints' frames at `model_from_joint`, one per joint.
    pub fn ends(&self, model_from_joint: &[Mat4]) -> Option<(Vec3, Vec3)> {
        let joint = model_from_joint.get(self.joint)?;
        Some((joint.w_axis.truncate(), joint.transform_point3(self.tip)))
    }
}

/// Bones of a character, ordered by joint: if the file gives the length of a joint's bone, that
/// one, or at a joint without children one that can be grabbed; otherwise one to each child that is
/// not at the same place; and for a joint without children one as far as the vertices reach that it
/// dominates.
pub(super) fn bones(
    skeleton: &SkeletalModel,
    attachments: &Attachments,
    positions: &[Vec3],
) -> Vec<JointBone> {
    let reach = leaf_tips(skeleton, attachments, positions);
    let mut bones = Vec::new();
    for (joint, described) in skeleton.joints().iter().enumerate() {
        let children = skeleton.children(joint);
        let tips: Vec<Vec3> = match (described.tip, children.is_empty()) {
            (Some(tip), true) => vec![no_stub(tip, reach[joint])],
            (Some(tip), false) => vec![tip],
            (None, true) => vec![reach[joint]],
            (None, false) => children
                .iter()
                .map(|&child| skeleton.joints()[child].offset)
                .collect(),
        };
        let long = tips
            .into_iter()
            .filter(|tip| tip.is_finite() && *tip != Vec3::ZERO);
        bones.extend(long.map(|tip| JointBone { joint, tip }));
    }
    bones
}

/// `tip`, or the end of a bone in its direction that `reach` is as long as, if it is a stub beside that: such a bone
/// hides in its joint, and the head that it moves could be grabbed nowhere.
fn no_stub(tip: Vec3, reach: Vec3) -> Vec3 {
    let along = tip.normalize_or_zero();
    let far = reach.dot(along);
    if tip.length() < STUB * far {
        along * far
    } else {
        tip
    }
}

/// Tips of the bones of all joints without children: the farthest extent of the vertices that the
/// joint dominates, along their mean direction. Zero where it dominates none.
fn leaf_tips(skeleton: &SkeletalModel, attachments: &Attachments, positions: &[Vec3]) -> Vec<Vec3> {
    let at = skeleton.bind_positions();
    let followers = || {
        let vertices = attachments.vertices().zip(positions);
        vertices.filter_map(|(influences, &position)| {
            let most = influences.iter().find(|i| i.weight > DOMINANT)?;
            let joint = most.joint as usize;
            let is_leaf = joint < at.len() && skeleton.children(joint).is_empty();
            is_leaf.then(|| (joint, position - at[joint]))
        })
    };
    let mut sums = vec![Vec3::ZERO; at.len()];
    for (joint, offset) in followers() {
        sums[joint] += offset;
    }
    let directions: Vec<Vec3> = sums.iter().map(|sum| sum.normalize_or_zero()).collect();
    let mut farthest = vec![0.0_f32; at.len()];
    for (joint, offset) in followers() {
        farthest[joint] = farthest[joint].max(offset.dot(directions[joint]));
    }
    let tips = directions.iter().zip(farthest);
    tips.map(|(&direction, far)| direction * far).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Character, Influence, Joint};
    use crate::geometry::Mesh;

    fn joint(parent: Option<usize>, offset: [f32; 3], tip: Option<Vec3>) -> Joint {
        Joint {
            parent,
            offset: offset.into(),
            tip,
            ..Joint::default()
        }
    }

    fn character(joints: Vec<Joint>, vertices: &[([f32; 3], u32, f32)]) -> Character {
        let mut attachments = Attachments::new();
        for &(_, joint, weight) in vertices {
            attachments.push_vertex([Influence { joint, weight }]);
        }
        let positions = vertices.iter().map(|(at, ..)| Vec3::from(*at)).collect();
        let skeleton = SkeletalModel::new(joints).unwrap();
        Character::new(skeleton, attachments, Mesh::new(positions, Vec::new())).unwrap()
    }

    #[test]
    fn there_is_a_bone_to_every_child_that_lies_elsewhere() {
        let joints = vec![
            joint(None, [1.0, 0.0, 0.0], None),
            joint(Some(0), [0.0, 0.0, 0.0], None),
            joint(Some(0), [0.0, 2.0, 0.0], None),
            joint(Some(0), [0.0, 0.0, 3.0], None),
        ];
        let bones = character(joints, &[]).bones().to_vec();
        let tips: Vec<_> = bones.iter().map(|bone| (bone.joint, bone.tip)).collect();
        assert_eq!(tips, [(0, Vec3::Y * 2.0), (0, Vec3::Z * 3.0)]);
    }

    #[test]
    fn a_leafs_bone_reaches_as_far_as_the_vertices_that_follow_it() {
        let joints = vec![
            joint(None, [0.0, 1.0, 0.0], None),
            joint(Some(0), [0.0, 1.0, 0.0], None),
        ];
        let vertices = [
            ([-1.0, 3.0, 0.0], 1, 1.0),
            ([1.0, 3.0, 0.0], 1, 0.6),
            ([0.0, 4.5, 0.0], 1, 0.9),
            ([0.0, 9.0, 0.0], 1, 0.5),
            ([0.0, 9.0, 0.0], 0, 1.0),
        ];
        let bones = character(joints, &vertices).bones().to_vec();
        assert_eq!(bones.len(), 2);
        assert_eq!((bones[0].joint, bones[0].tip), (0, Vec3::Y));
        assert_eq!(bones[1].joint, 1);
        assert!(bones[1].tip.abs_diff_eq(Vec3::Y * 2.5, 1e-6), "{bones:?}");
    }

    #[test]
    fn a_length_from_the_file_comes_before_children_and_vertices() {
        let joints = vec![
            joint(None, [0.0; 3], Some(Vec3::Y * 0.5)),
            joint(Some(0), [0.0, 2.0, 0.0], Some(Vec3::X)),
        ];
        let bones = character(joints, &[([5.0, 5.0, 5.0], 1, 1.0)])
            .bones()
            .to_vec();
        let tips: Vec<_> = bones.iter().map(|bone| (bone.joint, bone.tip)).collect();
        assert_eq!(tips, [(0, Vec3::Y * 0.5), (1, Vec3::X)]);
    }

    #[test]
    fn a_stub_at_a_leaf_reaches_as_far_as_what_it_moves_so_that_it_can_be_grabbed() {
        let tip_of = |tip: Vec3| {
            let joints = vec![
                joint(None, [0.0; 3], None),
                joint(Some(0), [0.0, 1.0, 0.0], Some(tip)),
            ];
            let head = [([0.5, 3.0, 0.0], 1, 1.0), ([-0.5, 3.0, 0.0], 1, 1.0)];
            character(joints, &head).bones()[1].tip
        };
        assert!(tip_of(Vec3::Y * 0.2).abs_diff_eq(Vec3::Y * 2.0, 1e-6));
        for long_or_elsewhere in [Vec3::Y * 0.3, Vec3::X * 0.2, Vec3::Y * -0.2] {
            assert_eq!(tip_of(long_or_elsewhere), long_or_elsewhere);
        }
    }

    #[test]
    fn a_leaf_that_moves_nothing_has_no_bone() {
        let joints = vec![
            joint(None, [0.0; 3], None),
            joint(Some(0), [0.0, 2.0, 0.0], None),
        ];
        assert_eq!(character(joints, &[]).bones().len(), 1);
    }
}
