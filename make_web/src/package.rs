//! The page in one archive.

use super::files::{files_below, with_slashes};
use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::Path;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Folder that the archive holds.
const FOLDER: &str = "editor-page";

/// Packs all files of the page in `folder` into a new `archive`.
///
/// # Errors
/// If a file cannot be read or written.
pub fn package(folder: &Path, archive: &Path) -> Result<(), Box<dyn Error>> {
    let mut zip = ZipWriter::new(fs::File::create(archive)?);
    for name in files_below(folder)? {
        let inside = format!("{FOLDER}/{}", with_slashes(&name));
        zip.start_file(inside, SimpleFileOptions::default())?;
        zip.write_all(&fs::read(folder.join(name))?)?;
    }
    zip.finish()?;
    Ok(())
}
