//! Writing whole files.

use super::staged::{Staged, behind_links, copied_beside, folder_of, staged, target_of};
use super::{Disk, in_words};
use crate::io::{Diagnostic, Files};
use std::path::{Path, PathBuf};

/// Writes `bytes` to `path` atomically, so that the file has either its old contents or all of the
/// new: to a temporary file in the same folder, which is then renamed. A symbolic link stays a
/// link, even to a file that does not exist yet, and an existing file keeps its permissions.
///
/// # Errors
/// If the folder does not exist or is not writable, the disk is full, or `path` is a folder, a
/// device or a pipe. Then nothing is left behind.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Diagnostic> {
    staged(path, bytes)?.put_in_place()
}

/// Whether [`write_whole`] may write to `path`, as far as it can be told before there is anything to write, so that
/// nobody waits for work that is lost.
///
/// # Errors
/// As [`write_whole`]. A folder that is missing is never made: its name may be misspelled.
pub fn expect_place_for(path: &Path) -> Result<(), Diagnostic> {
    target_of(path).map(|_| ())
}

/// Writes several files that belong together, each as [`write_whole`] does: all are first written
/// to temporary files, and then renamed in their order, so that a file that names others comes last.
///
/// # Errors
/// As [`write_whole`], at the first file; then nothing is left behind. Only if the system refuses to
/// rename one that it let be written, those before it stay.
pub fn write_all_whole(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Diagnostic> {
    let all = files.iter().map(|(path, bytes)| staged(path, bytes));
    let all: Vec<Staged> = all.collect::<Result<_, _>>()?;
    all.into_iter().try_for_each(Staged::put_in_place)
}

/// Writes files as [`write_all_whole`] does, and keeps each that is replaced as `NAME~` beside the new
/// one, in the place of an older one, but for those whose path and bytes are `dispensable`. A file that
/// has the same bytes already is left alone, so that writing twice does not lose what was there before.
///
/// # Errors
/// As [`write_all_whole`]; then those of `NAME~` are the old ones as well.
pub fn write_all_keeping(
    files: &[(PathBuf, Vec<u8>)],
    dispensable: &dyn Fn(&Path, &[u8]) -> bool,
) -> Result<(), Diagnostic> {
    let is_new = |(path, bytes): &&(PathBuf, Vec<u8>)| !holds(path, bytes);
    let mut all = Vec::new();
    for (path, bytes) in files.iter().filter(is_new) {
        all.push((staged(path, bytes)?, copy_beside(path, dispensable)?));
    }
    all.into_iter().try_for_each(replace_and_keep)
}

/// Puts a file in its place, and then what was there before: if the system refuses the first, the older
/// version stays that is kept.
fn replace_and_keep((written, kept): (Staged, Option<Staged>)) -> Result<(), Diagnostic> {
    written.put_in_place()?;
    kept.map_or(Ok(()), Staged::put_in_place)
}

/// Whether the file at `path` has just these bytes.
fn holds(path: &Path, bytes: &[u8]) -> bool {
    let length = std::fs::metadata(path).map(|file| file.len());
    length.is_ok_and(|length| length == bytes.len() as u64)
        && Disk.read(path).is_ok_and(|read| read == bytes)
}

/// Longest name of a file on most systems, in bytes.
const LONGEST_NAME: usize = 255;

/// A copy of the file at `path`, to be put beside it as `NAME~`; `None` if there is no such file, it is
/// `dispensable`, or its name has no room for the mark.
fn copy_beside(
    path: &Path,
    dispensable: &dyn Fn(&Path, &[u8]) -> bool,
) -> Result<Option<Staged>, Diagnostic> {
    let Some(target) = behind_links(path).filter(|target| target.is_file()) else {
        // Whatever is wrong with the file, writing it says so.
        return Ok(None);
    };
    let name = target.file_name().unwrap_or_default();
    if name.len() >= LONGEST_NAME {
        return Ok(None);
    }
    let mut beside = target.clone().into_os_string();
    beside.push("~");
    let beside = PathBuf::from(beside);
    let read = Disk.read(&target)?;
    if dispensable(path, &read) {
        return Ok(None);
    }
    copied_beside(&target, beside, &read).map(Some)
}

/// Makes the folder that `path` lies in, and those above it, where they are missing.
///
/// # Errors
/// If the system refuses.
pub fn make_folder_of(path: &Path) -> Result<(), Diagnostic> {
    let folder = folder_of(path);
    std::fs::create_dir_all(folder).map_err(|error| Diagnostic::new(folder, in_words(&error)))
}

/// Makes the folders that `paths` lie in, where they are missing, and then calls `write`. If either fails,
/// the folders that were made are taken away again, as far as they are empty.
///
/// # Errors
/// If the system refuses a folder, or as `write`.
pub fn in_new_folders<'p>(
    paths: impl Iterator<Item = &'p Path> + Clone,
    write: impl FnOnce() -> Result<(), Diagnostic>,
) -> Result<(), Diagnostic> {
    let missing = |path: &'p Path| folder_of(path).ancestors().take_while(|it| !it.exists());
    let mut made: Vec<&Path> = paths.clone().flat_map(missing).collect();
    let written = paths
        .map(make_folder_of)
        .try_for_each(|folder| folder)
        .and_then(|()| write());
    if written.is_err() {
        // A folder comes before the one that it lies in; one that is not empty stays.
        made.sort_unstable_by(|one, other| other.cmp(one));
        made.dedup();
        for folder in made {
            let _ = std::fs::remove_dir(folder);
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

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
    fn folders_that_are_made_for_files_go_again_if_these_cannot_be_written() {
        let folder = tempfile::tempdir().unwrap();
        let blocked = folder.path().join("blocked");
        fs::create_dir_all(blocked.join("a.obj")).unwrap();
        let files = |last: &str| {
            let paths = ["new/deep/b.obj", "new/c.obj", last];
            paths.map(|path| (folder.path().join(path), b"one".to_vec()))
        };
        let write = |last| {
            let files = files(last);
            let paths = files.iter().map(|(path, _)| &**path);
            in_new_folders(paths, || write_all_whole(&files))
        };
        assert!(write("blocked/a.obj").is_err());
        assert_eq!(entries(folder.path()), 1);
        assert!(blocked.join("a.obj").is_dir());
        write("blocked/d.obj").unwrap();
        assert!(folder.path().join("new/deep/b.obj").is_file());
        assert_eq!(fs::read(blocked.join("d.obj")).unwrap(), b"one");
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

    #[test]
    fn files_that_belong_together_are_written_all_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| (folder.path().join(name), text.as_bytes().to_vec());
        fs::write(folder.path().join("a.obj"), "old").unwrap();
        let missing = file("none/a.png", "3");
        let error = write_all_whole(&[file("a.obj", "1"), file("a.mtl", "2"), missing]);
        assert!(error.unwrap_err().message.starts_with("there is no folder"));
        assert_eq!(fs::read(folder.path().join("a.obj")).unwrap(), b"old");
        assert_eq!(entries(folder.path()), 1);
        write_all_whole(&[file("a.mtl", "2"), file("a.obj", "1")]).unwrap();
        assert_eq!(fs::read(folder.path().join("a.obj")).unwrap(), b"1");
        assert_eq!(fs::read(folder.path().join("a.mtl")).unwrap(), b"2");
        assert_eq!(entries(folder.path()), 2);
    }

    #[test]
    fn the_version_before_is_kept_until_there_is_another_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.scene");
        let write = |text: &str| {
            write_all_keeping(&[(path.clone(), text.as_bytes().to_vec())], &|_, _| false)
        };
        let kept = || fs::read(folder.path().join("a.scene~")).ok();
        write("one").unwrap();
        assert_eq!(kept(), None);
        write("two").unwrap();
        write("two").unwrap();
        assert_eq!(kept().unwrap(), b"one", "saved twice");

        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        write("three").unwrap_err();
        assert_eq!(kept().unwrap(), b"one", "nothing was replaced");
        assert_eq!(entries(folder.path()), 2);
    }

    #[test]
    fn a_file_that_cannot_be_replaced_is_named_and_leaves_the_version_that_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.scene");
        fs::write(&path, "two").unwrap();
        fs::write(folder.path().join("a.scene~"), "one").unwrap();
        let written = staged(&path, b"three").unwrap();
        let kept = copy_beside(&path, &|_, _| false).unwrap();
        // Something that no system replaces by a file.
        fs::remove_file(&path).unwrap();
        fs::create_dir(&path).unwrap();
        let error = replace_and_keep((written, kept)).unwrap_err();
        assert_eq!(error.path, path);
        assert_eq!(fs::read(folder.path().join("a.scene~")).unwrap(), b"one");
        assert_eq!(entries(folder.path()), 2);
    }

    #[test]
    fn what_is_dispensable_does_not_take_the_place_of_what_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, "theirs").unwrap();
        for ours in ["one", "two", "three"] {
            let file = [(path.clone(), ours.as_bytes().to_vec())];
            write_all_keeping(&file, &|_, old| old != b"theirs").unwrap();
        }
        assert_eq!(fs::read(folder.path().join("a.png~")).unwrap(), b"theirs");
        assert_eq!(fs::read(&path).unwrap(), b"three");
    }

    #[test]
    fn a_kept_version_is_replaced_though_it_is_write_protected_and_a_name_may_be_too_long_for_one()
    {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.scene");
        let write = |path: &Path, text: &str| {
            write_all_keeping(&[(path.to_owned(), text.as_bytes().to_vec())], &|_, _| {
                false
            })
            .unwrap();
        };
        write(&path, "one");
        write(&path, "two");
        let kept = folder.path().join("a.scene~");
        let mut permissions = fs::metadata(&kept).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&kept, permissions).unwrap();
        write(&path, "three");
        assert_eq!(fs::read(&kept).unwrap(), b"two");

        let long = folder.path().join("a".repeat(LONGEST_NAME));
        write(&long, "one");
        write(&long, "two");
        assert_eq!(fs::read(&long).unwrap(), b"two");
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
