//! Layout of the joint list: one line a joint, with its name, three fields and a reset button.

use super::joint_tree::Row;
use super::number_field::ROOM_FOR_LETTER_AND_ANGLE;
use super::shortened::{shortened, text_width};
use crate::character::SkeletalModel;
use egui::{FontId, Rect, TextStyle, Ui, pos2, vec2};

/// So many levels are indented by so many points each; deeper ones no further: names need the room,
/// but what hangs on what is to be seen, too.
const INDENTS: [(usize, f32); 3] = [(8, 4.0), (8, 2.0), (32, 1.0)];
/// The least part of it, where names need the room.
const LEAST_INDENT: f32 = 0.5;
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
    /// By how much rows are indented, of what [`INDENTS`] say.
    indent: f32,
    /// Number of bytes at the start of every name that say nothing, because all names share them.
    prefix: usize,
}

impl Columns {
    /// Fields as wide as the longest name leaves room for. Where a name is too long even for the narrowest fields, all are
    /// indented less; one that is still too long loses its middle, so that each joint keeps to one line.
    pub(super) fn new(ui: &Ui, skeleton: &SkeletalModel, rows: &[Row]) -> Self {
        let width = ui.available_width();
        let prefix = common_prefix(skeleton);
        let font = font(ui);
        let measured = if rows.len() > MANY { &[] } else { rows };
        let names = measured.iter().map(|row| {
            let name = &skeleton.joints()[row.joint].name;
            (row.depth, text_width(ui, &name[prefix..], &font))
        });
        let is_root = |row: &&Row| skeleton.joints()[row.joint].parent.is_none();
        let offset = |row: &Row| (row.depth + 1, text_width(ui, OFFSET, &font));
        let offsets = measured.iter().filter(is_root).map(offset);
        let labels: Vec<(usize, f32)> = names.chain(offsets).collect();
        let room_beside = |field: f32| width - RESET - 4.0 * GAP - 3.0 * field;
        let least = room_beside(*FIELD.start());
        // What has no room even so, and what is not indented, gains nothing by it.
        let fitting = labels
            .iter()
            .map(|&(depth, text)| (least - ARROW - text) / indent(depth));
        let indent_by = fitting
            .filter(|part| *part >= LEAST_INDENT)
            .fold(1.0, f32::min);
        let label = |(depth, text): &(usize, f32)| indent(*depth) * indent_by + ARROW + text;
        let longest = labels.iter().map(label).fold(0.0, f32::max);
        let room = if labels.is_empty() {
            0.0
        } else {
            room_beside(0.0) - longest
        };
        let field = (room / 3.0).floor().clamp(*FIELD.start(), *FIELD.end());
        Self {
            width,
            field,
            indent: indent_by,
            prefix,
        }
    }

    /// Left edge of the name within a row.
    pub(super) fn name_left(&self, row: &Row) -> f32 {
        self.left(row.depth)
    }

    /// Left edge of [`OFFSET`] within the row below a root: that of the names of the root's children.
    pub(super) fn offset_left(&self, root: &Row) -> f32 {
        self.left(root.depth + 1)
    }

    fn left(&self, depth: usize) -> f32 {
        indent(depth) * self.indent + ARROW
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

    #[test]
    fn where_names_are_too_long_rows_are_indented_less_before_a_name_is_cut() {
        let named = |last: &str| {
            let names = (0..10).map(|joint| format!("Joint {joint}"));
            let names = names.chain([last.to_owned()]).enumerate();
            let joints = names.map(|(index, name)| Joint {
                name,
                parent: index.checked_sub(1),
                ..Joint::default()
            });
            SkeletalModel::new(joints.collect()).expect("a chain")
        };
        let shown = |last: &str| {
            let (skeleton, mut shown) = (named(last), (0.0, 0.0));
            let rows: Vec<Row> = (0..11)
                .map(|joint| Row {
                    joint,
                    depth: joint,
                    folded: None,
                })
                .collect();
            let context = egui::Context::default();
            let mut output = context.run_ui(egui::RawInput::default(), |ui| {
                ui.set_max_width(250.0);
                let columns = Columns::new(ui, &skeleton, &rows);
                let row = columns.place(ui);
                let name = columns.name(row, columns.name_left(&rows[10]));
                shown = (
                    columns.indent,
                    name.width() - text_width(ui, last, &font(ui)),
                );
            });
            output.textures_delta.clear();
            shown
        };
        let (indent, room) = shown("Short");
        assert!(indent == 1.0 && room > 0.0, "{indent} {room}");
        let (indent, room) = shown("Right middle 2");
        assert!(indent < 1.0 && room >= -0.01, "{indent} {room}");
        // That does not help what is far too long.
        let (indent, room) = shown("A name that has no room whatever is done");
        assert!(indent == 1.0 && room < 0.0, "{indent} {room}");
    }
}
