//! The program with its window: winit brings events, egui the panels, [`crate::render`] the
//! picture, and nothing is drawn while nothing changes.

mod application;
mod compare;
mod exports;
mod file_dialogs;
mod frame;
mod frame_rate;
pub mod globals;
mod imports;
mod input_parts;
mod poses;
mod preferences;
mod screenshots;
mod workspace;

pub use application::{AppError, Options, run};
