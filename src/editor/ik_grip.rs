use super::{Screen, Session};
use crate::character::ik::IkChain;
use crate::character::{JointBone, SkeletalModel};
use crate::scene::{BoneHit, ShapeId};
use glam::Vec3;

/// Distance between the end of a bone and a child, relative to the bone's length, up to which the
/// bone ends at the child: files round lengths of bones and positions of joints separately.
const SAME_PLACE: f32 = 0.05;

/// Length of a finger's bone on the screen, in pixels, below which the wrist is grabbed instead,
/// since fingers cannot be told apart; and that of the palm, which is about twice as long.
const TINY: f32 = 20.0;
const TINY_PALM: f32 = 2.0 * TINY;

/// Least length of the bone that leads to a wrist, relative to the longest bone of the hand.
const FOREARM: f32 = 2.0;

/// Part of a character that is moved by inverse kinematics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IkGrip {
    /// Joint; a root moves with everything below it.
    Joint(usize),
    /// End of a bone at which there is no joint.
    Tip {
        /// Index of the joint that turns the bone.
        joint: usize,
        /// End of the bone, in the joint's frame.
        tip: Vec3,
    },
}

impl IkGrip {
    /// Grip of a bone that was hit: the nearer of its ends; or the wrist above it if the bone is
    /// tiny on `screen`. Of joints in one place, one above the other, it is the uppermost, which
    /// moves them all.
    pub fn of(session: &Session, hit: &BoneHit, screen: &Screen) -> Option<Self> {
        let character = &session.scene().character(hit.shape)?.character;
        let shape = session.evaluated().shape(hit.shape)?;
        let frames = &shape.geometry.figure.as_ref()?.model_from_joint;
        let bone = character.bones().get(hit.bone)?;
        let (start, end) = bone.ends(frames)?;
        let place = |at: Vec3| shape.world_from_model.transform_point3(at);
        let skeleton = character.skeleton();
        let length = place(start).distance(place(end));
        if let Some(wrist) = wrist(skeleton, bone) {
            let tiny = if wrist == bone.joint { TINY_PALM } else { TINY };
            if length / screen.world_per_pixel(place(start))? < tiny {
                return Some(Self::Joint(wrist));
            }
        }
        if hit.point.distance(place(start)) < hit.point.distance(place(end)) {
            return Some(Self::Joint(uppermost(skeleton, bone.joint)));
        }
        let mut children = skeleton.children(bone.joint).iter();
        let near = SAME_PLACE * bone.tip.length();
        let ends = |&&child: &&usize| {
            let offset = skeleton.joints()[child].offset;
            offset.distance(bone.tip) <= near
        };
        Some(match children.find(ends) {
            Some(&child) => Self::Joint(child),
            None => Self::Tip {
                joint: bone.joint,
                tip: bone.tip,
            },
        })
    }

    /// Index of the joint, or of the joint that turns the bone.
    pub fn joint(self) -> usize {
        match self {
            Self::Joint(joint) | Self::Tip { joint, .. } => joint,
        }
    }

    /// Position in the world.
    pub fn place(self, session: &Session, shape: ShapeId) -> Option<Vec3> {
        let evaluated = session.evaluated().shape(shape)?;
        let figure = evaluated.geometry.figure.as_ref()?;
        let frame = figure.model_from_joint.get(self.joint())?;
        let in_model = match self {
            Self::Joint(_) => frame.w_axis.truncate(),
            Self::Tip { tip, .. } => frame.transform_point3(tip),
        };
        Some(evaluated.world_from_model.transform_point3(in_model))
    }

    /// Chain that moves the grip; `None` for a root, and if no joint above it can turn, as below a
    /// pin.
    pub fn chain(self, session: &Session, shape: ShapeId) -> Option<IkChain> {
        let character = session.scene().character(shape)?;
        let (skeleton, pose) = (character.character.skeleton(), character.pose());
        let (length, pins) = (character.ik.length, &character.ik.pins);
        match self {
            Self::Joint(joint) => IkChain::to_joint(skeleton, pose, joint, length, pins),
            Self::Tip { joint, tip } => IkChain::to_point(skeleton, pose, joint, tip, length, pins),
        }
    }
}

/// Index of the uppermost of the joints that are in the same place as `joint`.
fn uppermost(skeleton: &SkeletalModel, joint: usize) -> usize {
    let joints = skeleton.joints();
    let same = |&joint: &usize| {
        joints[joint]
            .parent
            .filter(|_| joints[joint].offset == Vec3::ZERO)
    };
    std::iter::successors(Some(joint), same)
        .last()
        .unwrap_or(joint)
}

/// Index of the wrist above `bone`, or of the ankle above toes: a joint whose branches are much
/// shorter than the bone that leads to it.
fn wrist(skeleton: &SkeletalModel, bone: &JointBone) -> Option<usize> {
    let joints = skeleton.joints();
    let mut longest = bone.tip.length();
    let mut joint = bone.joint;
    loop {
        let parent = joints[joint].parent?;
        let leading = joints[joint].offset.length();
        let branches = skeleton.children(joint).len() > 1;
        if branches && leading >= FOREARM * longest {
            return Some(joint);
        }
        longest = longest.max(leading);
        joint = parent;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;

    fn skeleton(joints: &[(Option<usize>, [f32; 3])]) -> SkeletalModel {
        let joints = joints.iter().map(|&(parent, offset)| Joint {
            parent,
            offset: offset.into(),
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).unwrap()
    }

    fn bone(joint: usize, tip: [f32; 3]) -> JointBone {
        let tip = tip.into();
        JointBone { joint, tip }
    }

    /// A trunk with two arms; the first has a hand with two fingers.
    fn body() -> SkeletalModel {
        skeleton(&[
            (None, [0.0, 1.0, 0.0]),
            (Some(0), [0.0, 0.5, 0.0]),
            (Some(1), [0.2, 0.0, 0.0]),
            (Some(2), [0.3, 0.0, 0.0]),
            (Some(3), [0.25, 0.0, 0.0]),
            (Some(4), [0.1, 0.0, 0.02]),
            (Some(5), [0.04, 0.0, 0.0]),
            (Some(4), [0.1, 0.0, -0.02]),
            (Some(1), [-0.2, 0.0, 0.0]),
            (Some(8), [-0.3, 0.0, 0.0]),
        ])
    }

    #[test]
    fn palm_and_fingers_hang_on_the_wrist() {
        let body = body();
        for part in [
            bone(4, [0.1, 0.0, 0.02]),
            bone(5, [0.04, 0.0, 0.0]),
            bone(6, [0.03, 0.0, 0.0]),
            bone(7, [0.04, 0.0, 0.0]),
        ] {
            assert_eq!(wrist(&body, &part), Some(4), "{part:?}");
        }
    }

    #[test]
    fn arms_do_not_hang_on_the_chest_as_fingers_do_nor_a_tail_on_anything() {
        let body = body();
        for arm in [
            bone(3, [0.25, 0.0, 0.0]),
            bone(2, [0.3, 0.0, 0.0]),
            bone(9, [-0.3, 0.0, 0.0]),
        ] {
            assert_eq!(wrist(&body, &arm), None, "{arm:?}");
        }
        let tail: Vec<_> = (0..9_usize)
            .map(|joint| (joint.checked_sub(1), [0.0, 0.1, 0.0]))
            .collect();
        assert_eq!(wrist(&skeleton(&tail), &bone(8, [0.0, 0.1, 0.0])), None);
    }
}
