//! Whole shapes turned and scaled together, by the pointer and by numbers.

use crate::posing::support::{SIZE, cameras, pixel, transforms, vector};
use editor_core::editor::{
    Constraint, Edit, GizmoAxes, Handle, RotationGizmo, ScaleBy, ScaleGizmo, Session, ShapeGroup,
    ShapeScale, ShapeTurn, View,
};
use editor_core::geometry::{Mesh, SharedMesh};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{Camera, NewShape, ShapeId, ShapeKind};
use glam::{DVec3, Mat3, Vec2, Vec3};
use proptest::prelude::*;

/// Cubes at these places, all selected, the last of them active.
fn cubes(camera: Camera, places: &[Transform]) -> Session {
    let mut session = Session::new();
    let cube = |&transform: &Transform| {
        let mut new = NewShape::new("Cube", ShapeKind::Cube);
        new.placement.transform = transform;
        new.placement.uniform_scaling = false;
        new
    };
    session
        .edit(Edit::Insert(places.iter().map(cube).collect()))
        .unwrap();
    session.look(View::SetCamera(camera));
    session
}

fn places(session: &Session) -> Vec<Transform> {
    let shapes = session.scene().shapes().iter();
    shapes.map(|shape| shape.placement.transform).collect()
}

fn group(session: &Session) -> ShapeGroup {
    ShapeGroup::of_selected(session).expect("shapes are selected")
}

