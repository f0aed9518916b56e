//! Volumes behind the question which side of a surface is outside. Each is the flux of a field
//! of divergence one, which for a linear field is exact with one sample a triangle.

use glam::{DVec3, Vec3};

/// The volume that a surface about +Y encloses with discs over its ends, positive if its
/// triangles wind counter-clockwise seen from outside. The field has no flux through discs
/// across +Y, so they need not be there.
pub fn enclosed_by_lathe(positions: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    let field = |p: DVec3| DVec3::new(p.x, 0.0, p.z) / 2.0;
    flux(positions, triangles.iter().copied(), field)
}

/// The volume that a surface with closed rings of `ring` vertices encloses, its first and last
/// ring closed by fans, positive if its triangles wind counter-clockwise seen from outside.
/// They must wind along the ring first, then from one ring to the next.
pub fn enclosed_by_sweep(positions: &[Vec3], triangles: &[[u32; 3]], ring: usize) -> f64 {
    let origin = positions.first().map_or(DVec3::ZERO, |p| p.as_dvec3());
    let field = |p: DVec3| (p - origin) / 3.0;
    let fan = |first: usize| {
        let at = move |i: usize| (first + i) as u32;
        (2..ring).map(move |i| [at(0), at(i - 1), at(i)])
    };
    let last = positions.len().saturating_sub(ring);
    flux(positions, triangles.iter().copied(), field) + flux(positions, fan(last), field)
        - flux(positions, fan(0), field)
}

fn flux(
    positions: &[Vec3],
    triangles: impl Iterator<Item = [u32; 3]>,
    field: impl Fn(DVec3) -> DVec3,
) -> f64 {
    triangles
        .map(|corners| {
            let [a, b, c] = corners.map(|i| positions[i as usize].as_dvec3());
            field((a + b + c) / 3.0).dot((b - a).cross(c - a)) / 2.0
        })
        .sum()
}
