use super::commands::Command;
use super::number_field::NumberField;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::{labelled, named};
use super::{
    Action, Ask, character_panel, color_field, commands, curve_panel, joint_list, shape_list,
};
use crate::editor::{Edit, Session, View, for_all_selected};
use crate::math::Transform;
use crate::scene::{Shape, ShapeKind};
use egui::epaint::TextShape;
use egui::{
    Align, Align2, Button, Color32, FontId, Frame, Id, Label, Layout, Margin, Panel, Rect, Response,
    RichText, ScrollArea, Sense, TextStyle, Ui, WidgetInfo, WidgetType, pos2, vec2,
};
use glam::Vec3;
use std::f32::consts::FRAC_PI_2;
use std::ops::RangeInclusive;

/// Width in points, margins included, as in the course's editor.
const WIDTH: f32 = 280.0;
const NARROWEST: f32 = 248.0;
const WIDEST: f32 = 560.0;

/// Width of the window in points up to which the panel is folded away until it is asked for, and then a
/// sheet at the bottom: beside it, the view would be too narrow to work in.
const NARROW_WINDOW: f32 = 600.0;

/// The shape panel at the right, or at the bottom of a narrow window: the list of shapes, and all
/// properties of the selected one.
pub(super) fn show(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    state.is_narrow = root.available_width() <= NARROW_WINDOW;
    // Below its view, a low window would have no room.
    if state.is_narrow && root.available_height() > root.available_width() {
        return sheet(root, session, state, actions);
    }
    if state.is_panel_folded() {
        return strip(root, state);
    }
    let widest = (root.available_width() * 0.7).clamp(NARROWEST, WIDEST);
    let shown = Panel::right(Id::new("shape panel").with(state.panel_resets))
        .frame(frame(root))
        .default_size(state.panel_width.unwrap_or(WIDTH))
        .size_range(NARROWEST..=widest)
        .show(root, |ui| {
            heading(ui, state);
            ui.separator();
            content(ui, session, state, actions);
        });
    // In the middle of a drag of its edge it is not worth keeping.
    if !root.input(|input| input.pointer.any_down()) {
        state.panel_width = Some(shown.response.rect.width().round());
    }
}

fn frame(ui: &Ui) -> Frame {
    Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(8, 4))
}

/// Shares of the height that a sheet's handle can be dragged to.
const SHEET_SHARES: RangeInclusive<f32> = 0.25..=0.75;

/// The panel below the view, so that a whole figure is seen while its numbers are dragged. Its handle is
/// all that is left of it when it is folded away.
fn sheet(root: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    let is_folded = state.is_panel_folded();
    let all = root.available_rect_before_wrap();
    let content_height = if is_folded {
        0.0
    } else {
        (all.height() * state.sheet_share).round()
    };
    let shown = Panel::bottom("sheet of shapes")
        .frame(Frame::side_top_panel(root.style()).inner_margin(0))
        .resizable(false)
        .exact_size(HANDLE + content_height)
        .show(root, |ui| {
            let mut place = ui.max_rect();
            place.set_height(HANDLE);
            let button = handle(ui, place, Sense::click_and_drag(), state);
            let centered = Align2::CENTER_CENTER;
            let (font, color) = handle_style(ui, &button);
            let text = format!("{} {HANDLE_TEXT}", if is_folded { "⏶" } else { "⏷" });
            let middle = place.center();
            ui.painter().text(middle, centered, text, font, color);
            if !is_folded {
                frame(ui).show(ui, |ui| content(ui, session, state, actions));
            }
            button
        });
    if let Some(at) = shown.inner.interact_pointer_pos()
        && shown.inner.dragged()
    {
        let share = (all.bottom() - HANDLE / 2.0 - at.y) / all.height().max(1.0);
        state.fold_panel(share < SHEET_SHARES.start() / 2.0);
        state.sheet_share = share.clamp(*SHEET_SHARES.start(), *SHEET_SHARES.end());
    }
}

/// The list of shapes, and the selected one.
fn content(ui: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    let newly_selected = session.selected() != state.selected;
    state.selected = session.selected();
    shape_list::show(ui, session, newly_selected, state, actions);
    ui.separator();
    ScrollArea::vertical()
        // That of another document begins at its top.
        .id_salt(("properties", session.opened()))
        .auto_shrink(false)
        .show(ui, |ui| selected(ui, session, state, actions));
}

/// Title of the panel, with the button that folds it away.
fn heading(ui: &mut Ui, state: &mut UiState) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        if fold_button(ui, "⏵") {
            state.fold_panel(true);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), heading_text);
    });
}

fn heading_text(ui: &mut Ui) {
    let title = RichText::new("Shape Selector and Properties").heading();
    ui.add(Label::new(title).truncate());
}

/// Width in points of the strip that is left of the panel at the right, and height of the sheet's handle.
const STRIP: f32 = 24.0;
const HANDLE: f32 = 32.0;

