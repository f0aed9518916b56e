use crate::curves::support::{evaluate, read, spatial, spline};
use editor_core::geometry::{Basis, Curve, close_frames, is_closed};
use glam::Vec3;
use proptest::prelude::*;

/// A closed curve out of its plane: eight points, the first three repeated.
fn closed_and_not_flat() -> Curve {
    let ring: Vec<Vec3> = (0..11)
        .map(|i| {
            let angle = std::f32::consts::TAU * i as f32 / 8.0;
            let height = if i % 8 < 3 {
                1.5
            } else {
                -0.3 * (i % 8) as f32
            };
            Vec3::new(2.0 * angle.cos(), height, 2.0 * angle.sin())
        })
        .collect();
    let mut ring = ring;
    for i in 0..3 {
        ring[8 + i] = ring[i];
    }
    spline(Basis::BSpline, 20, ring)
}

#[test]
fn tangents_point_along_the_curve() {
    let points = closed_and_not_flat().evaluate();
    for pair in points.windows(2) {
        let chord = (pair[1].position - pair[0].position).normalize_or_zero();
        assert!(pair[0].frame.tangent.dot(chord) > 0.99);
    }
}

#[test]
fn a_flat_curve_keeps_its_binormal_on_z_through_inflections() {
    let wave = (0..12)
        .map(|i| Vec3::new(i as f32, if i % 2 == 0 { 1.0 } else { -1.0 }, 0.0))
        .collect();
    for point in spline(Basis::BSpline, 10, wave).evaluate() {
        assert!(point.frame.binormal.distance(Vec3::Z) < 1e-6);
    }
}

#[test]
fn a_curve_along_z_starts_with_another_axis() {
    let row = (0..5).map(|i| Vec3::Z * i as f32).collect();
    for point in spline(Basis::BSpline, 5, row).evaluate() {
        assert_eq!(point.frame.tangent, Vec3::Z);
        assert!(point.frame.is_orthonormal(1e-6));
    }
}

#[test]
fn closing_brings_the_last_frame_onto_the_first_in_proportion_to_length() {
    let carried = closed_and_not_flat().evaluate();
    let mut closed = carried.clone();
    let angle = close_frames(&mut closed).unwrap();
    assert!(
        angle.abs() > 0.05,
        "the test needs a curve that misses, {angle}"
    );
    let (first, last) = (closed[0], closed[closed.len() - 1]);
    assert_eq!(first, carried[0]);
    assert_eq!(first, last);

    let length: f32 = carried
        .windows(2)
        .map(|pair| pair[0].position.distance(pair[1].position))
        .sum();
    let mut walked = 0.0;
    for (i, point) in closed.iter().enumerate().take(closed.len() - 1) {
        let turned = carried[i].frame.angle_to(point.frame);
        assert!((turned - angle * walked / length).abs() < 1e-4, "{turned}");
        assert!(point.frame.is_orthonormal(1e-5));
        walked += carried[i].position.distance(carried[i + 1].position);
    }
}

#[test]
fn an_open_curve_and_one_that_ends_in_another_direction_are_not_closed() {
    let mut open = Curve::circle(40, 1.0).unwrap().evaluate();
    open.pop();
    assert!(!is_closed(&open));
    assert_eq!(close_frames(&mut open), None);

    let drop = spatial(&[[0., 0., 0.], [2., 2., 0.], [-2., 2., 0.], [0., 0., 0.]]);
    let mut drop = spline(Basis::Bezier, 10, drop).evaluate();
    assert!(is_closed(&drop));
    assert_eq!(close_frames(&mut drop), None);
}

#[test]
fn frames_are_closed_on_sweeps_only_and_only_if_wanted() {
    let control = closed_and_not_flat().control_points().to_vec();
    let list: String = control
        .iter()
        .map(|p| format!("[{} {} {}]", p.x, p.y, p.z))
        .collect();
    let curve = format!("bsp3 way 20 {} {list}\ncirc ring 8 0.2\n", control.len());
    let alone = evaluate(read(&curve).unwrap(), true);
    let swept = read(&format!("{curve} gcyl . ring way")).unwrap();
    let closed = evaluate(swept.clone(), true);
    let left = evaluate(swept, false);
    let angle = |geometry: &editor_core::scene::EvaluatedGeometry| {
        geometry.curves.as_ref().unwrap().curves[0].closing_angle
    };
    assert_eq!(angle(&alone), None);
    assert_eq!(angle(&left), None);
    assert!(angle(&closed).is_some());
}

proptest! {
    #[test]
    fn every_frame_of_every_curve_is_orthonormal(
        control in prop::collection::vec((-3_i8..4, -3_i8..4, -3_i8..4), 4..14)
    ) {
        // Small whole numbers: points repeat and fall in rows often.
        let control: Vec<Vec3> = control
            .iter()
            .map(|&(x, y, z)| Vec3::new(x.into(), y.into(), z.into()))
            .collect();
        let whole = control[..1 + 3 * ((control.len() - 1) / 3)].to_vec();
        let curves = [spline(Basis::BSpline, 6, control), spline(Basis::Bezier, 6, whole)];
        for point in curves.iter().flat_map(Curve::evaluate) {
            prop_assert!(point.frame.is_orthonormal(1e-5), "{point:?}");
        }
    }
}
