//! The page's files: written from the program for WebAssembly, compressed, packed in an archive, served.

mod compress;
mod files;
mod package;
mod server;

pub use compress::{compress, of_first_picture};
pub use files::write;
pub use package::package;
pub use server::{Server, serve};
