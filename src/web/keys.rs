//! Keys that mean something to the program, and something else to the browser.

use super::browser;
use crate::ui::{COMMANDS, is_kept_by_browsers};
use egui::{Key, Modifiers};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Event, KeyboardEvent};

/// Keys with Ctrl that stay the browser's: it tells of copying and pasting by itself, and reloading is
/// expected of every page.
const OF_THE_BROWSER: [Key; 4] = [Key::C, Key::X, Key::V, Key::R];

/// Keeps the browser from doing what a key means to it where it is the shortcut of a command.
///
/// # Errors
/// If the browser refuses to tell.
pub(super) fn keep_for_commands() -> Result<(), JsValue> {
    let window = browser::window().ok_or("There is no page.")?;
    browser::listen(&window, "keydown", |event: Event| {
        if let Ok(event) = event.dyn_into::<KeyboardEvent>()
            && is_of_a_command(&event)
        {
            event.prevent_default();
        }
    })
}

fn is_of_a_command(event: &KeyboardEvent) -> bool {
    let Some(key) = Key::from_name(&event.key().to_uppercase()) else {
        return false;
    };
    let ctrl = event.ctrl_key() || event.meta_key();
    let is_function_key = event.key().len() > 1 && event.key().starts_with('F');
    // Other keys mean nothing to a browser, or are typed.
    if !(is_function_key || ctrl && !OF_THE_BROWSER.contains(&key)) {
        return false;
    }
    let pressed = Modifiers {
        alt: event.alt_key(),
        shift: event.shift_key(),
        ctrl,
        command: ctrl,
        mac_cmd: false,
    };
    if is_kept_by_browsers(pressed, key) {
        return false;
    }
    let mut shortcuts = COMMANDS.iter().flat_map(|entry| entry.shortcuts);
    shortcuts
        .any(|shortcut| shortcut.logical_key == key && pressed.matches_exact(shortcut.modifiers))
}
