//! The program without a place: the session, the panels' state, preferences, the comparison and
//! the pictures of a frame. What differs between a window, a command and a test is behind the one
//! trait [`Host`].
//!
//! A host calls [`Program::frame`] once a frame, or, where something else runs egui for it,
//! [`Program::show`] and [`Program::draw`].

mod comparison;
mod files;
mod frame;
mod frame_rate;
pub mod globals;
mod graphics;
mod host;
mod input_parts;
mod job;
mod preferences;
mod running;

pub use frame::{DrawnFrame, FrameInput, Pass, ProgramError};
pub use graphics::{Graphics, GraphicsInfo};
pub use host::{Host, HostEvent, Purpose, StorageKey};
pub use job::{Job, JobResult};
pub use running::{Options, Program, Shown};
