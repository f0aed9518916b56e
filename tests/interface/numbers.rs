//! Numbers of the panels: drags that a right click cancels, and joints that are selected by their numbers.

use crate::interface::{Editor, figure};
use editor_core::editor::View;
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, pos2, vec2};
use glam::Vec3;

const ROOT: usize = 0;
const CHEST: usize = 1;
const NECK: usize = 3;
const LEFT_ELBOW: usize = 17;

impl Editor {
    /// The middle of the number of that name.
    fn number(&self, name: &str) -> Pos2 {
        self.widget(name).rect().center()
    }

    /// Presses buttons, or releases them, one right after the other.
    fn buttons(&mut self, at: Pos2, changes: &[(PointerButton, bool)]) {
        for &(button, pressed) in changes {
            self.harness.event(Event::PointerButton {
                pos: at,
                button,
                pressed,
                modifiers: Modifiers::NONE,
            });
            self.harness.step();
        }
        self.settle();
    }

    /// Clicks with the right button in the middle of a drag with the left one, which is released first
    /// or last.
    fn cancel_by_right_click(&mut self, at: Pos2, left_first: bool) {
        let (left, right) = (PointerButton::Primary, PointerButton::Secondary);
        let released = if left_first {
            [left, right]
        } else {
            [right, left]
        };
        let released = released.map(|button| (button, false));
        self.buttons(at, &[(right, true), released[0], released[1]]);
    }
}

#[test]
fn an_angle_has_its_sign_at_the_panels_first_width_and_its_decimal_under_the_pointer() {
    let mut editor = Editor::with_figure();
    editor.type_into("Neck X", "-120.3");
    editor.harness.hover_at(pos2(200.0, 300.0));
    editor.settle();
    let written = |editor: &Editor| {
        let place = editor.widget("Neck X").rect();
        let painted = editor.painted().into_iter();
        let mut inside =
            painted.filter(|(text, at)| place.contains_rect(*at) && text.contains('1'));
        inside.next().map(|(text, _)| text).unwrap_or_default()
    };
    let at_rest = written(&editor);
    assert!(at_rest.ends_with('°'), "{at_rest}");
    editor
        .harness
        .hover_at(editor.widget("Neck X").rect().center());
    editor.settle();
    assert!(
        written(&editor).starts_with("-120.3"),
        "{}",
        written(&editor)
    );
}

#[test]
fn what_is_no_number_changes_nothing_and_is_said_to_be_none() {
    for (typed, is_wrong) in [
        ("abc", true),
        ("1/0", true),
        ("", false),
        (" ", false),
        ("45/2", false),
    ] {
        let mut editor = Editor::with_figure();
        editor.click("Neck X");
        editor.key(Key::Delete);
        editor.harness.event(egui::Event::Text(typed.to_owned()));
        editor.settle();
        editor.key(Key::Enter);
        let fresh = editor.session().messages.fresh();
        let told = fresh
            .iter()
            .filter(|told| told.text.contains("is no number"));
        assert_eq!(told.count(), usize::from(is_wrong), "“{typed}”");
        let angle = if typed == "45/2" { 22.5 } else { 0.0 };
        assert!((editor.joint(3).x - angle).abs() < 1e-3, "“{typed}”");
    }
    let mut editor = Editor::with_figure();
    editor.begin_typing("Neck X", "abc");
    editor.key(Key::Escape);
    assert!(
        editor.session().messages.fresh().is_empty(),
        "it is given up"
    );
}

#[test]
fn a_number_that_a_field_cannot_have_is_told_with_the_one_that_it_has_instead() {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Cube"]);
    editor.type_into("Uniform Scale", "2");
    assert_eq!(editor.last_told(), None);
    editor.type_into("Uniform Scale", "-1");
    let told = editor.last_told().unwrap_or_default();
    assert_eq!(told, "Uniform Scale can be 0.001 at least: -1 was typed");
    let scale = editor.shape().placement.transform.scale;
    assert!((scale.x - 0.001).abs() < 1e-6, "{scale}");
}

#[test]
fn a_right_click_that_cancels_the_drag_of_a_number_does_nothing_to_the_one_under_the_pointer() {
    for (dragged, other) in [("Neck X", "Neck Y"), ("Position X", "Position Y")] {
        for left_first in [true, false] {
            let mut editor = Editor::with_figure();
            editor.type_into(dragged, "10");
            editor.type_into(other, "20");
            let before = [dragged, other].map(|name| editor.value(name));
            let (from, to) = (editor.number(dragged), editor.number(other));
            editor.take(from);
            editor.point(to);
            assert_ne!(editor.value(dragged), before[0]);
            editor.cancel_by_right_click(to, left_first);
            let after = [dragged, other].map(|name| editor.value(name));
            assert_eq!(after, before, "left first: {left_first}");
            assert!(!editor.harness.ctx.text_edit_focused(), "it types nothing");
            editor.point(from);
            assert_eq!(editor.value(dragged), before[0], "the drag is over");
            editor.drag(other, 10.0);
            assert_ne!(editor.value(other), before[1], "the next one works");
        }
    }
}

#[test]
fn a_right_click_that_cancels_the_drag_of_a_number_presses_no_button_under_the_pointer() {
    for left_first in [true, false] {
        let mut editor = Editor::with_figure();
        editor.type_into("Neck Y", "20");
        let before = editor.joint(NECK);
        let (from, to) = (editor.number("Neck X"), editor.number("Reset Neck"));
        editor.take(from);
        editor.point(to);
        editor.cancel_by_right_click(to, left_first);
        assert_eq!(editor.joint(NECK), before);
    }
}

