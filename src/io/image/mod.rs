//! Pictures as files: PNG, JPEG and GIF.

mod decode;
mod encode;

pub use decode::{decode, is_picture};
pub(super) use decode::{decode_what_is_there, decoded_size, format_of};
pub use encode::{PictureFormat, encode};
