//! The eye and the lock in the list of shapes.

use crate::interface::{Editor, curves};
use editor_core::editor::{Edit, Session, View};
use editor_core::scene::{CharacterDisplay, ModelDisplay, Shape, ShapeId};
use egui::{Key, Modifiers, Pos2, vec2};
use glam::Vec3;

const LEFT_ELBOW: usize = 17;

/// A cube that fills the middle of the view, in which the pointer counts.
fn with_cube() -> Editor {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Cube"]);
    editor.harness.state_mut().gestures = true;
    editor
}

fn middle(editor: &Editor) -> Pos2 {
    editor.harness.state().view.center()
}

/// Clicks beside everything, then in the middle; what is selected then.
fn clicked(editor: &mut Editor) -> Option<ShapeId> {
    let corner = editor.harness.state().view.left_bottom() + vec2(20.0, -20.0);
    editor.click_at(corner);
    assert_eq!(editor.session().selected(), None);
    let middle = middle(editor);
    editor.click_at(middle);
    editor.session().selected()
}

#[test]
fn others_are_hidden_and_the_selection_is_inverted_among_what_is_shown() {
    let mut editor = Editor::new();
    for name in ["Cube", "Sphere", "Pyramid", "Teapot"] {
        editor.choose(&["Insert", name]);
    }
    let of_each = |editor: &Editor, is: fn(&Session, &Shape) -> bool| {
        let session = editor.session();
        let shapes = session.scene().shapes().iter();
        shapes.map(|shape| is(session, shape)).collect::<Vec<_>>()
    };
    let shown = |editor: &Editor| of_each(editor, |_, shape| shape.visible);
    let shapes = editor.session().scene().shapes();
    let [first, second] = [shapes[0].id, shapes[1].id];
    editor.edit(Edit::SetVisible(first, false));
    editor.view(View::Select(Some(second)));
    editor.choose(&["Edit", "Invert Selection"]);
    let selected = of_each(&editor, |session, shape| session.is_selected(shape.id));
    assert_eq!(selected, [false, false, true, true]);
    editor.choose(&["Edit", "Hide Others"]);
    assert_eq!(shown(&editor), [false, false, true, true]);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(shown(&editor), [false, true, true, true], "in one step");
}

#[test]
fn the_eye_hides_a_shape_and_shows_it_again() {
    let mut editor = with_cube();
    editor.click("Hide Cube");
    assert!(!editor.shape().visible);
    assert!(!editor.has("Hide Cube"));
    editor.click("Show Cube");
    assert!(editor.shape().visible);
}

#[test]
fn the_lock_locks_a_shape_and_unlocks_it() {
    let mut editor = with_cube();
    editor.click("Lock Cube");
    assert!(editor.shape().locked);
    editor.click("Unlock Cube");
    assert!(!editor.shape().locked);
}

#[test]
fn h_hides_the_selected_shape_alone_and_shift_l_locks_it() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.key(Key::H);
    editor.key_with(Modifiers::SHIFT, Key::L);
    let [cube, sphere] = editor.session().scene().shapes() else {
        panic!("two shapes");
    };
    assert_eq!((cube.visible, cube.locked), (true, false));
    assert_eq!((sphere.visible, sphere.locked), (false, true));
    editor.key(Key::H);
    editor.key_with(Modifiers::SHIFT, Key::L);
    assert!(editor.shape().visible && !editor.shape().locked);
}

#[test]
fn signs_of_a_shape_that_is_not_selected_leave_the_selection() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.click("Hide Cube");
    editor.click("Lock Cube");
    assert_eq!(editor.session().selected(), Some(ShapeId(2)));
    let cube = &editor.session().scene().shapes()[0];
    assert!(!cube.visible && cube.locked);
}

#[test]
fn the_pointer_passes_through_what_is_hidden_or_locked() {
    for sign in ["Hide Cube", "Lock Cube"] {
        let mut editor = with_cube();
        editor.choose(&["Insert", "Sphere"]);
        editor.view(View::Select(None));
        assert_eq!(clicked(&mut editor), Some(ShapeId(1)), "the cube's corner");
        editor.click(sign);
        assert_eq!(clicked(&mut editor), Some(ShapeId(2)), "{sign}");
        editor.click("[1] Cube (ID: 1)");
        assert_eq!(editor.session().selected(), Some(ShapeId(1)), "{sign}");
    }
}

