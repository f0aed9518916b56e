//! The file system: reading whole files, and writing them whole or not at all. Used by the window
//! and the commands, which pass it to the layers below as [`crate::io::Files`].

use crate::io::builtin::WithBuiltin;
use crate::io::{Diagnostic, Files, WithArchives};
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Files that the program can read: those on disk, also inside archives, and those built in.
pub fn files() -> WithBuiltin<WithArchives<Disk>> {
    WithBuiltin(WithArchives::new(Disk))
}

/// Size of the largest file that is read, in bytes.
const LARGEST: u64 = 1 << 30;

/// Files on this machine.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    /// # Errors
    /// If there is no such file, it may not be read, is no ordinary file, or has more than 1 GiB.
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let diagnostic = |error: io::Error| Diagnostic::new(path, in_words(&error));
        // Checked before opening, since opening a pipe waits until someone writes to it.
        let metadata = std::fs::metadata(path).map_err(diagnostic)?;
        let wrong = if metadata.is_dir() {
            "expected a file, found a folder".to_owned()
        } else if !metadata.is_file() {
            "expected an ordinary file, found a device or a pipe".to_owned()
        } else if metadata.len() > LARGEST {
            let mib = metadata.len() >> 20;
            format!("expected a file of at most 1024 MiB, found {mib}")
        } else {
            let mut bytes = Vec::with_capacity(metadata.len() as usize);
            let file = File::open(path).map_err(diagnostic)?;
            file.take(LARGEST)
                .read_to_end(&mut bytes)
                .map_err(diagnostic)?;
            return Ok(bytes);
        };
        Err(Diagnostic::new(path, wrong))
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        // Fails for an empty path, and where the current folder is gone.
        std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
    }
}

/// Message of an error, in plain words.
fn in_words(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::PermissionDenied => "there is no permission to open it".to_owned(),
        ErrorKind::NotADirectory => "a part of its path is a file, not a folder".to_owned(),
        ErrorKind::StorageFull => "the disk is full".to_owned(),
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read".to_owned(),
        _ => error.to_string(),
    }
}

/// Number of symbolic links that are followed, as in Linux.
const MOST_LINKS: usize = 40;

/// Writes `bytes` to `path` atomically, so that the file has either its old contents or all of the
/// new: to a temporary file in the same folder, which is then renamed. A symbolic link stays a
/// link, even to a file that does not exist yet, and an existing file keeps its permissions.
///
/// # Errors
/// If the folder does not exist or is not writable, the disk is full, or `path` is a folder, a
/// device or a pipe. Then nothing is left behind.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Diagnostic> {
    let Some(target) = behind_links(path) else {
        let message = "expected a file to write, found a link that leads to itself";
        return Err(Diagnostic::new(path, message));
    };
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
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
    write_beside(&target, folder, bytes).map_err(|error| {
        let message = match error.kind() {
            ErrorKind::PermissionDenied => {
                format!("there is no permission to write in {}", folder.display())
            }
            _ => in_words(&error),
        };
        Diagnostic::new(path, message)
    })
}

/// Keeps the file at `path` a second time as `NAME~` beside it, in the place of an older one: it
/// stays there when `path` is replaced. Does nothing if there is no such file.
///
/// # Errors
/// If the folder is not writable or the disk is full. The file at `path` is there in any case.
pub fn keep_beside(path: &Path) -> Result<(), Diagnostic> {
    let Some(target) = behind_links(path).filter(|target| target.is_file()) else {
        // Whatever is wrong with the file, writing it says so.
        return Ok(());
    };
    let mut name = target.clone().into_os_string();
    name.push("~");
    let beside = PathBuf::from(name);
    let read = Disk.read(&target)?;
    write_whole(&beside, &read)
}

/// Target of `path` after all symbolic links, which need not exist; `None` for links in a circle.
fn behind_links(path: &Path) -> Option<PathBuf> {
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

/// Whether two paths refer to the same existing file.
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    let real = |path| std::fs::canonicalize(path).ok();
    real(one).is_some() && real(one) == real(other)
}