/// Where rings cross, the pointer can go along the one that faces the eye alone.
#[test]
fn at_the_top_and_at_the_side_of_the_ring_that_faces_the_eye_it_is_that_which_is_hit() {
    let camera = Camera {
        theta: 1.3,
        phi: 0.15,
        ..Camera::default()
    };
    for camera in [Camera::default(), camera] {
        let session = cubes(camera, &[Transform::IDENTITY]);
        let rings = RotationGizmo::of_shapes(&session, GizmoAxes::World, SIZE).unwrap();
        let sight = camera.eye();
        let axis = sight.abs().max_position();
        let front = rings.ring(axis).iter().filter(|point| point.front);
        let mut count = 0;
        for point in front {
            let hit = rings.hit(point.pixel).map(|hit| hit.handle);
            assert_eq!(hit, Some(Handle::Ring(axis)), "{camera:?} {point:?}");
            count += 1;
        }
        assert!(count > 30, "{count}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn a_ring_turns_all_rigidly_about_their_middle_by_the_angle_of_the_pointer(
        camera in cameras(), one in transforms(), active in transforms(), axis in 0..3_usize,
        local in any::<bool>(), degrees in -170.0..170.0_f32,
    ) {
        let mut session = cubes(camera, &[one, active]);
        let middle = (one.position + active.position) / 2.0;
        let axes = if local { GizmoAxes::Local } else { GizmoAxes::World };
        let group = group(&session);
        let about = group.axis(axes, axis);
        prop_assume!(about.dot(camera.forward()).abs() > 0.4);
        // Both ends of a drag on a ring, as seen in the picture.
        let turn = Mat3::from_axis_angle(about, degrees.to_radians());
        let arm = about.any_orthonormal_vector() * 0.5;
        let ends = [arm, turn * arm].map(|arm| pixel(&session, middle + arm));
        let [Some(from), Some(to)] = ends else { return Ok(()) };
        let ray = camera.ray(from, SIZE);
        let mut drag = ShapeTurn::begin(group, about, middle + arm, &ray).unwrap();
        session.begin_gesture();
        let before = session.document();
        let edit = drag.update(&session, &camera.ray(to, SIZE), false);
        session.edit(edit).unwrap();
        prop_assert!((drag.angle().to_degrees() as f32 - degrees).abs() < 0.1, "{}", drag.angle().to_degrees());
        let turn = Mat3::from_axis_angle(about, drag.angle() as f32);
        for (now, was) in places(&session).iter().zip([one, active]) {
            let arm = turn * (was.position - middle);
            prop_assert!(now.position.abs_diff_eq(middle + arm, 1e-5));
            let rotation = turn * was.rotation.to_mat3();
            prop_assert!(now.rotation.to_mat3().abs_diff_eq(rotation, 1e-5));
            prop_assert_eq!(now.scale, was.scale);
        }
        session.cancel_gesture();
        prop_assert_eq!(session.document(), before);
        prop_assert_eq!(places(&session), vec![one, active]);
    }

    #[test]
    fn a_handle_scales_along_its_axis_by_the_way_of_the_pointer_from_the_pivot(
        camera in cameras(), one in transforms(), active in transforms(), axis in 0..3_usize,
        factor in 0.2..3.0_f32,
    ) {
        let mut session = cubes(camera, &[one, active]);
        let middle = (one.position + active.position) / 2.0;
        let group = group(&session);
        let along = group.axis(GizmoAxes::Local, axis);
        prop_assume!(along.dot(camera.forward()).abs() < 0.9);
        let ends = [0.4, 0.4 * factor].map(|way| pixel(&session, middle + along * way));
        let [Some(from), Some(to)] = ends else { return Ok(()) };
        let across = (camera.right(), camera.up());
        let mut drag = ShapeScale::begin(group, ScaleBy::Axis(axis), across, &camera.ray(from, SIZE));
        let edit = drag.update(&camera.ray(to, SIZE), false);
        session.edit(edit).unwrap();
        let now = places(&session);
        for (now, was) in now.iter().zip([one, active]) {
            for other in 0..3 {
                let expected = was.scale[other] * if other == axis { factor } else { 1.0 };
                prop_assert!((now.scale[other] - expected).abs() < 5e-3 * expected, "{now:?} {was:?}");
            }
            prop_assert_eq!(now.rotation, was.rotation);
        }
        for (now, was) in now.iter().zip([one, active]) {
            let (from, to) = (was.position - middle, now.position - middle);
            let stretched = from + along * (from.dot(along) * (drag.factor() as f32 - 1.0));
            prop_assert!(to.abs_diff_eq(stretched, 1e-4), "{to} {stretched}");
        }
    }

    #[test]
    fn no_scale_reaches_zero_or_loses_its_number_whatever_is_done(
        camera in cameras(), active in transforms(), axis in 0..3_usize,
        pixels in prop::array::uniform2((-2000.0..2000.0_f32, -2000.0..2000.0_f32)),
        snap in any::<bool>(), kind in 0..3_usize,
        typed in prop_oneof![Just(0.0), Just(-0.0), Just(1e300), Just(1e-300), Just(f64::NAN), -5.0..5.0],
    ) {
        let mut session = cubes(camera, &[active]);
        let by = [ScaleBy::Axis(axis), ScaleBy::Distance, ScaleBy::Doubling(0.5)][kind];
        let [from, to] = pixels.map(|at| camera.ray(Vec2::from(at), SIZE));
        let across = (camera.right(), camera.up());
        let mut drag = ShapeScale::begin(group(&session), by, across, &from);
        let edits = [drag.update(&to, snap), drag.scaled_by(typed)];
        for edit in edits {
            session.edit(edit).unwrap();
            let scale = places(&session)[0].scale;
            // At least 0.001; a factor times a size is rounded.
            let least = 0.001 * (1.0 - 1e-3);
            prop_assert!(scale.is_finite() && scale.abs().min_element() >= least, "{scale}");
        }
    }

    #[test]
    fn what_is_hit_where_a_gizmo_is_drawn_is_that_handle(
        camera in cameras(), active in transforms(), axis in 0..3_usize,
    ) {
        let session = cubes(camera, &[active]);
        let rings = RotationGizmo::of_shapes(&session, GizmoAxes::World, SIZE).unwrap();
        let middle = rings.center_pixel();
        for point in rings.ring(axis).iter().filter(|point| point.front) {
            let hit = rings.hit(point.pixel).map(|hit| hit.handle);
            prop_assert!(hit.is_some());
            let apart = |other: Vec2| other.distance(point.pixel) > 20.0;
            let others = (0..3).filter(|&other| other != axis);
            let alone = others.flat_map(|other| rings.ring(other)).all(|other| apart(other.pixel));
            let from_free = point.pixel.distance(middle) - RotationGizmo::FREE_RADIUS;
            if alone && from_free.abs() > 20.0 {
                prop_assert_eq!(hit, Some(Handle::Ring(axis)));
            }
        }
        let handles = ScaleGizmo::new(&session, SIZE).unwrap();
        let center = handles.center_pixel();
        prop_assert_eq!(handles.hit(center).map(|hit| hit.handle), Some(Handle::Center));
        let on_ring = center + Vec2::from_angle(axis as f32) * ScaleGizmo::RADIUS;
        prop_assert_eq!(handles.hit(on_ring).map(|hit| hit.handle), Some(Handle::FreeRing));
        if let Some((_, end)) = handles.handle(axis) {
            let alone = (0..3).all(|other| other == axis
                || handles.handle(other).is_none_or(|(_, far)| far.distance(end) > 40.0));
            if alone {
                prop_assert_eq!(handles.hit(end).map(|hit| hit.handle), Some(Handle::Arrow(axis)));
            }
        }
    }

    #[test]
    fn typed_amounts_are_exact(at in vector(-1.0..1.0), degrees in -360.0..360.0_f64, factor in 0.1..10.0_f64) {
        let place = Transform { position: at, ..Transform::IDENTITY };
        let mut session = cubes(Camera::default(), &[place]);
        let ray = Camera::default().ray(SIZE * 0.3, SIZE);
        let mut turn = ShapeTurn::begin(group(&session), Vec3::Z, Vec3::X, &ray).unwrap();
        let edit = turn.turned_by(degrees.to_radians());
        let across = (Vec3::X, Vec3::Y);
        let mut scale = ShapeScale::begin(group(&session), ScaleBy::Distance, across, &ray).along(Some(Constraint::Axis(1)));
        session.edit(edit).unwrap();
        let turned = places(&session)[0].rotation;
        let off = (f64::from(turned.degrees().z) - degrees).rem_euclid(360.0);
        prop_assert!(off.min(360.0 - off) < 1e-3 && turned.degrees().x.abs() < 1e-3, "{turned:?}");
        session.edit(scale.scaled_by(factor)).unwrap();
        let scaled = places(&session)[0].scale;
        prop_assert_eq!(scaled, Vec3::new(1.0, factor as f32, 1.0));
    }
}

#[test]
fn an_uneven_scale_turns_uniform_scaling_off_and_an_even_one_leaves_it_on() {
    let mut session = Session::new();
    let cube = NewShape::new("Cube", ShapeKind::Cube);
    session.edit(Edit::Insert(vec![cube])).unwrap();
    let uniform = |session: &Session| {
        let shape = session.scene().shape(ShapeId(1)).unwrap();
        shape.placement.uniform_scaling
    };
    let (camera, across) = (Camera::default(), (Vec3::X, Vec3::Y));
    let ray = camera.ray(SIZE * 0.3, SIZE);
    let all = ShapeScale::begin(group(&session), ScaleBy::Distance, across, &ray);
    for (only, stays) in [
        (Some(Constraint::Axis(2)), false),
        (Some(Constraint::Plane(2)), false),
        (None, true),
    ] {
        session.edit(all.along(only).scaled_by(2.0)).unwrap();
        assert_eq!(uniform(&session), stays, "{only:?}");
    }
}

#[test]
fn with_ctrl_angles_go_by_15_degrees_and_factors_by_a_tenth() {
    let camera = Camera::default();
    let mut session = cubes(camera, &[Transform::IDENTITY]);
    let ray = |x: f32, y: f32| {
        let at = pixel(&session, Vec3::new(x, y, 0.0)).unwrap();
        camera.ray(at, SIZE)
    };
    let start = ray(1.0, 0.0);
    let mut turn = ShapeTurn::begin(group(&session), Vec3::Z, Vec3::X, &start).unwrap();
    let edit = turn.update(&session, &ray(0.7, 0.6), true);
    let across = (camera.right(), camera.up());
    let mut scale = ShapeScale::begin(group(&session), ScaleBy::Distance, across, &start);
    let scaled = scale.update(&ray(1.26, 0.0), true);
    assert!((scale.factor() - 1.3).abs() < 1e-9, "{}", scale.factor());
    session.edit(edit).unwrap();
    let turned = places(&session)[0].rotation.degrees();
    assert!(turned.abs_diff_eq(Vec3::Z * 45.0, 1e-3), "{turned}");
    session.edit(scaled).unwrap();
    let scale = places(&session)[0].scale;
    assert!(scale.abs_diff_eq(Vec3::splat(1.3), 1e-6), "{scale}");
}

#[test]
fn hidden_and_locked_shapes_stay_where_they_are() {
    let beside = Transform {
        position: Vec3::X,
        ..Transform::IDENTITY
    };
    let mut session = cubes(Camera::default(), &[beside, beside, Transform::IDENTITY]);
    session.edit(Edit::SetLocked(ShapeId(1), true)).unwrap();
    session.edit(Edit::SetVisible(ShapeId(2), false)).unwrap();
    let ray = Camera::default().ray(SIZE * 0.3, SIZE);
    let mut turn = ShapeTurn::begin(group(&session), Vec3::Z, Vec3::X, &ray).unwrap();
    let edit = turn.turned_by(1.0);
    session.edit(edit).unwrap();
    let now = places(&session);
    assert_eq!(now[..2], [beside, beside]);
    assert_ne!(now[2].rotation, Euler::ZERO);
    session.edit(Edit::SetLocked(ShapeId(3), true)).unwrap();
    assert!(ShapeGroup::of_selected(&session).is_none());
}

#[test]
fn a_figure_far_from_its_origin_turns_about_its_own_middle_and_its_handles_are_there() {
    let corners = [[99.0, 0.0, -1.0], [101.0, 0.0, 1.0], [100.0, 2.0, 0.0]];
    let mesh = Mesh {
        positions: corners.map(Vec3::from).to_vec(),
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let mut session = Session::new();
    let new = NewShape::new("Far", ShapeKind::Mesh(SharedMesh::new(mesh)));
    session.edit(Edit::Insert(vec![new])).unwrap();
    let middle = Vec3::new(100.0, 1.0, 0.0);
    assert_eq!(group(&session).pivot(), middle);
    let turned = group(&session).turned(DVec3::Y, 1.0, None);
    session.edit(turned).unwrap();
    let placed = session.scene().shapes()[0].placement.transform;
    let moved = placed.world_from_model().transform_point3(middle);
    assert!(moved.abs_diff_eq(middle, 1e-4), "{moved}");
    assert!(group(&session).pivot().abs_diff_eq(middle, 1e-4));
}
