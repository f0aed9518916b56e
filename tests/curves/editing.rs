use crate::curves::support::read;
use editor_core::editor::{Edit, Session};
use editor_core::geometry::Basis;
use editor_core::scene::NewShape;
use editor_core::scene::{
    CurveDisplay, CurveSet, CurveShape, CurveVisibility, ShapeId, ShapeKind, SurfaceVisibility,
};
use glam::Vec3;
use std::sync::Arc;

fn session(set: CurveSet) -> (Session, ShapeId) {
    let mut session = Session::new();
    let insert = Edit::Insert(vec![NewShape::new(
        "Curve",
        ShapeKind::Curve(CurveShape::new(set)),
    )]);
    session.edit(insert).unwrap();
    let id = session.selected().unwrap();
    (session, id)
}

fn curves(session: &Session, id: ShapeId) -> &CurveSet {
    session.scene().curve(id).unwrap().curves()
}

fn set_point(shape: ShapeId, curve: usize, point: usize, position: Vec3) -> Edit {
    Edit::SetControlPoint {
        shape,
        curve,
        point,
        position,
    }
}

#[test]
fn a_new_shape_of_curves_is_light_gray() {
    let (session, id) = session(CurveSet::start_circle());
    assert_eq!(session.scene().shape(id).unwrap().kind.start_color(), 30);
}

#[test]
fn moving_a_control_point_moves_the_curve_and_its_surface_at_once() {
    let text = "bez2 a 8 4 [1 0] [1 1] [1 2] [1 3] srev s 12 a";
    let (mut session, id) = session(read(text).unwrap());
    let before = session.evaluated().shape(id).unwrap().geometry.clone();
    session
        .edit(set_point(id, 0, 0, Vec3::new(2.0, 0.0, 7.0)))
        .unwrap();
    let after = &session.evaluated().shape(id).unwrap().geometry;
    assert_ne!(before.revision, after.revision);
    // A flat curve stays flat.
    let start = Vec3::new(2.0, 0.0, 0.0);
    assert_eq!(
        after.curves.as_ref().unwrap().curves[0].points[0].position,
        start
    );
    assert_eq!(after.mesh.positions[0], start);
}

#[test]
fn an_edit_that_changes_nothing_evaluates_nothing() {
    let (mut session, id) = session(CurveSet::start_spline(Basis::Bezier));
    let before = session.evaluated().shape(id).unwrap().geometry.clone();
    let there = curves(&session, id).curve(0).unwrap().control_points()[1];
    session.edit(set_point(id, 0, 1, there)).unwrap();
    let after = session.evaluated().shape(id).unwrap();
    assert!(Arc::ptr_eq(&before, &after.geometry));
}

#[test]
fn a_closed_curve_stays_closed_when_one_of_its_repeated_points_is_moved() {
    let b_spline = "bsp2 a 5 7 [0 0] [1 0] [1 1] [0 1] [0 0] [1 0] [1 1]";
    let bezier = "bez2 a 5 4 [0 0] [1 0] [1 1] [0 0]";
    for (text, moved, twin) in [
        (b_spline, 1, 5),
        (b_spline, 6, 2),
        (bezier, 0, 3),
        (bezier, 3, 0),
    ] {
        let (mut session, id) = session(read(text).unwrap());
        let place = Vec3::new(-3.0, 4.0, 0.0);
        session.edit(set_point(id, 0, moved, place)).unwrap();
        let points = curves(&session, id).curve(0).unwrap().control_points();
        assert_eq!((points[moved], points[twin]), (place, place));
        assert_eq!(points.iter().filter(|&&p| p == place).count(), 2);
    }
}

#[test]
fn a_profile_cannot_be_dragged_out_of_its_plane() {
    let text = "bez3 a 5 4 [0 0 0] [1 0 0] [1 1 0] [0 1 0] srev s 5 a";
    let (mut session, id) = session(read(text).unwrap());
    session.edit(set_point(id, 0, 2, Vec3::ONE)).unwrap();
    let points = curves(&session, id).curve(0).unwrap().control_points();
    assert_eq!(points[2], Vec3::new(1.0, 1.0, 0.0));
}

