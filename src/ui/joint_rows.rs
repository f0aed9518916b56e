//! Rows of the joint list: their layout, angles of a joint, offset of a root.

use super::joint_list::Row;
use super::number_field::{NumberField, ROOM_FOR_LETTER_AND_ANGLE};
use super::theme::{Palette, number_font};
use super::widgets::{ListMove, list_move, named};
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use egui::{
    Align2, Color32, FontId, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui,
    WidgetInfo, WidgetType, pos2, vec2,
};
use glam::Vec3;

const HEIGHT: f32 = 20.0;
const INDENT: f32 = 6.0;
/// Depth from which joints are indented no further: their names need the room.
const DEEPEST: usize = 8;
const ARROW: f32 = 12.0;
const RESET: f32 = 16.0;
const GAP: f32 = 2.0;
/// Width of a field in points: at least that of `329.5°`.
const FIELD: std::ops::RangeInclusive<f32> = 41.0..=64.0;

/// Number of rows above which only the rows in view are shown to egui, and names are not measured:
/// the panel must stay fast for any file.
pub(super) const MANY: usize = 512;

/// Layout of the rows: a name, three fields and a reset button. Lengths are in points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    width: f32,
    field: f32,
    /// Whether fields are below the name, because some name leaves no room for them beside it.
    stacked: bool,
}

impl Columns {
    /// Fields as wide as the longest name leaves room for; below the names if that is too little:
    /// names are never truncated.
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

    /// Whether letters of the axes are needed above the columns, because the fields are too narrow
    /// for their own.
    fn need_header(&self) -> bool {
        self.field < ROOM_FOR_LETTER_AND_ANGLE
    }

    /// Allocates the row of letters above the columns.
    fn place_header(&self, ui: &mut Ui) -> Rect {
        ui.allocate_space(vec2(self.width, 14.0)).1
    }

    fn top_of_fields(&self, row: Rect) -> f32 {
        row.top() + if self.stacked { HEIGHT } else { 0.0 }
    }

    fn height(&self) -> f32 {
        if self.stacked { 2.0 * HEIGHT } else { HEIGHT }
    }

    /// Allocates the next row.
    pub(super) fn place(&self, ui: &mut Ui) -> Rect {
        let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.y, 0.0);
        let (_, rect) = ui.allocate_space(vec2(self.width, self.height()));
        ui.spacing_mut().item_spacing.y = spacing;
        rect
    }

    /// Rectangle of the field of `axis` in a row.
    fn field(&self, row: Rect, axis: usize) -> Rect {
        let right = row.right() - RESET - GAP - (2 - axis) as f32 * (self.field + GAP);
        let top = self.top_of_fields(row);
        Rect::from_min_max(
            pos2(right - self.field, top + 1.0),
            pos2(right, top + HEIGHT - 1.0),
        )
    }

    /// Rectangle of the reset button at the end of a row.
    fn reset(&self, row: Rect) -> Rect {
        let top = self.top_of_fields(row);
        Rect::from_min_size(pos2(row.right() - RESET, top + 2.0), vec2(RESET, RESET))
    }

    /// Rectangle of the name in a row, from `left` within it.
    fn name(&self, row: Rect, left: f32) -> Rect {
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

/// Rectangle of the arrow before a name that starts at `left` within a row.
fn arrow(row: Rect, left: f32) -> Rect {
    Rect::from_min_size(
        pos2(row.left() + left - ARROW, row.top()),
        vec2(ARROW, HEIGHT),
    )
}

/// Left edge of the name within a row.
fn name_left(row: &Row) -> f32 {
    row.depth.min(DEEPEST) as f32 * INDENT + ARROW
}

/// Label of the row below a root.
const OFFSET: &str = "Offset";

/// Left edge of that label within its row: that of the names of the root's children.
fn offset_left(root: &Row) -> f32 {
    name_left(root) + INDENT
}

/// Font of names.
fn font(ui: &Ui) -> FontId {
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

/// Marks of a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub selected: bool,
    pub hovered: bool,
}

/// Input of the user in a row.
#[derive(Clone, Copy, Debug)]
pub(super) enum RowEvent {
    Fold,
    Select,
    /// A new angle about an axis (0 for x, 1 for y, 2 for z), in degrees.
    Turn(usize, f32),
    /// Reset of all three angles to 0.
    Reset,
    /// A new offset of a root from its place at rest, in the character's space.
    Offset(Vec3),
    Move(ListMove),
}

/// A joint's row as it was shown.
pub(super) struct Shown {
    /// Widget of the name, which has the keyboard focus for the row.
    pub name: Response,
    pub hovered: bool,
    pub event: Option<RowEvent>,
}

/// Shows the letters above the three columns, if they are needed.
pub(super) fn show_header(ui: &mut Ui, columns: &Columns) {
    if !columns.need_header() {
        return;
    }
    let row = columns.place_header(ui);
    let axes = Palette::of(ui.visuals()).axes;
    let font = TextStyle::Small.resolve(ui.style());
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let at = pos2(columns.field(row, axis).center().x, row.center().y);
        ui.painter()
            .text(at, Align2::CENTER_CENTER, letter, font.clone(), axes[axis]);
    }
}

