//! Commands that keys ask for: which of them wait, and what each means at the moment.

use super::commands::selected_character;
use super::compare::{CompareAction, CompareMeshAction};
use super::popups::is_in_dialog;
use super::posing::Typed;
use super::{
    Action, Ask, Command, Navigation, UiState, ViewInput, aspect, commands, control_points,
    number_field,
};
use crate::editor::{Session, Tool, View};
use crate::scene::{Look, Shape};

/// Commands about the document that are meant even while a text or a number is being typed, or a menu or
/// a choice of color is open, which they close.
const MEANT_WHILE_TYPING: [Command; 5] = [
    Command::New,
    Command::Open,
    Command::Save,
    Command::SaveAs,
    Command::Quit,
];

/// Those that are meant even in the middle of a drag.
const MEANT_IN_A_DRAG: [Command; 3] = [Command::Save, Command::SaveAs, Command::Quit];

/// Has commands about the document wait until what is being typed is taken over, for which the field
/// gives up the keyboard in this frame, until popups are closed, and saving until a drag has ended; runs
/// the one that has waited. Where `keys_are_taken`, such as by a file dialog, or another dialog has to be left
/// first, keys mean no commands.
pub(super) fn run_waiting(
    ctx: &egui::Context,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    in_drag: bool,
) -> Vec<Action> {
    // What came in with it is typed first.
    let is_typing = ctx.input(|input| {
        use egui::Event::{Key, Paste, Text};
        let typed = |event: &egui::Event| matches!(event, Text(_) | Paste(_) | Key { .. });
        input.events.iter().any(typed)
    });
    let gives_up = !is_typing && std::mem::take(&mut state.gives_up_typing);
    let takes_none = input.keys_are_taken || input.is_viewer || is_in_dialog(state, input);
    let typing = ctx.text_edit_focused() && state.search.is_none();
    let saves = |command: Command| matches!(command, Command::Save | Command::SaveAs);
    let in_gesture = in_drag || session.is_in_gesture();
    let in_popup = !typing && !in_gesture && egui::Popup::is_any_open(ctx);
    let waits = typing || in_popup || in_gesture && state.waiting.is_none_or(saves);
    if !waits {
        let aspect = aspect(state.view_rect);
        let command = state.waiting.take();
        return command.map_or_else(Vec::new, |command| {
            commands::run(command, session, state, aspect)
        });
    }
    if state.waiting.is_none() && !takes_none {
        let meant: &[Command] = if typing || in_popup {
            &MEANT_WHILE_TYPING
        } else {
            &MEANT_IN_A_DRAG
        };
        // What was typed into a number field is taken back by the field itself.
        let undoes = in_popup || number_field::is_untouched(ctx);
        let is_meant = |command: &Command| {
            let is_undo = undoes && *command == Command::Undo;
            let is_redo = in_popup && *command == Command::Redo;
            (is_undo || is_redo || meant.contains(command)) && is_there(*command, input)
        };
        let pressed = commands::pressed_with_ctrl(ctx, state.navigation);
        state.waiting = pressed.filter(is_meant);
    }
    if in_popup && state.waiting.is_some() {
        egui::Popup::close_all(ctx);
    }
    if typing && !is_typing && (gives_up || state.waiting.is_some()) {
        ctx.memory_mut(|memory| {
            if let Some(field) = memory.focused() {
                memory.surrender_focus(field);
            }
        });
    }
    // What waits for the end of a drag needs no frame before.
    let waits_for_drag = !typing && state.waiting.is_some_and(saves);
    if state.gives_up_typing || state.waiting.is_some() && !waits_for_drag {
        ctx.request_repaint();
    }
    Vec::new()
}

/// Whether a command exists where the program runs: nothing on a page is changed by other programs, and only
/// pages have an address.
pub(super) fn is_there(command: Command, input: &ViewInput) -> bool {
    match command {
        // Browsers reload the page by the key of the one, and close it themselves.
        Command::Reload | Command::Quit => !input.is_page,
        Command::CopyLink => input.is_page,
        _ => true,
    }
}

/// Whether a text field or a popup has the keyboard focus.
pub(super) fn takes_keys(ctx: &egui::Context) -> bool {
    ctx.text_edit_focused() || egui::Popup::is_any_open(ctx)
}

/// Seconds for which Esc does not end the program after it, or anything else, has ended something:
/// whoever presses it once too often must not lose the window.
const ESC_RESTS: f64 = 1.0;

/// Notice after the first press.
const ESC_ENDS: &str = "Esc again ends the program";

/// Seconds after which Esc has to be pressed again to end the program: the history of the document goes with it. Who
/// presses it many times, to get out of a menu, has not read the notice.
const ESC_AGAIN: std::ops::Range<f64> = 0.5..4.0;

/// A key that was pressed, and when, in seconds of egui's clock.
#[derive(Clone, Copy)]
pub(super) struct KeyPress {
    pub key: egui::Key,
    /// Whether neither Ctrl nor Alt was held.
    pub is_plain: bool,
    pub at: f64,
}

