//! Closed solids that parts are put together from: turned ones and rounded boxes.
use super::mesh::Mesh;
use glam::{DMat3, DVec3, IVec3};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// A solid turned about +Y. The profile goes from bottom to top as (radius, height); its first and
/// last points lie on the axis.
pub fn turned(profile: &[(f64, f64)], sides: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let rings = profile.len() - 2;
    for &(radius, y) in &profile[1..=rings] {
        for side in 0..sides {
            let (sin, cos) = (TAU * (f64::from(side) + 0.5) / f64::from(sides)).sin_cos();
            mesh.positions
                .push(DVec3::new(radius * sin, y, radius * cos));
        }
    }
    let (bottom, top) = (mesh.positions.len() as u32, mesh.positions.len() as u32 + 1);
    mesh.positions.push(DVec3::Y * profile[0].1);
    mesh.positions.push(DVec3::Y * profile[rings + 1].1);
    let ring = |r: usize, side: u32| r as u32 * sides + side % sides;
    for side in 0..sides {
        mesh.triangles
            .push([bottom, ring(0, side + 1), ring(0, side)]);
        mesh.triangles
            .push([top, ring(rings - 1, side), ring(rings - 1, side + 1)]);
        for r in 0..rings - 1 {
            let (a, b) = (ring(r, side), ring(r, side + 1));
            let (c, d) = (ring(r + 1, side + 1), ring(r + 1, side));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A cylinder about Y whose rims are beveled.
pub fn drum(radius: f64, half_height: f64, bevel: f64, sides: u32) -> Mesh {
    let (h, r, b) = (half_height, radius, bevel);
    let profile = [
        (0.0, -h),
        (r - b, -h),
        (r, -h + b),
        (r, h - b),
        (r - b, h),
        (0.0, h),
    ];
    turned(&profile, sides)
}

/// A ball with its poles on Y.
pub fn ball(radius: f64, sides: u32) -> Mesh {
    let rings = sides / 2;
    let profile: Vec<(f64, f64)> = (0..=rings)
        .map(|i| {
            let (sin, cos) = (0.5 * TAU * f64::from(i) / f64::from(rings)).sin_cos();
            (radius * sin, -radius * cos)
        })
        .collect();
    turned(&profile, sides)
}

/// A box whose edges are rounded in `steps` steps; `half` includes the rounding.
pub fn rounded_box(half: DVec3, rounding: f64, steps: i32) -> Mesh {
    let cells = 2 * steps + 1;
    let mut numbers: HashMap<IVec3, u32> = HashMap::new();
    let mut mesh = Mesh::default();
    let inner = half - DVec3::splat(rounding);
    // Each axis has `steps` lines in either rounding and the flat in between.
    let place = |i: i32| {
        let (sign, from_edge) = if i <= steps {
            (-1.0, i)
        } else {
            (1.0, cells - i)
        };
        let angle = TAU / 8.0 * f64::from(steps - from_edge) / f64::from(steps);
        (sign, angle.tan())
    };
    let mut vertex = |at: IVec3, mesh: &mut Mesh| {
        *numbers.entry(at).or_insert_with(|| {
            let axes = at.to_array().map(place);
            let sign = DVec3::from_array(axes.map(|a| a.0));
            let out = DVec3::from_array(axes.map(|a| a.0 * a.1)).normalize_or_zero();
            mesh.positions.push(sign * inner + out * rounding);
            mesh.positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        let unit = |a: usize| IVec3::from_array([0, 1, 2].map(|i| i32::from(i == a % 3)));
        let (u, v) = (unit(axis + 1), unit(axis + 2));
        for (side, flip) in [(0, true), (cells, false)] {
            for i in 0..cells {
                for j in 0..cells {
                    let at = |du: i32, dv: i32| unit(axis) * side + u * (i + du) + v * (j + dv);
                    let quad =
                        [at(0, 0), at(1, 0), at(1, 1), at(0, 1)].map(|c| vertex(c, &mut mesh));
                    let [a, b, c, d] = quad;
                    let both = if flip {
                        [[a, c, b], [a, d, c]]
                    } else {
                        [[a, b, c], [a, c, d]]
                    };
                    mesh.triangles.extend(both);
                }
            }
        }
    }
    mesh
}

/// The mesh with every position changed.
pub fn shaped(mut mesh: Mesh, change: impl Fn(DVec3) -> DVec3) -> Mesh {
    mesh.positions.iter_mut().for_each(|p| *p = change(*p));
    mesh
}

/// The mesh moved so that its origin comes to `at`.
pub fn moved(mesh: Mesh, at: DVec3) -> Mesh {
    shaped(mesh, |p| p + at)
}

/// The mesh turned so that its +Y looks along `axis`, then moved to `at`.
pub fn aimed(mesh: Mesh, axis: DVec3, at: DVec3) -> Mesh {
    let y = axis.normalize_or(DVec3::Y);
    let helper = if y.z.abs() > 0.9 { DVec3::X } else { DVec3::Z };
    let x = y.cross(helper).normalize_or(DVec3::X);
    let turn = DMat3::from_cols(x, y, x.cross(y));
    shaped(mesh, |p| turn * p + at)
}

/// The reflection in x = 0, still facing outward.
pub fn reflected(mesh: &Mesh) -> Mesh {
    let mut other = shaped(mesh.clone(), |p| DVec3::new(-p.x, p.y, p.z));
    for [_, b, c] in &mut other.triangles {
        std::mem::swap(b, c);
    }
    other
}
