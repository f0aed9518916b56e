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

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;
    use zip::ZipArchive;

    #[test]
    fn an_archive_holds_every_file_of_the_page_in_one_folder_by_relative_names() {
        let folder = tempfile::tempdir().unwrap();
        let page = folder.path().join("page");
        let files = [
            "README.md",
            "assets/characters/robot.obj",
            "editor.js",
            "editor_bg.wasm",
            "editor_bg.wasm.br",
            "index.html",
        ];
        for name in files {
            let path = page.join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, format!("bytes of {name}")).unwrap();
        }
        let archive = folder.path().join("page.zip");
        package(&page, &archive).unwrap();

        let mut zip = ZipArchive::new(fs::File::open(archive).unwrap()).unwrap();
        let mut packed = Vec::new();
        for index in 0..zip.len() {
            let mut file = zip.by_index(index).unwrap();
            let name = file.name().unwrap().into_owned();
            let mut bytes = String::new();
            file.read_to_string(&mut bytes).unwrap();
            packed.push((name, bytes));
        }
        let wanted = files.map(|name| (format!("editor-page/{name}"), format!("bytes of {name}")));
        assert_eq!(packed, wanted);
    }

    #[test]
    fn an_archive_that_cannot_be_written_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "page").unwrap();
        assert!(package(folder.path(), &folder.path().join("none/page.zip")).is_err());
        assert!(package(&folder.path().join("none"), &folder.path().join("page.zip")).is_err());
    }
}
