//! The page in one archive.

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
    let mut names: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder)? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    let mut zip = ZipWriter::new(fs::File::create(archive)?);
    for name in names {
        zip.start_file(format!("{FOLDER}/{name}"), SimpleFileOptions::default())?;
        zip.write_all(&fs::read(folder.join(name))?)?;
    }
    zip.finish()?;
    Ok(())
}
