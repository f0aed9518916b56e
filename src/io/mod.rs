//! Files: importers, exporters, scene files. Bytes in, values out; nothing here opens a file, a
//! dialog or a window.

mod diagnostic;
mod files;

pub use diagnostic::{Diagnostic, Imported, Position};
pub use files::Files;
