//! The way over the joints of a skeleton that a matrix stack goes (assignment, "Skeleton").

use super::SkeletalModel;

/// A step of the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WalkStep {
    /// Down to a joint from its parent: its transform is pushed.
    Enter(usize),
    /// Back up from a joint, after all that hang on it: its transform is popped.
    Leave(usize),
}

/// Iterator of [`SkeletalModel::walk`]. It keeps its own list of joints to visit: a chain of any
/// length in a file must not overflow the thread's stack.
#[derive(Clone, Debug)]
pub struct SkeletonWalk<'a> {
    skeleton: &'a SkeletalModel,
    /// Steps that are left, the next one last, but for those below joints that are not entered yet.
    left: Vec<WalkStep>,
}

impl SkeletalModel {
    /// The way over all joints: each is entered after its parent and left after its children, which
    /// come in the order of the file.
    pub fn walk(&self) -> SkeletonWalk<'_> {
        let roots = self.roots().iter().rev();
        SkeletonWalk {
            skeleton: self,
            left: roots.map(|&root| WalkStep::Enter(root)).collect(),
        }
    }
}

impl Iterator for SkeletonWalk<'_> {
    type Item = WalkStep;

    fn next(&mut self) -> Option<WalkStep> {
        let step = self.left.pop()?;
        if let WalkStep::Enter(joint) = step {
            self.left.push(WalkStep::Leave(joint));
            let children = self.skeleton.children(joint).iter().rev();
            self.left
                .extend(children.map(|&child| WalkStep::Enter(child)));
        }
        Some(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;

    #[test]
    fn each_joint_is_entered_after_its_parent_and_left_after_its_children() {
        let parents = [None, Some(0), Some(0), Some(1), None];
        let joints = parents.map(|parent| Joint {
            parent,
            ..Joint::default()
        });
        let skeleton = SkeletalModel::new(joints.to_vec()).unwrap();
        let steps: Vec<(bool, usize)> = skeleton
            .walk()
            .map(|step| match step {
                WalkStep::Enter(joint) => (true, joint),
                WalkStep::Leave(joint) => (false, joint),
            })
            .collect();
        let (enter, leave) = (|joint| (true, joint), |joint| (false, joint));
        let left = [enter(0), enter(1), enter(3), leave(3), leave(1)];
        let right = [enter(2), leave(2), leave(0), enter(4), leave(4)];
        assert_eq!(steps, [left, right].concat());
    }
}
