//! Number fields: dragged, typed as arithmetic, stepped, reset.

mod decimals;
mod typing;

pub use typing::evaluate;
pub(super) use typing::{is_untouched, take_wrong};

use crate::geometry::MAX_COORDINATE;
use crate::ui::GestureStep;
use crate::ui::pointing::Pointing;
use crate::ui::theme::{Palette, number_font};
use crate::ui::widgets::{forget_buttons, named, tip_beside_panel};
use decimals::{fitted, precise};
use egui::{
    Align2, Context, CursorIcon, Id, InputState, Key, Modifiers, PointerButton, Rect, Response,
    Sense, StrokeKind, Ui, Vec2, WidgetInfo, accesskit, pos2, vec2,
};
use std::ops::RangeInclusive;

/// Factors on the speed of a drag, with Shift and with Ctrl.
const FINER: f64 = 0.1;
const COARSER: f64 = 10.0;
/// Key of egui's memory for the beginnings and ends of drags in a frame.
const GESTURES: &str = "gestures of number fields";
/// Largest absolute value: everything computed from it must stay finite.
const FARTHEST: f64 = MAX_COORDINATE as f64;
/// Width in points below which a field shows its axis as a line instead of a letter.
const ROOM_FOR_LETTER: f32 = 44.0;
/// The same for angles: `-179°` and a letter need more room.
pub(super) const ROOM_FOR_LETTER_AND_ANGLE: f32 = 51.0;
/// Margin between a number and the edges of its field, in points.
const EDGE: f32 = 2.0;
/// Width of an axis' letter, in points.
const LETTER: f32 = 10.25;

/// A field for a number that can be dragged, typed as arithmetic, changed in steps by ↑ and ↓, and
/// reset by a right click.
#[derive(Clone, Debug)]
pub(super) struct NumberField<'a> {
    name: &'a str,
    value: f64,
    rest: f64,
    step: f64,
    range: RangeInclusive<f64>,
    unit: &'static str,
    decimals: RangeInclusive<usize>,
    axis: Option<usize>,
    wrap: Option<f64>,
    quiet: bool,
}

/// A number that is being dragged.
#[derive(Clone, Copy, Debug, Default)]
struct Dragged {
    /// Value when the drag began.
    start: f64,
    /// Value before it is rounded to steps.
    exact: f64,
}

impl<'a> NumberField<'a> {
    /// A field for `value` that changes by `step` per pixel of a drag; `name` is for assistive
    /// technology and tests.
    pub(super) fn new(name: &'a str, value: f32, step: f64) -> Self {
        Self {
            name,
            value: f64::from(value),
            rest: 0.0,
            step,
            range: -FARTHEST..=FARTHEST,
            unit: "",
            decimals: 0..=3,
            axis: None,
            wrap: None,
            quiet: false,
        }
    }

    /// A field for an angle in degrees, shown from -180 to 180 with at most one decimal. The value
    /// itself keeps its turns: 330 is shown as -30, and a step makes it 331.
    pub(super) fn degrees(name: &'a str, value: f32) -> Self {
        Self {
            unit: "°",
            decimals: 0..=1,
            wrap: Some(360.0),
            ..Self::new(name, value, 1.0)
        }
    }

    /// Sets the value that a right click resets to; 0 unless set.
    pub(super) fn rest(self, rest: f32) -> Self {
        let rest = f64::from(rest);
        Self { rest, ..self }
    }

    /// Sets the allowed values.
    pub(super) fn range(self, range: RangeInclusive<f64>) -> Self {
        Self { range, ..self }
    }

    /// Sets the unit that is written after the number.
    pub(super) fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Sets the least number of decimals, and the greatest, shown if there is room.
    pub(super) fn decimals(self, decimals: RangeInclusive<usize>) -> Self {
        Self { decimals, ..self }
    }

    /// Marks the field as that of axis 0, 1 or 2.
    pub(super) fn axis(self, axis: usize) -> Self {
        Self {
            axis: Some(axis),
            ..self
        }
    }

    /// If `quiet`, dims the field and leaves out its frame while its value is the one at rest: in a long list
    /// the others stand out.
    pub(super) fn quiet(self, quiet: bool) -> Self {
        Self { quiet, ..self }
    }

    /// Shows the field; returns the new value if the user changed it.
    pub(super) fn show(self, ui: &mut Ui, size: Vec2) -> Option<f32> {
        let (id, rect) = ui.allocate_space(size);
        self.show_at(ui, id, rect)
    }

