//! Hands, feet and hips of a skeleton, which are known by how its joints branch and by the lengths of their bones.

use crate::character::{JointBone, SkeletalModel};
use crate::math::Aabb;
use glam::Vec3;

/// Least length of the bone that leads to a wrist, relative to the longest bone of the hand.
const FOREARM: f32 = 2.0;

/// Length of a foot relative to the bone above it below which that counts as short.
const SHORT: f32 = 0.6;

/// Distance from the root, by the size of the skeleton, within which a joint lies beside it.
const BESIDE: f32 = 0.06;

/// The same for a pelvis below a root in the chest.
const CLOSE: f32 = 0.15;

/// Length of a bone relative to one below it below which it is no part of a limb: it would have to fold for the
/// least way of the lower one's end toward it, as the hips do below a trunk.
pub(super) const STUB: f32 = 0.35;

/// Whether limbs meet at a joint, as at the hips: more than one branch goes on with joints of its own.
pub(super) fn is_fork(skeleton: &SkeletalModel, joint: usize) -> bool {
    let children = skeleton.children(joint).iter();
    let limbs = children.filter(|&&child| !skeleton.children(child).is_empty());
    limbs.count() > 1
}

/// Index of the uppermost of the joints that are in the same place as `joint`.
pub(super) fn uppermost(skeleton: &SkeletalModel, joint: usize) -> usize {
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

/// The root that leads the figure where a joint of its hips is taken: one that lies beside the root, where limbs meet,
/// or one of a pelvis that hangs close below it. To lead these about by so short a chain would turn all of the figure
/// over, or swing both legs.
pub(super) fn root_at_hips(skeleton: &SkeletalModel, joint: usize) -> Option<usize> {
    let parent = |&joint: &usize| skeleton.joints().get(joint).and_then(|j| j.parent);
    let above: Vec<usize> = std::iter::successors(parent(&joint), parent).collect();
    let root = *above.last()?;
    let places = skeleton.bind_positions();
    let bounds = Aabb::from_points(places.iter().copied());
    let size = bounds.size().length();
    let from_root = |joint: usize| places[joint].distance(places[root]);
    let is_beside = |joint: usize| from_root(joint) < BESIDE * size;
    // A foot may stand beside a root on the ground, but on a leg that does not.
    let is_waist = || {
        let mut line = above.iter().chain([&joint]);
        line.all(|&joint| is_beside(joint)) && above.iter().any(|&joint| is_fork(skeleton, joint))
    };
    let is_pelvis = || {
        let ground = bounds.min.y + BESIDE * size;
        let hips = pelvis(skeleton, joint, |foot| places[foot].y < ground);
        hips.is_some_and(|hips| from_root(hips) < CLOSE * size)
    };
    (is_waist() || is_pelvis()).then_some(root)
}

/// The joint at which the legs meet, of a joint of the pelvis: that one, or one that hangs on it by bones that are short
/// beside those of the legs. Legs are limbs of which an end `is_on_ground`.
fn pelvis(
    skeleton: &SkeletalModel,
    joint: usize,
    is_on_ground: impl Fn(usize) -> bool,
) -> Option<usize> {
    let joints = skeleton.joints();
    let length = |joint: usize| joints[joint].offset.length();
    let below = |joint: usize| {
        let first = skeleton.children(joint).first().copied();
        std::iter::successors(first, |&next| skeleton.children(next).first().copied())
    };
    let is_leg =
        |hip: &&usize| below(**hip).count() > 1 && below(**hip).last().is_some_and(&is_on_ground);
    let longest = below(joint).map(length).fold(0.0, f32::max);
    let mut hips = joint;
    loop {
        if skeleton.children(hips).iter().filter(is_leg).count() > 1 {
            return Some(hips);
        }
        if length(hips) > STUB * longest {
            return None;
        }
        hips = joints[hips].parent?;
    }
}

/// The ankle above the end of a foot, or above toes there: a foot is short beside the two long bones of its leg, which
/// are what should follow it. Two joints above toes would fold the ankle.
pub(super) fn ankle_above(skeleton: &SkeletalModel, toe: usize) -> Option<usize> {
    let parent = |joint: usize| skeleton.joints().get(joint).and_then(|j| j.parent);
    let length = |joint: usize| skeleton.joints()[joint].offset.length();
    let ankle = parent(toe)?;
    let knee = parent(ankle)?;
    // The hip hangs on something.
    parent(parent(knee)?)?;
    // A palm has several fingers, and a neck hangs where arms do.
    let is_single = skeleton.children(ankle).len() == 1;
    let beside = skeleton.children(knee).iter();
    let is_neck = beside.filter(|&&child| child != ankle).any(|&child| {
        let mut below = skeleton.children(child).iter();
        below.any(|&next| !skeleton.children(next).is_empty())
    });
    let is_foot = ends_limb(length(toe), [length(ankle), length(knee)]);
    (is_single && is_foot && !is_neck).then_some(ankle)
}

/// Whether a bone of `joint` that ends at `tip`, where there is no joint, is a foot or a hand at the end of a limb: short
/// beside the two long bones that lead to it, which are what should follow it.
pub(super) fn is_end_of_limb(skeleton: &SkeletalModel, joint: usize, tip: Vec3) -> bool {
    let joints = skeleton.joints();
    let Some(above) = joints[joint]
        .parent
        .filter(|&above| joints[above].parent.is_some())
    else {
        return false;
    };
    let limb = [joint, above].map(|joint| joints[joint].offset.length());
    skeleton.children(joint).is_empty() && ends_limb(tip.length(), limb)
}

/// Whether a bone of the length `end` is short beside the two that lead to it, the nearer first, which are alike.
fn ends_limb(end: f32, [lower, upper]: [f32; 2]) -> bool {
    lower >= SHORT * upper && upper >= SHORT * lower && end < SHORT * lower
}

/// Index of the wrist above `bone`, or of the ankle above toes: a joint whose branches are much
/// shorter than the bone that leads to it.
pub(super) fn wrist(skeleton: &SkeletalModel, bone: &JointBone) -> Option<usize> {
    let joints = skeleton.joints();
    let mut longest = bone.tip.length();
    let mut joint = bone.joint;
    loop {
        let parent = joints[joint].parent?;
        let leading = joints[joint].offset.length();
        let branches = skeleton.children(joint).len() > 1;
        // From a root on the ground it is a long way to the hips.
        let is_arm = joints[parent].parent.is_some();
        if branches && is_arm && leading >= FOREARM * longest {
            return Some(joint);
        }
        longest = longest.max(leading);
        joint = parent;
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::character::Joint;

    pub(in crate::editor) fn skeleton(joints: &[(Option<usize>, [f32; 3])]) -> SkeletalModel {
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
    pub(in crate::editor) fn body() -> SkeletalModel {
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

    #[test]
    fn a_short_bone_at_the_end_of_a_limb_is_its_end_and_a_forearm_or_a_head_is_none() {
        let mut joints = vec![
            (None, [0.0, 1.0, 0.0]),
            (Some(0), [0.1, -0.05, 0.0]),
            (Some(1), [0.0, -0.45, 0.0]),
            (Some(2), [0.0, -0.4, 0.0]),
            (Some(0), [0.0, 0.5, 0.0]),
            (Some(4), [0.0, 0.1, 0.0]),
        ];
        let leg = skeleton(&joints);
        let is_end = |joint, tip: [f32; 3]| is_end_of_limb(&leg, joint, tip.into());
        assert!(is_end(3, [0.0, -0.05, 0.15]), "a foot");
        assert!(!is_end(3, [0.0, -0.3, 0.0]), "as long as a shin");
        assert!(!is_end(5, [0.0, 0.05, 0.0]), "a head on a short neck");
        joints.push((Some(3), [0.0, -0.05, 0.1]));
        let with_toes = skeleton(&joints);
        let heel = Vec3::new(0.0, -0.05, -0.05);
        assert!(!is_end_of_limb(&with_toes, 3, heel), "toes hang on it");
    }

    #[test]
    fn a_waist_beside_the_root_of_a_figure_with_legs_leads_all_of_it() {
        let leg = |x: f32, hips| {
            [
                (Some(hips), [x, -0.1, 0.0]),
                (None, [0.0, -0.4, 0.0]),
                (None, [0.0, -0.4, 0.0]),
            ]
        };
        let mut joints = vec![
            (None, [0.0, 1.0, 0.0]),
            (Some(0), [0.0, 0.0, 0.0]),
            (Some(1), [0.0, 0.075, 0.0]),
            (Some(2), [0.0, 0.395, 0.0]),
        ];
        for x in [-0.1, 0.1] {
            for (parent, offset) in leg(x, 1) {
                joints.push((parent.or(Some(joints.len() - 1)), offset));
            }
        }
        let body = skeleton(&joints);
        assert_eq!(root_at_hips(&body, 2), Some(0));
        assert_eq!(root_at_hips(&body, 3), None, "the neck is far from it");
        assert_eq!(root_at_hips(&body, 4), None, "so is the leg");
        assert_eq!(root_at_hips(&body, 1), Some(0), "the hips lead it as well");
        // A chain without limbs bends where it is taken.
        let chain: Vec<_> = (0..30_usize)
            .map(|joint| (joint.checked_sub(1), [0.0, 0.1, 0.0]))
            .collect();
        assert_eq!(root_at_hips(&skeleton(&chain), 1), None);
    }

    #[test]
    fn a_root_on_the_ground_makes_no_waist_of_feet_and_no_hand_of_the_head() {
        let mut joints = vec![
            (None, [0.0, 0.0, 0.0]),
            (Some(0), [0.0, 1.0, 0.0]),
            (Some(1), [0.0, 0.3, 0.0]),
            (Some(2), [0.0, 0.25, 0.0]),
            (Some(3), [0.0, 0.1, 0.0]),
        ];
        for x in [-0.08, 0.08] {
            let (hip, shoulder) = (joints.len(), joints.len() + 4);
            joints.push((Some(1), [x, 0.0, 0.0]));
            joints.push((Some(hip), [0.0, -0.5, 0.0]));
            joints.push((Some(hip + 1), [0.0, -0.45, 0.0]));
            joints.push((Some(hip + 2), [0.0, -0.03, 0.1]));
            joints.push((Some(2), [2.0 * x, 0.2, 0.0]));
            joints.push((Some(shoulder), [3.0 * x, 0.0, 0.0]));
            joints.push((Some(shoulder + 1), [3.0 * x, 0.0, 0.0]));
        }
        let body = skeleton(&joints);
        let (neck, head, ankle, toe) = (3, 4, 7, 8);
        for joint in [ankle, toe, head] {
            assert_eq!(root_at_hips(&body, joint), None, "{joint}");
        }
        assert_eq!(wrist(&body, &bone(neck, [0.0, 0.1, 0.0])), None);
        assert_eq!(ankle_above(&body, head), None, "a neck is no ankle");
        assert_eq!(ankle_above(&body, toe), Some(ankle));
    }

    #[test]
    fn a_pelvis_close_below_a_root_in_the_chest_leads_the_figure_and_neither_thighs_nor_shoulders_do()
     {
        let mut joints = vec![
            (None, [0.0, 1.2, 0.0]),
            (Some(0), [0.0, -0.2, 0.0]),
            (Some(0), [0.0, 0.2, 0.0]),
        ];
        for x in [-0.06, 0.06] {
            let hip = joints.len();
            joints.push((Some(1), [x, -0.1, 0.0]));
            joints.push((Some(hip), [x, -0.06, 0.0]));
            joints.push((Some(hip + 1), [0.0, -0.4, 0.0]));
            joints.push((Some(hip + 2), [0.0, -0.4, 0.0]));
        }
        for x in [-0.2, 0.2] {
            let shoulder = joints.len();
            joints.push((Some(0), [x, 0.1, 0.0]));
            joints.push((Some(shoulder), [x, -0.2, 0.0]));
            joints.push((Some(shoulder + 1), [x, -0.2, 0.0]));
        }
        let body = skeleton(&joints);
        let led: Vec<usize> = (0..joints.len())
            .filter(|&joint| root_at_hips(&body, joint).is_some())
            .collect();
        assert_eq!(led, [1, 3, 4, 7, 8]);
        joints[1].1 = [0.0, -0.5, 0.0];
        let far = skeleton(&joints);
        assert_eq!(root_at_hips(&far, 1), None, "a long back bends");
    }
}
