use crate::curves::support::{flat, spatial, spline};
use editor_core::geometry::{Basis, Curve, CurveError, CurvePoint};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

fn positions(curve: &Curve) -> Vec<Vec3> {
    curve.evaluate().iter().map(|p| p.position).collect()
}

fn points(count: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<Vec3>> {
    let coordinate = -10.0_f32..10.0;
    let point = (coordinate.clone(), coordinate.clone(), coordinate);
    prop::collection::vec(point.prop_map(|(x, y, z)| Vec3::new(x, y, z)), count)
}

/// How much each of four control points weighs along a curve: they are put one after the other
/// at 1 while the others stay at 0.
fn weights(basis: Basis) -> Vec<[f32; 4]> {
    let one = |k: usize| {
        let mut points = vec![Vec3::ZERO; 4];
        points[k] = Vec3::X;
        positions(&spline(basis, 16, points))
    };
    let of_each: [Vec<Vec3>; 4] = std::array::from_fn(one);
    (0..17)
        .map(|i| std::array::from_fn(|k| of_each[k][i].x))
        .collect()
}

#[test]
fn the_weights_of_control_points_are_positive_and_add_up_to_one() {
    for basis in [Basis::Bezier, Basis::BSpline] {
        for weights in weights(basis) {
            assert!(weights.iter().all(|&weight| weight >= 0.0));
            assert!((weights.iter().sum::<f32>() - 1.0).abs() < 1e-6);
        }
    }
}

#[test]
fn the_middle_of_a_bezier_curve_weighs_one_three_three_one_eighths() {
    assert_eq!(weights(Basis::Bezier)[8], [0.125, 0.375, 0.375, 0.125]);
}

#[test]
fn a_b_spline_starts_at_one_four_one_sixths() {
    let [a, b, c, d] = weights(Basis::BSpline)[0];
    assert!((a - 1.0 / 6.0).abs() < 1e-7 && (c - 1.0 / 6.0).abs() < 1e-7);
    assert!((b - 4.0 / 6.0).abs() < 1e-7 && d == 0.0);
}

#[test]
fn a_bezier_curve_passes_through_its_first_and_last_point_of_each_piece() {
    let control = spatial(&[
        [0.1, 0.2, 0.3],
        [1.0, 2.0, -1.0],
        [2.0, -2.0, 1.0],
        [3.3, 0.7, 0.9],
        [4.0, 2.0, 0.0],
        [5.0, 0.0, 2.0],
        [6.1, 0.6, -0.4],
    ]);
    let points = positions(&spline(Basis::Bezier, 10, control.clone()));
    assert_eq!(points[0], control[0]);
    assert!(points.contains(&control[3]));
    assert_eq!(points[points.len() - 1], control[6]);
}

#[test]
fn a_circle_has_one_point_more_than_steps_and_ends_on_its_first() {
    let points = Curve::circle(30, 2.0).unwrap().evaluate();
    assert_eq!(points.len(), 31);
    assert_eq!(points[0], points[30]);
    assert!(
        points
            .iter()
            .all(|p| (p.position.length() - 2.0).abs() < 1e-6)
    );
}

#[test]
fn a_shared_point_is_stored_once_where_the_curve_runs_on_and_twice_at_a_corner() {
    let smooth = flat(&[
        [0., 0.],
        [1., 0.],
        [2., 1.],
        [3., 1.],
        [4., 1.],
        [5., 0.],
        [6., 0.],
    ]);
    let mut corner = smooth.clone();
    corner[4] = Vec3::new(3.0, 2.0, 0.0);
    let smooth = spline(Basis::Bezier, 10, smooth).evaluate();
    let corner = spline(Basis::Bezier, 10, corner).evaluate();
    assert_eq!(smooth.len(), 21);
    assert_eq!(corner.len(), 22);
    assert_eq!(corner[10].position, corner[11].position);
    assert_eq!(corner[10].frame.tangent, Vec3::X);
    assert_eq!(corner[11].frame.tangent, Vec3::Y);
}

/// First and second differences at both ends of step `h` where two pieces of a B-spline meet.
#[test]
fn pieces_of_a_b_spline_meet_with_equal_first_and_second_derivatives() {
    let control = spatial(&[
        [0.0, 0.0, 0.0],
        [1.0, 3.0, -1.0],
        [2.0, -2.0, 1.0],
        [4.0, 1.0, 3.0],
        [3.0, 0.0, -4.0],
        [6.0, 2.0, 1.0],
    ]);
    let steps = 64;
    let h = 1.0 / f64::from(steps);
    let p: Vec<DVec3> = positions(&spline(Basis::BSpline, steps, control))
        .iter()
        .map(|p| p.as_dvec3())
        .collect();
    for joint in [steps as usize, 2 * steps as usize] {
        // One-sided differences of second order, exact for the second derivative's jump to O(h).
        let at = |i: i64| p[(joint as i64 + i) as usize];
        let first = |s: i64| (at(0) * -3.0 + at(s) * 4.0 - at(2 * s)) / (2.0 * h * s as f64);
        let second = |s: i64| (at(0) * 2.0 - at(s) * 5.0 + at(2 * s) * 4.0 - at(3 * s)) / (h * h);
        assert!(first(1).distance(first(-1)) < 0.02);
        // Coordinates are f32: their rounding, times 12 over h², is about 0.01.
        assert!(second(1).distance(second(-1)) < 0.05);
        assert!(second(1).length() > 5.0, "the test needs a bend to see");
    }
}

#[test]
fn a_b_spline_of_points_in_a_row_is_the_same_row() {
    let row: Vec<Vec3> = (0..6).map(|i| Vec3::X * i as f32).collect();
    let points = positions(&spline(Basis::BSpline, 4, row));
    for (i, point) in points.iter().enumerate() {
        assert!(point.distance(Vec3::X * (1.0 + i as f32 / 4.0)) < 1e-6);
    }
}

#[test]
fn counts_steps_and_numbers_that_make_no_curve_are_refused() {
    let points = vec![Vec3::ZERO; 6];
    assert_eq!(
        Curve::spline(Basis::Bezier, true, 5, points.clone()),
        Err(CurveError::BezierCount(6))
    );
    assert_eq!(
        Curve::spline(Basis::BSpline, true, 5, points[..3].to_vec()),
        Err(CurveError::BSplineCount(3))
    );
    assert_eq!(
        Curve::spline(Basis::BSpline, true, 0, points.clone()),
        Err(CurveError::Steps(0))
    );
    assert!(Curve::circle(u32::MAX, 1.0).is_err());
    assert!(Curve::circle(10, f32::NAN).is_err());
    assert!(Curve::circle(10, 1e10).is_err());
    let many = vec![Vec3::ZERO; 1000];
    assert!(Curve::spline(Basis::BSpline, true, 5000, many).is_err());
}

fn hull_holds(control: &[Vec3], points: &[CurvePoint], directions: &[Vec3]) -> bool {
    directions.iter().all(|&direction| {
        let along = |p: Vec3| p.as_dvec3().dot(direction.as_dvec3());
        let reach = control.iter().map(|&p| along(p)).fold(f64::MIN, f64::max);
        points.iter().all(|p| along(p.position) <= reach + 1e-4)
    })
}

proptest! {
    #[test]
    fn every_curve_stays_in_the_convex_hull_of_its_control_points(
        control in points(4..12),
        directions in points(20),
    ) {
        let b_spline = spline(Basis::BSpline, 7, control.clone());
        prop_assert!(hull_holds(&control, &b_spline.evaluate(), &directions));
        let whole = &control[..1 + 3 * ((control.len() - 1) / 3)];
        let bezier = spline(Basis::Bezier, 7, whole.to_vec());
        prop_assert!(hull_holds(whole, &bezier.evaluate(), &directions));
    }

    #[test]
    fn a_curve_goes_where_its_control_points_are_moved(control in points(7), by in points(1)) {
        for basis in [Basis::Bezier, Basis::BSpline] {
            let here = positions(&spline(basis, 5, control.clone()));
            let moved = control.iter().map(|&p| p + by[0]).collect();
            let there = positions(&spline(basis, 5, moved));
            prop_assert!(here.iter().zip(&there).all(|(a, b)| (*a + by[0]).distance(*b) < 1e-4));
        }
    }
}
