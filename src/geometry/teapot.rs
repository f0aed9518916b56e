use super::Mesh;
use glam::{Vec2, Vec3};

/// Steps along each side of a patch.
const STEPS: usize = 10;
/// Scale from the patches' units (the body's widest radius is 2) to the course's size (0.65).
const SCALE: f32 = 0.325;
/// A quarter of a circle as one cubic: how far its inner control points go, as the original patches
/// have it (0.5523 would be the best circle).
const QUARTER: f32 = 0.56;

/// Profiles of the parts turned about the axis, as radius and height, four control points each.
const TURNED: [[[f32; 2]; 4]; 6] = [
    [[1.4, 2.4], [1.3375, 2.53125], [1.4375, 2.53125], [1.5, 2.4]],
    [[1.5, 2.4], [1.75, 1.875], [2.0, 1.35], [2.0, 0.9]],
    [[2.0, 0.9], [2.0, 0.45], [1.5, 0.225], [1.5, 0.15]],
    [[0.0, 3.15], [0.8, 3.15], [0.0, 2.7], [0.2, 2.7]],
    [[0.2, 2.7], [0.4, 2.55], [1.3, 2.55], [1.3, 2.4]],
    [[1.5, 0.15], [1.5, 0.075], [1.425, 0.0], [0.0, 0.0]],
];

/// One row of a tube's control points: x and height where it meets the plane of symmetry on either
/// side, and the depth that its inner points reach.
type TubeRow = ([f32; 2], [f32; 2], f32);

/// Handle and spout, half a tube each; rows shared between neighbors are written once.
const TUBES: [[TubeRow; 7]; 2] = [
    [
        ([-1.6, 2.025], [-1.5, 2.25], 0.3),
        ([-2.3, 2.025], [-2.5, 2.25], 0.3),
        ([-2.7, 2.025], [-3.0, 2.25], 0.3),
        ([-2.7, 1.8], [-3.0, 1.8], 0.3),
        ([-2.7, 1.575], [-3.0, 1.35], 0.3),
        ([-2.5, 1.125], [-2.65, 0.9375], 0.3),
        ([-2.0, 0.9], [-1.9, 0.6], 0.3),
    ],
    [
        ([1.7, 1.425], [1.7, 0.6], 0.66),
        ([2.6, 1.425], [3.1, 0.825], 0.66),
        ([2.3, 2.1], [2.4, 2.025], 0.25),
        ([2.7, 2.4], [3.3, 2.4], 0.25),
        ([2.8, 2.475], [3.525, 2.49375], 0.25),
        ([2.9, 2.475], [3.45, 2.5125], 0.15),
        ([2.8, 2.4], [3.2, 2.4], 0.15),
    ],
];

/// Sixteen control points, `[v][u]`; y is up.
type Patch = [[Vec3; 4]; 4];

/// Martin Newell's teapot (1975) from its Bézier patches, spout along +X, centered, smooth normals;
/// its box is ±1.0445, ±0.5118, ±0.65.
#[doc(alias = "Teapot")]
pub fn teapot() -> Mesh {
    let mut positions = Vec::new();
    let mut normals = Vec::new();
    let mut triangles = Vec::new();
    for patch in patches() {
        add_patch(&patch, &mut positions, &mut normals, &mut triangles);
    }
    let mesh = Mesh::new(positions, triangles);
    let center = mesh.bounds().center();
    let positions = mesh
        .positions
        .iter()
        .map(|&p| (p - center) * SCALE)
        .collect();
    Mesh { positions, ..mesh }.with_normals(normals)
}

/// All patches, each with `∂u × ∂v` pointing outward.
fn patches() -> Vec<Patch> {
    let mut patches = Vec::new();
    for profile in TURNED {
        for quarter in 0..4 {
            patches.push(turned(profile, quarter));
        }
    }
    for rows in TUBES {
        for first in [0, 3] {
            for side in [-1.0, 1.0] {
                let patch: Patch = std::array::from_fn(|v| {
                    let (a, b, depth) = rows[first + v];
                    let across = [(a, 0.0), (a, depth), (b, depth), (b, 0.0)];
                    let row = across.map(|(p, z)| Vec3::new(p[0], p[1], side * z));
                    // Mirroring turns the patch inside out; walking u backwards mends it.
                    if side > 0.0 {
                        row
                    } else {
                        [row[3], row[2], row[1], row[0]]
                    }
                });
                patches.push(patch);
            }
        }
    }
    patches
}

