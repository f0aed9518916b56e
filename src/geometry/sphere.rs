use super::Mesh;
use glam::Vec3;
use std::f32::consts::{PI, TAU};

/// Axis of a sphere's poles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poles {
    /// +Y, as in the course's shape.
    Y,
    /// +Z, as in the course's joints.
    Z,
}

/// A sphere about the origin, smooth normals.
///
/// `slices` run round the axis and `stacks` from pole to pole, at least 3 and 2. The course's shape
/// has radius 0.5 and 20 of each, its joints radius 0.02 and 16 of each.
#[doc(alias = "Sphere")]
pub fn sphere(radius: f32, slices: u32, stacks: u32, poles: Poles) -> Mesh {
    let (slices, stacks) = (slices.max(3), stacks.max(2));
    let mut normals = Vec::with_capacity(((slices + 1) * (stacks + 1)) as usize);
    for stack in 0..=stacks {
        let polar = PI * stack as f32 / stacks as f32;
        for slice in 0..=slices {
            let around = TAU * slice as f32 / slices as f32;
            let normal = Vec3::new(
                polar.sin() * around.cos(),
                polar.sin() * around.sin(),
                polar.cos(),
            );
            normals.push(match poles {
                Poles::Y => Vec3::new(normal.y, normal.z, normal.x),
                Poles::Z => normal,
            });
        }
    }
    let mut triangles = Vec::with_capacity((2 * slices * (stacks - 1)) as usize);
    for stack in 0..stacks {
        for slice in 0..slices {
            let here = stack * (slices + 1) + slice;
            let below = here + slices + 1;
            // At a pole one of the two triangles has no area.
            if stack > 0 {
                triangles.push([here, below, here + 1]);
            }
            if stack + 1 < stacks {
                triangles.push([here + 1, below, below + 1]);
            }
        }
    }
    let positions = normals.iter().map(|&n| n * radius).collect();
    Mesh::new(positions, triangles).with_normals(normals)
}