/// Words on either, which say what the panel is.
const HANDLE_TEXT: &str = "Shapes and Properties";

/// The strip at the right edge that is left of the folded panel.
fn strip(root: &mut Ui, state: &mut UiState) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(0);
    let strip = Panel::right("folded shape panel").frame(frame);
    strip.resizable(false).exact_size(STRIP).show(root, |ui| {
        let place = ui.max_rect();
        let button = handle(ui, place, Sense::click(), state);
        let (font, color) = handle_style(ui, &button);
        let top = place.center_top() + vec2(0.0, 16.0);
        let painter = ui.painter();
        painter.text(top, Align2::CENTER_CENTER, "⏴", font.clone(), color);
        // From top to bottom.
        let text = painter.layout_no_wrap(HANDLE_TEXT.to_owned(), font, color);
        let corner = pos2(place.center().x + text.size().y / 2.0, place.top() + 32.0);
        painter.add(TextShape::new(corner, text, color).with_angle(FRAC_PI_2));
    });
}

/// A click anywhere in `place` unfolds the panel, or folds it away.
fn handle(ui: &mut Ui, place: Rect, sense: Sense, state: &mut UiState) -> Response {
    let button = ui.allocate_rect(place, sense);
    let command = Command::TogglePanel;
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, true, commands::label(command)));
    if button.hovered() || button.has_focus() {
        let fill = ui.style().interact(&button).weak_bg_fill;
        ui.painter().rect_filled(place, 0.0, fill);
    }
    let button = button.on_hover_text(commands::tooltip(ui.ctx(), command));
    if button.clicked() {
        state.fold_panel(!state.is_panel_folded());
    }
    button
}

fn handle_style(ui: &Ui, button: &Response) -> (FontId, Color32) {
    let color = ui.style().interact(button).text_color();
    (TextStyle::Body.resolve(ui.style()), color)
}

fn fold_button(ui: &mut Ui, sign: &str) -> bool {
    let button = ui.add(Button::new(sign).frame_when_inactive(false));
    let button = named(button, commands::label(Command::TogglePanel));
    let tip = commands::tooltip(ui.ctx(), Command::TogglePanel);
    button.on_hover_text(tip).clicked()
}

/// Everything about the selected shape.
fn selected(ui: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    state.curves.hovered = None;
    let shape = session.selected().and_then(|id| session.scene().shape(id));
    let Some(shape) = shape else {
        if !session.scene().shapes().is_empty() {
            ui.label(RichText::new("Select a shape in the list or in the view.").weak());
        }
        leave_joints(state, actions);
        return;
    };
    ui.push_id(shape.id, |ui| {
        properties(ui, session, shape, state, actions);
        if let ShapeKind::Character(character) = &shape.kind {
            ui.separator();
            character_panel::display(ui, shape.id, character.display, actions);
            ui.separator();
            character_panel::skinning(ui, shape.id, character, session, state, actions);
            ui.separator();
            character_panel::poses(ui, shape.id, character, &mut state.pose_name, actions);
            ui.separator();
            joint_list::show(ui, session, shape.id, &mut state.joints, actions);
        } else {
            leave_joints(state, actions);
        }
        if let ShapeKind::Mesh(_) = &shape.kind {
            ui.separator();
            let color = Palette::of(ui.visuals()).weak;
            ui.add(Label::new(RichText::new(WITHOUT_JOINTS).small().color(color)).wrap());
        }
        if let ShapeKind::Missing(missing) = &shape.kind {
            ui.separator();
            missing_file(ui, shape, &missing.reason, actions);
        }
        if let ShapeKind::Curve(curve) = &shape.kind {
            ui.separator();
            curve_panel::display(ui, shape.id, curve, actions);
            ui.separator();
            curve_panel::list(ui, session, shape.id, &mut state.curves, actions);
        }
    });
}

/// What is said of an imported mesh, which may have been meant as a character.
const WITHOUT_JOINTS: &str = "This mesh has no joints. A character's .obj has its .skel and .attach beside it, and is \
                              chosen or dropped together with them.";

/// Says why the box stands in for a shape, and lets its file be found.
fn missing_file(ui: &mut Ui, shape: &Shape, reason: &str, actions: &mut Vec<Action>) {
    ui.label("The file of this shape cannot be read. A box stands in for it.");
    ui.label(RichText::new(reason).weak());
    let tip = "Choose where the file is now. Others that are missing are found beside it, too.";
    if ui.button("Find…").on_hover_text(tip).clicked() {
        actions.push(Action::Ask(Ask::FindSource(shape.id)));
    }
}

/// Ends hovering over a joint of the list, where no list is shown.
fn leave_joints(state: &mut UiState, actions: &mut Vec<Action>) {
    if state.joints.hovered.take().is_some() {
        actions.push(Action::View(View::HoverJoint(None)));
    }
}

