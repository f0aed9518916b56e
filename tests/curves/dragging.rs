//! A grabbed control point stays under the pointer, whatever the view and the placement.

use editor_core::editor::{ControlPointDrag, Edit, Session, View};
use editor_core::geometry::{Basis, Curve};
use editor_core::math::{Euler, Transform};
use editor_core::scene::NewShape;
use editor_core::scene::{Camera, CurveItemKind, CurveSet, CurveShape, ShapeKind};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

const SIZE: Vec2 = Vec2::new(520.0, 560.0);
/// How far the point may be from where it is held, in pixels.
const TOLERANCE: f32 = 0.05;

fn vector(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(range).prop_map(Vec3::from_array)
}

fn cameras() -> impl Strategy<Value = Camera> {
    (
        vector(-1.0..1.0),
        1.0..20.0_f32,
        -3.1..3.1_f32,
        -1.47..1.47_f32,
    )
        .prop_map(|(target, radius, theta, phi)| Camera {
            target,
            radius,
            theta,
            phi,
            ..Camera::default()
        })
}

fn transforms() -> impl Strategy<Value = Transform> {
    (vector(-2.0..2.0), vector(-180.0..180.0), vector(0.1..10.0)).prop_map(
        |(position, degrees, scale)| Transform {
            position,
            rotation: Euler::from_degrees(degrees),
            scale,
        },
    )
}

fn session(camera: Camera, transform: Transform, flat: bool, points: [Vec3; 4]) -> Session {
    let mut set = CurveSet::new();
    let curve = Curve::spline(Basis::Bezier, flat, 4, points.to_vec()).unwrap();
    set.push("curve", CurveItemKind::Curve(curve)).unwrap();
    let mut session = Session::new();
    session
        .edit(Edit::Insert(vec![NewShape::new(
            "Curve",
            ShapeKind::Curve(CurveShape::new(set)),
        )]))
        .unwrap();
    let id = session.selected().unwrap();
    session.edit(Edit::SetTransform(id, transform)).unwrap();
    session.look(View::SetCamera(camera));
    session
}

fn world(session: &Session, point: usize) -> Vec3 {
    let id = session.selected().unwrap();
    let curves = session.scene().curve(id).unwrap().curves();
    let shape = session.evaluated().shape(id).unwrap();
    let model = curves.curve(0).unwrap().control_points()[point];
    shape.world_from_model.transform_point3(model)
}

fn pixel(session: &Session, point: usize) -> Option<Vec2> {
    session
        .view()
        .camera
        .pixel(world(session, point), SIZE)
        .filter(|p| p.cmpge(Vec2::ZERO).all() && p.cmple(SIZE).all())
}

proptest! {
    #![proptest_config(ProptestConfig {
        // Some points lie outside the picture.
        max_global_rejects: 100_000,
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::with_cases(2000)
    })]

    #[test]
    fn a_grabbed_control_point_stays_under_the_pointer(
        camera in cameras(),
        transform in transforms(),
        flat: bool,
        points in prop::array::uniform4(vector(-1.0..1.0)),
        which in 0..4_usize,
        grip in prop::array::uniform2(-5.0..5.0_f32),
        path in prop::collection::vec((0.0..1.0_f32, 0.0..1.0_f32), 1..6),
    ) {
        let mut session = session(camera, transform, flat, points);
        let at = pixel(&session, which);
        prop_assume!(at.is_some() && camera.is_in_depth(world(&session, which)));
        let before = world(&session, which);
        let at = at.unwrap_or_default();
        let pressed = at + Vec2::from_array(grip);
        let drag = ControlPointDrag::begin(&session, pressed, SIZE);
        let drag = drag.expect("a point within reach is grabbed");
        let (_, held) = drag.control_point();
        // It may lie just outside of the picture.
        let grip = camera.pixel(world(&session, held), SIZE).unwrap_or(at) - pressed;
        let (held_before, depth_before) = (world(&session, held), camera.depth(world(&session, held)));
        let document = session.document();
        session.begin_gesture();
        for (x, y) in path {
            let pointer = Vec2::new(x, y) * SIZE;
            let Some(edit) = drag.moved_to(&session, pointer, SIZE) else {
                prop_assert!(flat, "only a plane seen at a slant can be out of reach");
                continue;
            };
            session.edit(edit).unwrap();
            let now = camera.pixel(world(&session, held), SIZE).expect("before the eye");
            prop_assert!(
                (now - pointer - grip).length() < TOLERANCE,
                "{now} held at {pointer} by {grip}"
            );
            if !flat {
                let depth = camera.depth(world(&session, held));
                prop_assert!((depth - depth_before).abs() < 1e-4 * depth_before.max(1.0));
            }
        }
        prop_assert!(session.messages.history().is_empty());
        session.cancel_gesture();
        prop_assert_eq!(session.document(), document);
        prop_assert_eq!(world(&session, held), held_before);
        prop_assert_eq!(world(&session, which), before);
    }
}

