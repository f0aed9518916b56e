use crate::curves::support::{half_circle, volume};
use editor_core::geometry::{Curve, Mesh, generalized_cylinder, surface_of_revolution};
use std::f64::consts::PI;

/// The order with which errors shrink from each mesh to the next, twice as fine: 2 for pieces of
/// planes along a smooth surface.
fn orders(exact: f64, mesh: impl Fn(u32) -> Mesh) -> Vec<f64> {
    let errors: Vec<f64> = [16, 32, 64, 128]
        .into_iter()
        .map(|steps| {
            let mesh = mesh(steps);
            exact - volume(&mesh.positions, &mesh.triangles)
        })
        .collect();
    assert!(errors.iter().all(|&error| error > 0.0), "planes lie inside");
    errors
        .windows(2)
        .map(|pair| (pair[0] / pair[1]).log2())
        .collect()
}

#[test]
fn the_volume_of_a_sphere_of_revolution_converges_with_second_order() {
    let exact = 4.0 / 3.0 * PI * 1.5_f64.powi(3);
    for order in orders(exact, |steps| {
        surface_of_revolution(&half_circle(1.5, steps), 2 * steps)
    }) {
        assert!((order - 2.0).abs() < 0.05, "{order}");
    }
}

#[test]
fn the_volume_of_a_torus_converges_with_second_order() {
    let exact = 2.0 * PI * PI * 2.0 * 0.5 * 0.5;
    for order in orders(exact, |steps| {
        let profile = Curve::circle(steps, 0.5).unwrap().evaluate();
        let sweep = Curve::circle(2 * steps, 2.0).unwrap().evaluate();
        generalized_cylinder(&profile, &sweep)
    }) {
        assert!((order - 2.0).abs() < 0.05, "{order}");
    }
}
