//! Hints speak of what is at hand: of buttons and keys to who has a mouse, of fingers to who has none.

use super::Editor;
use egui::{Event, Modifiers, PointerButton, Pos2, TouchDeviceId, TouchId, TouchPhase, pos2};

/// Puts a finger on the screen, which moves the pointer there as in browsers, moves or lifts it.
fn touch(editor: &mut Editor, at: Pos2, phase: TouchPhase) {
    let mut events = vec![Event::PointerMoved(at)];
    if phase != TouchPhase::Move {
        events.push(Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: phase == TouchPhase::Start,
            modifiers: Modifiers::NONE,
        });
    }
    events.push(Event::Touch {
        device_id: TouchDeviceId(0),
        id: TouchId(1),
        phase,
        pos: at,
        force: None,
    });
    editor.harness.input_mut().events.extend(events);
    // More frames would be a long press.
    editor.harness.run_steps(1);
}

fn tap(editor: &mut Editor, at: Pos2) {
    touch(editor, at, TouchPhase::Start);
    touch(editor, at, TouchPhase::End);
    editor.settle();
}

fn point_with_a_mouse(editor: &mut Editor, at: Pos2) {
    editor.harness.event(Event::PointerMoved(at));
    editor.settle();
}

const ON_THE_GROUND: Pos2 = pos2(300.0, 480.0);

#[test]
fn the_status_line_and_the_first_help_speak_of_fingers_after_a_touch_and_of_buttons_after_a_mouse()
{
    for (navigation, mouse, fingers) in [
        (
            "As the course's editor",
            "Left drag moves the scene · right drag turns it · wheel zooms",
            "One finger turns the scene · two move it and zoom",
        ),
        (
            "Blender",
            "Middle drag turns, with Shift moves · left drag selects",
            "One finger selects in a box · two move the scene and zoom",
        ),
    ] {
        let mut editor = Editor::new();
        editor.choose(&["View", "Navigation", navigation]);
        editor.choose(&["Insert", "Cube"]);
        editor.harness.state_mut().state.first_help = true;
        editor.settle();
        assert!(editor.has(mouse), "{navigation}");
        assert!(editor.has("Insert adds shapes · ? shows every key"));
        tap(&mut editor, ON_THE_GROUND);
        assert!(editor.has(fingers) && !editor.has(mouse), "{navigation}");
        // A click in the view has shown that it is not needed.
        editor.harness.state_mut().state.first_help = true;
        editor.settle();
        assert!(editor.has("Insert adds shapes · Help tells the rest"));
        point_with_a_mouse(&mut editor, ON_THE_GROUND);
        assert!(editor.has(mouse) && !editor.has(fingers), "{navigation}");
    }
}

#[test]
fn beside_the_figure_the_status_line_says_what_the_tool_does_with_bones() {
    let summary = "Left drag moves the scene · right drag turns it · wheel zooms";
    let mut editor = Editor::with_figure();
    for (tool, does) in [
        ("Pose Tool", "Drag a bone to turn it · "),
        ("IK Tool", "Drag a bone to bring it somewhere · "),
        ("Select Tool", ""),
    ] {
        editor.click(tool);
        point_with_a_mouse(&mut editor, ON_THE_GROUND);
        assert!(editor.has(&format!("{does}{summary}")), "{tool}");
    }
    let mut editor = Editor::new();
    editor.click("Pose Tool");
    point_with_a_mouse(&mut editor, ON_THE_GROUND);
    assert!(editor.has(summary), "there is none");
}

#[test]
fn over_a_curve_that_is_not_selected_a_finger_is_told_to_tap_it_before_it_drags_its_points() {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Circle"]);
    let circle = editor.shape().id;
    editor.choose(&["Insert", "Cube"]);
    tap(&mut editor, ON_THE_GROUND);
    editor.harness.state_mut().hovered_shape = Some(circle);
    editor.settle();
    assert!(editor.has("Tap to select it, then drag its control points"));
}

#[test]
fn a_machine_that_is_made_for_fingers_is_told_of_them_before_the_first_touch() {
    let mut editor = Editor::with_figure();
    editor.harness.state_mut().state.has_fingers_first = true;
    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    assert!(editor.has("One finger turns the scene · two move it and zoom"));
    assert!(editor.has("Insert adds shapes · Help tells the rest"));
    point_with_a_mouse(&mut editor, ON_THE_GROUND);
    assert!(editor.has("Insert adds shapes · ? shows every key"));
}

#[test]
fn the_list_of_keys_has_the_gestures_of_fingers_where_these_point() {
    let mut editor = Editor::new();
    point_with_a_mouse(&mut editor, ON_THE_GROUND);
    editor.choose(&["Help", "Keys and Mouse"]);
    assert!(editor.has("Mouse") && !editor.has("Long press"));
    tap(&mut editor, ON_THE_GROUND);
    assert!(editor.has("Fingers") && editor.has("Long press"));
    assert!(editor.has("Turn the scene") && editor.has("Mouse"));
}
