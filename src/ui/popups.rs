//! Popups: menus, choices from a list, and choices of a color; dialogs that have to be left first.

use super::ViewInput;
use super::state::UiState;
use super::widgets::forget_buttons;
use super::windows::Dialog;
use egui::{Context, Event, Order, Popup, Pos2, Rect};

/// Closes popups when a button is pressed outside of them, and lets that press do nothing else, as in
/// GTK and Blender: whoever wants to be rid of a menu means nothing that lies below it. egui would close
/// them at the release, and only after what is below has had the click. To be called before the panels.
///
/// `titles` are those of the menu bar, which belong to its menus: a press there is left to them.
pub(super) fn close_by_press_outside(ctx: &Context, titles: Rect) {
    let pressed = ctx.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::PointerButton {
                pos, pressed: true, ..
            } => Some(*pos),
            _ => None,
        })
    });
    let Some(at) = pressed.filter(|_| Popup::is_any_open(ctx)) else {
        return;
    };
    if titles.contains(at) || is_in_popup(ctx, at) {
        return;
    }
    Popup::close_all(ctx);
    ctx.stop_dragging();
    forget_buttons(ctx);
    ctx.request_repaint();
}

/// Whether a dialog of the panels is open that has to be left before anything else is done, and whose the
/// keyboard is until then.
pub(super) fn is_in_dialog(state: &UiState, input: &ViewInput) -> bool {
    input.question.is_some() || state.search.is_some() || state.windows.is_open(Dialog::Screenshot)
}

/// Takes the pointer from what lies behind a dialog or a window that was opened, until it moves, and behind a dialog of
/// the panels the keyboard, too: a row of a list would go on by arrow keys. Returns whether a dialog of the panels is open. To be
/// called before the panels, once a frame.
pub(super) fn leave_to_dialog(ctx: &Context, state: &mut UiState, input: &ViewInput) -> bool {
    let in_dialog = is_in_dialog(state, input);
    let lies_below = in_dialog || input.is_below_dialog || state.windows.is_any_open();
    if lies_below && !state.was_below_dialog {
        // egui goes on showing the tooltip of whatever a pointer that rests is over, above all dialogs.
        forget_buttons(ctx);
    }
    state.was_below_dialog = lies_below;
    let opens = in_dialog && !state.was_in_dialog;
    state.was_in_dialog = in_dialog;
    if opens {
        ctx.memory_mut(|memory| {
            if let Some(behind) = memory.focused() {
                memory.surrender_focus(behind);
            }
        });
    }
    in_dialog
}

/// Whether a popup lies on top at `at`: nothing but popups and dialogs is in the foreground.
fn is_in_popup(ctx: &Context, at: Pos2) -> bool {
    let top = ctx.layer_id_at(at);
    let is_dialog = top == ctx.memory(|memory| memory.top_modal_layer());
    !is_dialog && top.is_some_and(|layer| layer.order == Order::Foreground)
}
