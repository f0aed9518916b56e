//! Typing into a number's field.

use super::{NumberField, clean};
use crate::ui::expression::evaluate;
use crate::ui::number_text::precise;
use crate::ui::theme::{Palette, number_font};
use egui::text::{CCursor, CCursorRange};
use egui::{Id, Key, Modifiers, Rect, Response, TextEdit, Ui, UiBuilder, pos2, vec2};

/// Fields narrower than this grow while they are typed into.
const ROOM_TO_TYPE: f32 = 76.0;

/// What is being typed into a field, kept by egui while the field has the keyboard.
#[derive(Clone, Default)]
struct Typed {
    text: String,
    /// The text that typing began with: leaving it as it is changes nothing, though it may be
    /// shorter than the value.
    began_with: String,
    /// egui's count of passes when the field was shown last. What was typed into a field that
    /// then was not shown for a while is forgotten.
    pass: u64,
}

impl Typed {
    fn beginning_with(text: String) -> Self {
        Self {
            began_with: text.clone(),
            text,
            pass: 0,
        }
    }

    fn value(&self) -> Option<f64> {
        (self.text != self.began_with).then(|| evaluate(&self.text))?
    }
}

/// Room to type a sum in: a narrow field grows over what is at its left.
fn roomy(rect: Rect) -> Rect {
    let left = rect.left().min(rect.right() - ROOM_TO_TYPE);
    Rect::from_min_max(pos2(left, rect.top()), rect.max)
}

impl NumberField<'_> {
    /// The value typed, when the keyboard has just gone elsewhere other than by Esc.
    pub(super) fn left(&self, ui: &Ui, id: Id) -> Option<f64> {
        let typed: Typed = ui.data_mut(|data| data.remove_temp(id))?;
        let just_now = typed.pass + 1 == ui.ctx().cumulative_pass_nr();
        let escaped = ui.input(|input| input.key_pressed(Key::Escape));
        if just_now && !escaped {
            typed.value()
        } else {
            None
        }
    }

    pub(super) fn type_into(&self, ui: &mut Ui, id: Id, rect: Rect) -> (Response, Option<f64>) {
        let kept: Option<Typed> = ui.data_mut(|data| data.remove_temp(id));
        let begins = kept.is_none();
        let mut typed = kept.unwrap_or_else(|| Typed::beginning_with(precise(self.shown())));
        let stepped = self.stepped(ui, &mut typed);
        if begins {
            select_all(ui, id, &typed.text);
        }
        let rect = roomy(rect);
        let wrong = evaluate(&typed.text).is_none();
        let palette = Palette::of(ui.visuals());
        let color = if wrong { palette.error } else { palette.strong };
        let edit = TextEdit::singleline(&mut typed.text)
            .id(id)
            .font(number_font())
            .text_color(color)
            .margin(vec2(4.0, 2.0))
            .min_size(rect.size())
            .desired_width(rect.width() - 8.0)
            .vertical_align(egui::Align::Center)
            .clip_text(true);
        let mut inner = ui.new_child(UiBuilder::new().max_rect(rect));
        let response = inner.add_sized(rect.size(), edit);
        if response.lost_focus() {
            let escaped = ui.input(|input| input.key_pressed(Key::Escape));
            let given = if escaped { None } else { typed.value() };
            return (response, given.or(stepped));
        }
        typed.pass = ui.ctx().cumulative_pass_nr();
        ui.data_mut(|data| data.insert_temp(id, typed));
        (response, stepped)
    }

    /// ↑ and ↓ while typing: the value and the text, changed by one step.
    fn stepped(&self, ui: &Ui, typed: &mut Typed) -> Option<f64> {
        let steps = ui.input_mut(|input| {
            input.count_and_consume_key(Modifiers::NONE, Key::ArrowUp) as f64
                - input.count_and_consume_key(Modifiers::NONE, Key::ArrowDown) as f64
        });
        if steps == 0.0 {
            return None;
        }
        let from = typed.value().unwrap_or(self.value);
        let value = self.brought_into_range(clean(from + steps * self.step));
        *typed = Typed::beginning_with(precise(value));
        Some(value)
    }
}

fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let end = CCursor::new(text.chars().count());
    state
        .cursor
        .set_char_range(Some(CCursorRange::two(CCursor::default(), end)));
    state.store(ui.ctx(), id);
}