#[test]
fn a_locked_shape_is_not_moved_in_the_view_but_by_its_numbers() {
    let mut editor = with_cube();
    editor.key(Key::G);
    editor.click("Lock Cube");
    let before = editor.shape().placement;
    let camera = editor.session().view().camera;
    // Along the arrow, too, which a shape that is not locked would have here.
    for beside in [0.0, 40.0] {
        let from = middle(&editor) + vec2(beside, 0.0);
        editor.hand(from, from + vec2(50.0, 20.0));
        assert_eq!(editor.session().scene().shapes()[0].placement, before);
    }
    assert_ne!(editor.session().view().camera, camera, "the camera moves");
    editor.type_into("Position X", "2");
    assert_eq!(editor.shape().placement.transform.position.x, 2.0);
}

#[test]
fn bones_of_a_hidden_or_locked_character_stay_at_rest_under_the_hand() {
    for sign in ["Hide Model1", "Lock Model1"] {
        for tool in [Key::B, Key::G, Key::I] {
            let mut editor = Editor::with_hands(tool);
            let id = editor.shape().id;
            let display = CharacterDisplay {
                mode: ModelDisplay::Both,
                ..CharacterDisplay::default()
            };
            editor.edit(Edit::SetDisplay(id, display));
            let from = editor.on_bone(LEFT_ELBOW);
            editor.click(sign);
            editor.hand(from, from + vec2(-20.0, 60.0));
            assert!(editor.character().pose().is_bind(), "{sign} {tool:?}");
            assert_eq!(editor.session().selected_joint(), None);
            editor.type_into("Neck X", "20");
            assert!((editor.joint(3).x - 20.0).abs() < 1e-3, "panels pose it");
        }
    }
}

#[test]
fn a_locked_character_has_no_rings_and_does_not_roll() {
    let mut editor = Editor::with_hands(Key::B);
    editor.click("Left elbow");
    editor.click("Lock Model1");
    let (start, _) = editor.bone(LEFT_ELBOW);
    let joint = editor.place(start);
    for away in [vec2(64.0, 0.0), vec2(0.0, 64.0), vec2(76.0, 0.0)] {
        editor.hand(joint + away, joint + away + vec2(10.0, 30.0));
    }
    let middle = middle(&editor);
    editor.point(middle);
    editor.key(Key::ArrowRight);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn control_points_of_a_hidden_or_locked_curve_stay() {
    for sign in ["Hide Bézier Curve", "Lock Bézier Curve"] {
        let mut editor = Editor::new();
        editor.choose(&["Insert", "Bézier Curve"]);
        let before = editor.value("1. curve point 4 X");
        let from = curves::place(&editor, 3);
        editor.click(sign);
        editor.press(from);
        assert_eq!(editor.session().hovered_control_point(), None);
        editor.release(from + vec2(-60.0, 45.0));
        editor.click("[1] Bézier Curve (ID: 1)");
        assert_eq!(editor.value("1. curve point 4 X"), before);
    }
}

#[test]
fn a_shape_that_is_hidden_while_it_is_held_is_let_go_of() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.take(from);
    editor.point(from + vec2(-10.0, 30.0));
    let id = editor.shape().id;
    editor.edit(Edit::SetVisible(id, false));
    let held = editor.character().pose().clone();
    editor.point(from + vec2(-60.0, 90.0));
    assert_eq!(editor.character().pose(), &held);
    editor.let_go(from);
    assert_eq!(editor.character().pose(), &held);
}

#[test]
fn everything_is_fitted_without_what_is_hidden() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.type_into("Position X", "30");
    editor.view(View::Select(None));
    editor.key(Key::F);
    let with_both = editor.session().view().camera;
    assert!((with_both.target.x - 15.0).abs() < 1.0);
    editor.click("Hide Sphere");
    editor.key(Key::F);
    let with_cube = editor.session().view().camera;
    assert!(with_cube.target.abs_diff_eq(Vec3::ZERO, 1e-4));
    assert!(with_cube.radius < with_both.radius / 4.0);

    editor.click("[2] Sphere (ID: 2)");
    editor.key(Key::F);
    assert_eq!(editor.session().view().camera, with_cube, "nothing to see");
    editor.click("Hide Cube");
    editor.key(Key::R);
    editor.key(Key::F);
    assert_eq!(editor.session().view().camera, with_cube, "nothing at all");
}
