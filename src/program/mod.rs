//! The program without a place: the session, the panels' state, preferences, the comparison and
//! the pictures of a frame. What differs between a window, a command and a test is behind the one
//! trait [`Host`].
//!
//! A host calls [`Program::frame`] once a frame. Where something else runs egui for it, it calls
//! [`allow_for_slow_frames`], [`Program::begin_frame`], [`Program::show`] within the pass of egui for each of the
//! [`input_parts`], [`Program::draw`] and [`Program::finish_frame`].

mod actions;
mod autosave;
mod awaited;
mod chosen;
mod click_duration;
mod clipboard;
mod compare_mesh;
mod compared_camera;
mod comparing;
mod comparison;
mod document;
mod document_file;
mod document_name;
mod draft_detail;
mod edges;
mod exports;
mod files;
mod finger_presses;
mod first_view;
mod frame;
mod frame_rate;
mod full_picture;
pub mod globals;
mod graphics;
mod host;
mod input_parts;
mod job;
mod look_tried;
mod meant_file;
mod mesh_comparison;
mod mesh_marks;
mod page_figure;
mod page_floor;
mod page_screenshot;
mod page_view;
mod picture_work;
mod preferences;
mod purpose;
mod questions;
mod reading;
mod running;
mod saving;
mod scene_key;
mod scene_link;
mod scene_picture;
#[cfg(test)]
mod scene_picture_tests;
mod several_poses;
mod sources;
mod split_view;
mod start_pictures;
mod textured;
mod view_before;
mod window_picture;

pub use autosave::Unsaved;
pub use click_duration::allow_for_slow_frames;
pub use finger_presses::FingerPresses;
pub use frame::{FrameInput, Pass, ProgramError};
pub use graphics::{Graphics, GraphicsInfo};
pub use host::{Host, HostEvent, NotStored, Previous, StorageKey};
pub use input_parts::input_parts;
pub use job::{Job, JobResult, RunningJob};
pub use preferences::{LastWindow, last_window};
pub use purpose::{FileKind, FileRequest, Purpose, Suggested};
pub use running::{Options, Program, Shown};
