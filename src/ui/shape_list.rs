use super::commands::Command;
use super::pointing::Pointing;
use super::theme::Palette;
use super::widgets::{list_move, moved, named, section, select_all, tip_beside_panel};
use super::{Action, UiState, commands, context_menu};
use crate::editor::{Edit, Session, View, for_all_selected};
use crate::scene::{Shape, ShapeId};
use egui::{
    Align, Button, Color32, Context, DragAndDrop, Key, Layout, Modifiers, Painter, Pos2, Rect,
    Response, RichText, ScrollArea, Sense, Stroke, StrokeKind, TextEdit, TextStyle, Ui, UiBuilder,
    WidgetInfo, WidgetType, pos2, vec2,
};
use std::f32::consts::PI;

/// Greatest height of the list, in points; longer lists scroll.
const TALLEST: f32 = 150.0;

/// Name that is being typed for a shape in the list.
#[derive(Clone, Debug)]
pub(super) struct Renaming {
    shape: ShapeId,
    text: String,
    /// Whether the field has the keyboard focus yet.
    begun: bool,
}

impl Renaming {
    /// Begins with the present name.
    pub(super) fn of(shape: &Shape) -> Self {
        Self {
            shape: shape.id,
            text: shape.name.clone(),
            begun: false,
        }
    }
}

/// The shapes, as `[i] Name (ID: n)`: a click or ↑ and ↓ select one, a double click renames it, a
/// drag moves it in the list. Icons at the end of its row hide it and lock it. If the selected
/// shape was just selected, here or elsewhere (`newly_selected`), it is scrolled into view.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    newly_selected: bool,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    section(ui, "Shape Selector");
    let shapes = session.scene().shapes();
    if shapes.is_empty() {
        state.shape_row_keys = None;
        ui.label(RichText::new("Nothing here yet. Insert adds a shape or a character.").weak());
        return;
    }
    ScrollArea::vertical()
        .id_salt("shape list")
        .max_height(TALLEST.min(ui.available_height() * 0.4))
        .show(ui, |ui| {
            ui.with_layout(Layout::top_down_justified(Align::LEFT), |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                rows(ui, session, newly_selected, state, actions);
            });
        });
}

fn rows(
    ui: &mut Ui,
    session: &Session,
    newly_selected: bool,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    let shapes = session.scene().shapes();
    if state
        .renaming
        .as_ref()
        .is_some_and(|r| session.scene().shape(r.shape).is_none())
    {
        state.renaming = None;
    }
    let mut chosen: Option<ShapeId> = None;
    let mut responses = Vec::with_capacity(shapes.len());
    let mut movement = None;
    let mut line = None;
    for (index, shape) in shapes.iter().enumerate() {
        if let Some(typed) = state.renaming.as_mut().filter(|r| r.shape == shape.id) {
            if rename(ui, shape, typed, actions) {
                state.renaming = None;
            }
            continue;
        }
        let selected = session.is_selected(shape.id);
        let row = ui
            .push_id(shape.id, |ui| {
                row(ui, session, (index, shape), selected, actions)
            })
            .inner;
        if session.selected() == Some(shape.id) && newly_selected {
            row.scroll_to_me(None);
        }
        if row.clicked() {
            row.request_focus();
            let modifiers = ui.input(|input| input.modifiers);
            if modifiers.command {
                actions.push(Action::View(View::ToggleSelected(shape.id)));
            } else if modifiers.shift {
                actions.push(Action::View(View::SelectTo(shape.id)));
            } else {
                actions.push(Action::View(View::Select(Some(shape.id))));
            }
        }
        if row.secondary_clicked() {
            let at = row.interact_pointer_pos().unwrap_or(row.rect.center());
            context_menu::about(Some(shape.id), session, state, at, actions);
        }
        if row.double_clicked() {
            state.renaming = Some(Renaming::of(shape));
        }
        if let Some(landing) = Landing::over(&row, index) {
            if row.dnd_release_payload::<(ShapeId, usize)>().is_some() {
                let edit = Edit::MoveInList(landing.shape, landing.place);
                actions.push(Action::Edit(edit));
            } else {
                line = Some(landing.line);
            }
        }
        if let Some(pressed) = list_move(ui, &row) {
            movement = moved(pressed, index, shapes.len());
        }
        responses.push(row);
    }
    // egui takes it from a row after clicks elsewhere, but not after drags, nor where a key chooses another tool, whose keys
    // are about what it works on.
    let is_pressed = ui.input(|input| input.pointer.any_pressed());
    let (tool, keys_before) = (state.pose.tool, state.shape_row_keys.take());
    for row in responses.iter().filter(|row| row.has_focus()) {
        let is_clicked_elsewhere = is_pressed && !row.contains_pointer();
        if is_clicked_elsewhere || keys_before.is_some_and(|before| before != tool) {
            row.surrender_focus();
        } else {
            state.shape_row_keys = Some(tool);
        }
    }
    // After all rows, whose colors would cover half of it.
    if let Some(y) = line {
        let stroke = Stroke::new(2.0, Palette::of(ui.visuals()).accent);
        ui.painter().hline(ui.max_rect().x_range(), y, stroke);
    }
    if let Some(to) = movement
        && let (Some(row), Some(shape)) = (responses.get(to), shapes.get(to))
    {
        row.request_focus();
        chosen = Some(shape.id);
    }
    if chosen.is_some() {
        actions.push(Action::View(View::Select(chosen)));
    }
}

