//! Files: importers, exporters, scene files. Bytes in, values out; nothing here opens a file, a
//! dialog or a window.

mod attach;
mod diagnostic;
mod files;
pub mod image;
mod import_character;
mod import_shape;
mod json;
mod material;
mod number;
mod obj;
mod pose_file;
mod scanner;
mod skel;

pub use attach::read_attach;
pub use diagnostic::{Diagnostic, Imported, Position};
pub use files::Files;
pub use import_character::{is_character, read_character};
pub use import_shape::read_shape_obj;
pub use obj::read_character_obj;
pub use pose_file::{Entries, PoseData, PoseFile};
pub use skel::read_skel;