    /// Shows the field in a rectangle that is already allocated; returns as [`Self::show`].
    pub(super) fn show_at(self, ui: &mut Ui, id: Id, rect: Rect) -> Option<f32> {
        let typing = ui.is_enabled()
            && ui.memory_mut(|memory| {
                memory.interested_in_focus(id, ui.layer_id());
                memory.has_focus(id)
            });
        let (response, given) = if typing {
            self.type_into(ui, id, rect)
        } else {
            let left = self.left(ui, id);
            let (response, dragged) = self.drag(ui, id, rect);
            (response, dragged.or(left))
        };
        let given = given.or_else(|| self.asked_by_assistive_technology(ui, id));
        self.describe(ui, &response, typing);
        let given = self.brought_into_range(given?);
        (given != self.value).then_some(given as f32)
    }

    fn brought_into_range(&self, value: f64) -> f64 {
        value.clamp(*self.range.start(), *self.range.end())
    }

    /// The value as shown: an angle within half a turn either way.
    fn shown(&self) -> f64 {
        match self.wrap {
            Some(turn) => {
                let wrapped = self.value.rem_euclid(turn);
                if wrapped > turn / 2.0 {
                    wrapped - turn
                } else {
                    wrapped
                }
            }
            None => self.value,
        }
    }

    fn drag(&self, ui: &mut Ui, id: Id, rect: Rect) -> (Response, Option<f64>) {
        let response = ui
            .interact(rect, id, Sense::click_and_drag())
            .on_hover_cursor(CursorIcon::ResizeHorizontal);
        self.paint(ui, &response, rect);
        if response.clicked() || response.double_clicked() {
            response.request_focus();
        }
        if response.secondary_clicked() {
            return (response, Some(self.rest));
        }
        if swiped(ui, &response) {
            return (response, None);
        }
        let given = self.dragged_to(ui, &response);
        (response, given)
    }

    fn dragged_to(&self, ui: &Ui, response: &Response) -> Option<f64> {
        let id = response.id.with("dragged");
        let before: Option<Dragged> = ui.data_mut(|data| data.remove_temp(id));
        if !response.dragged_by(PointerButton::Primary) {
            // egui ends a drag by Esc. Consumed, so that it does nothing else in this frame.
            let dragged = before?;
            let escape = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
            let end = if escape {
                GestureStep::Cancel
            } else {
                GestureStep::Commit
            };
            note_gesture(ui, end);
            return escape.then_some(dragged.start);
        }
        if before.is_none() {
            note_gesture(ui, GestureStep::Begin);
        }
        let mut dragged = before.unwrap_or(Dragged {
            start: self.value,
            exact: self.value,
        });
        let cancel = ui.input_mut(|input| {
            input.pointer.button_pressed(PointerButton::Secondary)
                || input.consume_key(Modifiers::COMMAND, Key::Z)
        });
        if cancel {
            note_gesture(ui, GestureStep::Cancel);
            forget_buttons(ui.ctx());
            return Some(dragged.start);
        }
        // The movement before egui decided that this is a drag counts, too.
        let delta = if response.drag_started() {
            response.total_drag_delta().unwrap_or_default().x
        } else {
            response.drag_delta().x
        };
        let (shift, ctrl) = ui.input(|input| (input.modifiers.shift, input.modifiers.command));
        let factor = match (shift, ctrl) {
            (true, _) => FINER,
            (_, true) => COARSER,
            _ => 1.0,
        };
        let after = dragged.exact + f64::from(delta) * self.step * factor;
        let after = self.brought_into_range(after);
        dragged.exact = after;
        ui.data_mut(|data| data.insert_temp(id, dragged));
        if delta == 0.0 {
            return None;
        }
        let grid = self.step * factor;
        Some(clean((after / grid).round() * grid))
    }

    fn room_for_letter(&self) -> f32 {
        match self.wrap {
            Some(_) => ROOM_FOR_LETTER_AND_ANGLE,
            None => ROOM_FOR_LETTER,
        }
    }

    fn paint(&self, ui: &Ui, response: &Response, rect: Rect) {
        if !ui.is_rect_visible(rect) {
            return;
        }
        let visuals = ui.style().interact(response);
        let palette = Palette::of(ui.visuals());
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        let is_used = response.hovered() || response.dragged() || response.has_focus();
        let is_dim = self.quiet && self.value == self.rest && !is_used;
        let text_color = match (is_dim, self.quiet) {
            (true, _) => palette.rest,
            (false, true) => palette.strong,
            (false, false) => visuals.text_color(),
        };
        if !is_dim {
            painter.rect(
                rect,
                visuals.corner_radius,
                visuals.weak_bg_fill,
                visuals.bg_stroke,
                StrokeKind::Inside,
            );
        }
        let font = number_font();
        let mut room = rect.width() - 2.0 * EDGE;
        if let Some(axis) = self.axis {
            let color = palette.axes[axis.min(2)];
            if rect.width() >= self.room_for_letter() {
                let at = rect.left_center() + vec2(4.0, 0.0);
                let letter = ["X", "Y", "Z"][axis.min(2)];
                painter.text(at, Align2::LEFT_CENTER, letter, font.clone(), color);
                room -= LETTER;
            } else {
                let line = Rect::from_min_max(
                    pos2(rect.left() + 2.0, rect.bottom() - 2.0),
                    pos2(rect.right() - 2.0, rect.bottom() - 1.0),
                );
                let strength = if is_dim { 0.35 } else { 0.7 };
                painter.rect_filled(line, 0.0, color.gamma_multiply(strength));
            }
        }
        let decimals = self.decimals.clone();
        let turn = (self.wrap, is_used);
        let text = fitted(self.shown(), self.unit, decimals, turn, |text| {
            painter
                .layout_no_wrap(text.to_owned(), font.clone(), text_color)
                .size()
                .x
                <= room
        });
        let at = rect.right_center() - vec2(EDGE, 0.0);
        painter.text(at, Align2::RIGHT_CENTER, text, font, text_color);
    }

