use super::{Pose, SkeletalModel};
use crate::math::Euler;
use glam::Vec3;
use std::collections::HashMap;

/// Distance between a joint and its partner's reflection at rest, relative to the size of the
/// skeleton, up to which they are a pair.
const NEAR: f32 = 0.02;

/// Left–right symmetry of a skeleton: pairs of joints, and the axis across which they are mirrored.
///
/// A pose is reflected joint by joint: as joints are parallel to the character's axes at rest, `S ·
/// R · S` with the reflection `S` is again a rotation, of the partner, and everything below it is
/// reflected too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mirror {
    /// Index of the axis: 0 for x, 1 for y, 2 for z.
    axis: usize,
    partner: Vec<usize>,
}

impl Mirror {
    /// Finds the pairs by names (`Left elbow`, `upper_arm.L`, `RightHand`) or, if no names say left
    /// or right, by the positions at rest.
    pub fn new(skeleton: &SkeletalModel) -> Self {
        let places = skeleton.bind_positions();
        by_name(skeleton, &places).unwrap_or_else(|| by_place(skeleton, &places))
    }

    /// Index of the joint on the other side; `joint` itself in the middle.
    pub fn partner(&self, joint: usize) -> usize {
        self.partner.get(joint).copied().unwrap_or(joint)
    }

    /// Index of the axis across which it mirrors: 0 for x, 1 for y, 2 for z.
    pub fn axis(&self) -> usize {
        self.axis
    }

    /// `pose` with left and right exchanged.
    pub fn pose(&self, pose: &Pose) -> Pose {
        let mut mirrored = Pose::new();
        for joint in 0..self.partner.len() {
            let from = self.partner(joint);
            // Turns about the axis stay, all others turn the other way round: Rx·Ry·Rz with
            // reflected axes keeps its order.
            let turned = self.keep(pose.rotation(from).radians, 1.0);
            mirrored.set_joint_transform(joint, Euler::from_radians(turned));
            mirrored.set_root_offset(joint, self.keep(pose.root_offset(from), -1.0));
        }
        mirrored
    }

    /// The coordinate of the axis times `sign`, the other two times minus `sign`.
    fn keep(&self, vector: Vec3, sign: f32) -> Vec3 {
        let mut signs = Vec3::splat(-sign);
        signs[self.axis] = sign;
        // Adding zero makes 0 of -0, which would be another number in a file.
        vector * signs + Vec3::ZERO
    }
}

/// Pairs by name; `None` if no two joints have names of either side.
fn by_name(skeleton: &SkeletalModel, places: &[Vec3]) -> Option<Mirror> {
    let joints = skeleton.joints();
    let tree = trees(skeleton);
    let mut in_tree: HashMap<(usize, &str), usize> = HashMap::new();
    let mut anywhere: HashMap<&str, usize> = HashMap::new();
    for (joint, described) in joints.iter().enumerate() {
        let name = described.name.as_str();
        in_tree.entry((tree[joint], name)).or_insert(joint);
        anywhere.entry(name).or_insert(joint);
    }
    // Two figures may use the same names, and two hands may be a tree each.
    let other = |joint: usize| {
        let (_, name) = sided(&joints[joint].name)?;
        let name = name.as_str();
        let found = in_tree.get(&(tree[joint], name));
        let partner = *found.or_else(|| anywhere.get(name))?;
        // Only roots have offsets to exchange.
        let both_roots = joints[joint].parent.is_none() == joints[partner].parent.is_none();
        both_roots.then_some(partner)
    };
    let partner: Vec<usize> = (0..joints.len())
        .map(|joint| {
            let back = other(joint).filter(|&partner| other(partner) == Some(joint));
            back.unwrap_or(joint)
        })
        .collect();
    let apart = partner.iter().zip(places);
    let apart = apart.fold(Vec3::ZERO, |sum, (&partner, at)| {
        sum + (places[partner] - *at).abs()
    });
    let any = partner.iter().enumerate().any(|(a, &b)| a != b);
    let axis = if apart.z > apart.x.max(apart.y) {
        2
    } else if apart.y > apart.x {
        1
    } else {
        0
    };
    any.then_some(Mirror { axis, partner })
}

/// Index of the root above each joint.
fn trees(skeleton: &SkeletalModel) -> Vec<usize> {
    let mut tree = vec![0; skeleton.joints().len()];
    for &root in skeleton.roots() {
        let mut open = vec![root];
        while let Some(joint) = open.pop() {
            tree[joint] = root;
            open.extend(skeleton.children(joint));
        }
    }
    tree
}

