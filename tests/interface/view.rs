//! What lies over the view, and the view itself.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::math::Transform;
use editor_core::scene::{Camera, Look, NewShape, ShapeKind, ViewDirection};
use editor_core::ui::{COMMANDS, Navigation};
use egui::Key;
use egui_kittest::kittest::NodeT;
use glam::{Vec3, vec2};

#[test]
fn the_view_is_what_the_panels_leave_free() {
    let editor = Editor::new();
    let view = editor.harness.state().view;
    assert_eq!(view.left(), 0.0);
    assert!((view.right() - 520.0).abs() <= 1.0, "{view}");
    assert!(view.top() > 16.0 && view.top() < 40.0, "{view}");
    assert!(view.bottom() > 560.0 && view.bottom() < 600.0, "{view}");
}

#[test]
fn an_end_of_the_axis_ball_turns_the_camera_and_keeps_target_and_distance() {
    let mut editor = Editor::new();
    let mut camera = Camera {
        target: Vec3::new(1.0, 2.0, 3.0),
        radius: 9.0,
        ..Camera::default()
    };
    camera.turn(vec2(70.0, -50.0));
    editor.view(View::SetCamera(camera));
    editor.click("Look from +X");
    let now = editor.session().view().camera;
    assert_eq!(now, camera.looking_from(ViewDirection::PlusX));
    editor.click("Look from +X");
    let now = editor.session().view().camera;
    assert_eq!(
        now,
        camera.looking_from(ViewDirection::MinusX),
        "again: from behind"
    );
}

#[test]
fn the_views_of_the_menu_are_the_courses() {
    let mut editor = Editor::new();
    for direction in ViewDirection::ALL {
        let starts = format!("View from {} ", direction.label());
        let named = COMMANDS
            .iter()
            .find(|entry| entry.label.starts_with(&starts));
        let label = named.expect("a command").label;
        editor.choose(&["View", "View from", label]);
        let camera = editor.session().view().camera;
        assert_eq!(camera, Camera::preset(direction), "{label}");
    }
    editor.choose(&["View", "Reset to Default Camera View"]);
    assert_eq!(editor.session().view().camera, Camera::default());
    editor.key(Key::Num7);
    let camera = editor.session().view().camera;
    assert_eq!(camera, Camera::preset(ViewDirection::PlusY));
}

#[test]
fn elsewhere_the_views_of_the_menu_look_at_the_same_target_from_the_same_distance() {
    let mut editor = Editor::new();
    editor
        .harness
        .state_mut()
        .state
        .set_navigation(Navigation::Blender);
    let far = Camera::from_numbers(&[10.0, 20.0, 30.0, 1.0, 2.0, 3.0]).unwrap();
    editor.view(View::SetCamera(far));
    editor.key(Key::Num3);
    let camera = editor.session().view().camera;
    assert_eq!(camera, far.looking_from(ViewDirection::PlusX));
    assert_eq!((camera.target, camera.radius), (far.target, far.radius));
}

#[test]
fn the_help_for_newcomers_goes_with_its_cross_or_the_first_gesture() {
    let mut editor = Editor::new();
    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    assert!(
        !editor.has("Close help"),
        "it would cover what to begin with"
    );
    editor.edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]));
    editor.click("Close help");
    assert!(!editor.has("Close help"));

    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    editor.drag("View of the scene", 40.0);
    assert!(!editor.has("Close help"));
}

#[test]
fn the_help_for_newcomers_tells_what_is_left_to_do() {
    let mut editor = Editor::new();
    editor.harness.state_mut().state.first_help = true;
    editor.edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]));
    let check = "View ⏵ Compare with Mesh… tells what is wrong in yours";
    let with_key = "press B and drag a bone, or drag a number at the right";
    assert!(!editor.has(check), "there is nothing to compare");
    assert!(editor.has(with_key));
    let of_points = "drag a control point, or a number at the right";
    assert!(!editor.has(of_points), "there is none");
    editor.choose(&["Insert", "Circle"]);
    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    assert!(editor.has(of_points));

    let mut editor = Editor::with_figure();
    editor.choose(&["Insert", "Circle"]);
    editor.harness.state_mut().state.first_help = true;
    editor.settle();
    assert!(editor.has(with_key) && !editor.has(of_points));
    editor.key(Key::B);
    editor.settle();
    assert!(editor.has(check));
    assert!(!editor.has(with_key), "the tool is chosen");
    editor.key(Key::K);
    assert!(!editor.has(check), "it would cover what is explained");
}

#[test]
fn a_drag_in_the_view_is_the_programs_and_changes_nothing_here() {
    let mut editor = Editor::with_figure();
    let camera = editor.session().view().camera;
    editor.drag("View of the scene", 40.0);
    assert_eq!(editor.session().view().camera, camera);
}

#[test]
fn of_two_ends_of_the_axis_ball_in_one_place_the_nearer_is_clicked() {
    let mut editor = Editor::new();
    let mut camera = Camera::default();
    // The ends of Z are a few points apart, and +Z is before the other.
    camera.turn(vec2(10.0, 0.0));
    editor.view(View::SetCamera(camera));
    editor.click("Look from +Z");
    let now = editor.session().view().camera;
    assert_eq!(now, camera.looking_from(ViewDirection::PlusZ));
}

#[test]
fn a_wide_shape_is_fitted_to_the_width_of_a_wide_view() {
    let mut editor = Editor::sized(egui::vec2(1400.0, 500.0));
    editor.choose(&["Insert", "Cube"]);
    let wide = Transform {
        scale: Vec3::new(10.0, 1.0, 1.0),
        ..Transform::IDENTITY
    };
    let cube = editor.shape().id;
    editor.edit(Edit::SetTransform(cube, wide));
    editor.key(Key::F);
    // The nearest edges, as seen from +Z, are the widest.
    let ends = [-5.0, 5.0].map(|x| editor.place(Vec3::new(x, 0.0, 0.5)).x);
    let share = (ends[1] - ends[0]) / editor.harness.state().view.width();
    assert!((0.85..1.0).contains(&share), "{share} of the width");
}

#[test]
fn the_mannequin_look_says_that_it_draws_bones_its_own_way_and_styles_are_not_chosen_there() {
    let mut editor = Editor::with_figure();
    editor.click("Both");
    let says_so = |editor: &Editor| {
        let painted = editor.painted();
        painted.iter().any(|(text, _)| text.contains("red lines"))
    };
    let can_choose =
        |editor: &Editor, label: &str| !editor.widget(label).accesskit_node().is_disabled();
    assert!(!says_so(&editor) && can_choose(&editor, "Spheres") && can_choose(&editor, "Boxes"));
    editor.view(View::SetLook(Look::Mannequin));
    assert!(says_so(&editor) && !can_choose(&editor, "Spheres") && !can_choose(&editor, "Boxes"));
    for (bones, same) in [(true, true), (false, false)] {
        editor.view(View::SetBones(bones));
        let painted = editor.painted();
        let are_same = painted
            .iter()
            .any(|(text, _)| text.contains("are the same"));
        assert_eq!(are_same, same);
        assert!(says_so(&editor));
    }
}
