//! Clicks and taps when frames are slow.

use egui::{Context, InputOptions};

/// Lets a press be a click for as long as ever, in the frame at `now`, in seconds on egui's clock, however long the
/// frame before took.
///
/// egui knows when a frame saw that a button was released, and not when it was: that may be as long ago as the frame
/// before began. On slow frames, as those of OpenGL in software, a click would be a press that does nothing, and a tap
/// the right button. Where no frame was under way, what happens is seen at once.
pub fn allow_for_slow_frames(context: &Context, now: Option<f64>) {
    let before = context.input(|input| input.time);
    let waited = now.map_or(0.0, |now| (now - before).max(0.0));
    let late = if context.requested_repaint_last_pass() {
        waited
    } else {
        0.0
    };
    let longest = InputOptions::default().max_click_duration + late;
    context.options_mut(|options| options.input_options.max_click_duration = longest);
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Event, Modifiers, PointerButton, RawInput, Rect, Sense, Vec2, pos2};

    /// Whether a button that fills the window is clicked in any of these frames: each has its time in seconds, and
    /// whether the button of the mouse is pressed or released in it, if either.
    fn is_clicked(frames: &[(f64, Option<bool>)]) -> bool {
        let context = Context::default();
        let mut clicked = false;
        for &(time, pressed) in frames {
            let press = pressed.map(|pressed| Event::PointerButton {
                pos: pos2(50.0, 50.0),
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            });
            let input = RawInput {
                screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), Vec2::splat(100.0))),
                time: Some(time),
                events: press.into_iter().collect(),
                ..RawInput::default()
            };
            allow_for_slow_frames(&context, input.time);
            let mut output = context.run_ui(input, |ui| {
                let size = ui.available_size();
                clicked |= ui.allocate_response(size, Sense::click()).clicked();
            });
            output.textures_delta.clear();
        }
        clicked
    }

    #[test]
    fn a_click_that_a_slow_frame_sees_late_is_one() {
        let slow = [
            (0.0, None),
            (0.9, None),
            (1.8, Some(true)),
            (3.2, Some(false)),
        ];
        assert!(is_clicked(&slow));
    }

    #[test]
    fn a_button_that_was_held_for_long_is_none() {
        // Nothing happens in a window that waits for events, until there is one.
        let waiting = [
            (0.0, None),
            (0.1, None),
            (0.2, Some(true)),
            (0.21, None),
            (0.22, None),
            (0.23, None),
            (1.4, Some(false)),
        ];
        assert!(!is_clicked(&waiting));
        let slow = [
            (0.0, None),
            (0.2, Some(true)),
            (0.6, None),
            (1.1, None),
            (1.6, Some(false)),
        ];
        assert!(!is_clicked(&slow));
    }
}
