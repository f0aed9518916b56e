//! Control points that are moved by G, as vertices in Blender.

use crate::interface::Editor;
use crate::interface::curves::{place, with_curve};
use editor_core::editor::Edit;
use editor_core::math::Euler;
use editor_core::ui::Navigation;
use egui::{Key, Modifiers, vec2};
use glam::Vec3;

/// A curve in the Blender navigation, one point of which was clicked and is under the pointer.
fn with_point(kind: &str, point: usize) -> Editor {
    let mut editor = with_curve(kind);
    let state = &mut editor.harness.state_mut().state;
    state.set_navigation(Navigation::Blender);
    let at = place(&editor, point);
    editor.press(at);
    editor.release(at);
    editor.point(at);
    editor
}

fn shows(editor: &Editor, text: &str) -> bool {
    let painted = editor.painted();
    painted.iter().any(|(painted, _)| painted.contains(text))
}

fn points(editor: &Editor) -> Vec<Vec3> {
    let id = editor.shape().id;
    let curve = editor.session().scene().curve(id).unwrap();
    curve.curves().curve(0).unwrap().control_points().to_vec()
}

#[test]
fn g_moves_the_point_that_was_clicked_with_the_pointer_and_esc_puts_it_back() {
    let mut editor = with_point("Bézier Curve", 3);
    let (before, transform) = (points(&editor), editor.shape().placement.transform);
    editor.key(Key::G);
    let by = vec2(-50.0, 30.0);
    let from = place(&editor, 3);
    editor.point(from + by);
    assert!(shows(&editor, "Point 4"), "the readout names it");
    let moved = place(&editor, 3) - from;
    assert!((moved - by).length() < 0.05, "{moved:?}");
    assert_eq!(points(&editor)[..3], before[..3]);
    assert_eq!(points(&editor)[3].z, 0.0, "flat seen from the front");
    assert_eq!(editor.shape().placement.transform, transform);
    editor.key(Key::Escape);
    assert_eq!(points(&editor), before);
}

#[test]
fn a_flat_curve_of_a_turned_shape_stays_flat() {
    let mut editor = with_point("Bézier Curve", 3);
    let shape = editor.shape();
    let mut transform = shape.placement.transform;
    transform.rotation = Euler::from_degrees(Vec3::new(17.0, 31.0, 8.0));
    editor.edit(Edit::SetTransform(shape.id, transform));
    let at = place(&editor, 3);
    editor.press(at);
    editor.release(at);
    editor.point(at);
    let before = points(&editor);
    editor.key(Key::G);
    for by in [vec2(-33.0, 21.0), vec2(47.0, 5.0), vec2(-8.0, -61.0)] {
        editor.point(at + by);
        assert_ne!(points(&editor), before);
        assert_eq!(points(&editor)[3].z, 0.0, "{by:?}");
    }
}

#[test]
fn an_axis_and_a_number_that_are_typed_at_once_are_taken_and_the_point_stays_the_one_at_hand() {
    let mut editor = with_point("Bézier Curve", 3);
    let before = points(&editor);
    for key in [Key::G, Key::X, Key::Num2] {
        editor.key(key);
    }
    editor.key(Key::Enter);
    let moved = points(&editor)[3] - before[3];
    assert!(moved.abs_diff_eq(Vec3::X * 2.0, 1e-5), "{moved}");
    // X is about the point rather than the curve.
    editor.key(Key::X);
    assert!(shows(&editor, "This point stays"));
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&editor), before, "undone as one step");
}

#[test]
fn a_point_of_a_curve_that_stays_flat_does_not_leave_its_plane() {
    let mut editor = with_point("Bézier Curve", 3);
    editor.key_with(Modifiers::SHIFT, Key::V);
    let at = place(&editor, 3);
    editor.press(at);
    editor.release(at);
    let before = points(&editor);
    for key in [Key::G, Key::Z, Key::Num2] {
        editor.key(key);
    }
    editor.key(Key::Enter);
    assert_eq!(points(&editor), before);
    assert_eq!(editor.session().messages.fresh().len(), 0);
    for key in [Key::G, Key::Y, Key::Num2] {
        editor.key(key);
    }
    editor.key(Key::Enter);
    let moved = points(&editor)[3] - before[3];
    assert!(moved.abs_diff_eq(Vec3::Y * 2.0, 1e-5), "{moved}");
}
