//! A bone held by the pointer.

use crate::posing::support::{
    SIZE, cameras, pixel, poses, session, transforms, vector, world_from_joint,
};
use editor_core::editor::{BoneDrag, Edit, RingDrag, Session, Together, roll};
use editor_core::math::Ray;
use editor_core::scene::{Camera, ShapeId, bones_in_world};
use glam::{DMat4, DVec2, DVec3, Mat3, Vec2, Vec3};
use proptest::prelude::*;

/// How far beside the half-line from the joint to the cursor a point may be, in pixels.
const TOLERANCE: f64 = 0.01;

/// Where a point is in the picture, in double precision: single precision alone is off by more
/// than the tolerance here and there.
fn exact_pixel(camera: &Camera, world: DVec3) -> Option<DVec2> {
    let (right, up, eye) = (
        camera.right().as_dvec3(),
        camera.up().as_dvec3(),
        camera.eye().as_dvec3(),
    );
    let forward = up.cross(right);
    let offset = world - eye;
    let depth = offset.dot(forward);
    let scale = f64::from(SIZE.y) * 0.5 / (f64::from(camera.fovy) * 0.5).tan() / depth;
    let from_middle = DVec2::new(offset.dot(right), -offset.dot(up)) * scale;
    (depth > 0.1).then(|| SIZE.as_dvec2() * 0.5 + from_middle)
}

fn frame(session: &Session, id: ShapeId, joint: usize) -> DMat4 {
    world_from_joint(session, id, joint).as_dmat4()
}

fn beside_half_line(at: DVec2, from: DVec2, through: DVec2) -> f64 {
    let along = (through - from).normalize_or_zero();
    let offset = at - from;
    (offset - along * offset.dot(along).max(0.0)).length()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

    #[test]
    fn the_grabbed_point_comes_to_lie_on_the_half_line_from_the_joint_to_the_cursor(
        camera in cameras(), transform in transforms(), pose in poses(), joint in 0..4_usize,
        along in 0.2..1.0_f32, cursor in (0.0..1.0_f32, 0.0..1.0_f32), way in (0.0..1.0_f32, 0.0..1.0_f32),
    ) {
        let (mut session, id) = session(camera, transform, &pose);
        let shape = session.evaluated().shape(id).unwrap();
        let (_, start, end) = bones_in_world(session.scene(), shape).nth(joint).unwrap();
        let grabbed = start.lerp(end, along);
        let in_joint = frame(&session, id, joint).inverse().transform_point3(grabbed.as_dvec3());
        let (way, cursor) = (SIZE * Vec2::from(way), SIZE * Vec2::from(cursor));
        let center = exact_pixel(&camera, start.as_dvec3());
        let held = exact_pixel(&camera, grabbed.as_dvec3());
        prop_assume!(center.is_some() && held.is_some());
        let (center, held) = (center.unwrap(), held.unwrap());
        // A cursor or a grip on the joint says nothing about a direction.
        prop_assume!(center.distance(cursor.as_dvec2()) > 3.0 && center.distance(held) > 3.0);
        let mut drag = BoneDrag::begin(&session, id, joint, (camera.eye(), grabbed), Together::Every).unwrap();
        for at in [way, cursor] {
            if let Some(edit) = drag.update(&session, &camera.ray(at, SIZE), false) {
                session.edit(edit).unwrap();
            }
        }
        let now = frame(&session, id, joint).transform_point3(in_joint);
        // Behind the eye it has no place in the picture.
        let Some(at) = exact_pixel(&camera, now) else { return Ok(()) };
        // In single precision a place far from the middle of the picture is known less well.
        let scale = 1.0 + center.distance(at) / 500.0;
        let off = beside_half_line(at, center, cursor.as_dvec2());
        prop_assert!(off <= TOLERANCE * scale, "{off} pixels beside");
    }

    #[test]
    fn a_drag_leaves_the_joint_and_everything_above_it_where_it_was(
        camera in cameras(), transform in transforms(), pose in poses(), cursor in (0.0..1.0_f32, 0.0..1.0_f32),
    ) {
        let (mut session, id) = session(camera, transform, &pose);
        let before = [0, 1, 3].map(|joint| world_from_joint(&session, id, joint));
        let start = world_from_joint(&session, id, 2).w_axis;
        let shape = session.evaluated().shape(id).unwrap();
        let (.., end) = bones_in_world(session.scene(), shape).nth(2).unwrap();
        let mut drag = BoneDrag::begin(&session, id, 2, (camera.eye(), end), Together::Every).unwrap();
        session.begin_gesture();
        let ray = camera.ray(SIZE * Vec2::from(cursor), SIZE);
        if let Some(edit) = drag.update(&session, &ray, false) {
            session.edit(edit).unwrap();
        }
        prop_assert!(world_from_joint(&session, id, 2).w_axis.abs_diff_eq(start, 1e-6));
        prop_assert_eq!(before, [0, 1, 3].map(|joint| world_from_joint(&session, id, joint)));
        session.cancel_gesture();
        prop_assert_eq!(session.scene().character(id).unwrap().pose(), &pose);
    }

    #[test]
    fn a_rolled_bone_keeps_its_direction_and_turns_by_the_angle(
        transform in transforms(), pose in poses(), joint in 0..4_usize, angle in -3.0..3.0_f32,
    ) {
        let (mut session, id) = session(Camera::default(), transform, &pose);
        let ends = |session: &Session| {
            let shape = session.evaluated().shape(id).unwrap();
            bones_in_world(session.scene(), shape).nth(joint).unwrap()
        };
        let before = ends(&session);
        let rotation = |session: &Session| session.scene().character(id).unwrap().pose().rotation(joint).to_mat3();
        let was = rotation(&session);
        let edit = roll(&session, id, joint, angle).unwrap();
        session.edit(edit).unwrap();
        let after = ends(&session);
        prop_assert!(after.1.abs_diff_eq(before.1, 1e-5) && after.2.abs_diff_eq(before.2, 1e-5));
        let turn: Mat3 = rotation(&session) * was.transpose();
        let cos = ((turn.x_axis.x + turn.y_axis.y + turn.z_axis.z - 1.0) * 0.5).clamp(-1.0, 1.0);
        prop_assert!((cos - angle.cos()).abs() < 1e-4);
    }

    #[test]
    fn a_ring_turns_about_its_axis_alone_by_what_the_cursor_says(
        camera in cameras(), pose in poses(), axis in vector(-1.0..1.0), angle in -2.5..2.5_f32,
    ) {
        let (mut session, id) = session(camera, Default::default(), &pose);
        let axis = axis.try_normalize();
        prop_assume!(axis.is_some());
        let axis = axis.unwrap();
        let center = world_from_joint(&session, id, 1).w_axis.truncate();
        let towards = (center - camera.eye()).normalize_or(Vec3::Z);
        // Seen flatter a ring is pulled along like a thread.
        prop_assume!(towards.dot(axis).abs() > 0.3);
        let arm = axis.any_orthonormal_vector() * 0.2;
        let turned = glam::Quat::from_axis_angle(axis, angle) * arm;
        let through = |point: Vec3| camera.ray(pixel(&session, point).unwrap(), SIZE);
        let (from, to) = (through(center + arm), through(center + turned));
        let mut drag = RingDrag::begin(&session, id, 1, axis, (center + arm, &from), Together::Every).unwrap();
        let before = world_from_joint(&session, id, 1);
        let edit = drag.update(&session, &to, false).unwrap();
        session.edit(edit).unwrap();
        prop_assert!((drag.angle() as f32 - angle).abs() < 2e-3, "{} {angle}", drag.angle());
        let after = world_from_joint(&session, id, 1);
        for column in [Vec3::X, Vec3::Y, Vec3::Z] {
            let expected = glam::Quat::from_axis_angle(axis, angle) * before.transform_vector3(column);
            prop_assert!(after.transform_vector3(column).abs_diff_eq(expected, 3e-3));
        }
        let edit = drag.update(&session, &to, true).unwrap();
        session.edit(edit).unwrap();
        let steps = drag.angle().to_degrees() / 15.0;
        prop_assert!((steps - steps.round()).abs() < 1e-9);
    }
}

