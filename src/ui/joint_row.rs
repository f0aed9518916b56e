use super::joint_tree::Row;
use super::number_field::NumberField;
use super::theme::{Palette, number_font};
use super::widgets::{ListMove, list_move, named};
use crate::character::{Pose, SkeletalModel};
use egui::{
    Align2, Color32, FontId, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui,
    WidgetInfo, WidgetType, pos2, vec2,
};
use glam::Vec3;

const HEIGHT: f32 = 20.0;
const INDENT: f32 = 6.0;
/// Deeper joints are indented no further: their names need the room.
const DEEPEST: usize = 8;
const ARROW: f32 = 12.0;
const RESET: f32 = 16.0;
const GAP: f32 = 2.0;
/// A field's width: at least that of `329.5`, and no more than is comfortable.
const FIELD: std::ops::RangeInclusive<f32> = 36.0..=64.0;

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

/// How a row looks beyond what it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub selected: bool,
    pub hovered: bool,
}

/// What a user did in a row.
#[derive(Clone, Copy, Debug)]
pub(super) enum RowEvent {
    Fold,
    Select,
    /// New angles, in degrees.
    Turn(Vec3),
    Reset,
    Move(ListMove),
}

/// A row as it was shown.
pub(super) struct Shown {
    /// The name, which has the keyboard for the row.
    pub name: Response,
    pub hovered: bool,
    pub event: Option<RowEvent>,
}

impl Columns {
    /// Makes the fields as wide as the longest name leaves room for, and puts them below the
    /// names where it leaves too little: names are never cut.
    pub(super) fn new(ui: &Ui, skeleton: &SkeletalModel, rows: &[Row]) -> Self {
        let width = ui.available_width();
        let font = font(ui);
        let longest = rows
            .iter()
            .take(MANY)
            .map(|row| name_left(row) + text_width(ui, &skeleton.joints()[row.joint].name, &font))
            .fold(0.0, f32::max);
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

    fn height(&self) -> f32 {
        if self.stacked { 2.0 * HEIGHT } else { HEIGHT }
    }

    /// The field of `axis` in the row that fills `row`.
    fn field(&self, row: Rect, axis: usize) -> Rect {
        let right = row.right() - RESET - GAP - (2 - axis) as f32 * (self.field + GAP);
        let top = if self.stacked {
            row.top() + HEIGHT
        } else {
            row.top()
        };
        Rect::from_min_max(
            pos2(right - self.field, top + 1.0),
            pos2(right, top + HEIGHT - 1.0),
        )
    }

    fn reset(&self, row: Rect) -> Rect {
        let top = if self.stacked {
            row.top() + HEIGHT
        } else {
            row.top()
        };
        Rect::from_min_size(pos2(row.right() - RESET, top + 2.0), vec2(RESET, RESET))
    }

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

/// The letters above the three columns.
pub(super) fn header(ui: &mut Ui, columns: &Columns) {
    if columns.stacked {
        return;
    }
    let (_, row) = ui.allocate_space(vec2(columns.width, 14.0));
    let axes = Palette::of(ui.visuals()).axes;
    let font = TextStyle::Small.resolve(ui.style());
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let at = pos2(columns.field(row, axis).center().x, row.center().y);
        ui.painter()
            .text(at, Align2::CENTER_CENTER, letter, font.clone(), axes[axis]);
    }
}

/// Makes room for the next row.
pub(super) fn place(ui: &mut Ui, columns: &Columns) -> Rect {
    let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.y, 0.0);
    let (_, rect) = ui.allocate_space(vec2(columns.width, columns.height()));
    ui.spacing_mut().item_spacing.y = spacing;
    rect
}

/// Shows the row of one joint in `rect`.
pub(super) fn show(
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

    let degrees = pose.rotation(row.joint).wrapped_degrees();
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{name} {letter}");
        let field = NumberField::degrees(&called, degrees[axis]).axis(axis);
        if let Some(value) = field.show_at(ui, id.with(("angle", axis)), columns.field(rect, axis))
        {
            let mut turned = degrees;
            turned[axis] = value;
            event = Some(RowEvent::Turn(turned));
        }
    }
    if changed && reset_button(ui, id.with("reset"), columns.reset(rect), name) {
        event = Some(RowEvent::Reset);
    }
    Shown {
        name: label,
        hovered,
        event,
    }
}

/// Left edge of the name within a row.
fn name_left(row: &Row) -> f32 {
    row.depth.min(DEEPEST) as f32 * INDENT + ARROW
}

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
    let rect = Rect::from_min_size(
        pos2(row.left() + left - ARROW, row.top()),
        vec2(ARROW, HEIGHT),
    );
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

/// Shown on turned joints alone, so that it marks them too.
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
