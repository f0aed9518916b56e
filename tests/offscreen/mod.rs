//! Tests that draw without a window, on each backend by the same body.

mod backends;
mod contexts;
mod draw_state;
mod gpu;
mod immediate;
mod light;
mod mannequin;
mod marks;
mod materials;
mod scene;
mod shadows;
mod skinning;
mod support;
mod texture;
mod tiles;