#[test]
fn a_flat_curve_seen_from_its_edge_stays_where_it_is() {
    let camera = Camera::preset(editor_core::scene::ViewDirection::PlusX);
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.0, -0.5, 0.0)];
    let session = session(camera, Transform::IDENTITY, true, points);
    let at = pixel(&session, 3).unwrap();
    let drag = ControlPointDrag::begin(&session, at, SIZE).unwrap();
    assert!(drag.moved_to(&session, at + Vec2::X, SIZE).is_none());
}

#[test]
fn a_plane_seen_at_less_than_a_degree_is_out_of_reach_and_at_two_degrees_it_is_not() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    for (degrees, moves) in [(0.5_f32, false), (2.0, true), (-0.5, false), (-2.0, true)] {
        // At 0° the eye is on the x axis.
        let camera = Camera {
            theta: degrees.to_radians(),
            ..Camera::default()
        };
        let session = session(camera, Transform::IDENTITY, true, points);
        let drag = ControlPointDrag::begin(&session, SIZE * 0.5, SIZE).unwrap();
        let edit = drag.moved_to(&session, SIZE * 0.5 + Vec2::Y, SIZE);
        assert_eq!(edit.is_some(), moves, "{degrees}°: {edit:?}");
    }
}

#[test]
fn a_plane_that_the_pointer_meets_behind_the_eye_is_out_of_reach() {
    // From a little above a ground at y = -1, the horizon is in the middle of the picture.
    let ground = Transform {
        position: Vec3::NEG_Y,
        rotation: Euler::from_degrees(Vec3::new(90.0, 0.0, 0.0)),
        ..Transform::IDENTITY
    };
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    let session = session(Camera::default(), ground, true, points);
    let at = pixel(&session, 0).unwrap();
    assert!(at.y > 280.0, "{at}");
    let drag = ControlPointDrag::begin(&session, at, SIZE).unwrap();
    for (y, moves) in [(400.0, true), (160.0, false), (20.0, false)] {
        let edit = drag.moved_to(&session, Vec2::new(260.0, y), SIZE);
        assert_eq!(edit.is_some(), moves, "{y}: {edit:?}");
    }
}

