//! Help ▸ Find Command: every command by its name, with its key, and every built-in character and curve.

use super::commands::{
    COMMANDS, Command, Entry, full_label, full_tooltip, in_words, key_now, run, why_disabled,
};
use super::elsewhere::elsewhere;
use super::key_commands::{is_there, refused_of_bone};
use super::state::UiState;
use super::widgets::{named, tip_beside};
use super::{Action, Ask, ViewInput};
use crate::editor::{Session, View};
use crate::scene::name_of_import;
use egui::{
    Align2, Button, Frame, Id, Key, Modal, Modifiers, RichText, ScrollArea, TextEdit, Ui, Vec2,
    vec2,
};

/// Words that are searched for, and the row that Enter runs.
#[derive(Clone, Debug, Default)]
pub(super) struct CommandSearch {
    text: String,
    row: usize,
}

/// Tooltip of a built-in file.
pub(super) const BUILTIN_TIP: &str =
    "Add it at the origin, or beside the characters that are there";

/// Width and greatest height of the list, in points.
const WIDTH: f32 = 420.0;
const TALLEST: f32 = 320.0;

/// Width and height in points that the window leaves to the list.
fn room(ui: &Ui) -> Vec2 {
    ui.ctx().content_rect().size() - vec2(48.0, 120.0)
}

/// Shows the search while it is open: arrows choose a row, Enter or a click runs it, Esc closes.
pub(super) fn show(
    root: &Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    aspect: f32,
    actions: &mut Vec<Action>,
) {
    let Some(mut search) = state.search.take() else {
        return;
    };
    let frame = Frame::popup(root.style()).inner_margin(12);
    let area = Modal::default_area(Id::new("find command"));
    let area = area.anchor(Align2::CENTER_TOP, vec2(0.0, 48.0));
    let modal = Modal::new(Id::new("find command")).area(area).frame(frame);
    let shown = modal.show(root.ctx(), |ui| {
        ui.set_width(WIDTH.min(room(ui).x));
        contents(ui, session, state, input, &mut search)
    });
    match shown.inner {
        Some(Row::Command(entry)) => match refused_of_bone(entry.command, session, state) {
            Some(why) => actions.push(Action::View(View::Tell(why.into()))),
            None => actions.extend(run(entry.command, session, state, aspect)),
        },
        Some(Row::Builtin { name, .. }) => actions.push(Action::Ask(Ask::InsertBuiltin(name))),
        None if shown.should_close() => {}
        None => state.search = Some(search),
    }
}

/// What is found.
#[derive(Clone, Copy, Debug)]
enum Row {
    Command(&'static Entry),
    /// A built-in file that can be inserted.
    Builtin {
        name: &'static str,
        /// Submenu of *Insert* that has it.
        menu: &'static str,
    },
}

impl Row {
    fn why_disabled(self, session: &Session, state: &UiState) -> Option<&'static str> {
        match self {
            Self::Command(entry) => why_disabled(entry.command, session, state),
            Self::Builtin { .. } => None,
        }
    }

    fn label(self, session: &Session, state: &UiState) -> String {
        match self {
            Self::Command(entry) => name(entry, session, state),
            Self::Builtin { name, menu } => format!("{menu}: {}", name_of_import(name)),
        }
    }
}

