//! What a formula changes of the tree of joints.

use crate::character::SkeletalModel;
use glam::DVec3;

/// A joint as no file has it, in T and in B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherJoint {
    /// Index of the joint.
    pub joint: usize,
    /// Joint that it hangs on; `None` for a root. It hangs on none that hangs on the joint itself.
    pub parent: Option<usize>,
    /// Its offset from there.
    pub offset: DVec3,
}

/// What each joint hangs on, in T and in B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parents {
    /// Its parent in the file.
    OfFile,
    /// The joint of the line before.
    LineBefore,
    /// The first joint.
    First,
    /// The joint whose index is that of its parent less 1. Children of the first joint stay on that.
    BeforeOwn,
    /// The same, but children of the first joint hang on nothing.
    BeforeOwnOrNone,
}

impl Parents {
    /// The joint that `joint` of the file `skeleton` hangs on.
    pub(super) fn of(self, skeleton: &SkeletalModel, joint: usize) -> Option<usize> {
        let own = skeleton.joints()[joint].parent;
        match self {
            Self::OfFile => own,
            Self::LineBefore => joint.checked_sub(1),
            Self::First => (joint > 0).then_some(0),
            Self::BeforeOwn => own.map(|own| own.saturating_sub(1)),
            Self::BeforeOwnOrNone => own?.checked_sub(1),
        }
    }

    /// All joints, parents before their children; `None` if some hang on one another.
    pub(super) fn order(self, skeleton: &SkeletalModel) -> Option<Vec<usize>> {
        let joints = skeleton.joints().len();
        let mut children = vec![Vec::new(); joints];
        let mut order = Vec::new();
        for joint in 0..joints {
            match self.of(skeleton, joint) {
                Some(parent) => children[parent].push(joint),
                None => order.push(joint),
            }
        }
        let mut next = 0;
        while let Some(&joint) = order.get(next) {
            order.append(&mut children[joint]);
            next += 1;
        }
        (order.len() == joints).then_some(order)
    }
}

/// Joints after which the matrix stack is popped, so that the next one hangs on what it does in the file. A joint is
/// visited after its parent, its children before its next sibling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Popped {
    /// Every joint.
    All,
    /// None: each joint hangs on the one that is visited before it.
    None,
    /// All but those without children.
    ButLeaves,
    /// Those without children alone.
    Leaves,
}

impl Popped {
    /// Whether the stack is popped after a joint, which has no children if it `is_leaf`.
    pub(super) fn pops(self, is_leaf: bool) -> bool {
        match self {
            Self::All => true,
            Self::None => false,
            Self::ButLeaves => !is_leaf,
            Self::Leaves => is_leaf,
        }
    }
}

/// What lies on the matrix stack before the roots are pushed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOnStack {
    /// Nothing.
    Nothing,
    /// B of the first root.
    Root,
    /// B of the joint that is visited last, where each hangs on the one that is visited before it: once, or multiplied
    /// by itself so many times as transforms have been computed at rest.
    LastVisited(usize),
}

/// Joints that the recursion over the tree comes to. It comes to roots, and to none that hangs on one that it does not come
/// to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// All but those without children.
    ButLeaves,
    /// The first child of each in the file.
    First,
    /// The last child of each.
    Last,
    /// All but the first child of each.
    ButFirst,
    /// All but the last child of each.
    ButLast,
}

impl Reached {
    /// Whether each joint is reached.
    pub(super) fn of(self, skeleton: &SkeletalModel) -> Vec<bool> {
        let joints = skeleton.joints();
        let mut ends: Vec<Option<(usize, usize)>> = vec![None; joints.len()];
        for (joint, parent) in joints.iter().map(|joint| joint.parent).enumerate() {
            if let Some(parent) = parent {
                let (first, _) = ends[parent].unwrap_or((joint, joint));
                ends[parent] = Some((first, joint));
            }
        }
        let comes_to = |joint: usize| {
            let Some((first, last)) = joints[joint].parent.and_then(|parent| ends[parent]) else {
                return true;
            };
            match self {
                Self::ButLeaves => ends[joint].is_some(),
                Self::First => joint == first,
                Self::Last => joint == last,
                Self::ButFirst => joint != first,
                Self::ButLast => joint != last,
            }
        };
        let above =
            |joint| std::iter::successors(Some(joint), |&joint: &usize| joints[joint].parent);
        (0..joints.len())
            .map(|joint| above(joint).all(comes_to))
            .collect()
    }
}

/// What a program has for a joint that nothing is worked out for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfilled {
    /// T is 0, as a new `Matrix4f` of the course's library is.
    Zero,
    /// T is the identity.
    Identity,
    /// So is B.
    IdentityInBoth,
}
