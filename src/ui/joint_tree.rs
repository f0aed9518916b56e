//! Which joints the list shows, in which order, how far indented.

use crate::character::SkeletalModel;
use std::collections::BTreeSet;

/// One row of the joint list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    /// Index of the joint.
    pub joint: usize,
    /// How many ancestors are shown above it.
    pub depth: usize,
    /// Whether it can be folded, and if so whether it is.
    pub folded: Option<bool>,
}

/// The rows in tree order, without what lies below a folded joint; while something is searched,
/// all joints whose name contains it, in the order of the file.
pub(super) fn rows(skeleton: &SkeletalModel, folded: &BTreeSet<usize>, search: &str) -> Vec<Row> {
    let search = search.trim().to_lowercase();
    if !search.is_empty() {
        return found(skeleton, &search);
    }
    let mut rows = Vec::with_capacity(skeleton.joints().len());
    let start = skeleton.roots().iter().rev();
    let mut open: Vec<(usize, usize)> = start.map(|&root| (root, 0)).collect();
    while let Some((joint, depth)) = open.pop() {
        let children = skeleton.children(joint);
        let is_folded = folded.contains(&joint);
        rows.push(Row {
            joint,
            depth,
            folded: (!children.is_empty()).then_some(is_folded),
        });
        if !is_folded {
            open.extend(children.iter().rev().map(|&child| (child, depth + 1)));
        }
    }
    rows
}

fn found(skeleton: &SkeletalModel, search: &str) -> Vec<Row> {
    let matches = |name: &str| name.to_lowercase().contains(search);
    skeleton
        .joints()
        .iter()
        .enumerate()
        .filter(|(_, joint)| matches(&joint.name))
        .map(|(joint, _)| Row {
            joint,
            depth: 0,
            folded: None,
        })
        .collect()
}

/// Unfolds everything above `joint`, so that its row is shown.
pub(super) fn reveal(skeleton: &SkeletalModel, folded: &mut BTreeSet<usize>, joint: usize) {
    let joints = skeleton.joints();
    let parent_of = |joint: usize| joints.get(joint).and_then(|joint| joint.parent);
    let mut above = parent_of(joint);
    while let Some(joint) = above {
        folded.remove(&joint);
        above = parent_of(joint);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;
    use glam::Vec3;

    /// 0 → {1 → 3, 2}, and a second root 4.
    fn skeleton() -> SkeletalModel {
        let parents = [None, Some(0), Some(0), Some(1), None];
        let names = ["Root", "Left hip", "Right hip", "Left knee", "Prop"];
        let joints = parents.iter().zip(names).map(|(&parent, name)| Joint {
            name: name.to_owned(),
            parent,
            offset: Vec3::Y,
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).expect("a tree")
    }

    fn joints(rows: &[Row]) -> Vec<usize> {
        rows.iter().map(|row| row.joint).collect()
    }

    #[test]
    fn children_stand_below_their_parent_one_step_further_in() {
        let rows = rows(&skeleton(), &BTreeSet::new(), "");
        assert_eq!(joints(&rows), [0, 1, 3, 2, 4]);
        let depths: Vec<usize> = rows.iter().map(|row| row.depth).collect();
        assert_eq!(depths, [0, 1, 2, 1, 0]);
        assert_eq!(rows[1].folded, Some(false));
        assert_eq!(rows[2].folded, None);
    }

    #[test]
    fn a_folded_joint_hides_what_is_below_it_until_that_is_revealed() {
        let mut folded = BTreeSet::from([0, 1]);
        assert_eq!(joints(&rows(&skeleton(), &folded, "")), [0, 4]);
        reveal(&skeleton(), &mut folded, 3);
        assert_eq!(joints(&rows(&skeleton(), &folded, "")), [0, 1, 3, 2, 4]);
    }

    #[test]
    fn a_search_finds_folded_joints_too_whatever_the_case() {
        let folded = BTreeSet::from([0]);
        assert_eq!(joints(&rows(&skeleton(), &folded, " LEFT ")), [1, 3]);
        assert!(rows(&skeleton(), &folded, "tail").is_empty());
    }
}