/// Shows the row of one joint in `rect`.
pub(super) fn show_joint(
    ui: &mut Ui,
    skeleton: &SkeletalModel,
    pose: &Pose,
    row: &Row,
    rect: Rect,
    look: Look,
    columns: &Columns,
) -> Shown {
    let id = ui.id().with(("joint", row.joint));
    let name = &skeleton.joints()[row.joint].name;
    let changed = pose.is_changed(row.joint);
    let hovered = ui.rect_contains_pointer(rect);

    let left = name_left(row);
    let label = ui.interact(columns.name(rect, left), id, Sense::click());
    paint_background(ui, rect, look, hovered, &label);
    let mut event = label.clicked().then_some(RowEvent::Select);
    if label.clicked() {
        label.request_focus();
    }
    if let Some(movement) = list_move(ui, &label) {
        event = Some(RowEvent::Move(movement));
    }
    paint_name(ui, &label, name, changed, look);
    if row.folded.is_some() && fold_arrow(ui, id, rect, left, row, name) {
        event = Some(RowEvent::Fold);
    }

    let degrees = pose.rotation(row.joint).degrees();
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{name} {letter}");
        let field = NumberField::degrees(&called, degrees[axis]).axis(axis);
        if let Some(value) = field.show_at(ui, id.with(("angle", axis)), columns.field(rect, axis))
        {
            event = Some(RowEvent::Turn(axis, value));
        }
    }
    let turned = pose.rotation(row.joint) != Euler::ZERO;
    if turned && reset_button(ui, id.with("reset"), columns.reset(rect), name) {
        event = Some(RowEvent::Reset);
    }
    Shown {
        name: label,
        hovered,
        event,
    }
}

fn paint_background(ui: &Ui, rect: Rect, look: Look, hovered: bool, label: &Response) {
    let palette = Palette::of(ui.visuals());
    if look.selected {
        ui.painter().rect_filled(rect, 3.0, palette.selection);
    } else if look.hovered || hovered {
        ui.painter().rect_filled(rect, 3.0, palette.field);
    }
    if label.has_focus() {
        let stroke = Stroke::new(1.0, palette.accent);
        ui.painter()
            .rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
    }
}

