//! Curves and surfaces: the menu, the panel, and control points in the view.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::geometry::{Basis, Curve};
use editor_core::scene::NewShape;
use editor_core::scene::{
    CurveItemKind, CurveSet, CurveShape, CurveVisibility, ShapeColor, ShapeId, ShapeKind,
    SurfaceVisibility,
};
use editor_core::ui::Ask;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use glam::Vec3;

pub fn with_curve(label: &str) -> Editor {
    let mut editor = Editor::new();
    editor.choose(&["Insert", label]);
    editor
}

fn with_set(set: CurveSet) -> Editor {
    let mut editor = Editor::new();
    editor.edit(Edit::Insert(vec![NewShape::new(
        "Curve",
        ShapeKind::Curve(CurveShape::new(set)),
    )]));
    editor
}

/// A profile, a curve in space and a circle, without surfaces.
fn three_curves() -> CurveSet {
    let mut set = CurveSet::new();
    let profile = [(1, 0), (2, 1), (1, 2), (1, 3)].map(|(x, y)| Vec3::new(x as f32, y as f32, 0.0));
    let path = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    for (name, curve) in [
        (
            "profile",
            Curve::spline(Basis::Bezier, true, 8, profile.to_vec()),
        ),
        (
            "path",
            Curve::spline(Basis::BSpline, false, 8, path.to_vec()),
        ),
        ("ring", Curve::circle(12, 0.5)),
    ] {
        set.push(name, CurveItemKind::Curve(curve.unwrap()))
            .unwrap();
    }
    set
}

fn curve(editor: &Editor) -> &CurveShape {
    let id = editor.shape().id;
    editor.session().scene().curve(id).expect("it is a curve")
}

fn kinds(editor: &Editor) -> Vec<CurveItemKind> {
    let items = curve(editor).curves().items();
    items.iter().map(|item| item.kind.clone()).collect()
}

fn points(editor: &Editor) -> &[Vec3] {
    curve(editor).curves().curve(0).unwrap().control_points()
}

#[test]
fn a_new_curve_is_light_gray_named_as_in_the_menu_and_selected() {
    let editor = with_curve("Bézier Curve");
    assert_eq!(editor.shape().name, "Bézier Curve");
    assert_eq!(editor.shape().placement.color, ShapeColor::Preset(30));
    assert_eq!(points(&editor).len(), 4);
    assert!(editor.has("1. curve point 4 Z"), "unfolded, being alone");
}

#[test]
fn fitting_shows_the_control_points_of_a_b_spline_which_lie_off_it() {
    let mut editor = with_curve("B-Spline Curve");
    editor.key(Key::F);
    let view = editor.harness.state().view.size();
    let size = glam::Vec2::new(view.x, view.y);
    let camera = editor.session().view().camera;
    for &point in points(&editor) {
        let pixel = camera.pixel(point, size).unwrap();
        let is_inside = pixel.cmpge(glam::Vec2::ZERO).all() && pixel.cmple(size).all();
        assert!(is_inside, "{point} at {pixel} of {size}");
    }
}

#[test]
fn each_visibility_is_chosen_by_its_label() {
    let mut editor = with_curve("B-Spline Curve");
    editor.click("Show Control Points");
    assert!(!curve(&editor).display.control_points);
    for (label, expected) in [
        ("Off", CurveVisibility::Off),
        (
            "On with Normals/Tangents/Binormals",
            CurveVisibility::OnWithFrames,
        ),
        ("On", CurveVisibility::On),
    ] {
        editor.click(&format!("Curve Visibility: {label}"));
        assert_eq!(curve(&editor).display.curve, expected);
    }
    for (label, expected) in [
        ("Off", SurfaceVisibility::Off),
        (
            "Wireframe with Normals",
            SurfaceVisibility::WireframeWithNormals,
        ),
        ("Shaded", SurfaceVisibility::Shaded),
    ] {
        editor.click(&format!("Surface Visibility: {label}"));
        assert_eq!(curve(&editor).display.surface, expected);
    }
}

