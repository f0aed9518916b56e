//! Archives, `.zip`: written from files in memory, and read as if they were folders.

use super::file_access::{self, is_archive, is_note_of_macos, is_scene};
use super::{Diagnostic, Files, IMPORTABLE};
use std::collections::BTreeSet;
use std::io::{Cursor, Read, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

/// Largest sum of the sizes of all files of an archive, in bytes, unpacked.
const LARGEST: u64 = 1 << 30;
/// Largest number of files of an archive.
const MOST_FILES: usize = 10_000;

/// A `.zip` archive of `entries`, each a relative path and its content. Equal entries make equal
/// archives: they have no time.
///
/// # Errors
/// If a file is larger, or a path longer, than an archive can hold.
pub fn to_zip(entries: &[(PathBuf, Vec<u8>)]) -> Result<Vec<u8>, Diagnostic> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().last_modified_time(zip::DateTime::default());
    for (path, bytes) in entries {
        let wrong = |error: ZipError| Diagnostic::new(path, error.to_string());
        zip.start_file(file_access::with_slashes(path), options)
            .map_err(wrong)?;
        zip.write_all(bytes)
            .map_err(|error| Diagnostic::new(path, error.to_string()))?;
    }
    let written = zip.finish();
    let written = written.map_err(|error| Diagnostic::new(Path::new("zip"), error.to_string()))?;
    Ok(written.into_inner())
}

/// Files, with those inside archives: `a.zip/x.obj` is `x.obj` in the archive `a.zip`.
#[derive(Debug)]
pub struct WithArchives<F> {
    files: F,
    /// The archive that was read last, since most files of one are read one after the other.
    last: Mutex<Option<Archive>>,
}

impl<F: Files> WithArchives<F> {
    /// `files`, with those inside its archives.
    pub fn new(files: F) -> Self {
        Self {
            files,
            last: Mutex::new(None),
        }
    }

    /// The archive that `path` leads into, and the name of the file there.
    fn split(&self, path: &Path) -> Option<(PathBuf, String)> {
        let mut folders = path.ancestors().skip(1);
        let is_archive = |folder: &&Path| is_archive(folder) && self.files.exists(folder);
        let archive = folders.find(is_archive)?;
        let inner = path.strip_prefix(archive).ok()?;
        Some((archive.to_owned(), file_access::with_slashes(inner)))
    }

    fn in_archive<T>(
        &self,
        archive: &Path,
        read: impl FnOnce(&mut Archive) -> Result<T, Diagnostic>,
    ) -> Result<T, Diagnostic> {
        // Whoever failed while it had the lock has left an archive that can be read.
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = last.as_mut().filter(|known| known.path == archive) {
            return read(known);
        }
        let opened = Archive::open(archive, self.files.read(archive)?)?;
        read(last.insert(opened))
    }
}

impl<F: Files> Files for WithArchives<F> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        match self.split(path) {
            None => self.files.read(path),
            Some((archive, name)) => self.in_archive(&archive, |archive| archive.read(path, &name)),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        match self.split(path) {
            None => self.files.exists(path),
            Some((archive, name)) => self
                .in_archive(&archive, |archive| Ok(archive.has(&name)))
                .unwrap_or(false),
        }
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        self.files.absolute(path)
    }

    fn real(&self, path: &Path) -> PathBuf {
        self.files.real(path)
    }
}

/// An archive that was found to be harmless: all its names lead to places inside it, and it does not
/// unpack to more than fits into memory.
#[derive(Debug)]
struct Archive {
    path: PathBuf,
    zip: ZipArchive<Cursor<Vec<u8>>>,
}

