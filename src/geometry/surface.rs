use super::Mesh;
use super::curve_evaluation::{CurvePoint, is_closed};
use super::turning::turning_number;
use crate::math::Aabb;
use glam::{DQuat, DVec2, DVec3, Vec3};
use std::collections::HashSet;
use std::f64::consts::TAU;

/// Distance, relative to the size of the surface, up to which corners coincide.
const COINCIDING: f32 = 1e-7;
/// Volume, relative to the cube of the size, below which it is rounding and has no sign.
const NO_VOLUME: f64 = 1e-9;

/// Surface of revolution of `profile` (in the plane z = 0) about +Y, in `steps` steps.
///
/// Vertices lie ring by ring, `profile.len()` each, `steps + 1` rings, the last on the first.
/// Normals are −N of the profile, turned along, and triangles wind counter-clockwise with them;
/// both are flipped where the profile, its ends closed by discs, turns round the other way, so that
/// normals point outward; where it turns round more than once or not at all, by the enclosed volume.
/// The volume alone would turn all normals of a glass round where its inner wall is dragged out
/// through the outer one. Triangles that shrink to a line on the axis are left out.
#[doc(alias = "makeSurfRev")]
pub fn surface_of_revolution(profile: &[CurvePoint], steps: u32) -> Mesh {
    let steps = steps.max(1);
    let size = Aabb::from_points(profile.iter().map(|point| point.position))
        .size()
        .length();
    // What lies on the axis but for rounding would turn on a tiny circle and leave slivers.
    let on_axis = |mut position: Vec3| {
        if position.x.abs() <= COINCIDING * size {
            position.x = 0.0;
        }
        position
    };
    let mut positions = Vec::with_capacity(profile.len() * (steps as usize + 1));
    let mut normals = Vec::with_capacity(positions.capacity());
    for step in 0..=steps {
        let turn = DQuat::from_rotation_y(TAU * f64::from(step % steps) / f64::from(steps));
        for point in profile {
            positions.push((turn * on_axis(point.position).as_dvec3()).as_vec3());
            normals.push((turn * -point.frame.normal.as_dvec3()).as_vec3());
        }
    }
    // Left and right of the axis the same profile turns in opposite directions.
    let mut triangles = quads(&positions, profile.len(), |column| {
        profile[column].position.x + profile[column + 1].position.x <= 0.0
    });
    let is_inward = match turns_of_meridian(&positions[..profile.len()]) {
        Some(1) => false,
        Some(-1) => true,
        _ => {
            let volume = enclosed_by_lathe(&positions, &triangles);
            volume < 0.0 && has_sign(volume, &positions)
        }
    };
    if is_inward {
        triangles.iter_mut().for_each(reverse);
        normals.iter_mut().for_each(|normal| *normal = -*normal);
    }
    Mesh::new(positions, triangles).with_normals(normals)
}

/// Generalized cylinder: the surface of `profile` (in the plane z = 0) swept along `sweep`. Each
/// profile point (x, y) becomes V + x·N + y·B in the frame of each point of the sweep.
///
/// Vertices lie ring by ring, `profile.len()` each, one ring a point of the sweep. Normals are −N
/// of the profile in the same frames, and triangles wind counter-clockwise with them; both are
/// flipped where a closed profile encloses a negative volume. To close a closed sweep, pass it
/// through [`super::close_frames`] first.
#[doc(alias = "makeGenCyl")]
pub fn generalized_cylinder(profile: &[CurvePoint], sweep: &[CurvePoint]) -> Mesh {
    let mut positions = Vec::with_capacity(profile.len() * sweep.len());
    let mut normals = Vec::with_capacity(positions.capacity());
    for along in sweep {
        let frame = along.frame;
        let turned = |flat: Vec3| frame.normal * flat.x + frame.binormal * flat.y;
        for point in profile {
            positions.push(along.position + turned(point.position));
            normals.push(turned(-point.frame.normal));
        }
    }
    let mut triangles = quads(&positions, profile.len(), |_| true);
    // Where the profile reaches beyond the center of a bend the surface folds over; its winding
    // stays consistent and goes with most of the normals.
    let agreement: f64 = triangles
        .iter()
        .map(|&corners| agreement(&positions, &normals, corners))
        .sum();
    let against_normals = agreement < 0.0;
    let volume = enclosed_by_sweep(&positions, &triangles, profile.len());
    let inward = if is_closed(profile) && has_sign(volume, &positions) {
        volume < 0.0
    } else {
        against_normals
    };
    if inward {
        triangles.iter_mut().for_each(reverse);
    }
    if inward != against_normals {
        normals.iter_mut().for_each(|normal| *normal = -*normal);
    }
    Mesh::new(positions, triangles).with_normals(normals)
}

