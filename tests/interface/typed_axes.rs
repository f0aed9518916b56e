//! Axes and planes that are typed in the middle of a drag.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::math::{Euler, Transform};
use editor_core::scene::ViewDirection;
use editor_core::ui::Navigation;
use egui::{Color32, Key, Modifiers};
use glam::{Vec3, vec2};

const SHIFT: Modifiers = Modifiers::SHIFT;

/// A cube in the Blender navigation, seen from above at an angle, with the pointer at this point of
/// the world.
fn with_cube(pointer: Vec3) -> Editor {
    let mut editor = Editor::new();
    editor.harness.state_mut().gestures = true;
    editor.key_with(SHIFT, Key::C);
    let state = &mut editor.harness.state_mut().state;
    state.set_navigation(Navigation::Blender);
    let mut camera = editor.session().view().camera;
    camera.orbit(vec2(0.6, 0.5));
    editor.view(View::SetCamera(camera));
    let at = editor.place(pointer);
    editor.point(at);
    editor
}

impl Editor {
    fn transform(&self) -> Transform {
        self.shape().placement.transform
    }

    fn keys(&mut self, keys: &[(Modifiers, Key)]) {
        for &(modifiers, key) in keys {
            self.key_with(modifiers, key);
            // The harness presses keys without the text that comes with them.
            let digits = [
                (Key::Num1, "1"),
                (Key::Num2, "2"),
                (Key::Num3, "3"),
                (Key::Num0, "0"),
            ];
            if let Some((_, digit)) = digits.iter().find(|digit| digit.0 == key) {
                self.harness.event(egui::Event::Text((*digit).to_owned()));
                self.settle();
            }
        }
    }

    /// Colors of the guides, the lines of axes that were typed.
    fn guides(&self) -> Vec<Color32> {
        let shapes = self.harness.output().shapes.iter();
        let lines = shapes.filter_map(|clipped| match &clipped.shape {
            egui::Shape::LineSegment { points, stroke } => {
                let is_long = points[0].distance(points[1]) > 150.0;
                (is_long && stroke.width == 1.5).then_some(stroke.color)
            }
            _ => None,
        });
        lines.collect()
    }
}

fn plain(keys: &[Key]) -> Vec<(Modifiers, Key)> {
    keys.iter().map(|&key| (Modifiers::NONE, key)).collect()
}

/// Begins a movement by `key`, and types an axis with Shift, and a digit.
fn type_with_shift(editor: &mut Editor, key: Key, axis: Key, digit: Key) {
    editor.keys(&plain(&[key]));
    editor.keys(&[(SHIFT, axis)]);
    editor.keys(&plain(&[digit, Key::Enter]));
}

#[test]
fn shift_and_an_axis_scale_the_two_other_axes() {
    for (axis, scale) in [
        (Key::X, Vec3::new(1.0, 2.0, 2.0)),
        (Key::Y, Vec3::new(2.0, 1.0, 2.0)),
        (Key::Z, Vec3::new(2.0, 2.0, 1.0)),
    ] {
        let mut editor = with_cube(Vec3::X);
        type_with_shift(&mut editor, Key::S, axis, Key::Num2);
        assert_eq!(editor.transform().scale, scale, "{axis:?}");
    }
}

#[test]
fn shift_and_an_axis_move_by_a_number_along_the_first_of_the_two_others() {
    for (axis, moved) in [(Key::X, Vec3::Y), (Key::Y, Vec3::X), (Key::Z, Vec3::X)] {
        let mut editor = with_cube(Vec3::X);
        type_with_shift(&mut editor, Key::G, axis, Key::Num1);
        assert_eq!(editor.transform().position, moved, "{axis:?}");
    }
}

#[test]
fn shift_and_y_let_a_shape_follow_the_pointer_over_the_ground() {
    let mut editor = with_cube(Vec3::X);
    editor.keys(&plain(&[Key::G]));
    editor.keys(&[(SHIFT, Key::Y)]);
    let to = editor.place(Vec3::new(1.5, 0.0, -0.5));
    editor.point(to);
    let moved = editor.transform().position;
    let expected = Vec3::new(0.5, 0.0, -0.5);
    assert!(moved.abs_diff_eq(expected, 1e-3), "{moved}");
    assert_eq!(moved.y, 0.0);
}

#[test]
fn the_plane_again_is_the_shapes_own_and_then_none() {
    let mut editor = with_cube(Vec3::X);
    let turned = Transform {
        rotation: Euler::from_degrees(Vec3::Z * 90.0),
        ..Transform::IDENTITY
    };
    let id = editor.shape().id;
    editor.edit(Edit::SetTransform(id, turned));
    editor.keys(&plain(&[Key::G]));
    editor.keys(&[(SHIFT, Key::Z), (SHIFT, Key::Z)]);
    editor.keys(&plain(&[Key::Num1]));
    let position = editor.transform().position;
    assert!(position.abs_diff_eq(Vec3::Y, 1e-6), "{position}");
    editor.keys(&[(SHIFT, Key::Z)]);
    let position = editor.transform().position;
    assert_eq!(position, Vec3::X, "without a plane, along the world's X");
    assert!(editor.guides().is_empty());
    editor.keys(&plain(&[Key::Y]));
    assert_eq!(editor.transform().position, Vec3::Y, "an axis alone again");
    editor.keys(&[(SHIFT, Key::Y)]);
    assert_eq!(editor.transform().position, Vec3::X, "all but that axis");
}