/// Pairs by position, across x or z, whichever gives more pairs: characters stand upright.
fn by_place(skeleton: &SkeletalModel, places: &[Vec3]) -> Mirror {
    let across = |axis: usize| Mirror {
        axis,
        partner: pairs_across(skeleton, places, axis),
    };
    let pairs = |mirror: &Mirror| {
        let partners = mirror.partner.iter().enumerate();
        partners.filter(|&(a, &b)| a != b).count()
    };
    let (x, z) = (across(0), across(2));
    if pairs(&z) > pairs(&x) { z } else { x }
}

fn pairs_across(skeleton: &SkeletalModel, places: &[Vec3], axis: usize) -> Vec<usize> {
    let low = places.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = places.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let near = NEAR * (high - low).length();
    let reflected = |at: Vec3| {
        let mut at = at;
        at[axis] = low[axis] + high[axis] - at[axis];
        at
    };
    let is_pair = |a: usize, b: usize| {
        let parents = (skeleton.joints()[a].parent, skeleton.joints()[b].parent);
        parents.0.is_some() == parents.1.is_some()
            && skeleton.children(a).len() == skeleton.children(b).len()
            && places[a].distance(reflected(places[b])) <= near
    };
    let mut partner: Vec<usize> = (0..places.len()).collect();
    let apart = |joint: usize| (places[joint] - reflected(places[joint]))[axis].abs() > near;
    for a in (0..places.len()).filter(|&joint| apart(joint)) {
        let free = |&b: &usize| b > a && partner[b] == b && is_pair(a, b);
        if partner[a] == a
            && let Some(b) = (0..places.len()).find(free)
        {
            partner[a] = b;
            partner[b] = a;
        }
    }
    partner
}

/// Side of a character in the name of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Side that the name of a joint says, and the name of its partner; `None` for a name without a
/// side.
pub(super) fn sided(name: &str) -> Option<(Side, String)> {
    let words = [
        (Side::Left, "left", "right"),
        (Side::Right, "right", "left"),
    ];
    for (side, word, other) in words {
        if let Some(at) = find_word(name, word) {
            let (before, rest) = name.split_at(at);
            let (word, after) = rest.split_at(word.len());
            return Some((side, format!("{before}{}{after}", like(word, other))));
        }
    }
    let separator = |c: char| !c.is_alphanumeric();
    let mut start = 0;
    for piece in name.split_inclusive(separator) {
        let token = piece.trim_end_matches(separator);
        let (side, other) = match token {
            "L" => (Side::Left, "R"),
            "R" => (Side::Right, "L"),
            "l" => (Side::Left, "r"),
            "r" => (Side::Right, "l"),
            _ => {
                start += piece.len();
                continue;
            }
        };
        let end = start + token.len();
        return (token.len() < name.len())
            .then(|| (side, format!("{}{other}{}", &name[..start], &name[end..])));
    }
    None
}

/// Position of `word` in `name` as a word of its own, in upper or lower case: `LeftArm`,
/// `left_arm`, `leftarm`, `armLeft`, but not `Bright`.
fn find_word(name: &str, word: &str) -> Option<usize> {
    let lower = name.to_ascii_lowercase();
    lower.match_indices(word).map(|(at, _)| at).find(|&at| {
        let before = name[..at].chars().next_back();
        let first = name[at..].chars().next();
        let after_lower = before.is_some_and(char::is_lowercase);
        let is_upper = first.is_some_and(char::is_uppercase);
        match before {
            None => true,
            Some(before) if !before.is_alphabetic() => true,
            Some(_) => after_lower && is_upper,
        }
    })
}

