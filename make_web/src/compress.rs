//! Files made smaller for their way, by the two methods that browsers know.

use super::files::files_below;
use brotli::enc::BrotliEncoderParams;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::error::Error;
use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Extensions of files that are compressed in themselves, or that no browser asks for.
const LEFT: [&str; 4] = ["gz", "br", "png", "md"];

/// Writes a `.gz` and a `.br` beside every file in `folder` that becomes smaller.
///
/// # Errors
/// If a file cannot be read or written.
pub fn compress(folder: &Path) -> Result<(), Box<dyn Error>> {
    for name in files_below(folder)? {
        let extension = name.extension().unwrap_or_default();
        if LEFT.iter().any(|left| extension == OsStr::new(left)) {
            continue;
        }
        let path = folder.join(name);
        let bytes = fs::read(&path)?;
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&bytes)?;
        for (extension, packed) in [("gz", gzip.finish()?), ("br", brotli(&bytes)?)] {
            if packed.len() < bytes.len() {
                fs::write(with_extension(&path, extension), packed)?;
            }
        }
    }
    Ok(())
}

fn brotli(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let parameters = BrotliEncoderParams {
        quality: 11,
        lgwin: 24,
        size_hint: bytes.len(),
        ..BrotliEncoderParams::default()
    };
    let mut packed = Vec::new();
    brotli::BrotliCompress(&mut &*bytes, &mut packed, &parameters)?;
    Ok(packed)
}

/// `path` with one more extension.
pub(super) fn with_extension(path: &Path, extension: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(extension);
    PathBuf::from(name)
}