#[test]
fn steps_and_radius_can_be_changed() {
    let (mut session, id) = session(read("circ a 5 1 srev s 7 a").unwrap());
    for edit in [
        Edit::SetSteps {
            shape: id,
            item: 0,
            steps: 9,
        },
        Edit::SetSteps {
            shape: id,
            item: 1,
            steps: 11,
        },
        Edit::SetRadius {
            shape: id,
            curve: 0,
            radius: 3.0,
        },
    ] {
        session.edit(edit).unwrap();
    }
    assert_eq!(
        curves(&session, id),
        &read("circ a 9 3 srev s 11 a").unwrap()
    );
}

#[test]
fn a_refused_change_says_why_and_changes_nothing() {
    let (mut session, id) = session(read("circ a 5 1 srev s 7 a").unwrap());
    let before = curves(&session, id).clone();
    let edit = Edit::SetSteps {
        shape: id,
        item: 1,
        steps: 0,
    };
    let document = session.document();
    let refused = session.edit(edit).unwrap_err();
    assert_eq!(refused.to_string(), "expected 1 to 10000 steps, found 0");
    assert_eq!(curves(&session, id), &before);
    assert_eq!(session.document(), document);
}

#[test]
fn surfaces_are_made_from_curves_of_the_shape() {
    let (mut session, id) = session(CurveSet::start_spline(Basis::BSpline));
    let revolution = Edit::MakeSurfaceOfRevolution {
        shape: id,
        profile: 0,
        steps: 20,
    };
    session.edit(revolution).unwrap();
    let tube = Edit::MakeSweep {
        shape: id,
        profile: None,
        sweep: 0,
    };
    session.edit(tube).unwrap();
    let names: Vec<&str> = curves(&session, id)
        .items()
        .iter()
        .map(|item| &*item.name)
        .collect();
    assert_eq!(names, ["curve", "surface", "tube", "surface2"]);
    let geometry = &session.evaluated().shape(id).unwrap().geometry;
    assert_eq!(geometry.curves.as_ref().unwrap().surfaces.len(), 2);
    assert!(session.messages.history().is_empty());
}

#[test]
fn a_curve_in_space_is_no_profile() {
    let text = "bez3 a 5 4 [0 0 0] [1 0 0] [1 1 0] [0 1 1]";
    let (mut session, id) = session(read(text).unwrap());
    let edit = Edit::MakeSurfaceOfRevolution {
        shape: id,
        profile: 0,
        steps: 20,
    };
    let refused = session.edit(edit).unwrap_err();
    assert_eq!(curves(&session, id).items().len(), 1);
    assert!(refused.to_string().contains("plane z = 0"), "{refused}");
}

#[test]
fn display_and_frame_closing_are_set_without_changing_the_curves() {
    let (mut session, id) = session(CurveSet::start_circle());
    let display = CurveDisplay {
        control_points: false,
        curve: CurveVisibility::OnWithFrames,
        surface: SurfaceVisibility::WireframeWithNormals,
    };
    session.edit(Edit::SetCurveDisplay(id, display)).unwrap();
    session.edit(Edit::SetFrameClosing(id, false)).unwrap();
    let shape = session.scene().curve(id).unwrap();
    assert_eq!(shape.display, display);
    assert!(!shape.frame_closing());
    assert_eq!(shape.curves(), &CurveSet::start_circle());
}

#[test]
fn edits_of_what_does_not_exist_do_nothing() {
    let (mut session, id) = session(CurveSet::start_circle());
    session
        .edit(set_point(ShapeId(99), 0, 0, Vec3::ONE))
        .unwrap();
    // A circle has no control points, and there is no tenth curve.
    for curve in [0, 9] {
        let edited = session.edit(set_point(id, curve, 0, Vec3::ONE));
        assert!(edited.is_err() || edited.is_ok_and(|change| change.is_nothing()));
    }
    assert_eq!(curves(&session, id), &CurveSet::start_circle());
}