/// The field and the list; what is to be run or inserted.
fn contents(
    ui: &mut Ui,
    session: &Session,
    state: &UiState,
    input: &ViewInput,
    search: &mut CommandSearch,
) -> Option<Row> {
    let (up, down, enter) = ui.input_mut(|i| {
        let mut pressed = |key| i.consume_key(Modifiers::NONE, key);
        (
            pressed(Key::ArrowUp),
            pressed(Key::ArrowDown),
            pressed(Key::Enter),
        )
    });
    let hint = "What do you want to do?";
    let field = TextEdit::singleline(&mut search.text).hint_text(hint);
    let field = named(ui.add(field.desired_width(f32::INFINITY)), "Find a command");
    field.request_focus();
    if field.changed() {
        search.row = 0;
    }
    let found = rows(&search.text, session, state, input);
    let nothing = found.is_empty().then_some("No command has these words.");
    if let Some(told) = elsewhere(&search.text).or(nothing) {
        ui.label(RichText::new(told).weak());
    }
    if found.is_empty() {
        return None;
    }
    let last = found.len() - 1;
    search.row = match (up, down) {
        (true, _) => search.row.saturating_sub(1),
        (_, true) => (search.row + 1).min(last),
        _ => search.row.min(last),
    };
    let why_not = found[search.row].why_disabled(session, state);
    let mut chosen = (enter && why_not.is_none()).then_some(found[search.row]);
    let tallest = TALLEST.min(room(ui).y);
    // What is left is only as high as the list was in the last frame, with fewer rows perhaps.
    let list = ScrollArea::vertical().max_height(tallest);
    list.min_scrolled_height(tallest).show(ui, |ui| {
        for (number, &row) in found.iter().enumerate() {
            let why = row.why_disabled(session, state);
            let name = row.label(session, state);
            let (navigation, tool) = (state.navigation, state.pose.tool);
            let (key, tip) = match row {
                Row::Command(entry) => (
                    key_now(ui.ctx(), navigation, (entry, entry.command), session, tool),
                    full_tooltip(entry, session, state),
                ),
                Row::Builtin { .. } => (String::new(), BUILTIN_TIP),
            };
            let button = Button::selectable(number == search.row, &name)
                .shortcut_text(key)
                .min_size(vec2(ui.available_width(), 0.0));
            let item = named(ui.add_enabled(why.is_none(), button), &name);
            tip_beside(&item, tip, why);
            if number == search.row && (up || down) {
                item.scroll_to_me(None);
            }
            if item.clicked() {
                chosen = Some(row);
            }
        }
    });
    if let Some(why) = why_not {
        ui.label(RichText::new(format!("{why}.")).weak());
    }
    chosen
}

/// What fits the words: built-in files whose names begin so, then commands, and then other built-in files.
fn rows(words: &str, session: &Session, state: &UiState, input: &ViewInput) -> Vec<Row> {
    let mut found = found(words);
    found.retain(|(_, entry)| is_there(entry.command, input));
    let row = |(_, entry)| Row::Command(entry);
    if words.trim().is_empty() {
        return found.into_iter().map(row).collect();
    }
    // What can be done now comes first among those that fit as well.
    let is_disabled = |entry: &Entry| why_disabled(entry.command, session, state).is_some();
    found.sort_by_key(|&(fit, entry)| (fit, is_disabled(entry)));
    let kinds = [
        (input.builtin_characters, "Built-in Character"),
        (input.builtin_curves, "Built-in Curve"),
    ];
    let all = kinds.into_iter().flat_map(|(names, menu)| {
        let names = names.iter();
        names.map(move |&name| Row::Builtin { name, menu })
    });
    let fits = |row: &Row| has_all(&row.label(session, state), words);
    let beginning = plain(words.trim());
    // One or two letters begin too much.
    let is_named = |row: &Row| match row {
        Row::Builtin { name, .. } => {
            beginning.chars().count() > 2 && plain(name).starts_with(&beginning)
        }
        Row::Command(_) => false,
    };
    let (named, others): (Vec<Row>, Vec<Row>) = all.filter(fits).partition(is_named);
    let commands = found.into_iter().map(row);
    named.into_iter().chain(commands).chain(others).collect()
}

/// A command as the list names it: with its menu where that says what it is, and with what it is about.
fn name(entry: &Entry, session: &Session, state: &UiState) -> String {
    let words = in_words(entry);
    if words == entry.label {
        full_label(entry.command, session, state)
    } else {
        words
    }
}

/// How well a command fits what is searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    /// Its label has all the words.
    Label,
    /// Its label has them together with the words by which other programs know it.
    Also,
    /// Its tooltip is needed for them, too.
    Tooltip,
}