const NO_EDIT_MODE: &str = "There is no Edit Mode: J or Ctrl+Tab poses. Shift+Tab, or Tab with the pointer beside the view, \
                            goes through the panels";

/// Says so where Tab is pressed with the pointer over the view in the Blender navigation, as it would be there to edit, and
/// has it lead nowhere: whoever does not see that the menus have the keyboard goes on with the wrong keys.
pub(super) fn tab_over_the_view(
    ctx: &egui::Context,
    session: &Session,
    state: &UiState,
) -> Option<Action> {
    let is_pressed = ctx.input(|input| {
        let is_over = |at| state.view_rect.contains(at);
        input.pointer.latest_pos().is_some_and(is_over)
            && input.modifiers.is_none()
            && input.key_pressed(egui::Key::Tab)
    });
    let is_meant = is_pressed && state.navigation == Navigation::Blender;
    if !is_meant || ctx.memory(|memory| memory.focused()).is_some() {
        return None;
    }
    ctx.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
    tell_once(NO_EDIT_MODE, session)
}

/// Seconds for which an axis and a number that follow a refused G, R or S are taken for its own.
const TYPED_AFTER: f64 = 3.0;

/// Whether what is typed `now` is taken for a G, R or S that was refused, and so is what follows it.
pub(super) fn ignores_typed(ctx: &egui::Context, state: &mut UiState, now: f64) -> bool {
    let is_ignored = is_ignored(state.refused_at, now);
    let is_typed = |event: &egui::Event| {
        use egui::Event::Key;
        matches!(event, Key { key, pressed: true, modifiers, .. }
            if !modifiers.command && !modifiers.alt && Typed::is_typed(*key))
    };
    if is_ignored && ctx.input(|input| input.events.iter().any(is_typed)) {
        state.refused_at = Some(now);
    }
    is_ignored
}

/// Whether Enter or Esc is pressed, which end what is typed for a G, R or S that was refused, as they end a drag.
pub(super) fn ends_typed(ctx: &egui::Context) -> bool {
    let ends = [egui::Key::Enter, egui::Key::Escape];
    ctx.input(|input| ends.into_iter().any(|key| input.key_pressed(key)))
}

fn is_ignored(refused_at: Option<f64>, now: f64) -> bool {
    refused_at.is_some_and(|at| now - at < TYPED_AFTER)
}

