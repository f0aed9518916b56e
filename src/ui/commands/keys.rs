//! Keyboard shortcuts of the commands: which there are, and how they are told.

use super::run::deletes_point;
use super::table::{ALT, CTRL, NONE, SHIFT, entry_of, meant};
use super::{COMMANDS, Command, Entry};
use crate::editor::{Session, Tool};
use crate::ui::blender_keys::NOT_HERE;
use crate::ui::{Navigation, UiState};
use egui::{Context, Id, Key, KeyboardShortcut, Modifiers};

/// Shortcuts that Blender's navigation adds, because its users' hands know them.
const AS_IN_BLENDER: &[(Command, KeyboardShortcut)] = &[
    (Command::SelectAll, KeyboardShortcut::new(NONE, Key::A)),
    (Command::SelectNone, KeyboardShortcut::new(ALT, Key::A)),
    (
        Command::InvertSelection,
        KeyboardShortcut::new(CTRL, Key::I),
    ),
    (Command::Delete, KeyboardShortcut::new(NONE, Key::X)),
    (Command::Duplicate, KeyboardShortcut::new(SHIFT, Key::D)),
    (Command::Rename, KeyboardShortcut::new(NONE, Key::F2)),
    (Command::FindCommand, KeyboardShortcut::new(NONE, Key::F3)),
    (Command::FitAll, KeyboardShortcut::new(NONE, Key::Home)),
    (Command::FitAll, KeyboardShortcut::new(SHIFT, Key::C)),
    (Command::Fit, KeyboardShortcut::new(NONE, Key::Period)),
    (Command::BoxSelect, KeyboardShortcut::new(NONE, Key::B)),
    // In place of B, as Ctrl+Tab is the browser's on a page. Tab alone, Blender's, goes from field to field.
    (
        Command::SetTool(Tool::Pose),
        KeyboardShortcut::new(NONE, Key::J),
    ),
    (
        Command::SetTool(Tool::Pose),
        KeyboardShortcut::new(CTRL, Key::Tab),
    ),
];

/// Shortcuts that are the browser's on a page: those for its windows and tabs, and the one that reloads.
const KEPT_BY_BROWSERS: [KeyboardShortcut; 6] = [
    KeyboardShortcut::new(NONE, Key::F5),
    KeyboardShortcut::new(CTRL, Key::Num1),
    KeyboardShortcut::new(CTRL, Key::Num3),
    KeyboardShortcut::new(CTRL, Key::Num7),
    KeyboardShortcut::new(CTRL, Key::N),
    KeyboardShortcut::new(CTRL, Key::Tab),
];

/// Whether a shortcut is the browser's on a page, where commands leave it alone.
pub fn is_kept_by_browsers(modifiers: Modifiers, key: Key) -> bool {
    KEPT_BY_BROWSERS
        .iter()
        .any(|kept| kept.logical_key == key && modifiers.matches_exact(kept.modifiers))
}

/// Whether a shortcut means something in Blender that is not here.
fn is_not_here(shortcut: &KeyboardShortcut) -> bool {
    NOT_HERE.iter().any(|(key, _)| key == shortcut)
}

impl Entry {
    /// Shortcuts in a navigation, whose own come first and take precedence over the general ones.
    pub(super) fn shortcuts_in(
        &self,
        navigation: Navigation,
    ) -> impl Iterator<Item = &'static KeyboardShortcut> {
        let walks = move |shortcut: &&KeyboardShortcut| {
            shortcut.modifiers.is_none() && navigation.walks_by(shortcut.logical_key)
        };
        let is_overridden = move |shortcut: &&KeyboardShortcut| match self.only_in {
            Some(only) => only != navigation,
            None if navigation == Navigation::Blender && is_not_here(shortcut) => true,
            None => {
                let others = COMMANDS.iter();
                let mut others = others.filter(|other| other.only_in == Some(navigation));
                others.any(|other| other.shortcuts.contains(shortcut))
                    || added(navigation).any(|(_, own)| own == *shortcut)
            }
        };
        let added = added(navigation).filter(|(command, _)| *command == self.command);
        let general = self
            .shortcuts
            .iter()
            .filter(move |shortcut| !is_overridden(shortcut) && !walks(shortcut));
        added.map(|(_, shortcut)| shortcut).chain(general)
    }

    /// The shortcuts of [`Entry::shortcuts_in`] that are told. Where Esc never quits, it is no key
    /// for that, and on a page those that browsers never give away are none.
    fn told_in(
        &self,
        ctx: &Context,
        navigation: Navigation,
    ) -> impl Iterator<Item = &'static KeyboardShortcut> {
        let quits = self.command == Command::Quit && !navigation.quits_by_esc();
        let is_page = is_page(ctx);
        let is_told = move |shortcut: &&KeyboardShortcut| {
            let is_no_quit = quits && shortcut.logical_key == Key::Escape;
            let is_kept = is_page && KEPT_BY_BROWSERS.contains(shortcut);
            !is_no_quit && !is_kept
        };
        self.shortcuts_in(navigation).filter(is_told)
    }

    /// All its shortcuts as text, such as `?, F1`; empty if it has none.
    pub(in crate::ui) fn keys(&self, ctx: &Context, navigation: Navigation) -> String {
        let keys: Vec<String> = self
            .told_in(ctx, navigation)
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .collect();
        keys.join(", ")
    }

    /// The first shortcut as text; empty if it has none.
    fn first_key(&self, ctx: &Context, navigation: Navigation) -> String {
        self.told_in(ctx, navigation)
            .next()
            .map(|shortcut| short(&ctx.format_shortcut(shortcut)))
            .unwrap_or_default()
    }

    fn with_key(&self, ctx: &Context, words: &str) -> String {
        let navigation = ctx.data(|data| data.get_temp(Id::NULL));
        match self.first_key(ctx, navigation.unwrap_or_default()) {
            key if key.is_empty() => words.to_owned(),
            key => format!("{words} ({key})"),
        }
    }
}

