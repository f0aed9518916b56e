//! The host with a window: winit brings events, egui-winit hands them to egui, and files come from
//! the disk. Nothing is drawn while nothing changes.

mod application;
mod dialog_files;
mod file_dialog;
mod open_dialog;
mod own_folders;
mod rescue;
mod slot;
mod storage;
mod typed_name;
mod typed_path;
mod watcher;
mod window_host;

pub use application::{AppError, run};