/// Scale factors that can be set.
const SCALES: RangeInclusive<f64> = 0.1..=10.0;

/// Position, scale, rotation and color of a shape, with Delete and Reset.
fn properties(
    ui: &mut Ui,
    session: &Session,
    shape: &Shape,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let for_all = |edit| Action::Edit(for_all_selected(session, edit));
    title(ui, session, shape, state, actions);
    let placement = &shape.placement;
    let (now, start) = (placement.transform, shape.start.transform);
    let mut edited = None;

    let position = row_of_three(ui, "Position", "Position", |axis, name| {
        NumberField::new(name, now.position[axis], 0.1)
            .rest(start.position[axis])
            .decimals(2..=3)
    });
    if let Some((axis, value)) = position {
        edited = Some(with(now, |to| to.position[axis] = value));
    }

    uniform_scaling(ui, session, shape, actions);
    if placement.uniform_scaling {
        let scale = labelled(ui, "Uniform Scale", |ui, size| {
            NumberField::new("Uniform Scale", now.scale.x, 0.1)
                .rest(start.scale.x)
                .range(SCALES)
                .decimals(2..=3)
                .show(ui, size)
        });
        if let Some(scale) = scale {
            edited = Some(with(now, |to| to.scale = Vec3::splat(scale)));
        }
    } else {
        let scale = row_of_three(ui, "Scale (X, Y, Z)", "Scale", |axis, name| {
            NumberField::new(name, now.scale[axis], 0.1)
                .rest(start.scale[axis])
                .range(SCALES)
                .decimals(2..=3)
        });
        if let Some((axis, value)) = scale {
            edited = Some(with(now, |to| to.scale[axis] = value));
        }
    }

    let rotation = row_of_three(ui, "Rotation", "Rotation", |axis, name| {
        NumberField::degrees(name, now.rotation.degrees()[axis])
            .rest(start.rotation.degrees()[axis])
    });
    if let Some((axis, value)) = rotation {
        let radians = value.to_radians();
        edited = Some(with(now, |to| to.rotation.radians[axis] = radians));
    }

    if let Some(transform) = edited {
        actions.push(for_all(Edit::SetTransform(shape.id, transform)));
    }
    let color = labelled(ui, "Color", |ui, size| {
        color_field::show(ui, placement.color, size.x)
    });
    if let Some(color) = color {
        actions.push(for_all(Edit::SetColor(shape.id, color)));
    }
}

fn uniform_scaling(ui: &mut Ui, session: &Session, shape: &Shape, actions: &mut Vec<Action>) {
    labelled(ui, "", |ui, _| {
        let mut uniform = shape.placement.uniform_scaling;
        let hint = "Scale X, Y and Z together. Turning it on takes the scale of X for all.";
        if ui
            .checkbox(&mut uniform, "Uniform Scaling")
            .on_hover_text(hint)
            .changed()
        {
            let edit = Edit::SetUniformScaling(shape.id, uniform);
            actions.push(Action::Edit(for_all_selected(session, edit)));
        }
    });
}

fn with(transform: Transform, change: impl FnOnce(&mut Transform)) -> Transform {
    let mut changed = transform;
    change(&mut changed);
    changed
}

/// The shape's ID, with Delete and Reset.
fn title(
    ui: &mut Ui,
    session: &Session,
    shape: &Shape,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        for (command, label, edit) in [
            (Command::Delete, "Delete", Edit::Delete(shape.id)),
            (Command::Reset, "Reset", Edit::Reset(shape.id)),
        ] {
            let button = ui.add(Button::new(label));
            let tip = commands::tooltip_now(ui.ctx(), command, session, state);
            if button.on_hover_text(tip).clicked() {
                actions.push(Action::Edit(for_all_selected(session, edit)));
            }
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let text = match session.selected_shapes().count() {
                1 => format!("Selected Shape ID: {}", shape.id),
                count => format!("{count} shapes, active ID: {}", shape.id),
            };
            let color = Palette::of(ui.visuals()).strong;
            ui.add(Label::new(RichText::new(text).color(color)).truncate())
                .on_hover_text(&shape.name);
        });
    });
    ui.add_space(2.0);
}

/// A label and three fields named `NAME X`, `NAME Y` and `NAME Z`; axis and value of the one that
/// was changed.
fn row_of_three<'n>(
    ui: &mut Ui,
    label: &str,
    name: &str,
    field: impl for<'f> Fn(usize, &'f str) -> NumberField<'f>,
) -> Option<(usize, f32)> {
    labelled(ui, label, |ui, size| {
        let gap = ui.spacing().item_spacing.x;
        let each = vec2(((size.x - 2.0 * gap) / 3.0).floor(), size.y);
        let mut changed = None;
        for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
            let name = format!("{name} {letter}");
            let given = field(axis, &name).axis(axis).show(ui, each);
            changed = given.map(|value| (axis, value)).or(changed);
        }
        changed
    })
}