impl Archive {
    fn open(path: &Path, bytes: Vec<u8>) -> Result<Self, Diagnostic> {
        let wrong = |message: String| Err(Diagnostic::new(path, message));
        let Ok(mut zip) = ZipArchive::new(Cursor::new(bytes)) else {
            return wrong("expected a .zip archive, found another or a damaged file".to_owned());
        };
        if zip.len() > MOST_FILES {
            let count = zip.len();
            return wrong(format!(
                "expected at most {MOST_FILES} files in it, found {count}"
            ));
        }
        let mut unpacked = 0_u64;
        for index in 0..zip.len() {
            let file = zip.by_index_raw(index);
            let known = file.and_then(|file| Ok((file.name()?.into_owned(), file.size())));
            let Ok((name, size)) = known else {
                return wrong("expected a whole archive, found a damaged one".to_owned());
            };
            if !is_inside(&name) {
                let name = super::scanner::quoted(&name);
                let message = format!("expected names of files inside the archive, found {name}");
                return wrong(message);
            }
            unpacked = unpacked.saturating_add(size);
        }
        if unpacked > LARGEST {
            let (most, found) = (LARGEST >> 20, unpacked >> 20);
            return wrong(format!(
                "expected files of at most {most} MiB in it, unpacked, found {found}"
            ));
        }
        let path = path.to_owned();
        Ok(Self { path, zip })
    }

    fn has(&self, name: &str) -> bool {
        self.zip.index_for_name(name).is_some()
    }

    /// The content of the file `name`, which messages call `path`.
    fn read(&mut self, path: &Path, name: &str) -> Result<Vec<u8>, Diagnostic> {
        let file = self.zip.by_name(name).map_err(|error| match error {
            ZipError::FileNotFound => Diagnostic::new(path, "there is no such file"),
            ZipError::UnsupportedArchive(_) => Diagnostic::new(
                path,
                "expected a file that is stored or deflated without a password, found another",
            ),
            _ => Diagnostic::new(
                path,
                "expected a whole file in the archive, found a damaged one",
            ),
        })?;
        // What is promised was checked; more than that is not unpacked.
        let size = file.size();
        let mut bytes = Vec::new();
        let read = file.take(size + 1).read_to_end(&mut bytes);
        if read.is_err() || bytes.len() as u64 != size {
            let message = "expected a whole file in the archive, found a damaged one";
            return Err(Diagnostic::new(path, message));
        }
        Ok(bytes)
    }
}

/// What is opened of the archive at `path`, as paths that [`WithArchives`] reads: its one scene, or else all
/// models in it, in the order of their names, as if they had been chosen together.
///
/// # Errors
/// If the archive cannot be read, or there is more than one scene in it, or neither a scene nor a model.
pub(super) fn main_files(files: &dyn Files, path: &Path) -> Result<Vec<PathBuf>, Diagnostic> {
    let archive = Archive::open(path, files.read(path)?)?;
    let names = archive.zip.file_names().filter_map(Result::ok);
    let names = names.map(|name| PathBuf::from(name.as_ref()));
    let is_note = |name: &Path| name.file_name().is_some_and(is_note_of_macos);
    let names: Vec<PathBuf> = names.filter(|name| !is_note(name)).collect();
    let scenes = names.iter().filter(|name| is_scene(name));
    let scenes: Vec<&PathBuf> = scenes.collect();
    let wrong = |message| Err(Diagnostic::new(path, message));
    if let [only] = scenes[..] {
        return Ok(vec![path.join(only)]);
    }
    if !scenes.is_empty() {
        let count = scenes.len();
        return wrong(format!("expected one .scene in it, found {count}"));
    }
    let is_model = |name: &&PathBuf| IMPORTABLE.contains(&&*file_access::extension(name));
    let models = names.iter().filter(is_model).map(|name| path.join(name));
    let models: BTreeSet<PathBuf> = models.collect();
    if models.is_empty() {
        let models = IMPORTABLE
            .map(|extension| format!(".{extension}"))
            .join(", ");
        return wrong(format!(
            "expected a .scene or a model ({models}) in it, found neither"
        ));
    }
    Ok(models.into_iter().collect())
}

/// The models in the archive at `path` if there is no scene among them, and else `path` itself: what is to be opened
/// where an archive stands for the files in it. One that cannot be opened stands for itself, so that reading it says
/// why.
pub fn unpacked(files: &dyn Files, path: &Path) -> Vec<PathBuf> {
    let own = || vec![path.to_owned()];
    if !is_archive(path) {
        return own();
    }
    match main_files(files, path) {
        Ok(models) if !models.iter().any(|model| is_scene(model)) => models,
        _ => own(),
    }
}

/// Whether a name leads to a place inside the archive, on every system.
fn is_inside(name: &str) -> bool {
    let is_plain = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    !name.contains(['\\', ':', '\0'])
        && !name.starts_with('/')
        && Path::new(name).components().all(is_plain)
}
