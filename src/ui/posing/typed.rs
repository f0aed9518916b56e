//! Numbers and axes typed in the middle of a drag.

use crate::editor::{Constraint, GizmoAxes};
use crate::ui::number_field::evaluate;
use egui::{Context, Event, FocusDirection, Key};

/// Most characters of a number: more are not exact anyway.
const LONGEST: usize = 12;
/// Characters between two numbers. After another one, or `=` at the beginning, a minus subtracts; else it turns the sign of
/// the number, as in Blender.
const OPERATORS: [char; 4] = ['+', '-', '*', '/'];
/// Keys that numbers are typed with.
const NUMBER: [Key; 16] = [
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
    Key::Minus,
    Key::Plus,
    Key::Equals,
    Key::Period,
    Key::Comma,
    Key::Slash,
];

/// What has been typed during a drag: an axis or a plane, and the exact amount.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::ui) struct Typed {
    text: String,
    /// Whether `=` was typed first, so that a minus subtracts.
    is_sum: bool,
    /// Axes along which alone things are moved or scaled, or the axis about which they are turned.
    constraint: Option<Constraint>,
    /// Whether its key was pressed again: then it is one of the other kind of axes.
    other_axes: bool,
    /// Whether Tab was pressed, after which Blender has the number of the next axis: nothing is added to this one.
    is_ended: bool,
    /// Whether Enter was pressed.
    confirmed: bool,
}

