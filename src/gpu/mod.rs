//! OpenGL 3.3 core (or OpenGL ES 3.0) behind safe Rust: contexts, programs, buffers, vertex
//! arrays, textures, framebuffers, the draw state, and [`Immediate`], the compatibility layer for
//! code that thinks in `glBegin … glEnd`.
//!
//! # Safety
//!
//! This is the one module of the project with `unsafe` (the course kept its GL error handling in
//! `ErrorHandling`). One argument carries nearly every block: a GL entry point may be called when
//! its context is current on the calling thread, every pointer and range passed to it is valid, and
//! every name passed to it is of that context.
//! - Entry points are reached only through `Gl::current` and its kin, which make the context current
//!   first and give nothing where that fails. [`Gl`] is neither `Send` nor `Sync`, so the thread is
//!   the one that created it. They are used before anything else can make another context current.
//! - Every object holds a [`Gl`], which keeps the context alive, so no call outlives the context,
//!   whatever is dropped first. The one painter that keeps entry points of its own,
//!   `InterfacePainter`, holds a [`Gl`] as well.
//! - Objects that are used together are checked to be of one context.
//! - Pointers come from slices, whose lengths are checked against the sizes passed beside them;
//!   draws check their ranges against the buffers attached to the vertex array, whose sizes count
//!   only once the driver has reserved the memory.
//!
//! - On a page no pointer reaches a driver: the browser checks every call and every range. There a call
//!   names the context that it is for, so a context is current as long as the browser has not taken it
//!   away. It is shared with egui's painter, and every draw sets all state that it depends on.
//!
//! `SAFETY: current context` below refers to this paragraph. It relies on nothing else in the
//! process making contexts current on threads on which a [`Gl`] lives.
//!
//! # Faults
//!
//! A failure that a caller can act on is a [`GpuError`]. A mistake in our own drawing code (a
//! uniform that no shader declares, a draw beyond a buffer's end) draws nothing, is kept, and is
//! returned once by [`Gl::check`], together with what the driver reports.
#![doc(alias = "ErrorHandling")]

mod attribute;
mod blit;
mod buffer;
mod context;
mod display_list;
mod draw_state;
mod driver;
#[cfg(test)]
mod failure_tests;
mod fence;
mod framebuffer;
mod framebuffer_object;
mod gl;
mod gpu_error;
mod immediate;
pub(crate) mod interface_painter;
#[cfg(not(target_arch = "wasm32"))]
mod native_driver;
mod program;
mod reading;
#[cfg(test)]
pub(crate) mod test_driver;
mod texture;
mod vertex_array;

pub use attribute::Attribute;
pub use blit::Rect;
pub use buffer::{Buffer, IndexBuffer, Usage};
pub use context::Api;
#[cfg(target_arch = "wasm32")]
pub use context::CanvasContext;
#[cfg(not(target_arch = "wasm32"))]
pub use context::{Backend, HeadlessContext, WindowContext};
pub use display_list::DisplayList;
pub use draw_state::{Blend, DepthTest, DrawState};
pub use driver::Info;
pub use fence::Fence;
pub use framebuffer::Framebuffer;
pub use gl::Gl;
pub use gpu_error::{ContextError, GpuError};
pub use immediate::{Immediate, Mode, PointShape};
pub use program::Program;
pub use reading::Reading;
pub use texture::{Filter, FloatTexture, Sampling, Texture, Wrap};
pub use vertex_array::{Primitive, VertexArray, VertexArrayBuilder};
