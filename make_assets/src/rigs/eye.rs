//! Eyeballs.
use super::super::solids::{aimed, ball};
use super::model::Weights;
use super::paint::Painted;
use glam::DVec3;

/// A ball at `center` that looks along `gaze`. Round the line of sight it is colored in rings:
/// `rings` are (material, angle in radians where the next begins), the last goes on to the back.
pub fn eye(
    center: DVec3,
    radius: f64,
    gaze: DVec3,
    rings: &[(usize, f64)],
    weights: &Weights,
) -> Painted {
    const SIDES: u32 = 32;
    let mesh = aimed(ball(radius, SIDES), gaze, center);
    let count = mesh.positions.len();
    let mut painted = Painted::new(mesh, vec![weights.clone(); count]);
    for (triangle, material) in painted.mesh.triangles.iter().zip(&mut painted.materials) {
        let middle = triangle.map(|v| painted.mesh.positions[v as usize] - center);
        let angle = middle.iter().sum::<DVec3>().angle_between(gaze);
        let ring = rings.iter().find(|ring| angle < ring.1).or(rings.last());
        *material = ring.map_or(0, |ring| ring.0);
    }
    painted
}
