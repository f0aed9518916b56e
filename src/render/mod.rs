//! Draws a scene: [`Renderer`] for the picture, [`InterfacePainter`] for the panels over it, and
//! [`Offscreen`] for both without a window. The window and the command line draw through the same
//! [`Renderer::draw`].

mod axis_pass;
mod background_pass;
mod bone_lines;
mod cached_mesh;
mod compose;
mod curve_lines;
mod curve_pass;
mod floor_pass;
mod frame;
mod ground_pass;
mod interface_painter;
mod lights;
mod mesh_cache;
mod mesh_programs;
mod offscreen;
mod outline_pass;
mod palettes;
mod read_back;
mod renderer;
mod shadow_pass;
mod skeleton_pass;
mod skin;
mod skinning_choice;
mod surface_pass;
mod table;
mod texture_cache;

pub use compose::{compose, view_place};
pub use frame::{Frame, Marks};
pub use interface_painter::{InterfaceError, InterfacePainter};
pub use offscreen::{Offscreen, OffscreenError, read_picture};
pub use read_back::read_back_skinning;
pub use renderer::Renderer;
