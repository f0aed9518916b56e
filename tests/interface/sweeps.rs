//! Insert ▸ Sweep from Curves with two selected shapes: which of them is carried along which.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::geometry::{Basis, Curve, CurveForm};
use editor_core::math::Transform;
use editor_core::scene::{CurveItemKind, CurveSet, CurveShape, NewShape, ShapeId, ShapeKind};
use egui::{Key, Modifiers};
use glam::Vec3;

const SWEEP: &[&str] = &["Insert", "Sweep from Curves"];

fn path() -> Curve {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    Curve::spline(Basis::BSpline, false, 8, points.to_vec()).unwrap()
}

fn ring() -> Curve {
    Curve::circle(12, 0.5).unwrap()
}

/// Shapes of one curve each, all selected, of which the one at index `active` is active; with their
/// identifiers.
fn with_curves(curves: &[Curve], active: usize) -> (Editor, Vec<ShapeId>) {
    let mut editor = Editor::new();
    for curve in curves {
        let mut set = CurveSet::new();
        set.push("curve", CurveItemKind::Curve(curve.clone()))
            .unwrap();
        let kind = ShapeKind::Curve(CurveShape::new(set));
        editor.edit(Edit::Insert(vec![NewShape::new("Curve", kind)]));
    }
    let shapes = editor.session().scene().shapes().iter();
    let ids: Vec<ShapeId> = shapes.map(|shape| shape.id).collect();
    editor.view(View::Select(None));
    let others = ids.iter().filter(|&&id| id != ids[active]);
    for &id in others.chain([&ids[active]]) {
        editor.view(View::ToggleSelected(id));
    }
    (editor, ids)
}

impl Editor {
    fn items(&self, shape: ShapeId) -> Vec<CurveItemKind> {
        let curve = self.session().scene().curve(shape).unwrap();
        let items = curve.curves().items().iter();
        items.map(|item| item.kind.clone()).collect()
    }
}

fn swept(path: Curve, profile: Curve) -> [CurveItemKind; 3] {
    let surface = CurveItemKind::Sweep {
        profile: 1,
        sweep: 0,
    };
    [
        CurveItemKind::Curve(path),
        CurveItemKind::Curve(profile),
        surface,
    ]
}

#[test]
fn of_two_selected_curves_the_flat_one_is_carried_along_the_other_whichever_is_active() {
    for active in [0, 1] {
        let (mut editor, ids) = with_curves(&[ring(), path()], active);
        editor.choose(SWEEP);
        assert_eq!(editor.items(ids[1]), swept(path(), ring()));
        assert_eq!(editor.items(ids[0]).len(), 1, "the profile stays");
        assert_eq!(editor.shape().id, ids[1], "what has the surface is shown");
        editor.key_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(editor.items(ids[1]).len(), 1, "it is one step");
    }
}

#[test]
fn of_two_flat_curves_the_active_one_is_the_path() {
    let flat = CurveSet::start_spline(Basis::Bezier);
    let flat = flat.curve(0).unwrap();
    let (mut editor, ids) = with_curves(&[flat.clone(), ring()], 0);
    editor.choose(SWEEP);
    assert_eq!(editor.items(ids[0]), swept(flat.clone(), ring()));
    let (mut editor, ids) = with_curves(&[flat.clone(), ring()], 1);
    editor.choose(SWEEP);
    assert_eq!(editor.items(ids[1]), swept(ring(), flat.clone()));
}

#[test]
fn a_profile_is_carried_as_large_as_its_shape_shows_it() {
    let scaled = |scale| {
        let (mut editor, ids) = with_curves(&[ring(), path()], 1);
        let transform = Transform {
            position: Vec3::splat(7.0),
            scale,
            ..Transform::IDENTITY
        };
        editor.edit(Edit::SetTransform(ids[0], transform));
        editor.choose(SWEEP);
        editor.items(ids[1])
    };
    let CurveItemKind::Curve(profile) = &scaled(Vec3::splat(0.2))[1] else {
        panic!("the profile comes before the surface");
    };
    assert!(matches!(profile.form(), CurveForm::Circle { radius } if (radius - 0.1).abs() < 1e-6));
    let uneven = scaled(Vec3::new(2.0, 1.0, 1.0));
    assert_eq!(uneven.len(), 1, "an ellipse is no curve of the course");
}

#[test]
fn where_no_curve_can_be_carried_the_key_says_why() {
    for (curves, why) in [
        (
            &[path(), path()][..],
            "Neither of the selected curves lies in the plane z = 0, as the one that is carried must",
        ),
        (
            &[path(), ring(), ring()],
            "More than two curves are selected: one is carried along the other",
        ),
    ] {
        let (mut editor, ids) = with_curves(curves, 0);
        editor.key_with(Modifiers::SHIFT, Key::W);
        assert!(ids.iter().all(|&id| editor.items(id).len() == 1));
        let fresh = editor.session().messages.fresh();
        assert_eq!(fresh.last().map(|told| &*told.text), Some(why));
    }
}

#[test]
fn a_surface_that_is_there_already_is_not_made_again_and_the_key_says_so() {
    for (curves, key) in [
        (&[ring()][..], Key::V),
        (&[ring(), path()], Key::W),
        (&[path(), ring()], Key::W),
    ] {
        let (mut editor, _) = with_curves(curves, 0);
        editor.key_with(Modifiers::SHIFT, key);
        let made = editor.session().document();
        assert!(editor.session().messages.fresh().is_empty());
        editor.key_with(Modifiers::SHIFT, key);
        let fresh = editor.session().messages.fresh();
        let told = fresh.last().map(|told| &*told.text);
        assert_eq!(told, Some("The curve has this surface already"));
        assert_eq!(editor.session().document(), made);
    }
}
