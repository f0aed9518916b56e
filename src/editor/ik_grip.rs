use super::limbs::{STUB, ankle_above, is_end_of_limb, is_fork, root_at_hips, uppermost, wrist};
use super::{Screen, Session};
use crate::character::SkeletalModel;
use crate::character::ik::IkChain;
use crate::scene::{BoneHit, IkSettings, ShapeId};
use glam::Vec3;

/// Distance between the end of a bone and a child, relative to the bone's length, up to which the
/// bone ends at the child: files round lengths of bones and positions of joints separately.
const SAME_PLACE: f32 = 0.05;

/// Length of a finger's bone on the screen, in pixels, below which the wrist is grabbed instead: who takes a hand of
/// a figure that is seen whole means the arm; and that of the palm, which is about twice as long.
const TINY: f32 = 40.0;
const TINY_PALM: f32 = 2.0 * TINY;

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
    /// tiny on `screen`, or, with a chain of the usual length, the ankle above the end of a foot, or the root
    /// where the hips are. Of joints in one place, one above the other, it is the uppermost, which moves them all.
    pub fn of(session: &Session, hit: &BoneHit, screen: &Screen) -> Option<Self> {
        let posed = session.scene().character(hit.shape)?;
        let character = &posed.character;
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
        let is_limb = posed.ik.length == IkSettings::LIMB;
        if hit.point.distance(place(start)) < hit.point.distance(place(end)) {
            let joint = uppermost(skeleton, bone.joint);
            let root = root_at_hips(skeleton, joint).filter(|_| is_limb);
            return Some(Self::Joint(root.unwrap_or(joint)));
        }
        let mut children = skeleton.children(bone.joint).iter();
        let near = SAME_PLACE * bone.tip.length();
        let ends = |&&child: &&usize| {
            let offset = skeleton.joints()[child].offset;
            offset.distance(bone.tip) <= near
        };
        let end = match children.find(ends) {
            Some(&child) => Self::Joint(child),
            None => Self::Tip {
                joint: bone.joint,
                tip: bone.tip,
            },
        };
        let led = match end {
            Self::Joint(joint) => root_at_hips(skeleton, joint),
            Self::Tip { joint, tip } => is_end_of_limb(skeleton, joint, tip).then_some(joint),
        };
        let led = led.or_else(|| ankle_above(skeleton, end.joint()));
        Some(led.filter(|_| is_limb).map_or(end, Self::Joint))
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

    /// Whether limbs meet at the second joint above the grip: a knee follows the thigh, and does not turn the
    /// hips with all that hangs on them.
    fn ends_limb(self, skeleton: &SkeletalModel) -> bool {
        let parent = |joint: usize| skeleton.joints().get(joint).and_then(|j| j.parent);
        let last = match self {
            Self::Joint(joint) => parent(joint),
            Self::Tip { joint, .. } => Some(joint),
        };
        let above = last.and_then(parent);
        let fork = |joint: Option<usize>| joint.is_some_and(|joint| is_fork(skeleton, joint));
        fork(above) && !fork(last)
    }

    /// Whether the bone that leads to the last joint above the grip is a stub beside the grip's own.
    fn follows_stub(self, skeleton: &SkeletalModel) -> bool {
        let joint = |index: usize| skeleton.joints().get(index);
        let (last, bone) = match self {
            Self::Joint(grip) => match joint(grip) {
                Some(grip) => (grip.parent.and_then(joint), grip.offset),
                None => return false,
            },
            Self::Tip { joint: last, tip } => (joint(last), tip),
        };
        let above = last.map_or(0.0, |last| last.offset.length());
        // Joints in one place are no bone that could fold.
        above > 0.0 && above < STUB * bone.length()
    }

    /// Chain that moves the grip; `None` for a root, and if no joint above it can turn, as below a
    /// pin.
    pub fn chain(self, session: &Session, shape: ShapeId) -> Option<IkChain> {
        let character = session.scene().character(shape)?;
        let (skeleton, pose) = (character.character.skeleton(), character.pose());
        let pins = &character.ik.pins;
        let length = match character.ik.length {
            IkSettings::LIMB if self.ends_limb(skeleton) || self.follows_stub(skeleton) => 1,
            length => length,
        };
        match self {
            Self::Joint(joint) => IkChain::to_joint(skeleton, pose, joint, length, pins),
            Self::Tip { joint, tip } => IkChain::to_point(skeleton, pose, joint, tip, length, pins),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Joint};
    use crate::editor::Edit;
    use crate::editor::limbs::tests::{body, skeleton};
    use crate::geometry::Mesh;
    use crate::scene::{Camera, CharacterShape, NewShape, ShapeKind};
    use glam::Vec2;
    use std::sync::Arc;

    #[test]
    fn a_trunk_leans_on_short_hips_without_turning_them() {
        let trunk = skeleton(&[
            (None, [0.0, 1.0, 0.0]),
            (Some(0), [0.0, 0.0, 0.0]),
            (Some(1), [0.0, 0.075, 0.0]),
            (Some(2), [0.0, 0.395, 0.0]),
            (Some(3), [0.0, 0.06, 0.0]),
        ]);
        let (session, shape) = session(trunk);
        let chain = IkGrip::Joint(3).chain(&session, shape).unwrap();
        assert_eq!(chain.joints(), [2]);
        let tip = Vec3::new(0.0, 0.2, 0.0);
        let head = IkGrip::Tip { joint: 4, tip };
        assert_eq!(head.chain(&session, shape).unwrap().joints(), [4]);
    }

    /// A session with a character of this skeleton.
    fn session(skeleton: SkeletalModel) -> (Session, ShapeId) {
        let mesh = Mesh::new(Vec::new(), Vec::new());
        let character = Character::new(skeleton, Attachments::new(), mesh).unwrap();
        let mut session = Session::new();
        let kind = ShapeKind::Character(CharacterShape::new(Arc::new(character)));
        let insert = Edit::Insert(vec![NewShape::new("Figure", kind)]);
        session.edit(insert).unwrap();
        let shape = session.selected().unwrap();
        (session, shape)
    }

    #[test]
    fn of_the_usual_two_joints_none_turns_another_limb() {
        let (mut session, shape) = session(body());
        let chain = |session: &Session, joint| {
            let chain = IkGrip::Joint(joint).chain(session, shape);
            chain.map(|chain| chain.joints().to_vec()).unwrap()
        };
        assert_eq!(chain(&session, 4), [2, 3], "a wrist");
        assert_eq!(chain(&session, 3), [2], "an elbow, and not the chest");
        assert_eq!(
            chain(&session, 2),
            [0, 1],
            "a shoulder, which the chest turns"
        );
        let ik = IkSettings {
            length: 3,
            ..IkSettings::default()
        };
        session.edit(Edit::SetIk(shape, ik)).unwrap();
        assert_eq!(chain(&session, 3), [0, 1, 2], "as long as is asked for");
    }

    #[test]
    fn a_foot_is_grabbed_at_the_ankle_and_a_finger_where_it_is() {
        let body = skeleton(&[
            (None, [0.0, 1.0, 0.0]),
            (Some(0), [0.1, 0.0, 0.0]),
            (Some(1), [0.0, -0.45, 0.0]),
            (Some(2), [0.0, -0.4, 0.0]),
            (Some(3), [0.0, -0.05, 0.15]),
            (Some(4), [0.0, 0.0, 0.05]),
            // An arm of a hand and a finger.
            (Some(0), [0.2, 0.5, 0.0]),
            (Some(6), [0.3, 0.0, 0.0]),
            (Some(7), [0.28, 0.0, 0.0]),
            (Some(8), [0.1, 0.0, 0.0]),
            (Some(9), [0.04, 0.0, 0.0]),
            // A heel.
            (Some(2), [0.0, -0.4, -0.05]),
            (Some(11), [0.05, 0.0, 0.0]),
        ]);
        for (joint, expected) in [(3, 3), (2, 3), (1, 2), (8, 8), (9, 10), (7, 8)] {
            let grip = grip(body.clone(), joint, 100.0);
            assert_eq!(grip, IkGrip::Joint(expected), "the bone of {joint}");
        }
        let (mut session, shape) = session(body);
        let ik = IkSettings {
            length: 3,
            ..IkSettings::default()
        };
        session.edit(Edit::SetIk(shape, ik)).unwrap();
        let toes = grip_in((session, shape), 3, 100.0);
        assert_eq!(toes, IkGrip::Joint(4), "with a chain that was chosen");
    }

    /// Grip of the bone of `joint`, hit close to its end, where it is `pixels` long.
    fn grip(skeleton: SkeletalModel, joint: usize, pixels: f32) -> IkGrip {
        grip_in(session(skeleton), joint, pixels)
    }

    fn grip_in((session, shape): (Session, ShapeId), joint: usize, pixels: f32) -> IkGrip {
        let start = IkGrip::Joint(joint).place(&session, shape).unwrap();
        let bones = session.scene().character(shape).unwrap().character.bones();
        let bone = bones.iter().position(|bone| bone.joint == joint).unwrap();
        let tip = bones[bone].tip;
        // A picture 1000 pixels high shows 2 tan(45°/2) of a length at the distance 1.
        let seen = 2.0 * 22.5_f32.to_radians().tan() / 1000.0;
        let camera = Camera {
            target: start,
            radius: tip.length() / (pixels * seen),
            ..Camera::default()
        };
        let hit = BoneHit {
            shape,
            joint,
            bone,
            distance: 1.0,
            point: start + tip * 0.9,
        };
        let size = Vec2::splat(1000.0);
        IkGrip::of(&session, &hit, &Screen { camera, size }).unwrap()
    }

    #[test]
    fn a_palm_is_grabbed_from_80_pixels_on_and_a_finger_from_40_and_else_the_wrist() {
        for (pixels, found) in [(30.0, 4), (60.0, 4), (76.0, 4), (84.0, 5)] {
            assert_eq!(grip(body(), 4, pixels), IkGrip::Joint(found), "{pixels}");
        }
        for (pixels, found) in [(30.0, 4), (36.0, 4), (44.0, 6), (60.0, 6)] {
            assert_eq!(grip(body(), 5, pixels), IkGrip::Joint(found), "{pixels}");
        }
        // No wrist is above an arm, however small it is.
        assert_eq!(grip(body(), 2, 5.0), IkGrip::Joint(3));
    }

    #[test]
    fn the_end_of_a_bone_is_a_joint_only_where_a_child_is() {
        let tip = Vec3::new(0.0, 2.0, 0.0);
        for (child, found) in [
            ([0.0, 1.0, 0.0], IkGrip::Tip { joint: 0, tip }),
            ([0.5, 2.0, 0.0], IkGrip::Tip { joint: 0, tip }),
            // A twentieth of the bone's length is 0.1.
            ([0.0, 1.92, 0.0], IkGrip::Joint(2)),
            ([0.0, 2.0, 0.0], IkGrip::Joint(2)),
        ] {
            let root = Joint {
                tip: Some(tip),
                ..Joint::default()
            };
            let below = |offset: [f32; 3]| Joint {
                parent: Some(0),
                offset: offset.into(),
                ..Joint::default()
            };
            let joints = vec![root, below([1.0, 0.0, 0.0]), below(child)];
            let skeleton = SkeletalModel::new(joints).unwrap();
            assert_eq!(grip(skeleton, 0, 500.0), found, "{child:?}");
        }
    }
}