#[test]
fn frames_close_by_a_switch_that_needs_a_sweep() {
    let mut editor = with_set(three_curves());
    editor.click("Close Frames");
    assert!(curve(&editor).frame_closing(), "no sweep yet");
    editor.choose(&["Insert", "Sweep from Curves"]);
    editor.click("Close Frames");
    assert!(!curve(&editor).frame_closing());
}

#[test]
fn steps_radius_and_control_points_are_typed() {
    let mut editor = with_curve("Bézier Curve");
    editor.type_into("1. curve steps", "7");
    assert_eq!(curve(&editor).curves().curve(0).unwrap().steps(), 7);
    editor.type_into("1. curve steps", "0");
    assert_eq!(curve(&editor).curves().curve(0).unwrap().steps(), 1);
    let flat = points(&editor)[1];
    editor.type_into("1. curve point 2 Z", "1/4");
    assert_eq!(points(&editor)[1], flat + Vec3::Z * 0.25);

    editor.choose(&["Insert", "Circle"]);
    editor.type_into("1. curve radius", "2.5");
    let circle = curve(&editor).curves().curve(0).unwrap();
    assert_eq!(circle, &Curve::circle(60, 2.5).unwrap());
}

#[test]
fn steps_are_whole_numbers_when_they_are_dragged() {
    let mut editor = with_curve("Circle");
    editor.drag("1. curve steps", 20.0);
    assert_eq!(curve(&editor).curves().curve(0).unwrap().steps(), 64);
}

#[test]
fn flat_curves_have_no_z_to_type() {
    let mut editor = with_set(three_curves());
    editor.click("1. profile");
    assert!(editor.has("1. profile point 1 Y"));
    assert!(!editor.has("1. profile point 1 Z"));
}

#[test]
fn folds_show_and_hide_what_is_in_a_curve() {
    let mut editor = with_set(three_curves());
    assert!(!editor.has("2. path point 1 X"));
    editor.click("2. path");
    assert!(editor.has("2. path point 1 X"));
    editor.click("2. path");
    assert!(!editor.has("2. path point 1 X"));
}

#[test]
fn what_is_behind_a_curve_that_is_taken_away_does_not_take_its_fold() {
    let mut editor = with_set(three_curves());
    editor.click("2. path");
    editor.click("Remove 2. path");
    assert!(editor.has("2. ring"));
    assert!(!editor.has("2. ring radius"), "it was folded");
    editor.click("2. ring");
    editor.click("Remove 1. profile");
    assert_eq!(kinds(&editor).len(), 1);
}

#[test]
fn control_points_are_added_and_taken_away_where_the_kind_allows() {
    let mut editor = with_curve("B-Spline Curve");
    editor.click("Remove 1. curve point 1");
    assert_eq!(points(&editor).len(), 4, "the last piece stays");
    let between = (points(&editor)[0] + points(&editor)[1]) / 2.0;
    editor.click("Add behind 1. curve point 1");
    assert_eq!(points(&editor).len(), 5);
    assert_eq!(points(&editor)[1], between);
    editor.click("Remove 1. curve point 2");
    assert_eq!(points(&editor).len(), 4);

    editor.choose(&["Insert", "Bézier Curve"]);
    editor.click("Add behind 1. curve point 4");
    assert_eq!(points(&editor).len(), 7);
    editor.click("Remove 1. curve point 5");
    assert_eq!(points(&editor).len(), 7, "a handle");
    editor.click("Remove 1. curve point 7");
    assert_eq!(points(&editor).len(), 4);
}