#[test]
fn a_right_click_that_cancels_a_drag_in_the_view_does_nothing_to_a_number_under_the_pointer() {
    for left_first in [true, false] {
        let mut editor = Editor::with_hands(Key::B);
        editor.type_into("Neck Y", "20");
        // Its rings would be in the way.
        editor.view(View::SelectJoint(None));
        let from = editor.on_bone(LEFT_ELBOW);
        let to = editor.number("Neck Y");
        editor.take(from);
        editor.point(from + vec2(-20.0, 60.0));
        editor.point(to);
        assert_ne!(editor.joint(LEFT_ELBOW), Vec3::ZERO);
        editor.cancel_by_right_click(to, left_first);
        assert_eq!(editor.joint(LEFT_ELBOW), Vec3::ZERO);
        assert!((editor.joint(NECK).y - 20.0).abs() < 1e-3);
        assert!(!editor.harness.ctx.text_edit_focused());
    }
}

#[test]
fn a_click_that_ends_a_movement_by_key_does_nothing_to_a_number_under_the_pointer() {
    for button in [PointerButton::Primary, PointerButton::Secondary] {
        let mut editor = Editor::with_figure();
        editor.harness.state_mut().gestures = true;
        let state = &mut editor.harness.state_mut().state;
        state.set_navigation(Navigation::Blender);
        editor.type_into("Neck Y", "20");
        editor.point(pos2(200.0, 300.0));
        editor.key(Key::G);
        let to = editor.number("Neck Y");
        editor.point(to);
        let position = |editor: &Editor| editor.shape().placement.transform.position;
        let moved = position(&editor);
        assert_ne!(moved, Vec3::ZERO);
        editor.buttons(to, &[(button, true), (button, false)]);
        let stays = button == PointerButton::Primary;
        assert_eq!(position(&editor), if stays { moved } else { Vec3::ZERO });
        assert!((editor.joint(NECK).y - 20.0).abs() < 1e-3);
        assert!(!editor.harness.ctx.text_edit_focused());
        editor.point(pos2(100.0, 200.0));
        assert_eq!(position(&editor), if stays { moved } else { Vec3::ZERO });
    }
}

#[test]
fn dragging_or_typing_a_number_of_a_joint_selects_the_joint_and_adds_no_step() {
    let mut editor = Editor::with_figure();
    let steps = |editor: &Editor| editor.session().done_steps();
    let before = steps(&editor);
    editor.drag("Neck X", 25.0);
    assert_eq!(editor.session().selected_joint(), Some(NECK));
    assert_eq!(steps(&editor), before + 1);
    editor.type_into("Chest Y", "30");
    assert_eq!(editor.session().selected_joint(), Some(CHEST));
    assert_eq!(steps(&editor), before + 2);
    editor.drag("Root Offset X", 25.0);
    assert_eq!(editor.session().selected_joint(), Some(ROOT));
    assert_eq!(steps(&editor), before + 3);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn a_drag_of_a_number_that_is_cancelled_is_no_step() {
    let mut editor = Editor::with_figure();
    let before = editor.session().done_steps();
    editor.reveal("Neck X");
    let from = editor.number("Neck X");
    editor.take(from);
    editor.point(from + vec2(30.0, 0.0));
    assert_eq!(editor.session().selected_joint(), Some(NECK));
    editor.cancel_by_right_click(from, false);
    assert_eq!(editor.session().done_steps(), before);
    assert_eq!(editor.joint(NECK), Vec3::ZERO);
}

#[test]
fn a_click_on_a_joint_selects_it_though_the_number_of_another_was_being_typed() {
    let mut editor = Editor::with_figure();
    editor.begin_typing("Neck X", "10");
    editor.click("Chest");
    assert!((editor.joint(NECK).x - 10.0).abs() < 1e-3);
    assert_eq!(editor.session().selected_joint(), Some(CHEST));
}

#[test]
fn the_list_stays_where_it_is_while_numbers_in_it_are_dragged_and_typed() {
    let mut editor = Editor::new();
    editor.add_character(figure::chain(60));
    let place = |editor: &Editor, joint| editor.widget(&format!("Joint {joint}")).rect();
    let window = editor.harness.ctx.content_rect();
    // The last row that is in sight, where the list fades out: a joint selected elsewhere would be
    // scrolled further up.
    let is_seen = |&joint: &usize| place(&editor, joint).bottom() < window.bottom() - 4.0;
    let last = (0..60).rev().find(is_seen).expect("rows are in sight");
    let before = place(&editor, last);
    let at = editor.number(&format!("Joint {last} X"));
    editor.click_at(at);
    editor.harness.event(Event::Text("5".to_owned()));
    editor.settle();
    editor.point(pos2(200.0, 300.0));
    editor.key(Key::Enter);
    editor.harness.run_steps(40);
    assert_eq!(editor.session().selected_joint(), Some(last));
    assert_eq!(place(&editor, last), before);
    editor.view(View::SelectJoint(None));
    editor.take(at);
    editor.point(pos2(200.0, 300.0));
    editor.harness.run_steps(40);
    assert_eq!(editor.session().selected_joint(), Some(last));
    assert_eq!(place(&editor, last), before);
}
