//! The disk as the file dialog sees it.

use crate::disk::{Disk, in_words};
use crate::program::Purpose;
use egui_file_dialog::{Disks, FileSystem, Metadata, NativeFileSystem, UserDirectories};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The disk, where a file to read is also there under its name without extension. The dialog would
/// take a path that is typed like that for a folder.
pub(super) struct DialogFiles(pub Purpose);

impl FileSystem for DialogFiles {
    fn is_file(&self, path: &Path) -> bool {
        path.is_file() || !path.is_dir() && self.0.found(&Disk, path).is_some()
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        NativeFileSystem.metadata(path)
    }

    fn is_dir(&self, path: &Path) -> bool {
        NativeFileSystem.is_dir(path)
    }

    fn read_dir(&self, path: &Path) -> io::Result<Vec<PathBuf>> {
        // The dialog shows errors as they are.
        let read = NativeFileSystem.read_dir(path);
        read.map_err(|error| match error.kind() {
            ErrorKind::NotFound => io::Error::other("There is no such file or folder"),
            _ => io::Error::other(in_words(&error)),
        })
    }

    fn get_disks(&self, canonicalize_paths: bool) -> Disks {
        NativeFileSystem.get_disks(canonicalize_paths)
    }

    fn is_path_hidden(&self, path: &Path) -> bool {
        NativeFileSystem.is_path_hidden(path)
    }

    fn create_dir(&self, path: &Path) -> io::Result<()> {
        NativeFileSystem.create_dir(path)
    }

    fn user_dirs(&self, canonicalize_paths: bool) -> Option<UserDirectories> {
        NativeFileSystem.user_dirs(canonicalize_paths)
    }

    fn current_dir(&self) -> io::Result<PathBuf> {
        NativeFileSystem.current_dir()
    }

    fn load_text_file_preview(&self, path: &Path, max_chars: usize) -> io::Result<String> {
        NativeFileSystem.load_text_file_preview(path, max_chars)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_that_is_not_there_is_told_in_plain_words() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("nothing.dae");
        let told = DialogFiles(Purpose::Open).read_dir(&path).unwrap_err();
        assert_eq!(told.to_string(), "There is no such file or folder");
    }
}
