//! Layout of the joint list: one line a joint, with its name, three fields and a reset button.

use super::joint_tree::Row;
use super::number_field::ROOM_FOR_LETTER_AND_ANGLE;
use super::shortened::{shortened, text_width};
use crate::character::SkeletalModel;
use egui::{FontId, Rect, TextStyle, Ui, pos2, vec2};

/// So many levels are indented by so many points each; deeper ones no further: names need the room,
/// but what hangs on what is to be seen, too.
const INDENTS: [(usize, f32); 3] = [(8, 4.0), (8, 2.0), (32, 1.0)];
const ARROW: f32 = 12.0;
const RESET: f32 = 14.0;
const GAP: f32 = 2.0;
/// Width of a field in points: at least that of `-179°`.
const FIELD: std::ops::RangeInclusive<f32> = 36.0..=64.0;

/// Number of rows above which only the rows in view are shown to egui, and names are not measured:
/// the panel must stay fast for any file.
pub(super) const MANY: usize = 512;

/// Layout of the rows: a name, three fields and a reset button. Lengths are in points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    width: f32,
    field: f32,
    /// Number of bytes at the start of every name that say nothing, because all names share them.
    prefix: usize,
}

impl Columns {
    /// Fields as wide as the longest name leaves room for. A name that is too long even for the
    /// narrowest fields loses its middle, so that each joint keeps to one line.
    pub(super) fn new(ui: &Ui, skeleton: &SkeletalModel, rows: &[Row]) -> Self {
        let width = ui.available_width();
        let prefix = common_prefix(skeleton);
        let font = font(ui);
        let measured = if rows.len() > MANY { &[] } else { rows };
        let name = |row: &Row| {
            let name = &skeleton.joints()[row.joint].name;
            name_left(row) + text_width(ui, &name[prefix..], &font)
        };
        let is_root = |row: &&Row| skeleton.joints()[row.joint].parent.is_none();
        let offset = |row: &Row| offset_left(row) + text_width(ui, OFFSET, &font);
        let offsets = measured.iter().filter(is_root).map(offset);
        let longest = measured.iter().map(name).chain(offsets);
        let longest = longest.fold(0.0, f32::max);
        let room = if measured.is_empty() {
            0.0
        } else {
            width - longest - RESET - 4.0 * GAP
        };
        let field = (room / 3.0).floor().clamp(*FIELD.start(), *FIELD.end());
        Self {
            width,
            field,
            prefix,
        }
    }

    /// A joint's name as it is written: without what all names begin with.
    pub(super) fn written<'a>(&self, name: &'a str) -> &'a str {
        name.get(self.prefix..).unwrap_or(name)
    }

    /// Whether letters of the axes are needed above the columns, because the fields are too narrow
    /// for their own.
    pub(super) fn need_header(&self) -> bool {
        self.field < ROOM_FOR_LETTER_AND_ANGLE
    }

    /// Allocates the row of letters above the columns.
    pub(super) fn place_header(&self, ui: &mut Ui) -> Rect {
        ui.allocate_space(vec2(self.width, 14.0)).1
    }

    /// Allocates the next row.
    pub(super) fn place(&self, ui: &mut Ui) -> Rect {
        let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.y, 0.0);
        let (_, rect) = ui.allocate_space(vec2(self.width, ui.spacing().interact_size.y));
        ui.spacing_mut().item_spacing.y = spacing;
        rect
    }

    /// Rectangle of the field of `axis` in a row.
    pub(super) fn field(&self, row: Rect, axis: usize) -> Rect {
        let right = row.right() - RESET - GAP - (2 - axis) as f32 * (self.field + GAP);
        Rect::from_min_max(
            pos2(right - self.field, row.top() + 1.0),
            pos2(right, row.bottom() - 1.0),
        )
    }

    /// Rectangle of the reset button at the end of a row.
    pub(super) fn reset(&self, row: Rect) -> Rect {
        let corner = pos2(row.right() - RESET, row.top() + 2.0);
        Rect::from_min_size(corner, vec2(RESET, row.height() - 4.0))
    }

    /// Rectangle of the name in a row, from `left` within it.
    pub(super) fn name(&self, row: Rect, left: f32) -> Rect {
        Rect::from_min_max(
            pos2(row.left() + left, row.top()),
            pos2(self.field(row, 0).left() - GAP, row.bottom()),
        )
    }
}

/// Rectangle of the arrow before a name that starts at `left` within a row.
pub(super) fn arrow(row: Rect, left: f32) -> Rect {
    let corner = pos2(row.left() + left - ARROW, row.top());
    Rect::from_min_size(corner, vec2(ARROW, row.height()))
}

/// Left edge of the name within a row.
pub(super) fn name_left(row: &Row) -> f32 {
    indent(row.depth) + ARROW
}

fn indent(mut depth: usize) -> f32 {
    let mut sum = 0.0;
    for (levels, step) in INDENTS {
        let part = depth.min(levels);
        sum += part as f32 * step;
        depth -= part;
    }
    sum
}

/// Label of the row below a root.
pub(super) const OFFSET: &str = "Offset";

/// Left edge of that label within its row: that of the names of the root's children.
pub(super) fn offset_left(root: &Row) -> f32 {
    indent(root.depth + 1) + ARROW
}

/// Font of names.
pub(super) fn font(ui: &Ui) -> FontId {
    FontId {
        size: 13.0,
        ..TextStyle::Body.resolve(ui.style())
    }
}

/// A joint and another one that is folded away in it, of which the latter is shortened last.
pub(super) fn shortened_path(ui: &Ui, folded: &str, inside: &str, room: f32) -> String {
    let end = format!(" › {inside}");
    let font = font(ui);
    let left = room - text_width(ui, &end, &font);
    let path = shortened(ui, folded, &font, left) + &end;
    shortened(ui, &path, &font, room)
}

/// Number of bytes of the namespace, such as `mixamorig:`, that all names begin with.
fn common_prefix(skeleton: &SkeletalModel) -> usize {
    let joints = skeleton.joints();
    let first = joints.first().map_or("", |joint| &joint.name);
    let Some(end) = first.rfind(':').map(|colon| colon + 1) else {
        return 0;
    };
    let prefix = &first[..end];
    let is_shared = |name: &str| name.len() > end && name.starts_with(prefix);
    let all = joints.iter().all(|joint| is_shared(&joint.name));
    if all { end } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;

    fn prefix_of(names: &[&str]) -> usize {
        let joints = names.iter().enumerate().map(|(index, name)| Joint {
            name: (*name).to_owned(),
            parent: index.checked_sub(1),
            ..Joint::default()
        });
        common_prefix(&SkeletalModel::new(joints.collect()).expect("a chain"))
    }

    #[test]
    fn a_namespace_that_all_joints_share_is_not_written() {
        assert_eq!(prefix_of(&["mixamorig:Hips", "mixamorig:Spine"]), 10);
        assert_eq!(prefix_of(&["mixamorig:Hips", "Spine"]), 0);
        assert_eq!(prefix_of(&["Left hip", "Left knee"]), 0);
        assert_eq!(prefix_of(&["a:", "a:b"]), 0, "no name becomes empty");
    }

    #[test]
    fn deeper_joints_are_indented_further_but_ever_less() {
        let at = [0, 1, 8, 9, 16, 17, 48, 1000].map(indent);
        assert_eq!(at, [0.0, 4.0, 32.0, 34.0, 48.0, 49.0, 80.0, 80.0]);
    }
}
