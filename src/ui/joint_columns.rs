//! Where things stand in the rows of the joint list.

use super::joint_tree::Row;
use super::number_field::ROOM_FOR_LETTER_AND_ANGLE;
use crate::character::SkeletalModel;
use egui::{Color32, FontId, Rect, TextStyle, Ui, pos2, vec2};

const HEIGHT: f32 = 20.0;
const INDENT: f32 = 6.0;
/// Deeper joints are indented no further: their names need the room.
const DEEPEST: usize = 8;
const ARROW: f32 = 12.0;
const RESET: f32 = 16.0;
const GAP: f32 = 2.0;
/// A field's width: at least that of `329.5°`, and no more than is comfortable.
const FIELD: std::ops::RangeInclusive<f32> = 41.0..=64.0;

/// Of lists with more rows than this only the rows in sight are shown to egui, and names are
/// not measured: the panel must stay quick whatever a file holds.
pub(super) const MANY: usize = 512;

/// Where things stand in all rows of the list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    width: f32,
    field: f32,
    /// Whether the fields stand below the name, because some name leaves them no room beside it.
    stacked: bool,
}

impl Columns {
    /// Makes the fields as wide as the longest name leaves room for, and puts them below the
    /// names where it leaves too little: names are never cut.
    pub(super) fn new(ui: &Ui, skeleton: &SkeletalModel, rows: &[Row]) -> Self {
        let width = ui.available_width();
        let font = font(ui);
        let name = |row: &Row| {
            let name = &skeleton.joints()[row.joint].name;
            name_left(row) + text_width(ui, name, &font)
        };
        let is_root = |row: &&Row| skeleton.joints()[row.joint].parent.is_none();
        let offset = |row: &Row| offset_left(row) + text_width(ui, OFFSET, &font);
        let first = rows.iter().take(MANY);
        let offsets = first.clone().filter(is_root).map(offset);
        let longest = first.map(name).chain(offsets).fold(0.0, f32::max);
        let field = ((width - longest - RESET - 3.0 * GAP - 2.0) / 3.0).floor();
        let stacked = rows.len() > MANY || field < *FIELD.start();
        let room = if stacked {
            width - RESET - 3.0 * GAP - 20.0
        } else {
            width
        };
        let field = if stacked { (room / 3.0).floor() } else { field };
        Self {
            width,
            field: field.clamp(*FIELD.start(), *FIELD.end()),
            stacked,
        }
    }

    /// Whether letters above the columns are needed to tell the axes, since the fields are too
    /// narrow to have their own.
    pub(super) fn need_header(&self) -> bool {
        self.field < ROOM_FOR_LETTER_AND_ANGLE
    }

    /// Makes room for the letters above the columns.
    pub(super) fn place_header(&self, ui: &mut Ui) -> Rect {
        ui.allocate_space(vec2(self.width, 14.0)).1
    }

    fn top_of_fields(&self, row: Rect) -> f32 {
        row.top() + if self.stacked { HEIGHT } else { 0.0 }
    }

    fn height(&self) -> f32 {
        if self.stacked { 2.0 * HEIGHT } else { HEIGHT }
    }

    /// Makes room for the next row.
    pub(super) fn place(&self, ui: &mut Ui) -> Rect {
        let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.y, 0.0);
        let (_, rect) = ui.allocate_space(vec2(self.width, self.height()));
        ui.spacing_mut().item_spacing.y = spacing;
        rect
    }

    /// The field of `axis` in the row that fills `row`.
    pub(super) fn field(&self, row: Rect, axis: usize) -> Rect {
        let right = row.right() - RESET - GAP - (2 - axis) as f32 * (self.field + GAP);
        let top = self.top_of_fields(row);
        Rect::from_min_max(
            pos2(right - self.field, top + 1.0),
            pos2(right, top + HEIGHT - 1.0),
        )
    }

    /// The button at the end of the row that fills `row`.
    pub(super) fn reset(&self, row: Rect) -> Rect {
        let top = self.top_of_fields(row);
        Rect::from_min_size(pos2(row.right() - RESET, top + 2.0), vec2(RESET, RESET))
    }

    /// The name in the row that fills `row`, from `left` within it.
    pub(super) fn name(&self, row: Rect, left: f32) -> Rect {
        let right = if self.stacked {
            row.right()
        } else {
            self.field(row, 0).left() - GAP
        };
        Rect::from_min_max(
            pos2(row.left() + left, row.top()),
            pos2(right, row.top() + HEIGHT),
        )
    }
}

/// The arrow before a name that starts at `left` in the row that fills `row`.
pub(super) fn arrow(row: Rect, left: f32) -> Rect {
    Rect::from_min_size(
        pos2(row.left() + left - ARROW, row.top()),
        vec2(ARROW, HEIGHT),
    )
}

/// Left edge of the name within a row.
pub(super) fn name_left(row: &Row) -> f32 {
    row.depth.min(DEEPEST) as f32 * INDENT + ARROW
}

/// What the row below a root is called.
pub(super) const OFFSET: &str = "Offset";

/// Left edge of that within the row: as far in as the names of the root's children.
pub(super) fn offset_left(root: &Row) -> f32 {
    name_left(root) + INDENT
}

/// What names are written in.
pub(super) fn font(ui: &Ui) -> FontId {
    FontId {
        size: 13.0,
        ..TextStyle::Body.resolve(ui.style())
    }
}

fn text_width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    ui.painter()
        .layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE)
        .size()
        .x
}
