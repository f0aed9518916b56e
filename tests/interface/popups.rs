//! Menus and choices that are open: what a press outside of them does, and keys in them.

use crate::interface::Editor;
use editor_core::scene::{Camera, ShapeColor};
use egui::{Key, Modifiers, Pos2, pos2};

/// A place in the view that no menu covers.
const IN_VIEW: Pos2 = pos2(480.0, 520.0);

impl Editor {
    fn press_and_release_at(&mut self, at: Pos2) {
        self.harness.hover_at(at);
        self.harness.drag_at(at);
        self.harness.drop_at(at);
        self.settle();
    }
}

#[test]
fn the_click_in_the_view_that_closes_a_menu_selects_and_deselects_nothing() {
    let mut editor = Editor::with_figure();
    editor.harness.state_mut().gestures = true;
    let selected = editor.session().selected();
    assert!(selected.is_some());
    editor.click("File");
    editor.press_and_release_at(IN_VIEW);
    assert!(!editor.has("Save As…"), "the menu is closed");
    assert_eq!(editor.session().selected(), selected);
    editor.press_and_release_at(IN_VIEW);
    assert_eq!(
        editor.session().selected(),
        None,
        "the next click counts again"
    );
}

#[test]
fn a_drag_that_begins_outside_of_a_menu_closes_it_and_leaves_the_camera_alone() {
    let mut editor = Editor::new();
    editor.harness.state_mut().gestures = true;
    let drag = |editor: &mut Editor| {
        editor.harness.hover_at(IN_VIEW);
        editor.harness.drag_at(IN_VIEW);
        editor.harness.hover_at(IN_VIEW + egui::vec2(40.0, 30.0));
        editor.settle();
        editor.harness.drop_at(IN_VIEW + egui::vec2(40.0, 30.0));
        editor.settle();
    };
    editor.choose(&["View", "Look"]);
    drag(&mut editor);
    assert!(!editor.has("Fit to View"), "the menu is closed");
    assert_eq!(editor.session().view().camera, Camera::default());
    drag(&mut editor);
    assert_ne!(editor.session().view().camera, Camera::default());
}

#[test]
fn the_click_on_a_panel_that_closes_a_menu_presses_nothing_there() {
    let mut editor = Editor::with_figure();
    let hide = editor.widget("Hide Model1").rect().center();
    editor.click("Help");
    editor.press_and_release_at(hide);
    assert!(!editor.has("About"), "the menu is closed");
    assert!(editor.shape().visible);
    editor.press_and_release_at(hide);
    assert!(!editor.shape().visible);
}

#[test]
fn the_choice_of_a_color_is_closed_by_a_click_that_does_nothing_else() {
    let mut editor = Editor::with_figure();
    editor.harness.state_mut().gestures = true;
    let selected = editor.session().selected();
    editor.click("Color");
    assert!(editor.has("Red"));
    editor.press_and_release_at(IN_VIEW);
    assert!(!editor.has("Red"));
    assert_eq!(editor.session().selected(), selected);
}

#[test]
fn in_the_list_of_colors_keys_move_from_the_one_there_is_though_a_click_opened_it() {
    let mut editor = Editor::with_figure();
    let pose = editor.character().pose().clone();
    for (start, key, chosen) in [
        ("Teal", Key::ArrowDown, 15),
        ("Light Gray", Key::ArrowUp, 29),
        ("Nero", Key::ArrowUp, 28),
    ] {
        editor.click("Color");
        editor.click(start);
        let at = editor.widget("Color").rect().center();
        editor.press_and_release_at(at);
        editor.key(key);
        editor.key(Key::Enter);
        assert_eq!(
            editor.shape().placement.color,
            ShapeColor::Preset(chosen),
            "{start}"
        );
        assert!(!egui::Popup::is_any_open(&editor.harness.ctx));
    }
    assert_eq!(
        editor.character().pose(),
        &pose,
        "nothing behind it has turned"
    );
}

#[test]
fn the_title_of_another_menu_opens_it_by_one_touch_and_its_own_closes_it() {
    let mut editor = Editor::new();
    let title = |editor: &Editor, menu: &str| editor.widget(menu).rect().center();
    let (file, edit) = (title(&editor, "File"), title(&editor, "Edit"));
    editor.press_and_release_at(file);
    assert!(editor.has("Save As…"));
    // Fingers do not come from anywhere.
    editor.harness.drag_at(edit);
    editor.harness.drop_at(edit);
    editor.settle();
    assert!(editor.has("Select All") && !editor.has("Save As…"));
    editor.press_and_release_at(edit);
    assert!(!editor.has("Select All"));
}

#[test]
fn a_dialog_is_not_covered_by_the_tooltip_of_what_the_pointer_rests_on() {
    let drag_and_rest = |editor: &mut Editor| {
        editor.drag("Neck X", 10.0);
        let at = editor.widget("Neck X").rect().center();
        editor.harness.hover_at(at);
        editor.wait();
        editor.painted().iter().any(|(text, _)| is_tip(text))
    };
    let mut editor = Editor::with_figure();
    for (modifiers, key, opened) in [
        (Modifiers::NONE, Key::F12, "Save…"),
        (Modifiers::COMMAND, Key::Comma, "Reset to defaults"),
    ] {
        assert!(drag_and_rest(&mut editor), "there is a tooltip");
        editor.key_with(modifiers, key);
        assert!(editor.has(opened), "{opened} is shown");
        editor.wait();
        assert!(!editor.painted().iter().any(|(text, _)| is_tip(text)));
        editor.key(Key::Escape);
    }

    // A dialog of the program, such as the one for files.
    let mut editor = Editor::with_figure();
    assert!(drag_and_rest(&mut editor), "there is a tooltip");
    editor.harness.state_mut().keys_are_taken = true;
    editor.wait();
    assert!(!editor.painted().iter().any(|(text, _)| is_tip(text)));
}

/// Whether a text is that of the tooltip of a number.
fn is_tip(text: &str) -> bool {
    text.contains("click to type")
}
