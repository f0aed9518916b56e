//! Typing into a number field, and the arithmetic that it accepts.

use super::decimals::precise;
use super::{NumberField, clean};
use crate::ui::pointing::Pointing;
use crate::ui::theme::{Palette, number_font};
use crate::ui::widgets::select_all;
use egui::{Context, Id, Key, Modifiers, Rect, Response, TextEdit, Ui, UiBuilder, pos2, vec2};

/// Width to which a field grows at most while something is typed into it that needs it, in points.
const ROOM_TO_TYPE: f32 = 76.0;
/// Space between a field's edges and the text that is typed into it, on each side, in points.
const MARGIN: f32 = 4.0;
/// Seconds after the beginning of typing in which another tap is the second of a double one. Fingers are slower than
/// the clicks that egui takes for a double one.
const DOUBLE_TAP: f64 = 0.6;
/// Room for the cursor behind the text, in points.
const CURSOR: f32 = 4.0;

/// Text being typed into a field, kept by egui while the field has the keyboard focus.
#[derive(Clone, Default)]
struct Typed {
    text: String,
    /// Text when typing began. If it is left as it is, the value does not change, though the value
    /// may have more decimals.
    began_with: String,
    /// Time when typing began, in seconds of egui's clock.
    began_at: f64,
    /// egui's pass number when the field was last shown. Text is dropped if the field was not shown
    /// in between.
    pass: u64,
}

impl Typed {
    fn beginning_with(text: String, now: f64) -> Self {
        Self {
            began_with: text.clone(),
            began_at: now,
            text,
            pass: 0,
        }
    }

    /// Whether what was typed is no number. Nothing at all is none either, but leaves no doubt that the field is
    /// to stay as it was.
    fn is_wrong(&self) -> bool {
        let is_typed = self.text != self.began_with && !self.text.trim().is_empty();
        is_typed && evaluate(&self.text).is_none()
    }

    fn value(&self) -> Option<f64> {
        (self.text != self.began_with).then(|| evaluate(&self.text))?
    }
}

/// A rectangle wide enough for `text`: a narrow field grows to the left, over its neighbor, only for a sum.
fn roomy(ui: &Ui, rect: Rect, text: &str) -> Rect {
    let color = ui.visuals().text_color();
    let laid_out = ui
        .painter()
        .layout_no_wrap(text.to_owned(), number_font(), color);
    let needed = laid_out.size().x + 2.0 * MARGIN + CURSOR;
    let left = rect.left().min(rect.right() - needed.min(ROOM_TO_TYPE));
    Rect::from_min_max(pos2(left, rect.top()), rect.max)
}

impl NumberField<'_> {
    /// The value typed, if the field has just lost the keyboard focus, other than by Esc.
    pub(super) fn left(&self, ui: &Ui, id: Id) -> Option<f64> {
        let typed: Typed = ui.data_mut(|data| data.remove_temp(id))?;
        let just_now = typed.pass + 1 == ui.ctx().cumulative_pass_nr();
        let escaped = ui.input(|input| input.key_pressed(Key::Escape));
        if just_now && !escaped {
            self.note_wrong(ui, &typed);
            typed.value()
        } else {
            None
        }
    }

    /// Shows the field while it is typed into; returns its widget and the new value, if any.
    pub(super) fn type_into(&self, ui: &mut Ui, id: Id, rect: Rect) -> (Response, Option<f64>) {
        let kept: Option<Typed> = ui.data_mut(|data| data.remove_temp(id));
        let begins = kept.is_none();
        let now = ui.input(|input| input.time);
        let mut typed = kept.unwrap_or_else(|| Typed::beginning_with(precise(self.shown()), now));
        let stepped = self.stepped(ui, &mut typed);
        let undone = take_back(ui, &mut typed);
        if begins || undone {
            select_all(ui, id, &typed.text);
        }
        let rect = roomy(ui, rect, &typed.text);
        let wrong = evaluate(&typed.text).is_none();
        let palette = Palette::of(ui.visuals());
        let color = if wrong { palette.error } else { palette.strong };
        let edit = TextEdit::singleline(&mut typed.text)
            .id(id)
            .font(number_font())
            .text_color(color)
            .margin(vec2(MARGIN, 2.0))
            .min_size(rect.size())
            .desired_width(rect.width() - 2.0 * MARGIN)
            .vertical_align(egui::Align::Center)
            .clip_text(true);
        let mut inner = ui.new_child(UiBuilder::new().max_rect(rect));
        let response = inner.add_sized(rect.size(), edit);
        let is_tapped = response.clicked() && Pointing::of(ui.ctx()) == Pointing::Fingers;
        if response.double_clicked() || (is_tapped && now < typed.began_at + DOUBLE_TAP) {
            // A double click begins to type as one click does: it selects all, not a word.
            select_all(ui, id, &typed.text);
        }
        if response.lost_focus() {
            let escaped = ui.input(|input| input.key_pressed(Key::Escape));
            if escaped {
                return (response, stepped);
            }
            self.note_wrong(ui, &typed);
            return (response, typed.value().or(stepped));
        }
        typed.pass = ui.ctx().cumulative_pass_nr();
        ui.data_mut(|data| data.insert_temp(id, typed));
        (response, stepped)
    }

    /// Records for [`take_wrong`] that the field is left with what is no number in it, or one that it cannot have.
    fn note_wrong(&self, ui: &Ui, typed: &Typed) {
        let beyond = |value: &f64| self.brought_into_range(*value) != *value;
        let why = if typed.is_wrong() {
            NO_NUMBER.to_owned()
        } else if let Some(value) = typed.value().filter(beyond) {
            let taken = self.brought_into_range(value);
            let most = if value < taken { "least" } else { "most" };
            let (name, taken, value) = (self.name, precise(taken), precise(value));
            format!("{name} can be {taken} at {most}: {value} was typed")
        } else {
            return;
        };
        ui.data_mut(|data| data.insert_temp(Id::new(WRONG), why));
    }

    /// ↑ and ↓ while typing: changes the text by steps, and returns the new value.
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
        *typed = Typed::beginning_with(precise(value), typed.began_at);
        Some(value)
    }
}

