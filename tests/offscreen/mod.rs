//! Tests that draw without a window, on each backend by the same body.

mod backends;
mod draw_state;
mod gpu;
mod immediate;
mod mannequin;
mod materials;
mod scene;
mod shadows;
mod skinning;
mod support;
mod texture;
