use crate::io::{Diagnostic, Files};
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The largest file that is read, in bytes.
const LARGEST: u64 = 1 << 30;

/// The files on this machine.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    /// # Errors
    /// If there is no such file, it may not be read, is no ordinary file, or has more than 1 GiB.
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let told = |error: io::Error| Diagnostic::new(path, in_words(&error));
        // Asked before opening, for opening a pipe waits until someone writes into it.
        let metadata = std::fs::metadata(path).map_err(told)?;
        let wrong = if metadata.is_dir() {
            "expected a file, found a folder".to_owned()
        } else if !metadata.is_file() {
            "expected an ordinary file, found a device or a pipe".to_owned()
        } else if metadata.len() > LARGEST {
            let mib = metadata.len() >> 20;
            format!("expected a file of at most 1024 MiB, found {mib}")
        } else {
            let mut bytes = Vec::with_capacity(metadata.len() as usize);
            let file = File::open(path).map_err(told)?;
            file.take(LARGEST).read_to_end(&mut bytes).map_err(told)?;
            return Ok(bytes);
        };
        Err(Diagnostic::new(path, wrong))
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }
}

/// What went wrong, as one would say it.
pub(super) fn in_words(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::PermissionDenied => "there is no permission to open it".to_owned(),
        ErrorKind::NotADirectory => "a part of its path is a file, not a folder".to_owned(),
        ErrorKind::StorageFull => "the disk is full".to_owned(),
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read".to_owned(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_readable_file_is_told_in_plain_words() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("a.obj");
        let error = Disk.read(&missing).unwrap_err();
        assert_eq!(error.message, "there is no such file");
        let error = Disk.read(folder.path()).unwrap_err();
        assert_eq!(error.message, "expected a file, found a folder");
        assert!(!Disk.exists(&missing) && !Disk.exists(folder.path()));

        std::fs::write(&missing, "v").unwrap();
        assert_eq!(Disk.read(&missing), Ok(b"v".to_vec()));
        let error = Disk.read(&missing.join("b")).unwrap_err();
        assert_eq!(error.message, "a part of its path is a file, not a folder");
    }
}
