//! `editor_core`: everything behind the program `editor`, in layers.
//!
//! From the bottom up: [`math`], [`geometry`], [`character`], [`scene`], [`io`] and [`editor`]
//! know nothing of windows or graphics. ARCHITECTURE.md says which layer may use which, and
//! `tests/architecture` holds them to it.
#![deny(unsafe_code)]
#![warn(missing_docs)]

#[cfg(not(target_arch = "wasm32"))]
pub mod app;
pub mod character;
#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod compare;
pub mod diagnose;
#[cfg(not(target_arch = "wasm32"))]
pub mod disk;
pub mod editor;
pub mod geometry;
#[allow(unsafe_code, reason = "the one place that calls OpenGL")]
pub mod gpu;
pub mod grade;
pub mod io;
pub mod math;
pub mod program;
pub mod render;
pub mod revision;
pub mod scene;
pub mod steps;
pub mod ui;
#[cfg(target_arch = "wasm32")]
pub mod web;