    fn asked_by_assistive_technology(&self, ui: &Ui, id: Id) -> Option<f64> {
        use accesskit::{Action, ActionData};
        ui.input(|input| {
            let set = input
                .accesskit_action_requests(id, Action::SetValue)
                .find_map(|request| match &request.data {
                    Some(ActionData::NumericValue(value)) => Some(*value),
                    Some(ActionData::Value(text)) => evaluate(text),
                    _ => None,
                });
            let steps = input.num_accesskit_action_requests(id, Action::Increment) as f64
                - input.num_accesskit_action_requests(id, Action::Decrement) as f64;
            set.or((steps != 0.0).then_some(self.value + steps * self.step))
        })
    }

    /// Name, value and bounds for assistive technology; effects of the mouse for the tooltip.
    fn describe(&self, ui: &Ui, response: &Response, typing: bool) {
        response.widget_info(|| WidgetInfo::drag_value(ui.is_enabled(), self.shown()));
        let response = named(response.clone(), self.name);
        let whole = format!("{}{}", precise(self.shown()), self.unit);
        ui.ctx().accesskit_node_builder(response.id, |node| {
            use accesskit::Action;
            node.set_numeric_value(self.shown());
            node.set_numeric_value_step(self.step);
            node.set_min_numeric_value(*self.range.start());
            node.set_max_numeric_value(*self.range.end());
            for action in [Action::SetValue, Action::Increment, Action::Decrement] {
                node.add_action(action);
            }
            if !typing {
                node.set_value(whole.as_str());
            }
        });
        if !typing && !response.dragged() {
            let mut tip = format!(
                "{}: {whole}\n{}{}{}",
                self.name,
                Pointing::of(ui.ctx()).words(
                    "Drag, with Shift finer · click to type · right click for ",
                    "Drag · tap to type · at rest it is ",
                ),
                precise(self.rest),
                self.unit
            );
            let (least, most) = (*self.range.start(), *self.range.end());
            if least > -FARTHEST && most < FARTHEST {
                let (least, most) = (precise(least), precise(most));
                tip = format!("{tip}\nFrom {least}{} to {most}{}", self.unit, self.unit);
            }
            tip_beside_panel(ui, &response, &tip);
        }
    }
}

/// Scrolls what the field is in by a finger that goes more up or down than aside, wherever it began; whether it does, and
/// so leaves the number as it is.
fn swiped(ui: &Ui, response: &Response) -> bool {
    let id = response.id.with("swiped");
    let held = response.dragged_by(PointerButton::Primary);
    if !held || !ui.input(InputState::any_touches) {
        ui.data_mut(|data| data.remove_temp::<bool>(id));
        return false;
    }
    let known = ui.data(|data| data.get_temp(id));
    let all = response.total_drag_delta().unwrap_or_default();
    let swipes = known.unwrap_or(all.y.abs() > all.x.abs());
    ui.data_mut(|data| data.insert_temp(id, swipes));
    if swipes {
        let first = known.is_none();
        let delta = if first {
            all.y
        } else {
            response.drag_delta().y
        };
        ui.scroll_with_delta(vec2(0.0, delta));
    }
    swipes
}

/// Records the beginning or end of a drag of a field, for [`take_gestures`].
fn note_gesture(ui: &Ui, step: GestureStep) {
    ui.data_mut(|data| {
        let noted: &mut Vec<GestureStep> = data.get_temp_mut_or_default(Id::new(GESTURES));
        noted.push(step);
    });
}

/// Beginnings and ends of drags of fields since the last call, in order.
pub(super) fn take_gestures(ctx: &Context) -> Vec<GestureStep> {
    ctx.data_mut(|data| data.remove_temp(Id::new(GESTURES)).unwrap_or_default())
}

/// Rounds off the errors of adding tenths in binary.
fn clean(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}
