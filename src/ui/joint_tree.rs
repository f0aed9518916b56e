//! Rows of the joint list, in the order of the tree: folded, searched, revealed.

use crate::character::SkeletalModel;
use std::collections::BTreeSet;

/// One row of the joint list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    /// Index of the joint.
    pub joint: usize,
    /// Number of ancestors shown above it.
    pub depth: usize,
    /// Whether it is folded; `None` if it has no children to fold.
    pub folded: Option<bool>,
}

/// Rows in tree order, without the descendants of folded joints; while `search` is not empty, all
/// joints whose name contains it, in file order.
pub(super) fn rows_of(
    skeleton: &SkeletalModel,
    folded: &BTreeSet<usize>,
    search: &str,
) -> Vec<Row> {
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

/// Unfolds all ancestors of `joint`, so that its row is shown.
pub(super) fn reveal(skeleton: &SkeletalModel, folded: &mut BTreeSet<usize>, joint: usize) {
    let mut above = parent_of(skeleton, joint);
    while let Some(joint) = above {
        folded.remove(&joint);
        above = parent_of(skeleton, joint);
    }
}

/// The joint that `joint` hangs on, if there is one.
pub(super) fn parent_of(skeleton: &SkeletalModel, joint: usize) -> Option<usize> {
    skeleton.joints().get(joint).and_then(|joint| joint.parent)
}

/// Index of the row of `joint`, or of the one that it is folded away in; `None` if a search hides it.
pub(super) fn row_with(skeleton: &SkeletalModel, rows: &[Row], joint: usize) -> Option<usize> {
    let mut at = Some(joint);
    while let Some(above) = at {
        if let Some(index) = rows.iter().position(|row| row.joint == above) {
            let is_shown = above == joint || rows[index].folded == Some(true);
            return is_shown.then_some(index);
        }
        at = parent_of(skeleton, above);
    }
    None
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
        let rows = rows_of(&skeleton(), &BTreeSet::new(), "");
        assert_eq!(joints(&rows), [0, 1, 3, 2, 4]);
        let depths: Vec<usize> = rows.iter().map(|row| row.depth).collect();
        assert_eq!(depths, [0, 1, 2, 1, 0]);
        assert_eq!(rows[1].folded, Some(false));
        assert_eq!(rows[2].folded, None);
    }

    #[test]
    fn a_folded_joint_hides_what_is_below_it_until_that_is_revealed() {
        let mut folded = BTreeSet::from([0, 1]);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, "")), [0, 4]);
        reveal(&skeleton(), &mut folded, 3);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, "")), [0, 1, 3, 2, 4]);
    }

    #[test]
    fn a_joint_that_is_folded_away_has_the_row_of_the_branch_and_none_in_a_search() {
        let (skeleton, folded) = (skeleton(), BTreeSet::from([1]));
        let rows = rows_of(&skeleton, &folded, "");
        let row = |joint| row_with(&skeleton, &rows, joint).map(|row| rows[row].joint);
        assert_eq!([0, 1, 2, 3].map(row), [Some(0), Some(1), Some(2), Some(1)]);
        let found = rows_of(&skeleton, &folded, "hip");
        assert_eq!(row_with(&skeleton, &found, 3), None);
        assert!(row_with(&skeleton, &found, 1).is_some());
    }

    #[test]
    fn a_search_finds_folded_joints_too_whatever_the_case() {
        let folded = BTreeSet::from([0]);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, " LEFT ")), [1, 3]);
        assert!(rows_of(&skeleton(), &folded, "tail").is_empty());
    }
}