#[test]
fn the_menu_makes_a_surface_of_revolution_and_a_sweep_from_the_curves_that_suit() {
    let mut editor = with_set(three_curves());
    editor.choose(&["Insert", "Surface of Revolution from Curve"]);
    editor.choose(&["Insert", "Sweep from Curves"]);
    let made = &kinds(&editor)[3..];
    let revolution = CurveItemKind::Revolution {
        steps: 48,
        profile: 0,
    };
    let sweep = CurveItemKind::Sweep {
        profile: 0,
        sweep: 1,
    };
    assert_eq!(made, [revolution, sweep]);
}

#[test]
fn a_sweep_from_a_single_curve_is_a_tube() {
    let mut editor = with_curve("Bézier Curve");
    editor.choose(&["Insert", "Sweep from Curves"]);
    let kinds = kinds(&editor);
    assert_eq!(kinds.len(), 3, "the curve, a small circle, the surface");
    let sweep = CurveItemKind::Sweep {
        profile: 1,
        sweep: 0,
    };
    assert_eq!(kinds[2], sweep);
}

#[test]
fn commands_for_curves_need_a_curve() {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Cube"]);
    editor.key_with(Modifiers::SHIFT, Key::V);
    editor.key_with(Modifiers::SHIFT, Key::W);
    editor.key_with(Modifiers::COMMAND, Key::E);
    assert!(editor.asked().is_empty());
    assert_eq!(editor.session().scene().shapes().len(), 1);

    let mut editor = with_set(three_curves());
    let id = editor.shape().id;
    editor.edit(Edit::RemoveCurveItem { shape: id, item: 2 });
    editor.edit(Edit::RemoveCurveItem { shape: id, item: 0 });
    editor.choose(&["Insert", "Surface of Revolution from Curve"]);
    assert_eq!(kinds(&editor).len(), 1, "a curve in space is no profile");
}

#[test]
fn surfaces_are_made_from_any_curve_of_the_list() {
    let mut editor = with_set(three_curves());
    editor.click("1. profile");
    editor.click("Revolve 1. profile");
    editor.click("1. profile");
    editor.click("2. path");
    editor.choose(&["Sweep along 2. path", "Carry 3. ring"]);
    editor.choose(&["Sweep along 2. path", "Carry a new small circle"]);
    let sweep = |profile| CurveItemKind::Sweep { profile, sweep: 1 };
    let made = &kinds(&editor)[3..];
    assert!(matches!(
        made[0],
        CurveItemKind::Revolution { profile: 0, .. }
    ));
    assert_eq!(made[1], sweep(2));
    assert_eq!(made[3], sweep(5));
    editor.click("4. surface");
    editor.type_into("4. surface steps", "9");
    assert!(matches!(
        kinds(&editor)[3],
        CurveItemKind::Revolution { steps: 9, .. }
    ));
}

#[test]
fn a_curve_is_added_to_the_list_and_taken_out_with_its_surfaces() {
    let mut editor = with_set(three_curves());
    editor.choose(&["Add a curve", "Add circle"]);
    assert_eq!(kinds(&editor).len(), 4);
    editor.choose(&["Insert", "Surface of Revolution from Curve"]);
    editor.choose(&["Insert", "Sweep from Curves"]);
    editor.click("Remove 1. profile");
    let names: Vec<String> = curve(&editor)
        .curves()
        .items()
        .iter()
        .map(|item| item.name.clone())
        .collect();
    assert_eq!(names, ["path", "ring", "curve"]);
}

#[test]
fn exports_are_asked_of_the_program() {
    let mut editor = Editor::new();
    editor.choose(&["File", "Export Geometry…"]);
    assert!(editor.asked().is_empty(), "nothing to export");
    editor.choose(&["Insert", "Circle"]);
    editor.choose(&["File", "Export Curve…"]);
    editor.choose(&["File", "Export Geometry…"]);
    let expected = [Ask::ExportCurve(ShapeId(1)), Ask::ExportGeometry];
    assert_eq!(editor.asked(), expected);
}

