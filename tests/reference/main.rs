//! Our results held against those of the course's own editor, on the course's own files.

#[path = "../support/reference.rs"]
mod reference;

mod facts;
mod golden_poses;