/// The field for a new name; whether it is done with. Esc leaves the name as it was, and so does
/// an empty one.
fn rename(ui: &mut Ui, shape: &Shape, typed: &mut Renaming, actions: &mut Vec<Action>) -> bool {
    let height = ui.spacing().interact_size.y;
    let edit = TextEdit::singleline(&mut typed.text).min_size(vec2(0.0, height));
    let field = named(ui.add(edit), &format!("Name of {}", shape.name));
    if !typed.begun {
        field.request_focus();
        select_all(ui, field.id, &typed.text);
        typed.begun = true;
        return false;
    }
    if !field.lost_focus() {
        return false;
    }
    let name = typed.text.trim();
    let escaped = ui.input(|input| input.key_pressed(Key::Escape));
    if !escaped && !name.is_empty() && name != shape.name {
        actions.push(Action::Edit(Edit::Rename(shape.id, name.to_owned())));
    }
    true
}

/// Ends a drag in the list without a change if Ctrl+Z is pressed, as egui does with Esc; whether there was
/// one, to which the keys of this frame belong. To be called before the panels.
pub(super) fn cancel_drag_by_undo(ctx: &Context, keys_are_taken: bool) -> bool {
    let drags = DragAndDrop::has_any_payload(ctx);
    let undoes = drags && !keys_are_taken;
    if undoes && ctx.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Z)) {
        DragAndDrop::clear_payload(ctx);
    }
    drags
}

/// Where a shape that is dragged in the list would land.
struct Landing {
    shape: ShapeId,
    /// The place in the list that it gets.
    place: usize,
    /// Height of the edge between two rows where that is, in points.
    line: f32,
}

impl Landing {
    /// The place before or after row `index`, if a shape is dragged over it.
    fn over(row: &Response, index: usize) -> Option<Self> {
        let (shape, from) = *row.dnd_hover_payload::<(ShapeId, usize)>()?;
        // No row but the one that is dragged counts as hovered meanwhile.
        let pointer = row.ctx.input(|input| input.pointer.latest_pos())?;
        let below = pointer.y > row.rect.center().y;
        let before = index + usize::from(below);
        Some(Self {
            shape,
            // Places count without the shape that moves.
            place: before - usize::from(from < before),
            line: if below {
                row.rect.bottom()
            } else {
                row.rect.top()
            },
        })
    }
}

/// One row; the widget that selects the shape.
fn row(
    ui: &mut Ui,
    session: &Session,
    (index, shape): (usize, &Shape),
    selected: bool,
    actions: &mut Vec<Action>,
) -> Response {
    let height = ui.spacing().interact_size.y;
    let (_, whole) = ui.allocate_space(vec2(ui.available_width(), height));
    let palette = Palette::of(ui.visuals());
    if selected {
        let fill = if session.selected() == Some(shape.id) {
            palette.selection
        } else {
            // Those selected with the active one, which the panel shows.
            palette.selection.gamma_multiply(0.6)
        };
        ui.painter().rect_filled(whole, 3.0, fill);
    }
    let (name, icons) = whole.split_left_right_at_x(whole.right() - ICONS);
    let label = format!("[{}] {} (ID: {})", index + 1, shape.name, shape.id);
    let color = match (selected, shape.visible) {
        (true, _) => palette.on_selection,
        (false, true) => palette.text,
        (false, false) => palette.weak,
    };
    let fill = Layout::top_down_justified(Align::LEFT);
    let place = UiBuilder::new().max_rect(name).layout(fill);
    // Fingers scroll the list, which they could not where a drag moved a shape.
    let sense = match Pointing::of(ui.ctx()) {
        Pointing::Mouse => Sense::click_and_drag(),
        Pointing::Fingers => Sense::click(),
    };
    // Its frame would leave out the icons.
    let button = Button::selectable(selected, RichText::new(&label).color(color))
        .frame_when_inactive(false)
        .sense(sense)
        .truncate();
    let row = ui.scope_builder(place, |ui| ui.add(button)).inner;
    let font = TextStyle::Button.resolve(ui.style());
    let needed = ui
        .painter()
        .layout_no_wrap(label.clone(), font, color)
        .size()
        .x;
    if needed + 2.0 * ui.spacing().button_padding.x > name.width() {
        tip_beside_panel(ui, &row, &label);
    }
    if sense.senses_drag() {
        row.dnd_set_drag_payload((shape.id, index));
    }
    eye_and_lock(ui, icons, session, shape, actions);
    row
}

/// Width of an icon in a row, in points.
const ICON: f32 = 20.0;
/// Width of both icons, in points.
const ICONS: f32 = 2.0 * ICON;
/// Width of their lines, in points.
const LINE: f32 = 1.3;

