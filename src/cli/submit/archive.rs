//! Archives to hand in, `.zip` and `.tar.gz`, made in memory.

use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::{self, Cursor, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Kind of archive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Zip,
    TarGz,
}

/// File of an archive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Path in the archive.
    pub path: PathBuf,
    pub bytes: Vec<u8>,
    pub is_executable: bool,
    /// Time of the last change. Who unpacks a submission over an older one and builds it gets what
    /// is new in it only if its files are newer.
    pub modified: SystemTime,
}

impl Entry {
    /// A new file, not to be executed.
    pub fn new(path: impl Into<PathBuf>, bytes: Vec<u8>) -> Self {
        Self {
            path: path.into(),
            bytes,
            is_executable: false,
            modified: SystemTime::now(),
        }
    }
}

impl Format {
    /// Extension with its dot.
    const EXTENSIONS: [(&'static str, Self); 2] = [(".zip", Self::Zip), (".tar.gz", Self::TarGz)];

    /// Format and name without the extension of the archive `path`; `None` if it is neither
    /// `.zip` nor `.tar.gz`, or nothing comes before that.
    pub fn of(path: &Path) -> Option<(Self, String)> {
        let name = path.file_name()?.to_string_lossy();
        let found = Self::EXTENSIONS.into_iter().find_map(|(end, format)| {
            let stem = name.len().checked_sub(end.len())?;
            let is_it = name.get(stem..)?.eq_ignore_ascii_case(end);
            is_it.then(|| (format, name[..stem].to_owned()))
        });
        found.filter(|(_, stem)| !stem.is_empty())
    }

    /// Archive of `entries`, all of them in the folder `root`.
    ///
    /// # Errors
    /// If a path is too long or a file too large for this kind of archive.
    pub fn pack(self, root: &str, entries: &[Entry]) -> io::Result<Vec<u8>> {
        match self {
            Self::Zip => to_zip(root, entries),
            Self::TarGz => to_tar_gz(root, entries),
        }
    }
}

/// Path in the archive, with forward slashes.
fn name(root: &str, path: &Path) -> String {
    let parts = path.iter().map(|part| part.to_string_lossy().into_owned());
    let parts: Vec<String> = std::iter::once(root.to_owned()).chain(parts).collect();
    parts.join("/")
}

fn mode(entry: &Entry) -> u32 {
    if entry.is_executable { 0o755 } else { 0o644 }
}

fn to_zip(root: &str, entries: &[Entry]) -> io::Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for entry in entries {
        let local = chrono::DateTime::<chrono::Local>::from(entry.modified).naive_local();
        let options = SimpleFileOptions::default()
            // Archives know no time before 1980.
            .last_modified_time(local.try_into().unwrap_or_default())
            .unix_permissions(mode(entry));
        zip.start_file(name(root, &entry.path), options)?;
        zip.write_all(&entry.bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}

fn to_tar_gz(root: &str, entries: &[Entry]) -> io::Result<Vec<u8>> {
    let mut tar = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::default()));
    for entry in entries {
        let mut header = tar::Header::new_gnu();
        header.set_size(entry.bytes.len() as u64);
        header.set_mode(mode(entry));
        let modified = entry.modified.duration_since(UNIX_EPOCH);
        header.set_mtime(modified.unwrap_or_default().as_secs());
        tar.append_data(&mut header, name(root, &entry.path), &entry.bytes[..])?;
    }
    tar.into_inner()?.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kind_of_archive_follows_from_its_name() {
        let of = |name: &str| Format::of(Path::new(name));
        assert_eq!(of("a/b.zip"), Some((Format::Zip, "b".to_owned())));
        assert_eq!(of("b.c.TAR.GZ"), Some((Format::TarGz, "b.c".to_owned())));
        for bad in ["b.tar", "b.gz", "zip", ".zip", "b", "ä", ""] {
            assert_eq!(of(bad), None, "{bad}");
        }
    }

    #[test]
    fn times_before_those_that_archives_know_are_no_failure() {
        for modified in [
            UNIX_EPOCH,
            UNIX_EPOCH - std::time::Duration::from_secs(1 << 33),
        ] {
            let entry = Entry {
                modified,
                ..Entry::new("a/b", vec![1, 2, 3])
            };
            for format in [Format::Zip, Format::TarGz] {
                assert!(format.pack("x", std::slice::from_ref(&entry)).is_ok());
            }
        }
    }
}