/// Runs the command of a key. Esc closes the window opened last, or else gives up the work whose progress
/// is shown, ends a comparison with a picture,
/// a mistake that is made on purpose, the panel that explains, or a comparison with a mesh, deselects the
/// joint, deselects the shape, or, pressed twice, ends the program.
pub(super) fn press(
    command: Command,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    aspect: f32,
    pressed: KeyPress,
    actions: &mut Vec<Action>,
) {
    let is_esc = pressed.key == egui::Key::Escape;
    if is_esc && state.windows.close_last() {
        return;
    }
    if is_esc && input.progress.is_some() {
        state.busy_at = pressed.at;
        actions.push(Action::Ask(Ask::CancelWork));
        return;
    }
    if is_esc && input.compare.is_some() {
        actions.push(Action::Ask(Ask::Compare(CompareAction::Close)));
        return;
    }
    if is_esc && state.explain.end_last() {
        return;
    }
    if is_esc && input.compare_mesh.is_some() {
        let close = Ask::CompareMesh(CompareMeshAction::Close);
        return actions.push(Action::Ask(close));
    }
    if is_esc {
        let deselect = if session.selected_joint().is_some() {
            Some(View::SelectJoint(None))
        } else {
            session.selected().map(|_| View::Select(None))
        };
        if let Some(deselect) = deselect {
            state.busy_at = pressed.at;
            actions.push(Action::View(deselect));
            return;
        }
        if !state.navigation.quits_by_esc() || !is_there(command, input) {
            return;
        }
        // Nothing was open since the first press.
        let is_second =
            |first: f64| ESC_AGAIN.contains(&(pressed.at - first)) && state.busy_at <= first;
        let is_second = state.escaped_at.take().is_some_and(is_second);
        // A question about unsaved work takes its place.
        let fresh = session.messages.fresh().iter();
        let told = fresh.enumerate().filter(|(_, m)| m.text == ESC_ENDS).rev();
        actions.extend(told.map(|(index, _)| Action::View(View::DismissMessage(index))));
        if !is_second {
            if pressed.at - state.busy_at >= ESC_RESTS {
                state.escaped_at = Some(pressed.at);
                actions.push(Action::View(View::Tell(ESC_ENDS.into())));
            }
            return;
        }
    }
    if !is_there(command, input) {
        return;
    }
    let is_typed = pressed.is_plain && Typed::is_typed(pressed.key);
    if is_typed && is_ignored(state.refused_at, pressed.at) {
        return;
    }
    state.refused_at = None;
    // Typed for an axis of a drag that a locked or hidden shape has refused.
    let is_any = |what: fn(&Shape) -> bool| session.selected_shapes().any(what);
    if command == Command::Delete && pressed.key == egui::Key::X {
        let refused = if is_any(|shape| shape.locked) {
            Some("X deletes nothing that is locked: the Delete key does")
        } else if is_any(|shape| !shape.visible) {
            Some("X deletes nothing that is hidden: the Delete key does")
        } else {
            None
        };
        if let Some(why) = refused {
            actions.push(Action::View(View::Tell(why.into())));
            return;
        }
    }
    // Who has just clicked a row of the list means the shape, and not a joint of it.
    let row_has_keys = state.shape_row_keys == Some(state.pose.tool);
    let of_row = command == Command::Delete && row_has_keys;
    let poses = matches!(state.pose.tool, Tool::Pose | Tool::Ik)
        && !of_row
        && selected_character(session).is_some()
        && session.selected_joint().is_none();
    // Who has just clicked beside a bone does not mean the whole figure.
    let why = match command {
        Command::Delete => {
            Some("No joint is selected to be put back. The Select tool (V) deletes the character")
        }
        Command::ResetPosition | Command::ResetRotation | Command::ResetScale => {
            Some("No joint is selected to be put back. The Select tool (V) puts the character back")
        }
        _ => None,
    };
    if let Some(why) = why.filter(|_| poses) {
        return actions.extend(tell_once(why, session));
    }
    if let Some(why) = refused_of_bone(command, session, state) {
        return actions.extend(tell_once(why, session));
    }
    let meant = match of_row {
        true => command,
        false => commands::meant(command, session, state.pose.tool),
    };
    let command = match meant {
        Command::Begin(Tool::Rotate) if command == Command::Begin(Tool::Move) => {
            let why = "Only the root moves: this bone turns, and numbers are degrees";
            actions.extend(tell_once(why, session));
            Command::Begin(Tool::Rotate)
        }
        // In Blender the same key leaves the mode again.
        Command::SetTool(Tool::Pose)
            if pressed.key == egui::Key::Tab && state.pose.tool == Tool::Pose =>
        {
            Command::SetTool(Tool::Select)
        }
        command => command,
    };
    if let Some(why) = commands::why_disabled(command, session, state) {
        let is_of_drag = matches!(command, Command::Begin(_));
        state.refused_at = is_of_drag.then_some(pressed.at);
        return actions.extend(tell_once(why, session));
    }
    let view = session.view();
    if command == Command::ResetCamera && view.look == Look::Mannequin && !state.compares[0] {
        let start = *session.start_camera();
        let told = match commands::second_home(session) {
            None => Some("Home once more leads to where the Virtual Mannequin's page starts"),
            Some(page) if page != start => Some(
                "This is where the Virtual Mannequin's page starts: Home leads back to where the document does, and \
                 Shift+F shows all of it",
            ),
            Some(_) => None,
        };
        actions.extend(told.and_then(|told| tell_once(told, session)));
    }
    let selected = session.selected().and_then(|id| session.scene().shape(id));
    let hides = command == Command::ToggleVisible && selected.is_some_and(|shape| shape.visible);
    let deletes_point = control_points::delete_clicked(session, &state.curves).is_some();
    let deletes_shape = command == Command::Cut || command == Command::Delete && !deletes_point;
    actions.extend(commands::run(command, session, state, aspect));
    if (hides || deletes_shape) && state.navigation == Navigation::Blender {
        // Neither what is not seen nor another shape is to be deleted by the next key.
        actions.push(Action::View(View::Select(None)));
    }
}

/// Why a command that in Blender is about the selected bones does nothing to the one that is selected, or to the character
/// without one; `None` where it is about something else.
pub(super) fn refused_of_bone(
    command: Command,
    session: &Session,
    state: &UiState,
) -> Option<&'static str> {
    let of_bones = state.navigation == Navigation::Blender
        && matches!(state.pose.tool, Tool::Pose | Tool::Ik)
        && state.shape_row_keys != Some(state.pose.tool);
    let selected = session.selected().filter(|_| of_bones)?;
    session.scene().character(selected)?;
    match (command, session.selected_joint()) {
        (Command::ToggleVisible, Some(_)) => {
            Some("A bone cannot be hidden: with the Select tool (V), H hides the character")
        }
        (Command::ToggleVisible, None) => {
            Some("No bone is selected: with the Select tool (V), H hides the character")
        }
        (Command::Duplicate, Some(_)) => {
            Some("A bone cannot be copied: with the Select tool (V), Shift+D copies the character")
        }
        (Command::Duplicate, None) => {
            Some("No bone is selected: with the Select tool (V), Shift+D copies the character")
        }
        _ => None,
    }
}

/// Tells why a key does nothing, unless that is what was told last and still stands there.
fn tell_once(why: &'static str, session: &Session) -> Option<Action> {
    let last = session.messages.fresh().last();
    let stands = last.is_some_and(|message| message.text == why);
    (!stands).then_some(Action::View(View::Tell(why.into())))
}
