//! The page's files: written from the program for WebAssembly, packed in an archive, served.

mod files;
mod package;
mod server;

pub use files::write;
pub use package::package;
pub use server::{Server, serve};
