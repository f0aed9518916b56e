//! Draws a scene: [`Renderer`] for the picture, [`InterfacePainter`] for the panels over it, and
//! [`Offscreen`] for both without a window. The window and the command line draw through the same
//! [`Renderer::draw`].

mod area;
mod backdrop;
mod backdrop_pass;
mod batches;
mod cached_mesh;
mod changed_shapes;
mod coarse_meshes;
mod compose;
#[cfg(test)]
mod compose_tests;
mod coverage;
#[cfg(test)]
mod crowd_tests;
mod curve_pass;
mod edge_pass;
mod frame;
mod ghost_pass;
mod gradual_picture;
mod ground_pass;
mod mesh_cache;
mod mesh_numbers;
mod mesh_programs;
mod mesh_upload;
mod mesh_uploading;
mod moving;
mod number_colors;
mod number_marks;
#[cfg(not(target_arch = "wasm32"))]
mod offscreen;
mod outline_pass;
mod outlines_over;
mod palettes;
mod passes;
mod picture_parts;
mod read_back;
mod renderer;
mod rows;
mod samples;
mod shown_triangles;
mod sight;
mod skeleton_pass;
mod skinning_choice;
mod skinning_tables;
mod still_layer;
mod surface_pass;
mod surface_programs;
mod tile;
mod upload_cache;

pub use crate::gpu::interface_painter::{InterfaceError, InterfacePainter};
pub use backdrop::Backdrop;
pub use compose::{Composer, Placed, view_place};
pub use frame::{Background, Frame, Marks};
pub use gradual_picture::GradualPicture;
pub use number_marks::{Ghost, GhostPaint, ShapeNumbers};
#[cfg(not(target_arch = "wasm32"))]
pub use offscreen::{Offscreen, OffscreenError};
pub use outlines_over::GradualOutlines;
pub use passes::Passes;
pub use picture_parts::{LargePicture, PictureParts, check_picture_size, read_picture};
pub use read_back::read_back_skinning;
pub use renderer::{RenderError, Renderer};
pub use surface_pass::MANNEQUIN_LIGHT;