impl Typed {
    /// Takes the keys of this frame that are meant for the drag, so that nothing else gets them. The
    /// number is in their text, since which keys `*` and the digits are on differs from keyboard to
    /// keyboard.
    pub(super) fn take_keys(&mut self, ctx: &Context) {
        let before = self.clone();
        ctx.input_mut(|input| {
            input.events.retain(|event| match event {
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } if !modifiers.command && !modifiers.alt => !self.take(*key, modifiers.shift),
                Event::Text(text) => {
                    text.chars().for_each(|typed| self.push(typed));
                    false
                }
                _ => true,
            });
        });
        if self.is_ended && !before.is_ended {
            // The same key would give the keyboard to a widget.
            ctx.memory_mut(|memory| memory.move_focus(FocusDirection::None));
        }
        if *self != before {
            ctx.request_repaint();
        }
    }

    /// Whether a key would mean something in the middle of a drag.
    pub(in crate::ui) fn is_typed(key: Key) -> bool {
        Self::default().take(key, false)
    }

    /// Takes one key, with Shift held or not; whether it means something here.
    fn take(&mut self, key: Key, shift: bool) -> bool {
        let along = |axis| match shift {
            true => Constraint::Plane(axis),
            false => Constraint::Axis(axis),
        };
        match key {
            Key::X => self.choose(along(0)),
            Key::Y => self.choose(along(1)),
            Key::Z => self.choose(along(2)),
            Key::Enter => self.confirmed = true,
            Key::Tab => self.is_ended = true,
            Key::Backspace if self.is_ended => self.is_ended = false,
            Key::Backspace => {
                if self.text.pop().is_none() && !std::mem::take(&mut self.is_sum) {
                    self.constraint = None;
                }
            }
            // Those of the number, whose text follows.
            key => return NUMBER.contains(&key),
        }
        true
    }

    /// Takes a character of the number, if it is one.
    fn push(&mut self, typed: char) {
        if self.is_ended {
            return;
        }
        let ends_in_digit = self.text.ends_with(|last: char| last.is_ascii_digit());
        let is_sum = self.is_sum || self.text.contains(['+', '*', '/']);
        match typed {
            '=' => self.is_sum = true,
            '-' | '−' if is_sum && self.text.ends_with('-') => {}
            '-' | '−' if is_sum => self.text.push('-'),
            '-' | '−' => {
                self.text = match self.text.strip_prefix('-') {
                    Some(positive) => positive.to_owned(),
                    None => format!("-{}", self.text),
                }
            }
            '.' | ',' => {
                let number = self.text.rsplit(OPERATORS).next().unwrap_or_default();
                if !number.contains('.') {
                    self.text.push('.');
                }
            }
            operator if ends_in_digit && OPERATORS.contains(&operator) => self.text.push(operator),
            digit if digit.is_ascii_digit() && self.text.len() < LONGEST => self.text.push(digit),
            _ => {}
        }
    }

    /// The first press of its key chooses an axis or a plane of the gizmo, the second one of the other
    /// kind, the third none.
    fn choose(&mut self, constraint: Constraint) {
        let is_again = self.constraint == Some(constraint);
        (self.constraint, self.other_axes) = match (is_again, self.other_axes) {
            (false, _) => (Some(constraint), false),
            (true, false) => (Some(constraint), true),
            (true, true) => (None, false),
        };
    }

    /// The axis or the plane, and which kind of axes it is of, where a gizmo has those of kind `axes`.
    pub(super) fn constraint(&self, axes: GizmoAxes) -> Option<(Constraint, GizmoAxes)> {
        let axes = if self.other_axes { axes.other() } else { axes };
        Some((self.constraint?, axes))
    }

    /// The number, or what those that were typed come to, as in `360*2/3`; `None` while there is none, or
    /// only a part of one such as `-`.
    pub(super) fn amount(&self) -> Option<f64> {
        evaluate(self.text.trim_end_matches(OPERATORS))
    }

    /// What was typed for the number, with a mark where typing goes on; `None` if there is nothing.
    pub(super) fn shown(&self) -> Option<String> {
        let mark = if self.is_ended { "" } else { "|" };
        let equals = if self.is_sum { "=" } else { "" };
        let text = format!("{equals}{}", self.text.replace('-', "−"));
        (!text.is_empty()).then(|| format!("{text}{mark}"))
    }

    /// Why nothing more is taken for the number, if so.
    pub(super) fn why_ended(&self) -> Option<&'static str> {
        self.is_ended
            .then_some("(one number alone; Backspace goes on with it)")
    }

    /// Whether Enter was pressed.
    pub(super) fn is_confirmed(&self) -> bool {
        self.confirmed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(keys: &[Key]) -> Typed {
        let mut typed = Typed::default();
        for &key in keys {
            assert!(typed.take(key, false), "{key:?}");
        }
        typed
    }

    #[test]
    fn after_tab_nothing_is_added_to_the_number_until_backspace() {
        let mut typed = Typed::default();
        "0.4".chars().for_each(|digit| typed.push(digit));
        assert!(typed.take(Key::Tab, false));
        "0.2".chars().for_each(|digit| typed.push(digit));
        assert_eq!(typed.amount(), Some(0.4));
        assert_eq!(typed.shown().unwrap(), "0.4");
        assert!(typed.why_ended().is_some());
        assert!(typed.take(Key::Backspace, false));
        typed.push('5');
        assert_eq!(typed.amount(), Some(0.45));
        assert_eq!(typed.shown().unwrap(), "0.45|");
        assert!(typed.why_ended().is_none());
    }

    #[test]
    fn digits_a_point_signs_and_backspace_make_a_number() {
        for (text, amount) in [
            ("25", Some(25.0)),
            ("2.5", Some(2.5)),
            (".5", Some(0.5)),
            ("2,.5", Some(2.5)),
            ("2-", Some(-2.0)),
            ("-2-", Some(2.0)),
            ("-2−", Some(2.0)),
            ("25<", Some(2.0)),
            ("2<<", None),
            ("-", None),
            ("0", Some(0.0)),
            ("5/", Some(5.0)),
            ("5/2", Some(2.5)),
            ("-5//2.5", Some(-2.0)),
            ("/5", Some(5.0)),
            ("5/0", None),
            ("3*2", Some(6.0)),
            ("3+2", Some(5.0)),
            ("1.5*1.5*", Some(2.25)),
            ("1 m", Some(1.0)),
            ("90-45", Some(-9045.0)),
            ("=90-45", Some(45.0)),
            ("=90-", Some(90.0)),
            ("=-90--45", Some(-135.0)),
            ("2*3-1", Some(5.0)),
            ("2*-3.5", Some(-7.0)),
            ("=<2-", Some(-2.0)),
        ] {
            let mut typed = Typed::default();
            for character in text.chars() {
                match character {
                    '<' => assert!(typed.take(Key::Backspace, false)),
                    character => typed.push(character),
                }
            }
            assert_eq!(typed.amount(), amount, "{text}");
        }
        assert!(!Typed::default().take(Key::Q, false), "means nothing here");
    }

    #[test]
    fn the_same_axis_again_is_of_the_other_kind_and_then_none() {
        use Key::{X, Z};
        let axis = |keys: &[Key]| typed(keys).constraint(GizmoAxes::World);
        assert_eq!(axis(&[X]), Some((Constraint::Axis(0), GizmoAxes::World)));
        assert_eq!(axis(&[X, X]), Some((Constraint::Axis(0), GizmoAxes::Local)));
        assert_eq!(axis(&[X, X, X]), None);
        let last = Some((Constraint::Axis(2), GizmoAxes::World));
        assert_eq!(axis(&[X, X, Z]), last);
    }
}
