//! Joints that are marked in the list: selected, under the pointer, changed, folded away.

use super::joint_rows::Look;
use super::joint_tree::{Row, parent_of, row_with};
use crate::character::{Pose, SkeletalModel};
use crate::editor::Session;
use crate::scene::CharacterShape;
use std::collections::BTreeSet;

/// Joints of a character that are marked in the list.
pub(super) struct Marks<'a> {
    skeleton: &'a SkeletalModel,
    pose: &'a Pose,
    selected: &'a [usize],
    hovered: Option<usize>,
    /// Row that the active joint is folded away in, with that joint; the same of the hovered one.
    folded_away: [Option<(usize, usize)>; 2],
    /// Joints above one that is not at rest.
    above_changed: BTreeSet<usize>,
    /// Joint of the row to which Tab goes.
    tab_stop: Option<usize>,
}

impl<'a> Marks<'a> {
    pub(super) fn new(session: &'a Session, character: &'a CharacterShape, rows: &[Row]) -> Self {
        let (skeleton, pose) = (character.character.skeleton(), character.pose());
        let (active, hovered) = (session.selected_joint(), session.hovered_joint());
        let folded_away = [active, hovered].map(|joint| {
            let joint = joint?;
            let row = rows.get(row_with(skeleton, rows, joint)?)?;
            (row.joint != joint).then_some((row.joint, joint))
        });
        let mut above_changed = BTreeSet::new();
        for joint in (0..skeleton.joints().len()).filter(|&joint| pose.is_changed(joint)) {
            let mut above = parent_of(skeleton, joint);
            while let Some(joint) = above.filter(|&joint| above_changed.insert(joint)) {
                above = parent_of(skeleton, joint);
            }
        }
        Self {
            skeleton,
            pose,
            selected: session.selected_joints(),
            hovered,
            folded_away,
            above_changed,
            tab_stop: active.or(rows.first().map(|row| row.joint)),
        }
    }

    /// Marks of a row.
    pub(super) fn look(&self, row: &Row) -> Look<'a> {
        let is_folded = row.folded == Some(true);
        let inside = self.folded_away.iter().flatten();
        let inside = inside.clone().find(|&&(at, _)| at == row.joint);
        let joint = inside.and_then(|&(_, joint)| self.skeleton.joints().get(joint));
        Look {
            selected: self.selected.contains(&row.joint),
            hovered: self.hovered == Some(row.joint),
            changed: self.pose.is_changed(row.joint),
            changed_inside: is_folded && self.above_changed.contains(&row.joint),
            inside: joint.map(|joint| joint.name.as_str()),
            stops_tab: self.tab_stop == Some(row.joint),
        }
    }
}
