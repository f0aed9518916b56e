//! The commands, the keys that start them, and the gestures beside them.

mod command;
mod gestures;
mod menu;
mod table;

pub use command::{Command, Primitive};
pub use gestures::{GESTURES, Gesture};
pub use menu::Menu;
pub use table::{COMMANDS, Entry};

pub(super) use gestures::gesture;

use super::Navigation;
use egui::{Context, Event, Key, KeyboardShortcut, Modifiers};
use table::CTRL;

/// The table's entries for one menu, in order.
pub(super) fn entries(menu: Menu) -> impl Iterator<Item = &'static Entry> {
    COMMANDS.iter().filter(move |entry| entry.menu == menu)
}

impl Entry {
    /// The keys that start it in a way of navigation, whose own come before the others'.
    fn shortcuts_in(
        &self,
        navigation: Navigation,
    ) -> impl Iterator<Item = &'static KeyboardShortcut> {
        let means_another = move |shortcut: &&KeyboardShortcut| match self.only_in {
            Some(only) => only != navigation,
            None => COMMANDS.iter().any(|other| {
                other.only_in == Some(navigation) && other.shortcuts.contains(shortcut)
            }),
        };
        self.shortcuts
            .iter()
            .filter(move |shortcut| !means_another(shortcut))
    }

    /// All those keys, as the window about the keys shows them; empty where there are none.
    pub(super) fn keys(&self, ctx: &Context, navigation: Navigation) -> String {
        let keys: Vec<String> = self
            .shortcuts_in(navigation)
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .collect();
        keys.join(", ")
    }

    /// The first of them, for a menu.
    pub(super) fn first_key(&self, ctx: &Context, navigation: Navigation) -> String {
        self.shortcuts_in(navigation)
            .next()
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .unwrap_or_default()
    }

    fn with_key(&self, ctx: &Context, words: &str) -> String {
        match self.first_key(ctx, Navigation::default()) {
            key if key.is_empty() => words.to_owned(),
            key => format!("{words} ({key})"),
        }
    }
}

/// `Esc` and `?` are what keyboards have on them.
fn short(shortcut: &str) -> String {
    shortcut
        .replace("Escape", "Esc")
        .replace("Questionmark", "?")
}

fn entry_of(command: Command) -> Option<&'static Entry> {
    COMMANDS.iter().find(|entry| entry.command == command)
}

/// Whether `command` is listed in `menu`.
pub(super) fn is_in(menu: Menu, command: Command) -> bool {
    entry_of(command).is_some_and(|entry| entry.menu == menu)
}

/// What menus call `command`.
pub(super) fn label(command: Command) -> &'static str {
    entry_of(command).map_or("", |entry| entry.label)
}

/// The tooltip of `command`, with its key, one that no way of navigation uses otherwise.
pub(super) fn tooltip(ctx: &Context, command: Command) -> String {
    let entry = entry_of(command);
    entry.map_or(String::new(), |entry| entry.with_key(ctx, entry.tooltip))
}

/// Other words for what `command` does, with its key as in [`tooltip`].
pub(super) fn with_key(ctx: &Context, command: Command, words: &str) -> String {
    let entry = entry_of(command);
    entry.map_or(String::new(), |entry| entry.with_key(ctx, words))
}

/// Takes the pressed keys of the table out of this frame's input and returns what they start.
pub(super) fn pressed(ctx: &Context, navigation: Navigation) -> Vec<Command> {
    ctx.input_mut(|input| {
        let mut commands = Vec::new();
        let held = input.pointer.any_down();
        input.events.retain(|event| {
            let (modifiers, key) = match event {
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } => (*modifiers, *key),
                // These two keys arrive as what they mean.
                Event::Copy => (CTRL, Key::C),
                Event::Paste(_) => (CTRL, Key::V),
                _ => return true,
            };
            let hit = command_of(modifiers, key, navigation)
                // Esc with something in the hand is meant for that, and ends nothing else.
                .filter(|&command| !(held && command == Command::Quit));
            commands.extend(hit);
            hit.is_none()
        });
        commands
    })
}

fn command_of(modifiers: Modifiers, key: Key, navigation: Navigation) -> Option<Command> {
    // Where the question mark lies, and with which modifiers, differs between keyboards.
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

#[cfg(test)]
mod tests {
    use super::table::{NONE, SHIFT};
    use super::*;

    #[test]
    fn no_two_commands_share_a_key_or_a_label() {
        for (i, one) in COMMANDS.iter().enumerate() {
            for other in &COMMANDS[i + 1..] {
                assert_ne!(one.label, other.label);
                if one.only_in != other.only_in {
                    continue;
                }
                for shortcut in one.shortcuts {
                    assert!(
                        !other.shortcuts.contains(shortcut),
                        "{} and {}",
                        one.label,
                        other.label
                    );
                }
            }
        }
    }

    #[test]
    fn a_key_means_another_command_with_shift() {
        assert_eq!(
            command_of(NONE, Key::T, Navigation::Course),
            Some(Command::ToggleAxis)
        );
        assert_eq!(
            command_of(SHIFT, Key::T, Navigation::Blender),
            Some(Command::Insert(Primitive::Teapot))
        );
        assert_eq!(
            command_of(Modifiers::CTRL, Key::T, Navigation::Course),
            None
        );
    }

    #[test]
    fn the_question_mark_counts_wherever_a_keyboard_has_it() {
        assert_eq!(
            command_of(SHIFT, Key::Questionmark, Navigation::Orbit),
            Some(Command::Keys)
        );
        assert_eq!(
            command_of(NONE, Key::Questionmark, Navigation::Orbit),
            Some(Command::Keys)
        );
    }

    #[test]
    fn every_command_is_in_a_menu_and_explained() {
        for entry in COMMANDS {
            assert!(Menu::ALL.contains(&entry.menu), "{}", entry.label);
            assert!(!entry.tooltip.is_empty(), "{}", entry.label);
        }
    }

    #[test]
    fn the_fonts_have_every_sign_that_the_panels_show() {
        let ctx = Context::default();
        let output = ctx.run_ui(egui::RawInput::default(), |ui| {
            let mut shown = "⊗⚠ℹ×🔍↺⏵⏷✔·°…⏵".to_owned();
            for gesture in GESTURES {
                shown += gesture.gesture;
                shown += gesture.does;
            }
            for entry in COMMANDS {
                shown += entry.label;
                shown += entry.tooltip;
                shown += &entry.keys(ui.ctx(), Navigation::Course);
            }
            let drawn = |sign: char| {
                let font = egui::FontId::proportional(14.0);
                let painter = ui.painter();
                let galley = painter.layout_no_wrap(sign.into(), font, egui::Color32::WHITE);
                galley.rows[0].glyphs[0].uv_rect
            };
            let unknown = drawn('\u{10fffe}');
            for sign in shown.chars().filter(|sign| !sign.is_whitespace()) {
                assert_ne!(drawn(sign), unknown, "no glyph for {sign}");
            }
        });
        output.drop_without_applying_deltas();
    }
}
