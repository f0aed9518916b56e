use crate::curves::support::{evaluate, flat, read, spatial, spline};
use editor_core::geometry::{Basis, Curve, Normals};
use glam::Vec3;

fn all_sound(text: &str) {
    for closing in [true, false] {
        let geometry = evaluate(read(text).unwrap(), closing);
        let curves = geometry.curves.as_ref().unwrap();
        for point in curves.curves.iter().flat_map(|curve| &curve.points) {
            assert!(point.position.is_finite());
            assert!(point.frame.is_orthonormal(1e-5), "{text}: {point:?}");
        }
        assert!(geometry.mesh.positions.iter().all(|p| p.is_finite()));
        let Normals::PerVertex(normals) = &geometry.mesh.normals else {
            panic!("no normals");
        };
        assert!(
            normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-4),
            "{text}"
        );
    }
}

#[test]
fn all_control_points_in_one_place_give_finite_frames() {
    all_sound("bez2 a 5 4 [1 1] [1 1] [1 1] [1 1] srev . 5 a gcyl . a a");
    all_sound("bsp3 a 5 5 [0 0 0] [0 0 0] [0 0 0] [0 0 0] [0 0 0] circ c 5 1 gcyl . c a");
}

#[test]
fn circles_without_a_radius_give_finite_surfaces() {
    all_sound("circ a 5 0 srev . 8 a gcyl . a a");
    all_sound("circ a 8 0 circ b 8 1 gcyl . a b gcyl . b a");
}

#[test]
fn repeated_control_points_and_cusps_keep_their_frames() {
    all_sound("bsp2 a 8 8 [0 0] [0 0] [0 0] [1 0] [1 0] [1 0] [1 1] [1 1] circ c 6 .1 gcyl . c a");
    all_sound("bez2 a 8 4 [-1 0] [1 1] [-1 1] [1 0] srev . 8 a");
    all_sound("bez3 a 9 4 [0 0 0] [1 1 0] [0 1 0] [1 0 0] circ c 6 .1 gcyl . c a");
}

#[test]
fn a_curve_that_turns_into_its_binormal_keeps_its_frames() {
    all_sound(
        "bez3 a 4 7 [0 0 0] [1 0 0] [2 0 0] [3 0 0] [3 0 1] [3 0 2] [3 0 3]
         circ c 6 .1 gcyl . c a",
    );
    all_sound("bez3 a 4 4 [0 0 0] [0 0 1] [0 0 2] [0 0 3] circ c 6 .1 gcyl . c a");
}

#[test]
fn a_single_step_and_the_largest_numbers_are_fine() {
    all_sound("circ a 1 1 circ b 2 1 gcyl . a b srev . 1 a");
    all_sound("circ a 5 1e9 circ b 5 1e9 gcyl . a b srev . 5 b");
    all_sound("circ a 5 1e-30 circ b 5 1e-30 gcyl . a b srev . 5 b");
}

#[test]
fn the_tangent_at_a_vanishing_derivative_is_the_direction_beside_it() {
    let points = flat(&[[0., 0.], [0., 0.], [1., 1.], [1., 1.]]);
    let points = spline(Basis::Bezier, 4, points).evaluate();
    let diagonal = Vec3::new(1.0, 1.0, 0.0) / 2.0_f32.sqrt();
    for point in &points {
        assert!(point.frame.tangent.distance(diagonal) < 1e-6, "{point:?}");
    }
}

#[test]
fn a_piece_without_extent_has_the_direction_of_its_neighbors() {
    let mut points = spatial(&[[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [3., 0., 0.]]);
    points.extend([Vec3::X * 3.0; 3]);
    points.extend(spatial(&[[3., 1., 0.], [3., 2., 0.], [3., 3., 0.]]));
    let points = spline(Basis::Bezier, 2, points).evaluate();
    assert!(points.iter().all(|p| p.frame.is_orthonormal(1e-6)));
    // The corner has both directions, whatever is repeated there.
    let at_corner = |tangent: Vec3| {
        let mut there = points.iter().filter(|p| p.position == Vec3::X * 3.0);
        there.any(|p| p.frame.tangent == tangent)
    };
    assert!(at_corner(Vec3::X) && at_corner(Vec3::Y));
}

#[test]
fn a_direction_is_found_in_control_points_that_almost_coincide() {
    let points = flat(&[
        [0., -0.459543],
        [0., -0.459544],
        [0., -0.459545],
        [1., -0.4],
    ]);
    let points = spline(Basis::BSpline, 8, points).evaluate();
    assert_eq!(points[0].frame.tangent, -Vec3::Y);
    assert!(points[1].frame.tangent.x > 0.99);
}

#[test]
fn a_circle_of_one_step_is_a_point_twice() {
    let points = Curve::circle(1, 1.0).unwrap().evaluate();
    assert_eq!(points.len(), 2);
    assert_eq!(points[0], points[1]);
}
