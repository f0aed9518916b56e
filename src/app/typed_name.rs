//! The file that is meant by what was typed or chosen in the file dialog.

use crate::disk::Disk;
use crate::io::Files;
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

/// The path of a file, from the root on and without `..`: a relative one would mean another file elsewhere,
/// and a path is shown by what it leads to.
pub(super) fn full_path(path: &Path) -> PathBuf {
    let is_up = |part: Component| part == Component::ParentDir;
    if path.components().any(is_up) {
        // Only the disk can tell what is above a folder that is a link.
        Disk.real(path)
    } else {
        Disk.absolute(path)
    }
}

/// `path` without the spaces around its name and before its extension, which the dialog adds to what was
/// typed; `None` for a name of nothing but spaces and an extension.
pub(super) fn trimmed(path: &Path) -> Option<PathBuf> {
    let (stem, extension) = (path.file_stem(), path.extension().unwrap_or_default());
    let (Some(stem), Some(extension)) = (stem.and_then(OsStr::to_str), extension.to_str()) else {
        // What is no text is taken as it is.
        return Some(path.to_owned());
    };
    let name = match (stem.trim(), extension.trim_end()) {
        ("", _) => return None,
        (stem, "") => stem.to_owned(),
        (stem, extension) => format!("{stem}.{extension}"),
    };
    Some(path.with_file_name(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_around_a_name_do_not_count_and_are_no_name() {
        let named = |name: &str| trimmed(&Path::new("/a b").join(name));
        for name in [
            "c d.scene",
            " c d.scene",
            "c d.scene ",
            "c d .scene",
            "\tc d.scene\u{a0}",
        ] {
            assert_eq!(named(name), Some("/a b/c d.scene".into()), "{name:?}");
        }
        assert_eq!(named(" Dr. No "), Some("/a b/Dr. No".into()));
        for name in [" ", "   ", " \t", "  .scene"] {
            assert_eq!(named(name), None, "{name:?}");
        }
    }

    #[test]
    fn a_path_is_told_without_its_detours() {
        let folder = tempfile::tempdir().unwrap();
        let real = folder.path().canonicalize().unwrap();
        assert_eq!(
            full_path(&real.join("gone/../b.scene")),
            real.join("b.scene")
        );
        assert_eq!(full_path(&real.join("b.scene")), real.join("b.scene"));
        assert!(full_path(Path::new("b.scene")).is_absolute());
    }
}
