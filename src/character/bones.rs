use super::{Attachments, Character, SkeletalModel};
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
    /// The bones: those between joints, ordered by the joint at their far end; then those of lone joints.
    pub bones: Vec<Bone>,
}

/// Bone of a stick figure: the segment between a joint and its parent, or that from a lone joint to its tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// Index of the joint that turns the bone, at the near end.
    pub joint: usize,
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
        let between = (skeleton.joints().iter().zip(&joints)).filter_map(|(joint, &end)| {
            let parent = joint.parent?;
            Some(Bone {
                joint: parent,
                start: joints[parent],
                end,
            })
        });
        Self {
            bones: between.collect(),
            model_from_joint: model_from_joint.to_vec(),
            joints,
        }
    }

    /// The same with the bones of `character` by which joints are grabbed that have neither parent nor children. In the
    /// assignment these have none, and a skeleton of such joints is nothing but a few points.
    pub fn with_lone_joints(mut self, character: &Character) -> Self {
        let skeleton = character.skeleton();
        let is_lone = |joint: usize| {
            skeleton.joints()[joint].parent.is_none() && skeleton.children(joint).is_empty()
        };
        let lone = character.bones().iter().filter(|bone| is_lone(bone.joint));
        let model_from_joint = &self.model_from_joint;
        self.bones.extend(lone.filter_map(|bone| {
            let (start, end) = bone.ends(model_from_joint)?;
            Some(Bone {
                joint: bone.joint,
                start,
                end,
            })
        }));
        self
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
/// one, or one that can be grabbed if it is a stub; otherwise one to each child that is
/// not at the same place; and for a joint without children one as far as the vertices reach that it
/// dominates.
pub(super) fn bones(
    skeleton: &SkeletalModel,
    attachments: &Attachments,
    positions: &[Vec3],
) -> Vec<JointBone> {
    let reach = reach_of_vertices(skeleton, attachments, positions);
    let mut bones = Vec::new();
    for (joint, described) in skeleton.joints().iter().enumerate() {
        let children = skeleton.children(joint);
        let tips: Vec<Vec3> = match (described.tip, children.is_empty()) {
            (Some(tip), _) => vec![no_stub(tip, reach[joint])],
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

/// How far the vertices reach that each joint dominates, along their mean direction, by joint. Zero where it dominates
/// none.
fn reach_of_vertices(
    skeleton: &SkeletalModel,
    attachments: &Attachments,
    positions: &[Vec3],
) -> Vec<Vec3> {
    let at = skeleton.bind_positions();
    let followers = || {
        let vertices = attachments.vertices().zip(positions);
        vertices.filter_map(|(influences, &position)| {
            let most = influences.iter().find(|i| i.weight > DOMINANT)?;
            let joint = most.joint as usize;
            (joint < at.len()).then(|| (joint, position - at[joint]))
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
    use crate::character::{Influence, Joint};
    use crate::geometry::Mesh;
    use glam::vec3;

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
    fn a_stub_reaches_as_far_as_what_it_moves_so_that_it_can_be_grabbed() {
        // A head, without and with an eye that hangs on it.
        for eyes in [0, 1] {
            let tip_of = |tip: Vec3| {
                let mut joints = vec![
                    joint(None, [0.0; 3], None),
                    joint(Some(0), [0.0, 1.0, 0.0], Some(tip)),
                ];
                joints.extend(vec![joint(Some(1), [0.0, 0.5, 0.5], None); eyes]);
                let head = [([0.5, 3.0, 0.0], 1, 1.0), ([-0.5, 3.0, 0.0], 1, 1.0)];
                character(joints, &head).bones()[1].tip
            };
            assert!(tip_of(Vec3::Y * 0.2).abs_diff_eq(Vec3::Y * 2.0, 1e-6));
            for long_or_elsewhere in [Vec3::Y * 0.3, Vec3::X * 0.2, Vec3::Y * -0.2] {
                assert_eq!(tip_of(long_or_elsewhere), long_or_elsewhere);
            }
        }
    }

    #[test]
    fn a_lone_joint_is_drawn_with_the_bone_that_it_is_grabbed_by_and_others_only_with_those_between_joints()
     {
        let drawn = |joints: Vec<Joint>| {
            let character = character(joints, &[([1.0, 3.0, 0.0], 0, 1.0)]);
            let frames = [
                Mat4::from_translation(Vec3::X),
                Mat4::from_translation(Vec3::Y),
            ];
            let skeleton = character.skeleton();
            let frames = &frames[..skeleton.joints().len()];
            let figure = StickFigure::new(skeleton, frames).with_lone_joints(&character);
            let bones = figure.bones.iter();
            let bones: Vec<_> = bones
                .map(|bone| (bone.joint, bone.start, bone.end))
                .collect();
            bones
        };
        let lone = || joint(None, [1.0, 0.0, 0.0], None);
        let to_its_vertex = (0, Vec3::X, vec3(1.0, 3.0, 0.0));
        assert_eq!(drawn(vec![lone()]), [to_its_vertex]);
        assert_eq!(drawn(vec![lone(), lone()]), [to_its_vertex]);
        assert_eq!(
            drawn(vec![lone(), joint(Some(0), [0.0; 3], Some(Vec3::Z))]),
            [(0, Vec3::X, Vec3::Y)]
        );
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