#[test]
fn the_points_of_a_profile_stay_in_its_plane_and_others_move_across_the_view() {
    // From the side, but not wholly.
    let theta = 20.0_f32.to_radians();
    let camera = Camera {
        theta,
        ..Camera::default()
    };
    let points = [Vec3::X, Vec3::ONE.with_z(0.0), Vec3::Y, Vec3::ZERO];
    let curve = Curve::spline(Basis::Bezier, false, 4, points.to_vec()).unwrap();
    for is_profile in [false, true] {
        let mut set = CurveSet::new();
        set.push("curve", CurveItemKind::Curve(curve.clone()))
            .unwrap();
        if is_profile {
            let (steps, profile) = (8, 0);
            set.push("vase", CurveItemKind::Revolution { steps, profile })
                .unwrap();
        }
        let mut session = Session::new();
        let shape = ShapeKind::Curve(CurveShape::new(set));
        let insert = Edit::Insert(vec![NewShape::new("Curve", shape)]);
        session.edit(insert).unwrap();
        session.look(View::SetCamera(camera));
        let drag = ControlPointDrag::begin(&session, SIZE * 0.5, SIZE).unwrap();
        let edit = drag.moved_to(&session, SIZE * 0.5 + Vec2::X * 50.0, SIZE);
        let Some(Edit::SetControlPoint { position, .. }) = edit else {
            panic!("{edit:?}")
        };
        // To the right is towards +x and -z.
        assert!(position.x > 0.05, "{position}");
        if is_profile {
            assert_eq!(position.z, 0.0);
        } else {
            let off = position.z + position.x / theta.tan();
            assert!(off.abs() < 1e-5, "{position}");
        }
    }
}

#[test]
fn a_new_curve_is_drawn_flat_in_a_view_that_looks_down_a_little() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.4, 0.3, 0.0)];
    let camera = Camera {
        theta: 1.2,
        phi: 0.3,
        ..Camera::default()
    };
    for (lifted, stays_flat) in [(0.0, true), (0.1, false)] {
        let mut points = points;
        points[0].z = lifted;
        let mut session = session(camera, Transform::IDENTITY, false, points);
        let at = pixel(&session, 3).unwrap();
        let drag = ControlPointDrag::begin(&session, at, SIZE).unwrap();
        let moved = at + Vec2::new(-25.0, -40.0);
        let edit = drag.moved_to(&session, moved, SIZE).unwrap();
        session.edit(edit).unwrap();
        assert_eq!(world(&session, 3).z == 0.0, stays_flat, "{lifted}");
        assert!(pixel(&session, 3).unwrap().abs_diff_eq(moved, 0.01));
    }
}

#[test]
fn a_shape_flattened_to_nothing_does_not_lose_its_points() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    for flat in [false, true] {
        let transform = Transform {
            scale: Vec3::ZERO,
            ..Transform::IDENTITY
        };
        let session = session(Camera::default(), transform, flat, points);
        if let Some(drag) = ControlPointDrag::begin(&session, SIZE * 0.5, SIZE) {
            assert!(drag.moved_to(&session, Vec2::ONE, SIZE).is_none());
        }
    }
}

#[test]
fn a_curve_drawn_in_a_straight_view_stays_flat_to_the_last_bit() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(1.0, 1.0, 0.0)];
    let mut session = session(Camera::default(), Transform::IDENTITY, false, points);
    let at = pixel(&session, 3).unwrap();
    let drag = ControlPointDrag::begin(&session, at, SIZE).unwrap();
    for step in 1..100 {
        let pointer = at + Vec2::new(-1.3, 0.7) * step as f32;
        let edit = drag.moved_to(&session, pointer, SIZE).unwrap();
        session.edit(edit).unwrap();
        assert_eq!(world(&session, 3).z, 0.0);
    }
}

#[test]
fn along_the_view_a_point_keeps_every_bit_in_a_shape_that_is_moved_and_scaled_too() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.4, 0.3, 0.123)];
    let placed = Transform {
        position: Vec3::new(0.31, -0.17, 0.73),
        scale: Vec3::new(0.7, 1.3, 1.1),
        ..Transform::IDENTITY
    };
    let session = session(Camera::default(), placed, false, points);
    let at = pixel(&session, 3).unwrap();
    let drag = ControlPointDrag::begin(&session, at, SIZE).unwrap();
    for step in 1..100 {
        let pointer = at + Vec2::new(-1.3, 0.7) * step as f32;
        let edit = drag.moved_to(&session, pointer, SIZE);
        let Some(Edit::SetControlPoint { position, .. }) = edit else {
            panic!("{edit:?}")
        };
        assert_eq!(position.z, 0.123, "step {step}");
        assert!(position.x < 0.4 && position.y < 0.3, "{position}");
    }
}
