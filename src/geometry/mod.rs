//! Meshes, curves, surfaces and the built-in shapes, in their own model space, at the origin and at
//! scale 1.

mod bone_box;
mod coarse;
mod control_points;
mod cube;
mod curve;
mod curve_evaluation;
mod ground_colors;
mod icosahedron;
mod mesh;
mod mesh_builder;
mod normals;
mod pyramid;
mod sphere;
mod surface;
mod teapot;
mod triangle_tree;
mod triangulate;
mod turning;
mod volume;
mod winding;

pub use bone_box::{BONE_HALF_WIDTH, cuboid_from_unit};
pub use coarse::CoarseMesh;
pub use cube::cube;
pub use curve::{Basis, Curve, CurveError, CurveForm, MAX_COORDINATE, MAX_CURVE_POINTS, MAX_STEPS};
pub use curve_evaluation::{CurveFrame, CurvePoint, close_frames, is_closed};
pub use ground_colors::GroundColors;
pub use icosahedron::icosahedron;
pub use mesh::{Material, MaterialGroup, Mesh, Normals, Picture, Seams, SharedMesh};
pub use mesh_builder::{Corner, MeshBuilder};
pub use normals::{Facets, face_normal, face_normals, smooth_normals};
pub use pyramid::pyramid;
pub use sphere::{Poles, sphere};
pub use surface::{generalized_cylinder, surface_of_revolution, wireframe};
pub use teapot::teapot;
pub use triangle_tree::{TriangleBoxes, TriangleOrder};
pub use triangulate::Triangulator;
pub use volume::enclosed_volume;
pub use winding::opposed_triangles;
