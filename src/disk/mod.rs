//! The file system: reading whole files, and writing them whole or not at all. Used by the window
//! and the commands, which hand it to everything below as [`crate::io::Files`].

mod read;
mod write;

use crate::io::builtin::WithBuiltin;
pub use read::Disk;
pub use write::{is_same_file, write_whole};

/// What the program reads: files on disk, and those it brings.
pub fn files() -> WithBuiltin<Disk> {
    WithBuiltin(Disk)
}