#[test]
fn a_drag_along_a_shapes_own_axes_tells_how_far_it_has_moved_along_these() {
    let mut editor = with_cube(Vec3::X);
    let turned = Transform {
        rotation: Euler::from_degrees(Vec3::Z * 30.0),
        ..Transform::IDENTITY
    };
    let id = editor.shape().id;
    editor.edit(Edit::SetTransform(id, turned));
    for (keys, letters) in [
        (&[(Modifiers::NONE, Key::X); 2], &["x"][..]),
        (&[(SHIFT, Key::Z); 2], &["x", "y"]),
    ] {
        editor.keys(&plain(&[Key::G]));
        editor.keys(keys);
        let to = editor.place(Vec3::new(1.5, 0.4, 0.0));
        editor.point(to);
        let moved = editor.transform().position;
        let own = [Vec3::X, Vec3::Y].map(|axis| turned.world_from_model().transform_vector3(axis));
        let told: Vec<String> = letters
            .iter()
            .zip(own)
            .map(|(letter, axis)| format!("{letter} {:+.2}", moved.dot(axis)))
            .collect();
        let told = format!("local {}", told.join("  "));
        let painted = editor.painted_over_view();
        assert!(
            painted.iter().any(|text| text.starts_with(&told)),
            "{told}: {painted:?}"
        );
        editor.keys(&plain(&[Key::Escape]));
    }
}

#[test]
fn a_turned_shape_is_scaled_along_its_own_axes_and_the_drag_says_so() {
    for (degrees, told) in [(0.0, "x × 2"), (30.0, "local x × 2")] {
        let mut editor = with_cube(Vec3::X);
        let turned = Transform {
            rotation: Euler::from_degrees(Vec3::Z * degrees),
            ..Transform::IDENTITY
        };
        let id = editor.shape().id;
        editor.edit(Edit::SetTransform(id, turned));
        editor.keys(&plain(&[Key::S, Key::X, Key::Num2]));
        let painted = editor.painted_over_view();
        assert!(
            painted.iter().any(|text| text.starts_with(told)),
            "{painted:?}"
        );
        assert_eq!(editor.transform().scale, Vec3::new(2.0, 1.0, 1.0));
    }
}

#[test]
fn a_turn_is_about_the_axis_with_shift_as_without() {
    let degrees = [Modifiers::NONE, SHIFT].map(|modifiers| {
        let mut editor = with_cube(Vec3::X);
        editor.keys(&plain(&[Key::R]));
        editor.keys(&[(modifiers, Key::Z)]);
        editor.keys(&plain(&[Key::Num3, Key::Num0, Key::Enter]));
        editor.transform().rotation.degrees()
    });
    assert!(degrees[0].abs_diff_eq(Vec3::Z * 30.0, 1e-3), "{degrees:?}");
    assert_eq!(degrees[1], degrees[0]);
}

#[test]
fn without_an_axis_a_number_turns_clockwise_in_the_picture_as_in_blender() {
    for (direction, away) in [
        (ViewDirection::PlusZ, Vec3::NEG_Z),
        (ViewDirection::PlusY, Vec3::NEG_Y),
        (ViewDirection::MinusX, Vec3::X),
    ] {
        let mut editor = with_cube(Vec3::X);
        editor.view(View::From(direction));
        editor.keys(&plain(&[Key::R, Key::Num3, Key::Num0, Key::Enter]));
        let degrees = editor.transform().rotation.degrees();
        assert!(degrees.abs_diff_eq(away * 30.0, 1e-2), "{degrees}");
    }
}

#[test]
fn the_guide_of_a_plane_has_both_of_its_axes() {
    for tool in [Key::G, Key::S] {
        let guides = |keys: &[(Modifiers, Key)]| {
            let mut editor = with_cube(Vec3::X);
            editor.keys(&plain(&[tool]));
            editor.keys(keys);
            editor.guides()
        };
        let [x, y] = [Key::X, Key::Y].map(|axis| guides(&plain(&[axis])));
        assert_eq!((x.len(), y.len()), (1, 1));
        assert_eq!(guides(&[(SHIFT, Key::Z)]), [x[0], y[0]]);
    }
}

#[test]
fn with_the_ik_tool_g_leads_a_joint_and_its_chain_follows_freely_along_an_axis_or_by_a_number() {
    const LEFT_KNEE: usize = 10;
    const LEFT_FOOT: usize = 11;
    let mut editor = Editor::with_hands(Key::I);
    let state = &mut editor.harness.state_mut().state;
    state.set_navigation(Navigation::Blender);
    editor.view(View::SelectJoint(Some(LEFT_FOOT)));
    let foot = |editor: &Editor| editor.bone(LEFT_KNEE).1;
    let start = foot(&editor);
    let at = editor.place(start);
    editor.point(at);
    editor.keys(&[(Modifiers::NONE, Key::G)]);
    let to = at + egui::vec2(20.0, -40.0);
    editor.point(to);
    assert!((editor.place(foot(&editor)) - to).length() < 0.5);
    // Along the height alone, and then exactly so far.
    editor.keys(&[(Modifiers::NONE, Key::Y)]);
    let up = foot(&editor) - start;
    assert!(
        up.y > 0.02 && up.x.abs() < 1e-3 && up.z.abs() < 1e-3,
        "{up}"
    );
    editor.harness.event(egui::Event::Text(".1".to_owned()));
    editor.settle();
    editor.keys(&[(Modifiers::NONE, Key::Enter)]);
    let up = foot(&editor) - start;
    assert!(up.abs_diff_eq(Vec3::Y * 0.1, 1e-3), "{up}");
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert!(foot(&editor).abs_diff_eq(start, 1e-5), "it was one step");
}
