//! Meshes and the built-in shapes, in their own model space, at the origin and at scale 1.

mod cube;
mod cuboid;
mod facets;
mod icosahedron;
mod mesh;
mod normals;
mod pyramid;
mod revision;
mod sphere;
mod teapot;
mod triangulate;

pub use cube::cube;
pub use cuboid::{BONE_HALF_WIDTH, cuboid_from_unit};
pub use facets::Facets;
pub use icosahedron::icosahedron;
pub use mesh::{Material, MaterialGroup, Mesh, Normals, Picture, nearest_triangle};
pub use normals::{face_normal, face_normals, smooth_normals};
pub use pyramid::pyramid;
pub use revision::{Revision, SharedMesh};
pub use sphere::{Poles, sphere};
pub use teapot::teapot;
pub use triangulate::triangulate;
