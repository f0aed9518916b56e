//! Which joint a weight belongs to.

use super::formula::{AtEnd, Columns, Formula};
use super::model::Model;

/// The joints as a program numbers them.
#[derive(Debug)]
pub(super) struct JointList<'a> {
    /// Joint that each index means.
    order: Vec<usize>,
    /// The joints in the own list of a Collada file's skin, in which numbers of weights count; empty without one.
    of_skin: &'a [usize],
}

impl<'a> JointList<'a> {
    pub(super) fn new(model: &Model<'a>, formula: &Formula) -> Self {
        let frames = model.character.file_frames();
        Self {
            order: model.joints_by(formula.joint_order.by),
            of_skin: frames.map_or(&[], |frames| &frames.skin_joints),
        }
    }

    /// Joint that each index means.
    pub(super) fn order(&self) -> &[usize] {
        &self.order
    }

    /// The joint that a weight moves a vertex with whose index in the file is `index`; `None` if it is
    /// taken for none.
    pub(super) fn joint(&self, columns: Columns, index: usize) -> Option<usize> {
        let is_last = index + 1 == self.order.len();
        let is_first = || self.next_to(index, true, AtEnd::Lost).is_none() && index > 0;
        let moved = match columns {
            Columns::Before(at_end) => self.next_to(index, true, at_end)?,
            Columns::After(at_end) => self.next_to(index, false, at_end)?,
            Columns::FirstAlone if !is_first() => return None,
            Columns::LastAlone if !is_last => return None,
            Columns::WithoutLast if is_last => return None,
            Columns::Without(joint) if index == joint => return None,
            Columns::Exchanged(a, b) if index == a => b,
            Columns::Exchanged(a, b) if index == b => a,
            Columns::Exact
            | Columns::FirstAlone
            | Columns::LastAlone
            | Columns::WithoutLast
            | Columns::Without(_)
            | Columns::Exchanged(..) => index,
        };
        self.order.get(moved).copied()
    }

    /// The joint next to that at `index` in the list that numbers count in: the one before it if `is_before`.
    fn next_to(&self, index: usize, is_before: bool, at_end: AtEnd) -> Option<usize> {
        let list = self.of_skin;
        let in_list = list.iter().position(|&joint| joint == index);
        let (place, count) = in_list.map_or((index, self.order.len()), |place| (place, list.len()));
        // The root, which comes first, has no column in an .attach file.
        let is_by_columns = matches!(at_end, AtEnd::Lost | AtEnd::OtherColumn);
        let first = usize::from(in_list.is_none() && is_by_columns);
        let next = match is_before {
            true => place.checked_sub(1).filter(|next| *next >= first),
            false => Some(place + 1).filter(|next| *next < count),
        };
        let joint_at = |place: usize| {
            if in_list.is_some() {
                list[place]
            } else {
                place
            }
        };
        let unlisted = |joint: &usize| !list.contains(joint);
        match (next, at_end) {
            (Some(next), _) => Some(joint_at(next)),
            (None, AtEnd::OfAll) if is_before => index.checked_sub(1).filter(unlisted),
            (None, AtEnd::OfAll) => Some(index + 1).filter(unlisted),
            (None, AtEnd::Lost) => None,
            (None, AtEnd::Same) => Some(index),
            (None, AtEnd::OtherEnd | AtEnd::OtherColumn) if is_before => Some(joint_at(count - 1)),
            (None, AtEnd::OtherEnd | AtEnd::OtherColumn) => Some(joint_at(first.min(count - 1))),
        }
    }
}