fn turned(profile: [[f32; 2]; 4], quarter: usize) -> Patch {
    let arc = [
        Vec2::new(1.0, 0.0),
        Vec2::new(1.0, QUARTER),
        Vec2::new(QUARTER, 1.0),
        Vec2::new(0.0, 1.0),
    ];
    std::array::from_fn(|v| {
        let [radius, height] = profile[v];
        arc.map(|mut on_arc| {
            for _ in 0..quarter {
                on_arc = on_arc.perp();
            }
            Vec3::new(radius * on_arc.x, height, radius * on_arc.y)
        })
    })
}

fn add_patch(
    patch: &Patch,
    positions: &mut Vec<Vec3>,
    normals: &mut Vec<Vec3>,
    triangles: &mut Vec<[u32; 3]>,
) {
    let first = positions.len() as u32;
    let row = STEPS as u32 + 1;
    for i in 0..=STEPS {
        for j in 0..=STEPS {
            let (u, v) = (i as f32 / STEPS as f32, j as f32 / STEPS as f32);
            positions.push(point(patch, u, v));
            normals.push(normal(patch, u, v));
        }
    }
    for i in 0..STEPS as u32 {
        for j in 0..STEPS as u32 {
            let here = first + i * row + j;
            let corners = [here, here + row, here + row + 1, here + 1];
            for triangle in [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|k: usize| corners[k])) {
                let [a, b, c] = triangle.map(|k| positions[k as usize]);
                // Where a side of the patch shrinks to a point, triangles have no area.
                if (b - a).cross(c - a).length_squared() > 1e-12 {
                    triangles.push(triangle);
                }
            }
        }
    }
}

fn bernstein(t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

fn bernstein_derivative(t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    [
        -3.0 * s * s,
        3.0 * s * s - 6.0 * s * t,
        6.0 * s * t - 3.0 * t * t,
        3.0 * t * t,
    ]
}

fn blend(patch: &Patch, along_u: [f32; 4], along_v: [f32; 4]) -> Vec3 {
    let mut sum = Vec3::ZERO;
    for (row, weight_v) in patch.iter().zip(along_v) {
        for (&point, weight_u) in row.iter().zip(along_u) {
            sum += point * (weight_u * weight_v);
        }
    }
    sum
}

fn point(patch: &Patch, u: f32, v: f32) -> Vec3 {
    blend(patch, bernstein(u), bernstein(v))
}

/// Unit normal. Where a side shrinks to a point the derivative along it vanishes: there the normal
/// is taken a little way inside the patch.
fn normal(patch: &Patch, u: f32, v: f32) -> Vec3 {
    let at = |u: f32, v: f32| {
        let along_u = blend(patch, bernstein_derivative(u), bernstein(v));
        let along_v = blend(patch, bernstein(u), bernstein_derivative(v));
        let normal = along_u.cross(along_v);
        if normal.length_squared() > 1e-9 {
            normal.try_normalize()
        } else {
            None
        }
    };
    let inside = |t: f32| t.clamp(0.01, 0.99);
    at(u, v)
        .or_else(|| at(inside(u), inside(v)))
        .unwrap_or(Vec3::Y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Normals, face_normals};

    #[test]
    fn its_box_is_the_course_s_and_the_spout_points_along_plus_x() {
        let bounds = teapot().bounds();
        let expected = Vec3::new(1.0445, 0.5118, 0.65);
        assert!(bounds.max.abs_diff_eq(expected, 2e-3), "{bounds:?}");
        assert!(bounds.min.abs_diff_eq(-expected, 2e-3), "{bounds:?}");
    }

    #[test]
    fn faces_and_normals_point_outward() {
        let mesh = teapot();
        let Normals::PerVertex(normals) = &mesh.normals else {
            panic!("the teapot is smooth");
        };
        let faces = face_normals(&mesh.positions, &mesh.triangles);
        let mut outward = 0;
        for (triangle, face) in mesh.triangles.iter().zip(faces) {
            let [a, b, c] = triangle.map(|corner| mesh.positions[corner as usize]);
            assert!(
                triangle
                    .iter()
                    .all(|&i| normals[i as usize].dot(face) > 0.0)
            );
            outward += i32::from((a + b + c).dot(face) > 0.0);
        }
        // Not all: the undersides of handle and lid look towards the middle.
        assert!(
            outward as usize > mesh.triangles.len() * 7 / 10,
            "{outward}"
        );
    }
}
