//! Presses of fingers, of which eframe tells twice.

use egui::{Event, PointerButton, Pos2};

/// Where the pointer's first button is pressed, if it is.
///
/// A finger or a pen comes as a pointer and as a touch, and eframe makes a press of each. The second would be a
/// click on what the first has uncovered, such as by closing a menu.
#[derive(Debug, Default)]
pub(super) struct FingerPresses {
    pressed: Option<Pos2>,
}

impl FingerPresses {
    /// Leaves one press for each finger in `events`, which go on from those of the frames before.
    pub fn count_once(&mut self, events: &mut Vec<Event>) {
        events.retain(|event| {
            let &Event::PointerButton {
                pos,
                button: PointerButton::Primary,
                pressed,
                ..
            } = event
            else {
                return true;
            };
            // Another finger may be down elsewhere.
            let is_again = pressed && self.pressed.is_some_and(|at| at.distance(pos) < 1.0);
            self.pressed = pressed.then_some(pos);
            !is_again
        });
    }
}
