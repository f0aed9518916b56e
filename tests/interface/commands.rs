//! Commands by their names: the search for them, and entries that say what their key does.

use crate::interface::Editor;
use crate::interface::curves::{place, with_curve};
use editor_core::editor::{Edit, View};
use editor_core::ui::COMMANDS;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::NodeT;
use glam::Vec3;

const NECK: usize = 3;

impl Editor {
    fn find_command(&mut self, words: &str) {
        self.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
        self.harness.event(Event::Text(words.to_owned()));
        self.settle();
    }

    /// How many names of commands are on the screen.
    fn commands_shown(&self) -> usize {
        let is_one = |text: &String| COMMANDS.iter().any(|entry| entry.label == text);
        let painted = self.painted().into_iter();
        painted.filter(|(text, _)| is_one(text)).count()
    }

    /// What stands in the list of keys beside a key.
    fn effect_of_key(&self, key: &str) -> String {
        let widgets = self.widgets();
        let nodes = widgets.iter().map(|widget| widget.accesskit_node());
        let labels = nodes.filter(|node| node.role() == Role::Label);
        let mut texts = labels.filter_map(|node| node.value());
        texts.find(|text| text == key).expect("the key is listed");
        texts.next().expect("it has an effect")
    }
}

#[test]
fn the_search_for_a_command_has_room_again_after_one_with_a_single_result() {
    let mut editor = Editor::new();
    let before = editor.commands_shown();
    editor.find_command("");
    editor.settle();
    let all = editor.commands_shown();
    assert!(all > before + 8, "{all}");
    editor.key(Key::Escape);
    editor.find_command("utah");
    assert_eq!(editor.commands_shown(), before + 1);
    editor.key(Key::Escape);
    editor.find_command("");
    assert_eq!(editor.commands_shown(), all, "when it is opened again");
    editor.harness.event(Event::Text("utah".to_owned()));
    editor.settle();
    for _ in 0.."utah".len() {
        editor.key(Key::Backspace);
    }
    assert_eq!(editor.commands_shown(), all, "when the words are gone");
}

#[test]
fn delete_is_named_for_what_its_key_does_with_a_joint_at_hand() {
    let mut editor = Editor::sized(egui::vec2(900.0, 1400.0));
    editor.add_character(super::figure::figure());
    let turn = |editor: &mut Editor| {
        editor.type_into("Neck X", "10");
        editor.view(View::SelectJoint(Some(NECK)));
    };
    turn(&mut editor);
    editor.click("Edit");
    assert!(editor.has("Duplicate") && !editor.has("Reset Joint"));
    editor.key(Key::Escape);
    editor.click("Pose Tool");
    editor.choose(&["Edit", "Reset Joint"]);
    assert_eq!(editor.joint(NECK), Vec3::ZERO, "as the key does");
    turn(&mut editor);
    editor.key(Key::Delete);
    assert_eq!(editor.joint(NECK), Vec3::ZERO);
    editor.view(View::SelectJoint(None));
    editor.click("Edit");
    assert!(!editor.has("Reset Joint"));
}

#[test]
fn the_list_of_keys_says_what_delete_does_now() {
    let mut editor = Editor::sized(egui::vec2(900.0, 1400.0));
    editor.add_character(super::figure::figure());
    editor.click("Pose Tool");
    editor.key(Key::F1);
    assert_eq!(editor.effect_of_key("Delete"), "Delete");
    editor.view(View::SelectJoint(Some(NECK)));
    assert_eq!(editor.effect_of_key("Delete"), "Reset Joint");
}

#[test]
fn the_button_that_deletes_names_its_key_only_while_the_key_does_the_same() {
    let mut editor = Editor::with_figure();
    editor.click("Pose Tool");
    for (joint, tip) in [
        (None, "Delete the selected shape (Delete)"),
        (Some(NECK), "Delete the selected shape"),
    ] {
        editor.view(View::SelectJoint(joint));
        editor.harness.run_steps(40);
        editor.reveal("Delete");
        editor.harness.run_steps(40);
        editor.widget("Delete").hover();
        editor.harness.run_steps(20);
        let painted = editor.painted();
        let is_told = painted.iter().any(|(text, _)| text == tip);
        assert!(is_told, "no “{tip}”: {painted:?}");
    }
}

#[test]
fn nor_does_it_while_the_key_deletes_a_control_point() {
    let mut editor = with_curve("Bézier Curve");
    let at = place(&editor, 3);
    editor.press(at);
    editor.release(at);
    editor.widget("Delete").hover();
    editor.harness.run_steps(40);
    let painted = editor.painted();
    let is_told = |tip: &str| painted.iter().any(|(text, _)| text == tip);
    assert!(is_told("Delete the selected shape") && !is_told("Delete the selected shape (Delete)"));
}

#[test]
fn what_a_row_is_called_at_the_moment_finds_it() {
    let mut editor = with_curve("Bézier Curve");
    let at = place(&editor, 0);
    editor.press(at);
    editor.release(at);
    editor.find_command("delete point");
    assert!(editor.has("Delete Point"));
}

#[test]
fn a_command_that_is_searched_for_does_what_it_is_called_whatever_its_key_does_now() {
    let mut editor = Editor::with_figure();
    editor.click("Pose Tool");
    editor.view(View::SelectJoint(Some(NECK)));
    editor.find_command("delete");
    editor.key(Key::Enter);
    assert!(editor.session().scene().shapes().is_empty());
}

#[test]
fn who_searches_for_what_is_no_command_is_told_where_it_is() {
    let mut editor = Editor::new();
    editor.find_command("submit");
    let painted = editor.painted();
    let is_told = |(text, _): &(String, _)| text.contains("editor submit --help");
    assert!(painted.iter().any(is_told), "{painted:?}");
    editor.key(Key::Enter);
    assert!(
        editor.has("Transparent"),
        "the picture for it is a command: {:?}",
        editor.painted()
    );
}

#[test]
fn delete_in_the_menu_is_about_the_point_that_its_key_would_delete() {
    let mut editor = with_curve("B-Spline Curve");
    let id = editor.shape().id;
    editor.edit(Edit::AddControlPoint {
        shape: id,
        curve: 0,
        after: 1,
    });
    let points = |editor: &Editor| {
        let curve = editor.session().scene().curve(id).unwrap();
        curve.curves().curve(0).unwrap().control_points().len()
    };
    let click_point = |editor: &mut Editor| {
        let at = place(editor, 2);
        editor.press(at);
        editor.release(at);
    };
    click_point(&mut editor);
    editor.choose(&["Edit", "Delete Point"]);
    assert_eq!(points(&editor), 4);
    click_point(&mut editor);
    editor.choose(&["Edit", "Delete Point"]);
    assert_eq!(points(&editor), 4, "as few as a B-spline needs");
    editor.key(Key::Delete);
    assert_eq!(points(&editor), 4);
    let told = editor.session().messages.fresh().last();
    assert!(told.is_some_and(|told| told.text.starts_with("This point stays")));
    editor.click("[1] B-Spline Curve (ID: 1)");
    editor.click("Edit");
    assert!(!editor.has("Delete Point"));
    editor.key(Key::Escape);
    editor.key(Key::Delete);
    assert!(editor.session().scene().shapes().is_empty());
}