/// `word` in upper or lower case like `pattern`.
fn like(pattern: &str, word: &str) -> String {
    let mut letters = pattern.chars();
    let upper = |letter: Option<char>| letter.is_some_and(char::is_uppercase);
    match (upper(letters.next()), upper(letters.next())) {
        (true, true) => word.to_ascii_uppercase(),
        (true, false) => word[..1].to_ascii_uppercase() + &word[1..],
        (false, _) => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;

    fn skeleton(joints: &[(&str, Option<usize>, [f32; 3])]) -> SkeletalModel {
        let joints = joints.iter().map(|&(name, parent, offset)| Joint {
            name: name.to_owned(),
            parent,
            offset: offset.into(),
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).unwrap()
    }

    /// A body with two arms of two joints, which reach to the side, forward and up.
    fn body(names: [&str; 6]) -> SkeletalModel {
        skeleton(&[
            (names[0], None, [0.0, 1.0, 0.0]),
            (names[1], Some(0), [0.0, 0.5, 0.1]),
            (names[2], Some(1), [0.2, 0.1, 0.0]),
            (names[3], Some(2), [0.5, 0.1, 0.2]),
            (names[4], Some(1), [-0.2, 0.1, 0.0]),
            (names[5], Some(4), [-0.5, 0.1, 0.2]),
        ])
    }

    const NAMED: [&str; 6] = [
        "Root",
        "Bright chest",
        "Left arm",
        "hand.L",
        "Right arm",
        "hand.R",
    ];

    #[test]
    fn names_have_a_side_in_many_ways() {
        for (name, other) in [
            ("Left elbow", "Right elbow"),
            ("LeftHand", "RightHand"),
            ("mixamorig:LeftArm", "mixamorig:RightArm"),
            ("upper_arm.L", "upper_arm.R"),
            ("Arm_l_001", "Arm_r_001"),
            ("L_Knee", "R_Knee"),
            ("LEFT_FOOT", "RIGHT_FOOT"),
            ("leftarm", "rightarm"),
        ] {
            let (left, right) = ((Side::Left, other.into()), (Side::Right, name.into()));
            assert_eq!(sided(name), Some(left), "{name}");
            assert_eq!(sided(other), Some(right), "{other}");
        }
        for name in ["Root", "Bright", "Neck", "L", "", "Lower leg", "é.x"] {
            assert_eq!(sided(name), None, "{name}");
        }
    }

    #[test]
    fn pairs_are_found_by_name_or_else_by_place() {
        let named = Mirror::new(&body(NAMED));
        assert_eq!(named.partner, [0, 1, 4, 5, 2, 3]);
        let numbered = Mirror::new(&body(["0", "1", "2", "3", "4", "5"]));
        assert_eq!(numbered, named);
    }

    #[test]
    fn a_mirrored_pose_brings_every_joint_to_the_reflection_of_its_partner() {
        let skeleton = body(NAMED);
        let mirror = Mirror::new(&skeleton);
        let mut pose = Pose::new();
        for joint in 0..6 {
            let degrees = Vec3::new(20.0, -35.0, 50.0) * (joint as f32 - 2.5);
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        pose.set_root_offset(0, Vec3::new(0.3, 0.2, -0.1));
        let frames = skeleton.update_current_joint_to_world_transforms(&pose);
        let mirrored = mirror.pose(&pose);
        let reflected = skeleton.update_current_joint_to_world_transforms(&mirrored);
        for joint in 0..6 {
            let mut expected = frames[mirror.partner(joint)].w_axis.truncate();
            expected.x = -expected.x;
            let found = reflected[joint].w_axis.truncate();
            assert!(
                found.abs_diff_eq(expected, 1e-5),
                "{joint}: {found} {expected}"
            );
        }
        assert_eq!(mirror.pose(&mirrored), pose, "twice is the pose itself");
    }

    #[test]
    fn a_root_is_no_partner_of_a_joint_that_hangs_on_another() {
        let skeleton = skeleton(&[
            ("hip.L", None, [0.2, 0.0, 0.0]),
            ("hip.R", Some(0), [-0.4, 0.0, 0.0]),
            ("arm.L", Some(1), [0.5, 1.0, 0.0]),
            ("arm.R", Some(1), [-0.1, 1.0, 0.0]),
        ]);
        assert_eq!(Mirror::new(&skeleton).partner, [0, 1, 3, 2]);
    }

    #[test]
    fn of_two_figures_with_the_same_names_each_is_mirrored_in_itself() {
        let one = [
            ("hips", None, [0.0, 1.0, 0.0]),
            ("arm.L", Some(0), [0.5, 0.0, 0.0]),
            ("arm.R", Some(0), [-0.5, 0.0, 0.0]),
        ];
        let other = one.map(|(name, parent, at)| (name, parent.map(|joint: usize| joint + 3), at));
        let mirror = Mirror::new(&skeleton(&[one, other].concat()));
        assert_eq!(mirror.partner, [0, 2, 1, 3, 5, 4]);
    }

    #[test]
    fn two_hands_that_nothing_joins_are_partners() {
        let skeleton = skeleton(&[
            ("hand.L", None, [0.5, 1.0, 0.0]),
            ("hand.R", None, [-0.5, 1.0, 0.0]),
            ("thumb.L", Some(0), [0.1, 0.0, 0.0]),
            ("thumb.R", Some(1), [-0.1, 0.0, 0.0]),
        ]);
        assert_eq!(Mirror::new(&skeleton).partner, [1, 0, 3, 2]);
    }

    #[test]
    fn a_character_that_looks_along_x_is_mirrored_across_z() {
        let skeleton = skeleton(&[
            ("a", None, [0.0, 0.0, 0.0]),
            ("b", Some(0), [0.1, 0.0, 0.5]),
            ("c", Some(0), [0.1, 0.0, -0.5]),
        ]);
        let mirror = Mirror::new(&skeleton);
        assert_eq!((mirror.axis(), mirror.partner(1)), (2, 2));
    }
}
