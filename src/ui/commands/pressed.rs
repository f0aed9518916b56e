//! Shortcuts of commands that are pressed.

use super::keys::{is_kept_by_browsers, is_page};
use super::table::{CTRL, SHIFT};
use super::{COMMANDS, Command, Entry};
use crate::ui::Navigation;
use egui::{Context, Event, Key, Modifiers};

/// Commands whose shortcuts were pressed in this frame, with the keys; their events are consumed.
pub(in crate::ui) fn pressed(ctx: &Context, navigation: Navigation) -> Vec<(Command, Key)> {
    let is_page = is_page(ctx);
    ctx.input_mut(|input| {
        let mut commands = Vec::new();
        let held = input.pointer.any_down();
        let Modifiers {
            command,
            shift,
            alt,
            ..
        } = input.modifiers;
        let ctrl = if alt { CTRL.plus(Modifiers::ALT) } else { CTRL };
        input.events.retain(|event| {
            let (modifiers, key) = match event {
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } => (*modifiers, *key),
                // egui reports these shortcuts as what they mean, whatever else is held.
                Event::Copy => (ctrl, Key::C),
                Event::Cut => (ctrl, Key::X),
                Event::Paste(_) if command && shift => (ctrl.plus(SHIFT), Key::V),
                Event::Paste(_) => (ctrl, Key::V),
                _ => return true,
            };
            let hit = command_of(modifiers, key, navigation)
                .filter(|_| !(is_page && is_kept_by_browsers(modifiers, key)))
                // Esc while a button is down cancels that drag, and ends nothing else.
                .filter(|&command| !(held && command == Command::Quit))
                .map(|command| (command, key));
            commands.extend(hit);
            hit.is_none()
        });
        commands
    })
}

/// The command of a shortcut with Ctrl that was pressed in this frame, if any; its event stays.
pub(in crate::ui) fn pressed_with_ctrl(ctx: &Context, navigation: Navigation) -> Option<Command> {
    ctx.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } if modifiers.command => command_of(*modifiers, *key, navigation),
            _ => None,
        })
    })
}

/// The command of a shortcut in a navigation, if it is one.
pub(super) fn command_of(
    modifiers: Modifiers,
    key: Key,
    navigation: Navigation,
) -> Option<Command> {
    // Keyboards differ in the key of the question mark and in its modifiers.
    let modifiers = if key == Key::Questionmark {
        Modifiers::NONE
    } else {
        modifiers
    };
    let has_key = |entry: &&Entry| {
        entry.shortcuts_in(navigation).any(|shortcut| {
            shortcut.logical_key == key && modifiers.matches_exact(shortcut.modifiers)
        })
    };
    let entry = COMMANDS.iter().find(has_key);
    entry.map(|entry| entry.command)
}
