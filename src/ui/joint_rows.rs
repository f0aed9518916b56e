//! Rows of the joint list: angles of a joint, offset of a root.

use super::joint_columns::{Columns, OFFSET, arrow, font, shortened_path};
use super::joint_tree::Row;
use super::number_field::NumberField;
use super::shape_properties::STEP;
use super::shortened::shortened;
use super::theme::{Palette, number_font};
use super::widgets::{ListMove, list_move, named, spoken, tip_beside_panel};
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use egui::{
    Align2, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui, WidgetInfo, WidgetType,
    pos2, vec2,
};
use glam::Vec3;

/// Width of the sign for a joint, folded away, that is not at rest, in points.
const DOT: f32 = 10.0;

/// Marks of a row.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Look<'a> {
    pub selected: bool,
    pub hovered: bool,
    /// Whether the joint is not at rest.
    pub changed: bool,
    /// Whether a joint that is folded away below it is not at rest.
    pub changed_inside: bool,
    /// Name of the joint, folded away below this one, that is selected or under the pointer.
    pub inside: Option<&'a str>,
    /// Whether Tab goes to the name: of all names of a list, to one.
    pub stops_tab: bool,
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
    let hovered = ui.rect_contains_pointer(rect);

    let left = columns.name_left(row);
    // Tab goes from number to number, and to one name of the list, from which arrow keys go to the others.
    let sense = if look.stops_tab || ui.memory(|memory| memory.has_focus(id)) {
        Sense::click()
    } else {
        Sense::CLICK
    };
    let label = ui.interact(columns.name(rect, left), id, sense);
    paint_background(ui, rect, look, hovered, &label);
    let mut event = label.clicked().then_some(RowEvent::Select);
    if label.clicked() {
        label.request_focus();
    }
    if let Some(movement) = list_move(ui, &label) {
        event = Some(RowEvent::Move(movement));
    }
    paint_name(ui, &label, name, columns, look);
    if row.folded.is_some() && fold_arrow(ui, id, rect, left, row, name) {
        event = Some(RowEvent::Fold);
    }

    let degrees = pose.rotation(row.joint).degrees();
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{name} {letter}");
        let field = NumberField::degrees(&called, degrees[axis])
            .axis(axis)
            .quiet(!look.selected);
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
        ui.painter()
            .rect_filled(rect, 3.0, palette.selection.gamma_multiply(0.4));
    }
    if look.inside.is_some() {
        let stroke = Stroke::new(1.0, palette.selection);
        ui.painter()
            .rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
    }
    if label.has_focus() {
        let stroke = Stroke::new(1.0, palette.accent);
        ui.painter()
            .rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
    }
}

fn paint_name(ui: &Ui, label: &Response, name: &str, columns: &Columns, look: Look) {
    let palette = Palette::of(ui.visuals());
    let color = match (look.selected, look.changed || look.changed_inside) {
        (true, _) => palette.on_selection,
        (false, true) => palette.strong,
        (false, false) => palette.text,
    };
    let whole = columns.written(name);
    let room = label.rect.width() - if look.changed_inside { DOT } else { 0.0 };
    let shown = match look.inside {
        Some(inside) => shortened_path(ui, whole, columns.written(inside), room),
        None => shortened(ui, whole, &font(ui), room),
    };
    let visible = label.rect.intersect(ui.clip_rect());
    let painter = ui.painter().with_clip_rect(visible);
    let at = label.rect.left_center();
    painter.text(at, Align2::LEFT_CENTER, &shown, font(ui), color);
    label.widget_info(|| {
        WidgetInfo::selected(
            WidgetType::SelectableLabel,
            ui.is_enabled(),
            look.selected,
            name,
        )
    });
    if look.changed_inside {
        let center = label.rect.right_center() - vec2(DOT / 2.0, 0.0);
        painter.circle_filled(center, 3.0, palette.accent);
    }
    if let Some(inside) = look.inside {
        let holds = format!("{inside} is folded away in it");
        let label = spoken(label.clone(), &holds);
        tip_beside_panel(ui, &label, &format!("{name}: {holds}"));
    } else if look.changed_inside {
        let holds = "a joint that is folded away in it is not at rest";
        let label = spoken(label.clone(), holds);
        tip_beside_panel(ui, &label, &format!("{name}: {holds}"));
    } else if shown != name {
        tip_beside_panel(ui, label, name);
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
    // From the keyboard, Left and Right fold.
    let button = ui.interact(rect, id.with("fold"), Sense::CLICK);
    let color = ui.style().interact(&button).text_color();
    let font = TextStyle::Small.resolve(ui.style());
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, symbol, font, color);
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), &label));
    button.on_hover_text(&label).clicked()
}

/// Button that resets `name`; whether it was clicked. It is shown only beside numbers that are not
/// at rest, so that it marks them, too. Tab passes it by: it comes up when a number is typed, and the next
/// one would be typed into it.
fn reset_button(ui: &Ui, id: Id, rect: Rect, name: &str) -> bool {
    let label = format!("Reset {name}");
    let button = ui.interact(rect, id, Sense::CLICK);
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
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), &label));
    let button = named(button, &label);
    tip_beside_panel(ui, &button, &format!("Put {name} back to rest"));
    button.clicked()
}

/// A root's offset as it was shown.
pub(super) struct ShownOffset {
    pub hovered: bool,
    /// What was done with it: the root was selected, or moved.
    pub event: Option<RowEvent>,
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
    let name = columns.name(rect, columns.offset_left(row));
    let font = font(ui);
    ui.painter().text(
        name.left_center(),
        Align2::LEFT_CENTER,
        OFFSET,
        font,
        palette.weak,
    );

    let called = format!("{} {OFFSET}", skeleton.joints()[row.joint].name);
    let id = ui.id().with(("root", row.joint));
    let name = ui.interact(name, id.with("name"), Sense::CLICK);
    name.widget_info(|| WidgetInfo::labeled(WidgetType::SelectableLabel, ui.is_enabled(), &called));
    let mut event = name.clicked().then_some(RowEvent::Select);
    let now = pose.root_offset(row.joint);
    for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
        let called = format!("{called} {letter}");
        let field = NumberField::new(&called, now[axis], STEP)
            .decimals(2..=3)
            .axis(axis)
            .quiet(true);
        if let Some(value) = field.show_at(ui, id.with(axis), columns.field(rect, axis)) {
            let mut moved = now;
            moved[axis] = value;
            event = Some(RowEvent::Offset(moved));
        }
    }
    let moved = now != Vec3::ZERO;
    if moved && reset_button(ui, id.with("reset"), columns.reset(rect), &called) {
        event = Some(RowEvent::Offset(Vec3::ZERO));
    }
    ShownOffset { hovered, event }
}