/// Commands whose label, other names and tooltip have all the words, in any order; those whose label has
/// them come first, then those whose other names have them.
fn found(words: &str) -> Vec<(Fit, &'static Entry)> {
    let all_in = |text: &str| has_all(text, words);
    let fit = |entry: &Entry| {
        let label = in_words(entry);
        let named = format!("{label} {}", entry.also);
        if all_in(&label) {
            return Some(Fit::Label);
        }
        if all_in(&named) {
            return Some(Fit::Also);
        }
        // Its tooltip tells of all that Esc ends before.
        let is_told = entry.command != Command::Quit;
        (is_told && all_in(&format!("{named} {}", entry.tooltip))).then_some(Fit::Tooltip)
    };
    let fitting = COMMANDS
        .iter()
        .filter_map(|entry| Some((fit(entry)?, entry)));
    let mut found: Vec<(Fit, &Entry)> = fitting.collect();
    found.sort_by_key(|(fit, _)| *fit);
    found
}

/// Whether a text has all the words, in any order.
fn has_all(text: &str, words: &str) -> bool {
    let (text, words) = (plain(text), plain(words));
    words.split_whitespace().all(|word| text.contains(word))
}

/// In small letters and without accents, which not every keyboard has: Bézier's is the only one.
fn plain(text: &str) -> String {
    text.to_lowercase().replace('é', "e")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_found_by_words_of_its_label_or_its_tooltip_in_any_order() {
        let found = |words: &str| -> Vec<&str> {
            let entries = found(words).into_iter();
            entries.map(|(_, entry)| entry.label).collect()
        };
        let mirroring = [
            "Mirror Pose",
            "Paste Pose Mirrored",
            "Mirror onto Other Side",
        ];
        assert_eq!(found("pose mirror"), mirroring);
        assert_eq!(found("ICOSA"), ["Icosahedron"]);
        assert_eq!(found("utah"), ["Teapot"]);
        assert_eq!(found("bezier")[0], "Bézier Curve");
        assert_eq!(found("BÉZIER"), found("bezier"));
        assert_eq!(found("pose")[0], "Reset View and Pose", "labels come first");
        assert!(found("pose").contains(&"Copy"), "tooltips after them");
        assert_eq!(found("").len(), COMMANDS.len());
        assert!(found("no such thing").is_empty());
    }

    #[test]
    fn words_of_other_programs_lead_to_the_command() {
        for (searched, label) in [
            ("submit", "Screenshot…"),
            ("hand in", "Screenshot…"),
            ("render", "Screenshot…"),
            ("wireframe", "Flat"),
            ("weights", "Weight of the Selected Joint"),
            ("heat map", "Weight of the Selected Joint"),
            ("sliders", "Shape Panel"),
            ("sidebar", "Shape Panel"),
            ("settings", "Preferences…"),
            ("zero pose", "Reset Pose"),
            ("flip", "Mirror Pose"),
            ("normals", "Flat"),
            ("floor", "Ground Grid"),
            ("axes", "Toggle Axis"),
            ("unhide", "Show All"),
            ("translate", "Move Tool"),
            ("lathe", "Surface of Revolution from Curve"),
            ("tube", "Sweep from Curves"),
            ("zoom", "Fit to View"),
            ("front view", "View from +Z (Front)"),
            ("shortcuts", "Keys and Mouse"),
            ("export mesh", "Export Geometry…"),
            ("inverse kinematics", "IK Tool"),
        ] {
            let found = found(searched);
            let is_there = |(_, entry): &(Fit, &Entry)| entry.label == label;
            assert!(found.iter().any(is_there), "{searched} leads to {found:?}");
        }
        for searched in ["screenshot", "mirror", "grid", "export", "pose", "reset"] {
            assert_eq!(found(searched)[0].0, Fit::Label, "{searched}");
        }
    }

    #[test]
    fn every_other_name_leads_to_its_command_before_what_only_mentions_it() {
        for entry in COMMANDS {
            assert_eq!(entry.also, plain(entry.also), "words are compared as these");
            for word in entry.also.split_whitespace() {
                let fit = found(word)
                    .into_iter()
                    .find(|(_, of)| of.label == entry.label);
                let (fit, _) = fit.unwrap_or_else(|| panic!("{word}"));
                assert_eq!(fit, Fit::Also, "{} has {word} in its label", entry.label);
            }
        }
    }
}
