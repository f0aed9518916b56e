//! OpenGL 3.3 core (or OpenGL ES 3.0) behind safe Rust: contexts, programs, buffers, vertex
//! arrays, textures, framebuffers, the draw state, and [`Immediate`], the compatibility layer for
//! code that thinks in `glBegin … glEnd`.
//!
//! # Safety
//!
//! This is the one module of the project with `unsafe` (the course kept its GL error handling in
//! `ErrorHandling`). One argument carries nearly every block: a GL entry point may be called when
//! its context is current on the calling thread and every pointer and range passed to it is valid.
//! - Entry points are reached through `Gl::raw` only, which makes the context current first.
//!   [`Gl`] is neither `Send` nor `Sync`, so the thread is the one that created it.
//! - Every object holds a [`Gl`], which keeps its context alive, so no call outlives the context.
//! - Pointers come from slices, whose lengths are checked against the sizes passed beside them;
//!   draws check their ranges against the buffers attached to the vertex array.
//!
//! `SAFETY: current context` below refers to this paragraph.
//!
//! # Faults
//!
//! What a caller can act on is a [`GpuError`]. What is a mistake in our own drawing code (a uniform
//! that no shader declares, a draw beyond a buffer's end) draws nothing, is kept, and is returned
//! once by [`Gl::check`], together with what the driver reports.
#![doc(alias = "ErrorHandling")]

mod attribute;
mod buffer;
mod context;
mod current;
mod display_list;
mod draw_state;
mod driver;
mod error;
mod framebuffer;
mod gl;
mod immediate;
mod program;
mod target;
mod texture;
mod thick_line;
mod vertex_array;

pub use attribute::Attribute;
pub use buffer::{Buffer, IndexBuffer, Usage};
pub use context::{Api, Backend, ContextError, HeadlessContext, WindowContext};
pub use display_list::DisplayList;
pub use draw_state::{Blend, DepthTest, DrawState};
pub use driver::Info;
pub use error::GpuError;
pub use framebuffer::{Framebuffer, Rect};
pub use gl::Gl;
pub use immediate::{Immediate, Mode, PointShape};
pub use program::Program;
pub use texture::{Filter, FloatTexture, Sampling, Texture, Wrap};
pub use vertex_array::{Primitive, VertexArray, VertexArrayBuilder};
