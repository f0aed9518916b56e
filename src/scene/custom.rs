//! The custom shape: made in code, to be replaced by one of your own.

use crate::geometry::Mesh;
use glam::Vec3;
use std::f32::consts::PI;

const POINTS: usize = 5;
const OUTER_RADIUS: f32 = 0.7;
const INNER_RADIUS: f32 = 0.3;
const THICKNESS: f32 = 0.2;

/// Shape of Insert ▸ Custom Shape: a five-pointed star in the XY plane.
///
/// The course hands this function out empty. To make a shape of your own, fill `positions` with
/// corners and `triangles` with three indices each, counter-clockwise seen from outside; the
/// normals follow from them.
#[doc(alias = "Custom")]
pub fn custom_shape() -> Mesh {
    let mut positions = vec![Vec3::Z * THICKNESS, Vec3::NEG_Z * THICKNESS];
    for corner in 0..2 * POINTS {
        let radius = if corner % 2 == 0 {
            OUTER_RADIUS
        } else {
            INNER_RADIUS
        };
        let angle = PI / 2.0 + PI * corner as f32 / POINTS as f32;
        positions.push(Vec3::new(radius * angle.cos(), radius * angle.sin(), 0.0));
    }

    let mut triangles = Vec::new();
    let rim = 2 * POINTS as u32;
    for corner in 0..rim {
        let (here, next) = (2 + corner, 2 + (corner + 1) % rim);
        triangles.push([0, here, next]);
        triangles.push([1, next, here]);
    }
    Mesh::new(positions, triangles)
}