/// The key in the row `row` of a menu that does `command` at the moment, as text: the first of the row itself
/// unless that means something else now, or that of another command which now means this one; empty if there is
/// none.
pub(in crate::ui) fn key_now(
    ctx: &Context,
    navigation: Navigation,
    (row, command): (&Entry, Command),
    session: &Session,
    tool: Tool,
) -> String {
    // From the last, so that Alt+R comes before Delete, both of which may put a joint back to rest.
    let rows = std::iter::once(row).chain(COMMANDS.iter().rev());
    let meaning_it = rows.filter(|row| meant(row.command, session, tool) == command);
    let mut keys = meaning_it.map(|row| row.first_key(ctx, navigation));
    keys.find(|key| !key.is_empty()).unwrap_or_default()
}

/// Shortcuts that `navigation` adds, with their commands.
fn added(navigation: Navigation) -> impl Iterator<Item = (Command, &'static KeyboardShortcut)> {
    let all = AS_IN_BLENDER.iter();
    all.filter(move |_| navigation == Navigation::Blender)
        .map(|(command, shortcut)| (*command, shortcut))
}

/// Key names as keyboards have them: `Esc`, `?`, `,`, `.`.
fn short(shortcut: &str) -> String {
    shortcut
        .replace("Escape", "Esc")
        .replace("Questionmark", "?")
        .replace("Comma", ",")
        .replace("Period", ".")
}

/// Remembers the navigation, whose shortcuts tooltips show, and whether this is a page, on which browsers keep some.
pub(in crate::ui) fn remember_for_keys(ctx: &Context, navigation: Navigation, is_page: bool) {
    ctx.data_mut(|data| {
        data.insert_temp(Id::NULL, navigation);
        data.insert_temp(on_page(), is_page);
    });
}

/// Whether this is a page of a browser.
pub(in crate::ui) fn is_page(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(on_page()).unwrap_or_default())
}

fn on_page() -> Id {
    Id::new("shortcuts of a page")
}

/// Tooltip of `command`, with its shortcut.
pub(in crate::ui) fn tooltip(ctx: &Context, command: Command) -> String {
    let entry = entry_of(command);
    entry.map_or(String::new(), |entry| entry.with_key(ctx, entry.tooltip))
}

/// Tooltip of `command`, with its shortcut unless that does something else at the moment.
pub(in crate::ui) fn tooltip_now(
    ctx: &Context,
    command: Command,
    session: &Session,
    state: &UiState,
) -> String {
    let is_of_point = command == Command::Delete && deletes_point(session, state);
    if meant(command, session, state.pose.tool) == command && !is_of_point {
        return tooltip(ctx, command);
    }
    entry_of(command).map_or_else(String::new, |entry| entry.tooltip.to_owned())
}

