//! Numbers and axes typed in the middle of a drag.

use crate::editor::GizmoAxes;
use crate::ui::number_field::evaluate;
use egui::{Context, Event, Key};

/// Most characters of a number: more are not exact anyway.
const LONGEST: usize = 12;

/// What has been typed during a drag: an axis, and the exact amount.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::ui) struct Typed {
    text: String,
    /// Axis that alone is moved along, turned about or scaled: 0 for x, 1 for y, 2 for z.
    axis: Option<usize>,
    /// Whether the key of the axis was pressed again: then it is one of the other kind of axes.
    other_axes: bool,
    /// Whether Enter was pressed.
    confirmed: bool,
}

impl Typed {
    /// Takes the keys of this frame that are meant for the drag, so that nothing else gets them.
    pub(super) fn take_keys(&mut self, ctx: &Context) {
        let before = self.clone();
        ctx.input_mut(|input| {
            input.events.retain(|event| match event {
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } if !modifiers.command && !modifiers.alt => !self.take(*key),
                // The same keys as text, which no field may get.
                Event::Text(_) => false,
                _ => true,
            });
        });
        if *self != before {
            ctx.request_repaint();
        }
    }

    /// Takes one key; whether it means something here.
    fn take(&mut self, key: Key) -> bool {
        match key {
            Key::X => self.choose_axis(0),
            Key::Y => self.choose_axis(1),
            Key::Z => self.choose_axis(2),
            Key::Enter => self.confirmed = true,
            Key::Backspace => {
                if self.text.pop().is_none() {
                    self.axis = None;
                }
            }
            Key::Minus => {
                self.text = match self.text.strip_prefix('-') {
                    Some(positive) => positive.to_owned(),
                    None => format!("-{}", self.text),
                }
            }
            Key::Period | Key::Comma => {
                let number = self.text.rsplit('/').next().unwrap_or_default();
                if !number.contains('.') {
                    self.text.push('.');
                }
            }
            Key::Slash => {
                if self.text.ends_with(|last: char| last.is_ascii_digit()) {
                    self.text.push('/');
                }
            }
            _ => match digit(key) {
                Some(digit) if self.text.len() < LONGEST => self.text.push(digit),
                Some(_) => {}
                None => return false,
            },
        }
        true
    }

    /// The first press of its key chooses an axis of the gizmo, the second one of the other kind,
    /// the third none.
    fn choose_axis(&mut self, axis: usize) {
        (self.axis, self.other_axes) = match (self.axis == Some(axis), self.other_axes) {
            (false, _) => (Some(axis), false),
            (true, false) => (Some(axis), true),
            (true, true) => (None, false),
        };
    }

    /// The axis, and which kind of axes it is of, where a gizmo has those of kind `axes`.
    pub(super) fn axis(&self, axes: GizmoAxes) -> Option<(usize, GizmoAxes)> {
        let axes = if self.other_axes { axes.other() } else { axes };
        Some((self.axis?, axes))
    }

    /// The number, or the quotient of those that were typed; `None` while there is none, or only a part of
    /// one such as `-`.
    pub(super) fn amount(&self) -> Option<f64> {
        evaluate(self.text.trim_end_matches('/'))
    }

    /// What was typed for the number, with a mark where typing goes on; `None` if there is nothing.
    pub(super) fn shown(&self) -> Option<String> {
        (!self.text.is_empty()).then(|| format!("{}|", self.text.replace('-', "−")))
    }

    /// Whether Enter was pressed.
    pub(super) fn is_confirmed(&self) -> bool {
        self.confirmed
    }
}

fn digit(key: Key) -> Option<char> {
    let digits = [
        Key::Num0,
        Key::Num1,
        Key::Num2,
        Key::Num3,
        Key::Num4,
        Key::Num5,
        Key::Num6,
        Key::Num7,
        Key::Num8,
        Key::Num9,
    ];
    let digit = digits.iter().position(|&known| known == key)?;
    char::from_digit(digit as u32, 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(keys: &[Key]) -> Typed {
        let mut typed = Typed::default();
        for &key in keys {
            assert!(typed.take(key), "{key:?}");
        }
        typed
    }

    #[test]
    fn digits_a_point_a_minus_and_backspace_make_a_number() {
        use Key::{Backspace, Comma, Minus, Num0, Num2, Num5, Period, Slash};
        for (keys, amount) in [
            (&[Num2, Num5][..], Some(25.0)),
            (&[Num2, Period, Num5], Some(2.5)),
            (&[Period, Num5], Some(0.5)),
            (&[Num2, Comma, Period, Num5], Some(2.5)),
            (&[Num2, Minus], Some(-2.0)),
            (&[Minus, Num2, Minus], Some(2.0)),
            (&[Num2, Num5, Backspace], Some(2.0)),
            (&[Num2, Backspace, Backspace], None),
            (&[Minus], None),
            (&[Num0], Some(0.0)),
            (&[Num5, Slash], Some(5.0)),
            (&[Num5, Slash, Num2], Some(2.5)),
            (&[Minus, Num5, Slash, Slash, Num2, Period, Num5], Some(-2.0)),
            (&[Slash, Num5], Some(5.0)),
            (&[Num5, Slash, Num0], None),
        ] {
            assert_eq!(typed(keys).amount(), amount, "{keys:?}");
        }
        assert!(!Typed::default().take(Key::Q), "means nothing here");
    }

    #[test]
    fn the_same_axis_again_is_of_the_other_kind_and_then_none() {
        use Key::{X, Z};
        let axis = |keys: &[Key]| typed(keys).axis(GizmoAxes::World);
        assert_eq!(axis(&[X]), Some((0, GizmoAxes::World)));
        assert_eq!(axis(&[X, X]), Some((0, GizmoAxes::Local)));
        assert_eq!(axis(&[X, X, X]), None);
        assert_eq!(axis(&[X, X, Z]), Some((2, GizmoAxes::World)));
    }
}