/// Where a control point of the first curve is on the screen.
pub fn place(editor: &Editor, point: usize) -> Pos2 {
    let view = editor.harness.state().view;
    let camera = &editor.session().view().camera;
    let size = glam::Vec2::new(view.width(), view.height());
    let id = editor.shape().id;
    let shape = editor.session().evaluated().shape(id).unwrap();
    let world = shape
        .world_from_model
        .transform_point3(points(editor)[point]);
    let pixel = camera.pixel(world, size).unwrap();
    view.min + vec2(pixel.x, pixel.y)
}

impl Editor {
    pub fn press(&mut self, at: Pos2) {
        self.harness.state_mut().gestures = true;
        self.take(at);
    }

    pub fn release(&mut self, at: Pos2) {
        self.point(at);
        self.let_go(at);
    }
}

const FAR: Vec2 = vec2(-60.0, 45.0);

#[test]
fn a_control_point_is_dragged_in_the_view_and_nothing_else_moves() {
    let mut editor = with_curve("Bézier Curve");
    let (before, camera) = (points(&editor).to_vec(), editor.session().view().camera);
    let from = place(&editor, 3) + vec2(4.0, -3.0);
    editor.press(from);
    editor.point(from + FAR * 0.5);
    editor.release(from + FAR);
    let grip = place(&editor, 3) - (from + FAR);
    assert!((grip - vec2(-4.0, 3.0)).length() < 0.05, "{grip:?}");
    assert_eq!(points(&editor)[..3], before[..3]);
    assert_eq!(points(&editor)[3].z, 0.0, "flat seen from the front");
    assert_eq!(editor.session().view().camera, camera);
    assert!(editor.session().selected().is_some());
}

#[test]
fn beside_a_control_point_a_drag_moves_the_scene() {
    let mut editor = with_curve("Bézier Curve");
    let before = points(&editor).to_vec();
    let from = place(&editor, 3) + vec2(9.0, 0.0);
    editor.press(from);
    editor.release(from + FAR);
    assert_eq!(points(&editor), before);
    assert_ne!(editor.session().view().camera.target, Vec3::ZERO);
}

#[test]
fn esc_or_a_right_click_puts_the_curve_back_and_ends_the_gesture() {
    for cancelled_by_key in [true, false] {
        let mut editor = with_curve("Bézier Curve");
        let (before, camera) = (
            curve(&editor).curves().clone(),
            editor.session().view().camera,
        );
        let from = place(&editor, 0);
        editor.press(from);
        editor.point(from + FAR);
        assert_ne!(curve(&editor).curves(), &before);
        if cancelled_by_key {
            editor.key(Key::Escape);
        } else {
            for pressed in [true, false] {
                editor.harness.event(Event::PointerButton {
                    pos: from + FAR,
                    button: PointerButton::Secondary,
                    pressed,
                    modifiers: Modifiers::NONE,
                });
            }
            editor.settle();
        }
        assert_eq!(curve(&editor).curves(), &before);
        editor.point(from + FAR * 2.0);
        editor.release(from + FAR * 2.0);
        assert_eq!(curve(&editor).curves(), &before);
        assert_eq!(editor.session().view().camera, camera);
        assert!(editor.asked().is_empty(), "the program goes on");
        // And the next gesture is a new one.
        editor.press(from);
        editor.release(from + FAR);
        assert_ne!(curve(&editor).curves(), &before);
    }
}

#[test]
fn the_status_line_promises_delete_only_for_points_that_it_deletes() {
    let mut editor = with_curve("Bézier Curve");
    editor.harness.state_mut().gestures = true;
    let over = |editor: &mut Editor, point: usize| {
        let at = place(editor, point);
        editor.point(at);
        let texts = editor.painted().into_iter().map(|(text, _)| text);
        let mut hints = texts.filter(|text| text.starts_with("Drag to move it"));
        hints.next().unwrap_or_default()
    };
    assert!(
        over(&mut editor, 0).contains("cannot have fewer points"),
        "one piece"
    );
    editor.click("Add behind 1. curve point 4");
    for (point, says) in [
        (0, "Delete removes it"),
        (1, "deleted with the point on the curve beside it"),
        (3, "Delete removes it"),
    ] {
        let hint = over(&mut editor, point);
        assert!(hint.contains(says), "{point}: {hint}");
        editor.press(place(&editor, point));
        editor.release(place(&editor, point));
        let before = points(&editor).len();
        editor.key(Key::Delete);
        let deletes = points(&editor).len() < before;
        assert_eq!(deletes, says.starts_with("Delete"), "{point}");
        if deletes {
            editor.key_with(Modifiers::COMMAND, Key::Z);
        }
    }
}

