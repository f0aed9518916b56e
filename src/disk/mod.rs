//! The file system: reading whole files, and writing them whole or not at all. Used by the window
//! and the commands, which hand it to everything below as [`crate::io::Files`].

mod read;
mod write;

pub use read::Disk;
pub use write::{is_same_file, write_whole};
