//! The file system: reading whole files, and writing them whole or not at all. Used by the window
//! and the commands, which pass it to the layers below as [`crate::io::Files`].

mod piped;
mod plain_name;
mod scratch;
mod staged;
mod write;

pub use piped::{PIPE, as_given, is_pipe, pipe_of, take_standard_input};
pub use plain_name::plain_name;
pub use scratch::ScratchFolder;
pub use write::{
    expect_place_for, in_new_folders, make_folder_of, write_all_keeping, write_all_whole,
    write_whole,
};

use crate::io::builtin::WithBuiltin;
use crate::io::{Diagnostic, Files, WithArchives};
use piped::piped;
use std::fs::File;
use std::io::{self, ErrorKind, Read};
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
        match piped(path) {
            Some(bytes) => Ok(bytes.to_vec()),
            None => read_at_most(path, LARGEST),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        piped(path).is_some() || path.is_file()
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        if piped(path).is_some() {
            return path.to_owned();
        }
        // Fails for an empty path, and where the current folder is gone.
        std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
    }

    fn real(&self, path: &Path) -> PathBuf {
        // Links in what is there of it; what is not there has none.
        let resolved = |path: PathBuf| {
            let known = |there: &Path| {
                let rest = path.strip_prefix(there).ok()?;
                Some(std::fs::canonicalize(there).ok()?.join(rest))
            };
            path.ancestors().find_map(known).unwrap_or(path.clone())
        };
        // Those before `..` first, and then those after folders that are not there.
        let resolved_before = crate::io::normal(&resolved(self.absolute(path)));
        crate::io::normal(&resolved(resolved_before))
    }
}

/// The whole content of `path`, an ordinary file of at most `most` bytes, some whole MiB.
///
/// # Errors
/// If there is no such file, it may not be read, is no ordinary file, or has more bytes.
pub fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>, Diagnostic> {
    let diagnostic = |error: io::Error| Diagnostic::new(path, in_words(&error));
    let too_large = |found: u64| {
        let (most, found) = (most >> 20, found.div_ceil(1 << 20));
        let message = format!("expected a file of at most {most} MiB, found {found}");
        Diagnostic::new(path, message)
    };
    // Checked before opening, since opening a pipe waits until someone writes to it.
    let metadata = std::fs::metadata(path).map_err(diagnostic)?;
    if metadata.is_dir() {
        let message = "expected a file, found a folder";
        return Err(Diagnostic::new(path, message));
    }
    if !metadata.is_file() {
        let message = "expected an ordinary file, found a device or a pipe";
        return Err(Diagnostic::new(path, message));
    }
    if metadata.len() > most {
        return Err(too_large(metadata.len()));
    }
    let mut bytes = Vec::with_capacity(metadata.len() as usize);
    let file = File::open(path).map_err(diagnostic)?;
    // Some files of the system say that they are empty, and have no end.
    let mut bounded = file.take(most + 1);
    bounded.read_to_end(&mut bytes).map_err(diagnostic)?;
    if bytes.len() as u64 > most {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// Message of an error of the system, in plain words.
pub(crate) fn in_words(error: &io::Error) -> String {
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such file",
        ErrorKind::PermissionDenied => "there is no permission to open it",
        ErrorKind::NotADirectory => "a part of its path is a file, not a folder",
        ErrorKind::IsADirectory => "it is a folder",
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => "the disk is full",
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read",
        ErrorKind::FileTooLarge => "the disk takes no files as large as this",
        ErrorKind::InvalidFilename => {
            "its name is too long, or has characters that no name can have"
        }
        ErrorKind::InvalidInput => "its name has characters that no name can have",
        ErrorKind::OutOfMemory => "there is not enough memory",
        ErrorKind::ResourceBusy | ErrorKind::ExecutableFileBusy => "another program is using it",
        ErrorKind::StaleNetworkFileHandle
        | ErrorKind::HostUnreachable
        | ErrorKind::NetworkUnreachable
        | ErrorKind::TimedOut => "the network drive that it is on does not answer",
        _ => {
            // The system's own words, without its number for them.
            let text = error.to_string();
            let words = text.split(" (os error ").next().unwrap_or_default();
            return format!("the system reports “{words}”");
        }
    };
    words.to_owned()
}

/// Whether two paths refer to the same existing file.
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    let real = |path| std::fs::canonicalize(path).ok();
    real(one).is_some() && real(one) == real(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[cfg(unix)]
    #[test]
    fn all_ways_that_lead_to_a_file_are_one_path_also_where_it_is_not_there_yet() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        fs::create_dir_all(folder.join("models")).unwrap();
        fs::write(folder.join("models/a.obj"), "").unwrap();
        std::os::unix::fs::symlink(folder.join("models"), folder.join("link")).unwrap();
        assert_eq!(
            Disk.real(&folder.join("link/../c.obj")),
            Disk.real(&folder.join("c.obj"))
        );
        for name in ["a.obj", "b.obj", "c.zip/d.obj"] {
            let direct = Disk.real(&folder.join("models").join(name));
            assert_eq!(Disk.real(&folder.join("link").join(name)), direct);
            assert_eq!(Disk.real(&folder.join("x/../link").join(name)), direct);
        }
    }

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

    #[cfg(unix)]
    #[test]
    fn a_device_is_refused_without_being_read_and_a_file_is_read_up_to_the_bound() {
        let folder = tempfile::tempdir().unwrap();
        let (socket, zeros) = (folder.path().join("socket"), folder.path().join("zeros"));
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        std::os::unix::fs::symlink("/dev/zero", &zeros).unwrap();
        for path in [&socket, &zeros] {
            let error = read_at_most(path, 1 << 20).unwrap_err();
            let message = "expected an ordinary file, found a device or a pipe";
            assert_eq!(error.message, message);
        }
        let path = folder.path().join("a");
        fs::write(&path, vec![7; 1 << 20]).unwrap();
        assert_eq!(read_at_most(&path, 1 << 20).unwrap().len(), 1 << 20);
        fs::write(&path, vec![7; (1 << 20) + 1]).unwrap();
        let error = read_at_most(&path, 1 << 20).unwrap_err();
        let message = "expected a file of at most 1 MiB, found 2";
        assert_eq!(error.message, message);
    }

    #[cfg(unix)]
    #[test]
    fn no_message_shows_the_text_or_the_number_of_the_systems_error() {
        for code in 1..134 {
            let words = in_words(&io::Error::from_raw_os_error(code));
            assert!(!words.contains("os error"), "{code}: {words}");
        }
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("round.obj");
        std::os::unix::fs::symlink("round.obj", &link).unwrap();
        let message = |path: &Path| Disk.read(path).unwrap_err().message;
        let round = "the system reports “Too many levels of symbolic links”";
        assert_eq!(message(&link), round);
        let long = "its name is too long, or has characters that no name can have";
        assert_eq!(message(&folder.path().join("a".repeat(300))), long);
        let null = "its name has characters that no name can have";
        assert_eq!(message(Path::new("a\0.obj")), null);
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
}