#[test]
fn a_ring_seen_edge_on_turns_the_way_in_which_it_is_pulled() {
    // Joint 1 is at (0.2, 0.3, 0), on a level with the eye before it.
    let center = Vec3::new(0.2, 0.3, 0.0);
    let camera = Camera {
        target: center,
        ..Camera::default()
    };
    let (session, id) = session(camera, Default::default(), &Default::default());
    let through = |point: Vec3| Ray {
        origin: camera.eye(),
        direction: point - camera.eye(),
    };
    // About y a turn to the left brings z to x: its front goes to the right, its back to the left.
    for (side, pulled, angle) in [
        (Vec3::Z, Vec3::X, 0.5),
        (Vec3::Z, Vec3::NEG_X, -0.5),
        (Vec3::NEG_Z, Vec3::X, -0.5),
    ] {
        let grabbed = center + side * 0.2;
        let (from, to) = (through(grabbed), through(grabbed + pulled * 0.1));
        let mut drag =
            RingDrag::begin(&session, id, 1, Vec3::Y, (grabbed, &from), Together::Every).unwrap();
        let edit = drag.update(&session, &to, false).unwrap();
        assert!((drag.angle() - angle).abs() < 1e-5, "{}", drag.angle());
        let Edit::SetJointTransform { rotation, .. } = edit else {
            panic!("{edit:?}")
        };
        let about_y = Vec3::Y * angle as f32;
        assert!(
            rotation.radians.abs_diff_eq(about_y, 1e-5),
            "{side} pulled to {pulled}: {}",
            rotation.radians
        );
    }
}

#[test]
fn a_cursor_on_the_joint_turns_nothing() {
    let camera = Camera::default();
    let (session, id) = session(camera, Default::default(), &Default::default());
    let center = world_from_joint(&session, id, 1).w_axis.truncate();
    let mut drag = BoneDrag::begin(
        &session,
        id,
        1,
        (camera.eye(), center + Vec3::Y * 0.1),
        Together::Every,
    )
    .unwrap();
    let ray = camera.ray(pixel(&session, center).unwrap(), SIZE);
    let edit = drag.update(&session, &ray, false).unwrap();
    let Edit::SetJointTransform { rotation, .. } = edit else {
        panic!("{edit:?}")
    };
    assert!(rotation.radians.abs_diff_eq(Vec3::ZERO, 1e-7));
}

#[test]
fn a_shape_scaled_to_nothing_cannot_be_dragged_and_nothing_panics() {
    let camera = Camera::default();
    let flat = editor_core::math::Transform {
        scale: Vec3::new(1.0, 0.0, 1.0),
        ..Default::default()
    };
    let (session, id) = session(camera, flat, &Default::default());
    assert!(BoneDrag::begin(&session, id, 1, (camera.eye(), Vec3::Y), Together::Every).is_none());
    assert!(
        BoneDrag::begin(
            &session,
            ShapeId(99),
            1,
            (camera.eye(), Vec3::Y),
            Together::Every
        )
        .is_none()
    );
    assert!(BoneDrag::begin(&session, id, 99, (camera.eye(), Vec3::Y), Together::Every).is_none());
}
