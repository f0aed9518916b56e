//! Transforms and small geometry: the matrix stack, Euler angles, boxes, cylinders and rays.
//!
//! Right-handed, +Y up, column vectors (`world = world_from_model * model`), angles in radians.

mod aabb;
mod cylinder;
mod euler;
mod frame;
mod matrix_stack;
mod ray;
mod transform;

pub use aabb::Aabb;
pub use cylinder::Cylinder;
pub use euler::Euler;
pub use frame::{Frame, bone_frame};
pub use matrix_stack::MatrixStack;
pub use ray::{Ray, TriangleHit};
pub use transform::{Transform, cofactors};