#[test]
fn delete_is_about_the_point_that_was_dragged_also_after_the_drag_is_undone() {
    let mut editor = with_curve("Bézier Curve");
    editor.harness.state_mut().gestures = true;
    editor.click("Add behind 1. curve point 4");
    let count = points(&editor).len();
    let at = place(&editor, 3);
    editor.press(at);
    editor.release(at + vec2(30.0, 10.0));
    assert_ne!(place(&editor, 3), at);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(place(&editor, 3), at);
    editor.key(Key::Delete);
    assert!(
        points(&editor).len() < count,
        "of the shape, which is there"
    );
    editor.click("Edit");
    assert!(!editor.has("Delete Point"), "it is gone");
    editor.key(Key::Escape);
    editor.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(points(&editor).len(), count);
    editor.key(Key::Delete);
    assert!(points(&editor).len() < count, "the point again");
}

#[test]
fn the_point_under_the_pointer_is_marked_and_named_in_the_view_and_in_the_panel() {
    let mut editor = with_curve("Bézier Curve");
    editor.harness.state_mut().gestures = true;
    let at = place(&editor, 2);
    editor.point(at);
    assert_eq!(editor.session().hovered_control_point(), Some((0, 2)));
    assert!(editor.has("curve, control point 3"));
    editor.point(at + vec2(0.0, 40.0));
    assert_eq!(editor.session().hovered_control_point(), None);

    editor.reveal("1. curve point 2 X");
    let row = editor.widget("1. curve point 2 X").rect().center();
    editor.point(row);
    assert_eq!(editor.session().hovered_control_point(), Some((0, 1)));
    editor.choose(&["Insert", "Cube"]);
    assert_eq!(editor.session().hovered_control_point(), None);
}

#[test]
fn a_click_on_a_control_point_keeps_the_selection() {
    let mut editor = with_curve("Bézier Curve");
    let at = place(&editor, 1);
    editor.press(at);
    editor.release(at);
    assert_eq!(editor.session().selected(), Some(ShapeId(1)));
}

#[test]
fn hidden_control_points_are_not_grabbed() {
    let mut editor = with_curve("Bézier Curve");
    editor.click("Show Control Points");
    let (at, before) = (place(&editor, 0), points(&editor).to_vec());
    editor.press(at);
    editor.release(at + FAR);
    assert_eq!(points(&editor), before);
}

#[test]
fn a_curve_deleted_while_its_point_is_dragged_ends_the_gesture() {
    let mut editor = with_curve("Bézier Curve");
    let from = place(&editor, 0);
    editor.press(from);
    editor.point(from + FAR);
    editor.edit(Edit::Delete(ShapeId(1)));
    editor.point(from);
    editor.release(from);
    editor.view(View::Select(None));
    assert!(editor.session().scene().shapes().is_empty());
    assert!(!editor.harness.state().state.gesture_under_way());
}

#[test]
fn of_several_flat_curves_the_last_is_turned() {
    let mut set = three_curves();
    let last = set.items()[0].kind.clone();
    set.push("last", last).unwrap();
    let mut editor = with_set(set);
    editor.choose(&["Insert", "Surface of Revolution from Curve"]);
    let turned = CurveItemKind::Revolution {
        steps: 48,
        profile: 3,
    };
    assert_eq!(kinds(&editor)[4], turned);
}
