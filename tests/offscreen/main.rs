//! Tests that draw without a window, on each backend by the same body.

mod gpu;
mod support;