/// The eye that hides the shape and the lock that locks it, in `rect`. They are drawn rather than
/// written: no font of egui has a closed eye.
fn eye_and_lock(ui: &Ui, rect: Rect, session: &Session, shape: &Shape, actions: &mut Vec<Action>) {
    let selected = session.is_selected(shape.id);
    let (left, right) = rect.split_left_right_at_fraction(0.5);
    let name = &shape.name;

    let does = if shape.visible { "Hide" } else { "Show" };
    let hint = if shape.visible {
        format!("Hide {name} in the view, not in exports")
    } else {
        format!("Show {name} in the view again")
    };
    let eye = icon(ui, left, &format!("{does} {name}"), "eye");
    let color = icon_color(ui, &eye, selected, !shape.visible);
    paint_eye(ui.painter(), left.center(), shape.visible, color);
    if with_hint(eye, Command::ToggleVisible, &hint, selected).clicked() {
        let edit = Edit::SetVisible(shape.id, !shape.visible);
        actions.push(Action::Edit(for_all_selected(session, edit)));
    }

    let does = if shape.locked { "Unlock" } else { "Lock" };
    let hint = if shape.locked {
        format!("Let {name} be clicked and moved in the view again")
    } else {
        format!("Keep {name} from being clicked, posed and moved in the view")
    };
    let lock = icon(ui, right, &format!("{does} {name}"), "lock");
    let color = icon_color(ui, &lock, selected, shape.locked);
    paint_lock(ui.painter(), right.center(), shape.locked, color);
    if with_hint(lock, Command::ToggleLocked, &hint, selected).clicked() {
        let edit = Edit::SetLocked(shape.id, !shape.locked);
        actions.push(Action::Edit(for_all_selected(session, edit)));
    }
}

fn icon(ui: &Ui, rect: Rect, label: &str, id: &str) -> Response {
    let button = ui.interact(rect, ui.id().with(id), Sense::click());
    let painter = ui.painter();
    let visuals = ui.style().interact(&button);
    if button.hovered() {
        painter.rect_filled(
            rect.shrink(1.0),
            visuals.corner_radius,
            visuals.weak_bg_fill,
        );
    }
    if button.has_focus() {
        let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).accent);
        painter.rect_stroke(rect.shrink(1.0), 2.0, stroke, StrokeKind::Inside);
    }
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), label));
    named(button, label)
}

/// Adds a tooltip, with the shortcut if the shape is selected: shortcuts act on that shape only.
fn with_hint(button: Response, command: Command, hint: &str, selected: bool) -> Response {
    if selected {
        let hint = commands::with_key(&button.ctx, command, hint);
        button.on_hover_text(hint)
    } else {
        button.on_hover_text(hint)
    }
}

/// Color of an icon: weak in the usual state, visible and unlocked.
fn icon_color(ui: &Ui, button: &Response, selected: bool, unusual: bool) -> Color32 {
    let palette = Palette::of(ui.visuals());
    if button.hovered() {
        palette.strong
    } else if selected {
        palette.on_selection
    } else if unusual {
        palette.strong
    } else {
        palette.weak
    }
}

/// An open eye, or one that is crossed out.
fn paint_eye(painter: &Painter, center: Pos2, open: bool, color: Color32) {
    const WIDE: f32 = 6.5;
    const HIGH: f32 = 4.2;
    let stroke = Stroke::new(LINE, color);
    let lid = |side: f32| {
        let points = (0..=12).map(|i| {
            let across = i as f32 / 6.0 - 1.0;
            center + vec2(across * WIDE, side * HIGH * (1.0 - across * across))
        });
        points.collect::<Vec<_>>()
    };
    painter.line(lid(-1.0), stroke);
    painter.line(lid(1.0), stroke);
    if open {
        painter.circle_filled(center, 2.0, color);
    } else {
        let along = vec2(5.5, -5.5);
        painter.line_segment([center - along, center + along], stroke);
    }
}

/// A closed lock, filled, or an open one, hollow.
fn paint_lock(painter: &Painter, center: Pos2, closed: bool, color: Color32) {
    const RADIUS: f32 = 2.8;
    let stroke = Stroke::new(LINE, color);
    let body = Rect::from_center_size(center + vec2(0.0, 2.6), vec2(9.0, 6.4));
    if closed {
        painter.rect_filled(body, 1.5, color);
    } else {
        painter.rect_stroke(body, 1.5, stroke, StrokeKind::Inside);
    }
    // The open one has swung to the side.
    let (middle, right_leg) = if closed {
        (body.center_top() - vec2(0.0, 1.8), body.top())
    } else {
        (body.right_top() - vec2(1.6, 1.8), body.top() - 1.2)
    };
    let mut shackle = vec![pos2(middle.x - RADIUS, body.top())];
    shackle.extend((0..=8).map(|i| {
        let angle = PI * (1.0 + i as f32 / 8.0);
        middle + RADIUS * vec2(angle.cos(), angle.sin())
    }));
    shackle.push(pos2(middle.x + RADIUS, right_leg));
    painter.line(shackle, stroke);
}
