//! Files under temporary names, to be put in the place of others.

use super::in_words;
use crate::io::Diagnostic;
use std::fs::File;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Number of symbolic links that are followed, as in Linux.
const MOST_LINKS: usize = 40;

/// A file that is written, under a temporary name.
pub(super) struct Staged {
    path: PathBuf,
    target: PathBuf,
    file: NamedTempFile,
}

impl Staged {
    /// Puts it in its place.
    ///
    /// # Errors
    /// If the system refuses; then it is gone, and what was there before stays.
    pub fn put_in_place(self) -> Result<(), Diagnostic> {
        let persisted = self.file.persist(&self.target);
        persisted.map_err(|error| cannot_replace(&self.path, &error.error))?;
        Ok(())
    }
}

/// Writes `bytes` to a temporary file beside `path`, or beside the file that it is a link to.
///
/// # Errors
/// If the folder does not exist or is not writable, the disk is full, or `path` is a folder, a device or a
/// pipe. Then nothing is left behind.
pub(super) fn staged(path: &Path, bytes: &[u8]) -> Result<Staged, Diagnostic> {
    let target = target_of(path)?;
    match write_beside(&target, folder_of(&target), bytes) {
        Ok(file) => Ok(Staged {
            path: path.to_owned(),
            target,
            file,
        }),
        Err(error) => Err(cannot_write(path, &target, &error)),
    }
}

/// The file that is written for `path`: the one that it is a link to, or itself.
///
/// # Errors
/// As [`staged`], as far as it can be told without writing.
pub(super) fn target_of(path: &Path) -> Result<PathBuf, Diagnostic> {
    let Some(target) = behind_links(path) else {
        let message = "expected a file to write, found a link that leads to itself";
        return Err(Diagnostic::new(path, message));
    };
    let folder = folder_of(&target);
    if let Ok(found) = std::fs::metadata(&target) {
        let wrong = if found.is_dir() {
            Some("expected a file to write, found a folder")
        } else if !found.is_file() {
            Some("expected an ordinary file to write, found a device or a pipe")
        } else if found.permissions().readonly() {
            Some("this file is write-protected")
        } else {
            None
        };
        if let Some(wrong) = wrong {
            return Err(Diagnostic::new(path, wrong));
        }
    }
    if !folder.is_dir() {
        let message = format!("there is no folder {}", folder.display());
        return Err(Diagnostic::new(path, message));
    }
    Ok(target)
}

/// Writes `bytes`, those of the file at `target`, to a temporary file that becomes `beside`, which lies in
/// the same folder.
///
/// # Errors
/// As [`staged`].
pub(super) fn copied_beside(
    target: &Path,
    beside: PathBuf,
    bytes: &[u8],
) -> Result<Staged, Diagnostic> {
    match write_beside(target, folder_of(target), bytes) {
        Ok(file) => Ok(Staged {
            path: beside.clone(),
            target: beside,
            file,
        }),
        Err(error) => Err(cannot_write(&beside, &beside, &error)),
    }
}

pub(super) fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn cannot_write(path: &Path, target: &Path, error: &io::Error) -> Diagnostic {
    let message = match error.kind() {
        ErrorKind::PermissionDenied => {
            let folder = folder_of(target).display();
            format!("there is no permission to write in {folder}")
        }
        _ => in_words(error),
    };
    Diagnostic::new(path, message)
}

/// Why a file is not replaced by one that was written beside it, so that it is not the folder's fault.
fn cannot_replace(path: &Path, error: &io::Error) -> Diagnostic {
    let message = match error.kind() {
        ErrorKind::PermissionDenied => {
            "the system does not let this file be replaced: it is immutable, or somebody else's"
                .to_owned()
        }
        _ => in_words(error),
    };
    Diagnostic::new(path, message)
}

/// Target of `path` after all symbolic links, which need not exist; `None` for links in a circle.
pub(super) fn behind_links(path: &Path) -> Option<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        // Fails for what is no link, or does not exist.
        let Ok(next) = std::fs::read_link(&target) else {
            return Some(target);
        };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    None
}

/// Name of a temporary file: this, some random letters, and [`SUFFIX`].
const PREFIX: &str = ".editor-";
const SUFFIX: &str = ".part";

/// Writes `bytes` to a temporary file in `folder`, with the permissions that `target` has.
fn write_beside(target: &Path, folder: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    remove_abandoned(folder);
    let mut file = temporary_file(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    if let Ok(before) = std::fs::metadata(target) {
        file.as_file().set_permissions(before.permissions())?;
    }
    Ok(file)
}

/// A new temporary file in `folder`, locked for as long as it is open: the lock says that someone
/// is still writing to it.
fn temporary_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    // By default only the owner may read a temporary file; the process's mask applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        // Where the file system knows no locks, nobody takes the file for abandoned either.
        let locked = file.as_file().lock();
        // Another process may have taken it for abandoned before it was locked.
        if locked.is_err() || file.path().exists() {
            return Ok(file);
        }
    }
}

/// Removes the temporary files in `folder` of processes that were ended while they wrote. Their
/// locks ended with them.
fn remove_abandoned(folder: &Path) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let name = entry.file_name();
        let name = name.as_encoded_bytes();
        let is_temporary = name.starts_with(PREFIX.as_bytes()) && name.ends_with(SUFFIX.as_bytes());
        // Opening a pipe waits, and a link leads to someone else's file.
        if is_temporary && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            let Ok(file) = File::options().write(true).open(entry.path()) else {
                continue;
            };
            // Locked until it is gone: who has just made it waits for the lock, and then sees that it is.
            if file.try_lock().is_ok() {
                // What cannot be removed stays; that keeps nobody from writing.
                let _ = std::fs::remove_file(entry.path());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_an_ended_process_left_behind_goes_with_the_next_file_and_nothing_else_does() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        // As a process leaves it that is ended while it writes.
        let (_, left) = temporary_file(folder.path()).unwrap().keep().unwrap();
        let writing = temporary_file(folder.path()).unwrap();
        for name in ["editor-a.part", ".editor-a.parts", ".part"] {
            fs::write(path(name), "mine").unwrap();
        }
        fs::create_dir(path(".editor-b.part")).unwrap();
        staged(&path("a.obj"), b"one")
            .unwrap()
            .put_in_place()
            .unwrap();
        assert!(!left.exists());
        assert!(writing.path().exists(), "its writer is still there");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 6);
    }

    #[test]
    fn it_is_not_the_folder_s_fault_that_a_file_cannot_be_replaced() {
        let refused = io::Error::from(ErrorKind::PermissionDenied);
        let error = cannot_replace(Path::new("a.scene"), &refused);
        assert_eq!(error.path, Path::new("a.scene"));
        assert!(error.message.contains("this file"), "{error}");
    }
}
