use super::joint_columns::{Columns, arrow, font, name_left};
use super::joint_tree::Row;
use super::number_field::NumberField;
use super::theme::{Palette, number_font};
use super::widgets::{ListMove, list_move, named};
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use egui::{
    Align2, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui, WidgetInfo, WidgetType,
    pos2,
};
use glam::Vec3;

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
    /// A new angle about an axis (0 for x, 1 for y, 2 for z), in degrees.
    Turn(usize, f32),
    /// All three angles back to 0.
    Reset,
    /// A new offset of a root.
    Offset(Vec3),
    Move(ListMove),
}

/// A row as it was shown.
pub(super) struct Shown {
    /// The name, which has the keyboard for the row.
    pub name: Response,
    pub hovered: bool,
    pub event: Option<RowEvent>,
}

/// The letters above the three columns.
pub(super) fn header(ui: &mut Ui, columns: &Columns) {
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

/// Shown beside numbers that are not at rest alone, so that it marks them too.
pub(super) fn reset_button(ui: &Ui, id: Id, rect: Rect, name: &str) -> bool {
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