/// Ctrl+Z while typing: takes back all that was typed, and returns whether there was any. egui's own way
/// takes back as much as was typed without a pause, also in this field earlier.
fn take_back(ui: &Ui, typed: &mut Typed) -> bool {
    let is_asked = ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Z));
    let undone = is_asked && typed.text != typed.began_with;
    if undone {
        typed.text.clone_from(&typed.began_with);
    }
    undone
}

/// Key of egui's memory for why a field that was left in a frame has another number than was typed.
const WRONG: &str = "another number was typed";
/// What is told of what is no number.
const NO_NUMBER: &str = "What was typed is no number, and nothing was changed: a value or an expression such as 45/2 is one";

/// Why a field that was left since the last call has another number than was typed into it, if it has.
pub(in crate::ui) fn take_wrong(ctx: &Context) -> Option<String> {
    ctx.data_mut(|data| data.remove_temp(Id::new(WRONG)))
}

/// Whether the keyboard belongs to a number field into which nothing has been typed yet.
pub(in crate::ui) fn is_untouched(ctx: &Context) -> bool {
    let field = ctx.memory(|memory| memory.focused());
    let typed = field.and_then(|id| ctx.data(|data| data.get_temp::<Typed>(id)));
    typed.is_some_and(|typed| typed.text == typed.began_with)
}

/// Deepest nesting of parentheses and signs, so that no text can exhaust the stack.
const DEEPEST: usize = 32;

/// Value of an arithmetic expression typed into a number field: `45/2`, `-(3 + 4) * 1.5`, `90°`.
///
/// Accepts + − * /, parentheses and signs, exponents, the typographic × · ÷ −, a trailing degree sign, and a
/// comma as a decimal point. `None` for anything else, and for values that are not finite.
pub fn evaluate(text: &str) -> Option<f64> {
    let plain: Vec<char> = text
        .trim()
        .trim_end_matches('°')
        .chars()
        .filter(|c| !c.is_whitespace())
        .map(|c| match c {
            '×' | '·' => '*',
            '÷' => '/',
            '−' => '-',
            ',' => '.',
            other => other,
        })
        .collect();
    let mut reader = Reader {
        rest: &plain,
        depth: 0,
    };
    let value = reader.sum()?;
    (reader.rest.is_empty() && value.is_finite()).then_some(value)
}

struct Reader<'a> {
    rest: &'a [char],
    depth: usize,
}

impl Reader<'_> {
    fn take(&mut self, wanted: char) -> bool {
        match self.rest.split_first() {
            Some((&first, rest)) if first == wanted => {
                self.rest = rest;
                true
            }
            _ => false,
        }
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                return Some(value);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            if self.take('*') {
                value *= self.factor()?;
            } else if self.take('/') {
                value /= self.factor()?;
            } else {
                return Some(value);
            }
        }
    }

    fn factor(&mut self) -> Option<f64> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let value = if self.take('-') {
            -self.factor()?
        } else if self.take('+') {
            self.factor()?
        } else if self.take('(') {
            let inner = self.sum()?;
            if !self.take(')') {
                return None;
            }
            inner
        } else {
            self.number()?
        };
        self.depth -= 1;
        Some(value)
    }

    fn number(&mut self) -> Option<f64> {
        let length = self
            .rest
            .iter()
            .take_while(|c| c.is_ascii_digit() || **c == '.')
            .count();
        let length = length + exponent(&self.rest[length..]);
        let (digits, rest) = self.rest.split_at(length);
        self.rest = rest;
        digits.iter().collect::<String>().parse().ok()
    }
}

/// Length of an exponent at the beginning of `text`, such as `e5` and `E-7`; 0 if there is none.
fn exponent(text: &[char]) -> usize {
    let sign = match text {
        ['e' | 'E', '+' | '-', ..] => 2,
        ['e' | 'E', ..] => 1,
        _ => return 0,
    };
    let digits = text[sign..].iter().take_while(|c| c.is_ascii_digit());
    match digits.count() {
        0 => 0,
        digits => sign + digits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_follows_the_usual_order() {
        for (text, value) in [
            ("7", 7.0),
            ("45/2", 22.5),
            ("1 + 2 * 3", 7.0),
            ("-(1+2)*3", -9.0),
            ("2--1", 3.0),
            ("8/2/2", 2.0),
            (".5", 0.5),
            ("1,5", 1.5),
            ("−30°", -30.0),
            ("3×4÷6", 2.0),
            ("1e5", 1e5),
            ("2E-3*1e+3", 2.0),
        ] {
            assert_eq!(evaluate(text), Some(value), "{text}");
        }
    }

    #[test]
    fn anything_else_is_no_number() {
        for text in [
            "", "-", "1+", "(1", "1)", "1..2", "a", "1 a", "1/0", "inf", "()", "1e", "e5", "1e+",
            "1e999",
        ] {
            assert_eq!(evaluate(text), None, "{text}");
        }
    }

    #[test]
    fn endless_parentheses_are_refused_rather_than_followed() {
        assert_eq!(evaluate(&"(".repeat(100_000)), None);
        assert_eq!(evaluate(&"-".repeat(100_000)), None);
    }
}