/// `words`, followed by the shortcut of `command` as in [`tooltip`].
pub(in crate::ui) fn with_key(ctx: &Context, command: Command, words: &str) -> String {
    let entry = entry_of(command);
    entry.map_or(String::new(), |entry| entry.with_key(ctx, words))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::commands::pressed::command_of;
    use crate::ui::commands::{GESTURES, Menu, Primitive, in_words};
    use egui::Modifiers;

    #[test]
    fn no_two_commands_share_a_key_or_a_label() {
        for (i, one) in COMMANDS.iter().enumerate() {
            for other in &COMMANDS[i + 1..] {
                assert_ne!(in_words(one), in_words(other));
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
    fn a_key_is_overridden_command_with_shift() {
        assert_eq!(
            command_of(NONE, Key::T, Navigation::Course),
            Some(Command::ToggleAxis)
        );
        assert_eq!(
            command_of(SHIFT, Key::T, Navigation::Course),
            Some(Command::Insert(Primitive::Teapot))
        );
        assert_eq!(
            command_of(Modifiers::CTRL, Key::T, Navigation::Course),
            None
        );
    }

    #[test]
    fn keys_that_walk_choose_no_tool_and_those_of_blender_begin_at_once() {
        let command = |key, navigation| command_of(NONE, key, navigation);
        let moves = Some(Command::SetTool(Tool::Move));
        assert_eq!(command(Key::W, Navigation::Orbit), moves);
        assert_eq!(command(Key::W, Navigation::Mannequin), None);
        assert_eq!(command(Key::G, Navigation::Mannequin), moves);
        let begins = Some(Command::Begin(Tool::Move));
        assert_eq!(command(Key::G, Navigation::Blender), begins);
        for navigation in Navigation::ALL {
            assert_eq!(command(Key::Q, navigation), Some(Command::BoxSelect));
        }
    }

    #[test]
    fn hands_from_blender_find_their_keys_and_esc_never_quits() {
        let command = |modifiers, key| command_of(modifiers, key, Navigation::Blender);
        assert_eq!(command(NONE, Key::A), Some(Command::SelectAll));
        assert_eq!(command(NONE, Key::X), Some(Command::Delete));
        assert_eq!(command(SHIFT, Key::D), Some(Command::Duplicate));
        assert_eq!(command(ALT, Key::A), Some(Command::SelectNone));
        assert_eq!(command(NONE, Key::Home), Some(Command::FitAll));
        assert_eq!(command(NONE, Key::Period), Some(Command::Fit));
        assert_eq!(command(NONE, Key::F3), Some(Command::FindCommand));
        assert_eq!(command(NONE, Key::B), Some(Command::BoxSelect));
        assert_eq!(command(SHIFT, Key::R), None, "nothing is repeated");
        let reset = command_of(SHIFT, Key::R, Navigation::Orbit);
        assert_eq!(reset, Some(Command::Reset));
        assert_eq!(command(SHIFT, Key::C), Some(Command::FitAll));
        assert_eq!(command(SHIFT, Key::S), None, "nothing snaps");
        let inserted = command_of(SHIFT, Key::S, Navigation::Orbit);
        assert_eq!(inserted, Some(Command::Insert(Primitive::Sphere)));
        let poses = Some(Command::SetTool(Tool::Pose));
        assert_eq!(command(CTRL, Key::Tab), poses);
        assert_eq!(command(NONE, Key::J), poses);
        assert_eq!(command_of(NONE, Key::B, Navigation::Orbit), poses);
        assert_eq!(command_of(NONE, Key::J, Navigation::Orbit), None);
        assert_eq!(command_of(NONE, Key::X, Navigation::Course), None);
        let quit = entry_of(Command::Quit).unwrap();
        let keys = |navigation| quit.keys(&Context::default(), navigation);
        assert!(keys(Navigation::Course).contains("Esc"));
        assert!(!keys(Navigation::Blender).contains("Esc"));
    }

    #[test]
    fn a_tooltip_names_the_key_of_the_navigation_that_is_chosen() {
        let ctx = Context::default();
        for (navigation, key) in [(Navigation::Course, "(G)"), (Navigation::Blender, "(W)")] {
            remember_for_keys(&ctx, navigation, false);
            let tooltip = tooltip(&ctx, Command::SetTool(Tool::Move));
            assert!(tooltip.ends_with(key), "{tooltip}");
        }
    }

    #[test]
    fn the_key_that_a_menu_shows_is_the_one_of_the_navigation_and_that_of_quit_always_works() {
        let ctx = Context::default();
        for (command, course, blender) in [
            (Command::Duplicate, "Ctrl+D", "Shift+D"),
            (Command::Delete, "Delete", "X"),
            (Command::FindCommand, "Ctrl+Shift+P", "F3"),
            (Command::Fit, "F", "."),
            (Command::Quit, "Ctrl+Q", "Ctrl+Q"),
        ] {
            let entry = entry_of(command).unwrap();
            assert_eq!(entry.first_key(&ctx, Navigation::Course), course);
            assert_eq!(entry.first_key(&ctx, Navigation::Blender), blender);
        }
    }

    #[test]
    fn on_a_page_no_key_is_told_that_browsers_keep() {
        let ctx = Context::default();
        let key = |command, navigation| entry_of(command).unwrap().keys(&ctx, navigation);
        let pose = Command::SetTool(Tool::Pose);
        assert_eq!(key(Command::New, Navigation::Orbit), "Ctrl+N");
        assert_eq!(key(pose, Navigation::Blender), "J, Ctrl+Tab");
        remember_for_keys(&ctx, Navigation::Orbit, true);
        assert_eq!(key(Command::New, Navigation::Orbit), "");
        assert_eq!(key(pose, Navigation::Blender), "J");
        assert_eq!(key(Command::Open, Navigation::Orbit), "Ctrl+O");
    }

    #[test]
    fn keys_are_told_by_the_signs_on_them() {
        let ctx = Context::default();
        let key = |command| {
            entry_of(command)
                .unwrap()
                .first_key(&ctx, Navigation::Course)
        };
        assert_eq!(key(Command::Preferences), "Ctrl+,");
        assert_eq!(key(Command::Keys), "?");
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
            let mut shown = "⊗⚠ℹ×🔍↺⏴⏵⏷✔·°…".to_owned();
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