fn paint_name(ui: &Ui, label: &Response, name: &str, changed: bool, look: Look) {
    let palette = Palette::of(ui.visuals());
    let color = match (look.selected, changed) {
        (true, _) => palette.on_selection,
        (false, true) => palette.strong,
        (false, false) => palette.text,
    };
    let visible = label.rect.intersect(ui.clip_rect());
    let painter = ui.painter().with_clip_rect(visible);
    let at = label.rect.left_center();
    let written = painter.text(at, Align2::LEFT_CENTER, name, font(ui), color);
    label.widget_info(|| {
        WidgetInfo::selected(
            WidgetType::SelectableLabel,
            ui.is_enabled(),
            look.selected,
            name,
        )
    });
    if written.right() > label.rect.right() {
        label.clone().on_hover_text(name);
    }
}

fn fold_arrow(ui: &Ui, id: Id, row: Rect, left: f32, at: &Row, name: &str) -> bool {
    let rect = arrow(row, left);
    let folded = at.folded.unwrap_or(false);
    let (symbol, does) = if folded {
        ("⏵", "Unfold")
    } else {
        ("⏷", "Fold")
    };
    let label = format!("{does} {name}");
    let button = ui.interact(rect, id.with("fold"), Sense::click());
    let color = ui.style().interact(&button).text_color();
    let font = TextStyle::Small.resolve(ui.style());
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, symbol, font, color);
    focus_ring(ui, &button);
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), &label));
    button.on_hover_text(&label).clicked()
}

/// Button that resets `name`; whether it was clicked. It is shown only beside numbers that are not
/// at rest, so that it marks them, too.
fn reset_button(ui: &Ui, id: Id, rect: Rect, name: &str) -> bool {
    let label = format!("Reset {name}");
    let button = ui.interact(rect, id, Sense::click());
    let visuals = ui.style().interact(&button);
    if button.hovered() {
        ui.painter()
            .rect_filled(rect, visuals.corner_radius, visuals.weak_bg_fill);
    }
    ui.painter().text(
        rect.center(),
        Align2::CENTER_CENTER,
        "↺",
        number_font(),
        Palette::of(ui.visuals()).accent,
    );
    focus_ring(ui, &button);
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), &label));
    named(button, &label)
        .on_hover_text(format!("Put {name} back to rest"))
        .clicked()
}

fn focus_ring(ui: &Ui, button: &Response) {
    if button.has_focus() {
        let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).accent);
        ui.painter()
            .rect_stroke(button.rect, 2.0, stroke, StrokeKind::Inside);
    }
}

/// A root's offset as it was shown.
pub(super) struct ShownOffset {
    pub hovered: bool,
    /// The new offset from the place at rest, in the character's space, if it was changed.
    pub offset: Option<Vec3>,
}

/// Shows the offset of a root in `rect`, below the row `row` of the root itself.
pub(super) fn show_offset(
    ui: &mut Ui,
    skeleton: &SkeletalModel,
    pose: &Pose,
    row: &Row,
    rect: Rect,
    columns: &Columns,
) -> ShownOffset {
    let hovered = ui.rect_contains_pointer(rect);
    let palette = Palette::of(ui.visuals());
    if hovered {
        ui.painter().rect_filled(rect, 3.0, palette.field);
    }
    let at = columns.name(rect, offset_left(row)).left_center();
    let font = font(ui);
    ui.painter()
        .text(at, Align2::LEFT_CENTER, OFFSET, font, palette.weak);

    let called = format!("{} {OFFSET}", skeleton.joints()[row.joint].name);
    let id = ui.id().with(("root", row.joint));
    let now = pose.root_offset(row.joint);
    let mut offset = None;
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{called} {letter}");
        let field = NumberField::new(&called, now[axis], 0.1)
            .decimals(2..=3)
            .axis(axis);
        if let Some(value) = field.show_at(ui, id.with(axis), columns.field(rect, axis)) {
            let mut moved = now;
            moved[axis] = value;
            offset = Some(moved);
        }
    }
    let moved = now != Vec3::ZERO;
    if moved && reset_button(ui, id.with("reset"), columns.reset(rect), &called) {
        offset = Some(Vec3::ZERO);
    }
    ShownOffset { hovered, offset }
}
