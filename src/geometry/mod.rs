//! Meshes, curves, surfaces and the built-in shapes, in their own model space, at the origin and
//! at scale 1.

mod cube;
mod cuboid;
mod curve;
mod curve_closing;
mod curve_evaluation;
mod curve_points;
mod facets;
mod icosahedron;
mod mesh;
mod mesh_builder;
mod normals;
mod pyramid;
mod shared_mesh;
mod sphere;
mod surface;
mod surface_volume;
mod teapot;
mod triangulate;

pub use cube::cube;
pub use cuboid::{BONE_HALF_WIDTH, cuboid_from_unit};
pub use curve::{
    Basis, Curve, CurveError, CurveForm, CurvePoint, MAX_COORDINATE, MAX_CURVE_POINTS, MAX_STEPS,
};
pub use curve_closing::{close_frames, is_closed};
pub use facets::Facets;
pub use icosahedron::icosahedron;
pub use mesh::{Material, MaterialGroup, Mesh, Normals, Picture, Seams, nearest_triangle};
pub use mesh_builder::{Corner, MeshBuilder};
pub use normals::{face_normal, face_normals, smooth_normals};
pub use pyramid::pyramid;
pub use shared_mesh::SharedMesh;
pub use sphere::{Poles, sphere};
pub use surface::{generalized_cylinder, surface_of_revolution, wireframe};
pub use teapot::teapot;
pub use triangulate::Triangulator;
