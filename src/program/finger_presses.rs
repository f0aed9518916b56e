//! Presses of fingers, which browsers report twice.

use egui::{Event, PointerButton, Pos2, TouchPhase};

/// Places where the pointer's first button is pressed.
///
/// A browser reports a finger or a pen as a pointer and as a touch, and eframe makes a press of each. The second would be
/// a click on what the first has uncovered, such as by closing a menu.
#[derive(Debug, Default)]
pub struct FingerPresses {
    pressed: Vec<Pos2>,
}

impl FingerPresses {
    /// Leaves one press at each place in `events`, which go on from those of the frames before, until the button is
    /// released or the pointer is gone.
    pub fn count_once(&mut self, events: &mut Vec<Event>) {
        events.retain(|event| match event {
            Event::PointerButton {
                pos,
                button: PointerButton::Primary,
                pressed: true,
                ..
            } => {
                let is_again = self.pressed.iter().any(|at| at.distance(*pos) < 1.0);
                self.pressed.push(*pos);
                !is_again
            }
            Event::PointerButton {
                button: PointerButton::Primary,
                ..
            }
            | Event::PointerGone
            | Event::WindowFocused(false)
            | Event::Touch {
                phase: TouchPhase::Cancel,
                ..
            } => {
                self.pressed.clear();
                true
            }
            _ => true,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, TouchDeviceId, TouchId, pos2};

    fn button(x: f32, pressed: bool) -> Event {
        Event::PointerButton {
            pos: pos2(x, 20.0),
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    fn touch(x: f32, phase: TouchPhase) -> Event {
        Event::Touch {
            device_id: TouchDeviceId(0),
            id: TouchId(1),
            phase,
            pos: pos2(x, 20.0),
            force: None,
        }
    }

    /// Number of presses that are left of each frame's events.
    fn presses(frames: &[&[Event]]) -> Vec<usize> {
        let mut fingers = FingerPresses::default();
        let left = frames.iter().map(|events| {
            let mut events = events.to_vec();
            fingers.count_once(&mut events);
            let is_press =
                |event: &&Event| matches!(event, Event::PointerButton { pressed: true, .. });
            events.iter().filter(is_press).count()
        });
        left.collect()
    }

    #[test]
    fn a_tap_is_one_press_and_the_next_tap_at_the_same_place_another() {
        let down = [button(9.0, true)];
        let again = [button(9.2, true), touch(9.2, TouchPhase::Start)];
        let up = [button(9.0, false)];
        let gone = [
            button(9.2, false),
            Event::PointerGone,
            touch(9.2, TouchPhase::End),
        ];
        let tap: [&[Event]; 4] = [&down, &again, &up, &gone];
        assert_eq!(presses(&[tap, tap].concat()), [1, 0, 0, 0, 1, 0, 0, 0]);
    }

    #[test]
    fn a_second_finger_is_a_press_elsewhere() {
        let (one, other) = ([button(9.0, true)], [button(200.0, true)]);
        assert_eq!(presses(&[&one, &one, &other, &one]), [1, 0, 1, 0]);
    }

    #[test]
    fn after_a_touch_that_was_cancelled_or_a_pointer_that_is_gone_a_press_counts() {
        for end in [
            touch(9.0, TouchPhase::Cancel),
            Event::PointerGone,
            Event::WindowFocused(false),
        ] {
            let down = [button(9.0, true)];
            assert_eq!(presses(&[&down, &[end], &down]), [1, 0, 1]);
        }
    }
}
