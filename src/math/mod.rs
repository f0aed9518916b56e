//! Transforms and basic geometry: the matrix stack, Euler angles, boxes and rays.
//!
//! Right-handed, +Y up, column vectors (`world = world_from_model * model`), angles in radians.

mod aabb;
mod euler;
mod matrix_stack;
mod ray;
mod segment;
mod transform;

pub use aabb::Aabb;
pub use euler::Euler;
pub use matrix_stack::MatrixStack;
pub use ray::{Cylinder, DRay, Ray, TriangleHit};
pub use segment::distance_from_segment;
pub use transform::{Transform, cofactors};