/// Wireframe: every edge of `triangles` once, as indices of its two vertices, the smaller first, in
/// the order in which the triangles name them.
pub fn wireframe(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let mut seen = HashSet::with_capacity(triangles.len() * 2);
    let edges = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    edges
        .map(|[a, b]| [a.min(b), a.max(b)])
        .filter(|&edge| seen.insert(edge))
        .collect()
}

/// Two triangles for each cell of a grid of `ring` columns; `forward` says for each column whether
/// they wind along the ring first, then from one ring to the next. Triangles with coinciding
/// corners are left out.
fn quads(positions: &[Vec3], ring: usize, forward: impl Fn(usize) -> bool) -> Vec<[u32; 3]> {
    let nearest = COINCIDING * size(positions);
    let apart = |a: u32, b: u32| positions[a as usize].distance(positions[b as usize]) > nearest;
    let rings = positions.len().checked_div(ring).unwrap_or(0);
    let mut triangles = Vec::with_capacity(2 * positions.len());
    for row in 1..rings {
        for column in 1..ring {
            let here = (row * ring + column) as u32;
            let (left, above) = (here - 1, here - ring as u32);
            let corner = above - 1;
            for mut triangle in [[corner, above, left], [above, here, left]] {
                let [a, b, c] = triangle;
                if apart(a, b) && apart(b, c) && apart(c, a) {
                    if !forward(column - 1) {
                        reverse(&mut triangle);
                    }
                    triangles.push(triangle);
                }
            }
        }
    }
    triangles
}

/// How often the direction of a profile turns round that is revolved about +Y, closed by discs over its ends where it is open;
/// `None` if it crosses the axis or turns back.
fn turns_of_meridian(profile: &[Vec3]) -> Option<i32> {
    let mut corners: Vec<DVec2> = profile.iter().map(|at| at.truncate().as_dvec2()).collect();
    let (first, last) = (*corners.first()?, *corners.last()?);
    if corners.iter().any(|at| at.x < 0.0) && corners.iter().any(|at| at.x > 0.0) {
        return None;
    }
    let coinciding = f64::from(COINCIDING * size(profile));
    if first.distance(last) > coinciding {
        corners.extend([last.with_x(0.0), first.with_x(0.0)]);
    }
    turning_number(&corners, coinciding)
}

/// Whether `volume` is more than rounding in a surface of this size.
fn has_sign(volume: f64, positions: &[Vec3]) -> bool {
    volume.abs() > NO_VOLUME * f64::from(size(positions)).powi(3)
}

fn size(positions: &[Vec3]) -> f32 {
    Aabb::from_points(positions.iter().copied()).size().length()
}

fn reverse(corners: &mut [u32; 3]) {
    corners.swap(1, 2);
}

/// Agreement of a triangle's winding with its corners' normals, weighted by area.
fn agreement(positions: &[Vec3], normals: &[Vec3], corners: [u32; 3]) -> f64 {
    let [a, b, c] = corners.map(|i| positions[i as usize].as_dvec3());
    let normal: DVec3 = corners
        .iter()
        .map(|&i| normals[i as usize].as_dvec3())
        .sum();
    (b - a).cross(c - a).dot(normal)
}

/// Volume enclosed by a surface of revolution about +Y with discs over its ends, positive if its
/// triangles wind counter-clockwise seen from outside. The field has no flux through discs across
/// +Y, so they need not be there.
fn enclosed_by_lathe(positions: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    let field = |p: DVec3| DVec3::new(p.x, 0.0, p.z) / 2.0;
    flux(positions, triangles.iter().copied(), field)
}

/// Volume enclosed by a surface with closed rings of `ring` vertices, its first and last ring
/// closed by fans, positive if its triangles wind counter-clockwise seen from outside. They must
/// wind along the ring first, then from one ring to the next.
fn enclosed_by_sweep(positions: &[Vec3], triangles: &[[u32; 3]], ring: usize) -> f64 {
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

/// Flux of `field`, of divergence one, through triangles: the volume that they enclose. For a
/// linear field it is exact with one sample per triangle.
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
