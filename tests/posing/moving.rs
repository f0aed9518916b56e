//! Roots and shapes held by the pointer.

use crate::posing::support::{SIZE, cameras, pixel, poses, session, transforms};
use editor_core::editor::{MoveAlong, MoveDrag, MoveTarget};
use editor_core::math::Ray;
use editor_core::scene::Camera;
use glam::{Vec2, Vec3};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

    #[test]
    fn a_root_follows_the_cursor_one_to_one_across_the_view_and_others_stay(
        camera in cameras(), transform in transforms(), pose in poses(), all in any::<bool>(),
        from in (0.2..0.8_f32, 0.2..0.8_f32), to in (0.2..0.8_f32, 0.2..0.8_f32),
    ) {
        let (mut session, id) = session(camera, transform, &pose);
        let root = MoveTarget::Root { shape: id, joint: 2 };
        let target = if all { root.all_roots() } else { root };
        let (from, to) = (SIZE * Vec2::from(from), SIZE * Vec2::from(to));
        let before = target.place(&session).unwrap();
        let along = MoveAlong::Plane(camera.forward());
        let mut drag = MoveDrag::begin(&session, target, along, &camera.ray(from, SIZE)).unwrap();
        let edit = drag.update(&camera.ray(to, SIZE), false);
        session.begin_gesture();
        session.edit(edit).unwrap();
        let after = target.place(&session).unwrap();
        let moved = pixel(&session, after).unwrap() - pixel(&session, before).unwrap();
        prop_assert!(moved.abs_diff_eq(to - from, 0.05), "{moved} {}", to - from);
        prop_assert!((camera.depth(after) - camera.depth(before)).abs() < 1e-4);
        let now = session.scene().character(id).unwrap().pose();
        let other = now.root_offset(3);
        if all {
            prop_assert!(other.abs_diff_eq(now.root_offset(0), 1e-6));
        } else {
            prop_assert_eq!(other, Vec3::ZERO);
        }
        for joint in 0..4 {
            prop_assert_eq!(now.rotation(joint), pose.rotation(joint));
        }
        session.cancel_gesture();
        prop_assert_eq!(session.scene().character(id).unwrap().pose(), &pose);
    }

    #[test]
    fn a_shape_moves_along_one_line_alone_if_that_is_asked_for(
        camera in cameras(), transform in transforms(), axis in 0..3_usize,
        to in (0.2..0.8_f32, 0.2..0.8_f32),
    ) {
        let (mut session, id) = session(camera, transform, &Default::default());
        let along = Vec3::AXES[axis];
        prop_assume!(camera.forward().dot(along).abs() < 0.95);
        let from = pixel(&session, transform.position).unwrap();
        let target = MoveTarget::Shape(id);
        let mut drag = MoveDrag::begin(&session, target, MoveAlong::Line(along), &camera.ray(from, SIZE)).unwrap();
        let edit = drag.update(&camera.ray(SIZE * Vec2::from(to), SIZE), false);
        session.edit(edit).unwrap();
        let now = session.scene().shape(id).unwrap().placement.transform;
        let moved = now.position - transform.position;
        prop_assert!(moved.reject_from(along).length() < 1e-5);
        prop_assert_eq!(now.rotation, transform.rotation);
        let edit = drag.update(&camera.ray(SIZE * Vec2::from(to), SIZE), true);
        session.edit(edit).unwrap();
        let steps = drag.moved().dot(along) / 0.1;
        prop_assert!((steps - steps.round()).abs() < 1e-3);
    }
}

#[test]
fn in_a_plane_of_two_axes_the_way_along_each_snaps_and_a_number_goes_along_the_first() {
    let (session, id) = session(Camera::default(), Default::default(), &Default::default());
    // In the plane z = 0, seen straight from the front.
    let (first, second) = (Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.8, 0.6, 0.0));
    let over = |along: f32, across: f32| Ray {
        origin: first * along + second * across + Vec3::Z * 5.0,
        direction: Vec3::NEG_Z,
    };
    let target = MoveTarget::Shape(id);
    let along = MoveAlong::Axes(first, second);
    let mut drag = MoveDrag::begin(&session, target, along, &over(0.0, 0.0)).unwrap();
    drag.update(&over(0.27, -0.46), true);
    let snapped = first * 0.3 - second * 0.5;
    assert!(drag.moved().abs_diff_eq(snapped, 1e-6), "{}", drag.moved());
    drag.update(&over(0.27, -0.46), false);
    let free = first * 0.27 - second * 0.46;
    assert!(drag.moved().abs_diff_eq(free, 1e-6), "{}", drag.moved());
    drag.moved_by(2.0);
    assert!(drag.moved().abs_diff_eq(first * 2.0, 1e-6));
}

#[test]
fn along_an_oblique_line_the_length_snaps_and_not_each_coordinate() {
    let (session, id) = session(Camera::default(), Default::default(), &Default::default());
    // A line in the plane z = 0, seen straight from the front.
    let along = Vec3::new(3.0, 4.0, 0.0);
    let over = |length: f32| Ray {
        origin: along / 5.0 * length + Vec3::Z * 5.0,
        direction: Vec3::NEG_Z,
    };
    let target = MoveTarget::Shape(id);
    let mut drag = MoveDrag::begin(&session, target, MoveAlong::Line(along), &over(0.0)).unwrap();
    for (length, snapped) in [
        (0.27, [0.18, 0.24, 0.0]),
        (0.04, [0.0; 3]),
        (-0.46, [-0.3, -0.4, 0.0]),
    ] {
        drag.update(&over(length), true);
        let (moved, snapped) = (drag.moved(), Vec3::from(snapped));
        assert!(moved.abs_diff_eq(snapped, 1e-6), "{length}: {moved}");
    }
}