/// Writes `bytes` to a temporary file in `folder`, which is then renamed to `target`.
fn write_beside(target: &Path, folder: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".editor-").suffix(".part");
    // By default only the owner may read a temporary file; the process's mask applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    if let Ok(before) = std::fs::metadata(target) {
        file.as_file().set_permissions(before.permissions())?;
    }
    file.persist(target).map_err(|error| error.error)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_no_readable_file_is_reported_in_plain_words() {
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

    #[test]
    fn a_path_on_disk_is_made_absolute_and_a_built_in_one_stays() {
        let here = std::env::current_dir().unwrap();
        let files = files();
        assert_eq!(files.absolute(Path::new("a/b.obj")), here.join("a/b.obj"));
        assert_eq!(files.absolute(Path::new("./b.obj")), here.join("b.obj"));
        let built_in = Path::new("builtin:adult");
        assert_eq!(files.absolute(built_in), built_in);
    }

    #[test]
    fn a_file_too_large_to_read_is_refused_with_its_size() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("huge.obj");
        // A hole: it takes no room on the disk.
        File::create(&path)
            .unwrap()
            .set_len((1 << 30) + (1 << 20))
            .unwrap();
        let error = Disk.read(&path).unwrap_err();
        let message = "expected a file of at most 1024 MiB, found 1025";
        assert_eq!(error.message, message);
    }

    #[test]
    fn a_file_is_the_same_under_all_its_names_and_missing_ones_are_not() {
        let folder = tempfile::tempdir().unwrap();
        let (path, missing) = (folder.path().join("a.obj"), folder.path().join("b.obj"));
        fs::write(&path, "v").unwrap();
        assert!(is_same_file(&path, &folder.path().join("./a.obj")));
        assert!(!is_same_file(&path, &missing));
        assert!(!is_same_file(&missing, &folder.path().join("c.obj")));
    }

    fn entries(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn a_file_is_written_and_replaced_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(entries(folder.path()), 1);
    }

    #[test]
    fn a_failed_write_leaves_nothing_behind_and_says_why() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("none").join("a.obj");
        let error = write_whole(&missing, b"one").unwrap_err();
        assert!(error.message.starts_with("there is no folder "), "{error}");
        let error = write_whole(folder.path(), b"one").unwrap_err();
        assert_eq!(error.message, "expected a file to write, found a folder");
        assert_eq!(entries(folder.path()), 0);
    }

    #[test]
    fn a_write_protected_file_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        fs::write(&path, "one").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        let error = write_whole(&path, b"two").unwrap_err();
        assert_eq!(error.message, "this file is write-protected");
        assert_eq!(fs::read(&path).unwrap(), b"one");
    }

    #[cfg(unix)]
    #[test]
    fn others_may_read_a_new_file_and_an_old_one_keeps_its_permissions_and_its_link() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("a"), folder.path().join("b"));
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        write_whole(&path, b"one").unwrap();
        let plain = folder.path().join("plain");
        fs::write(&plain, "").unwrap();
        assert_eq!(mode(&path), mode(&plain));

        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&path, &link).unwrap();
        write_whole(&link, b"two").unwrap();
        assert_eq!(mode(&path), 0o640);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&path).unwrap(), b"two");
    }

    #[cfg(unix)]
    #[test]
    fn what_is_no_ordinary_file_is_left_as_it_is() {
        use std::os::unix::fs::{FileTypeExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (socket, link) = (folder.path().join("a.obj"), folder.path().join("b.obj"));
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        symlink(&socket, &link).unwrap();
        for path in [&socket, &link] {
            let error = write_whole(path, b"one").unwrap_err();
            let message = "expected an ordinary file to write, found a device or a pipe";
            assert_eq!((&error.path, error.message.as_str()), (path, message));
        }
        let kept = fs::symlink_metadata(&socket).unwrap().file_type();
        assert!(kept.is_socket());
        assert_eq!(entries(folder.path()), 2);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_a_file_that_is_still_to_come_stays_a_link() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        fs::create_dir(&inner).unwrap();
        let (link, round) = (inner.join("link.obj"), inner.join("round.obj"));
        symlink("../over", &link).unwrap();
        symlink("new.obj", folder.path().join("over")).unwrap();
        write_whole(&link, b"one").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(folder.path().join("new.obj")).unwrap(), b"one");

        symlink("round.obj", &round).unwrap();
        let error = write_whole(&round, b"one").unwrap_err();
        let message = "expected a file to write, found a link that leads to itself";
        assert_eq!(error.message, message);
    }
}
