use super::scanner::{QUICK_STRETCH, STRETCH};
use super::{Diagnostic, Files};
use crate::steps::Pace;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Files that keep a record of what is read through them: of each file its path and the CRC-32 of
/// its bytes.
pub(super) struct Recorder<'a> {
    files: &'a dyn Files,
    record: Mutex<Record>,
}

#[derive(Default)]
struct Record {
    /// Paths with their CRC-32, in the order in which they were first read.
    read: Vec<(PathBuf, u32)>,
    known: HashSet<PathBuf>,
}

impl<'a> Recorder<'a> {
    /// A recorder of what is read from `files`.
    pub fn new(files: &'a dyn Files) -> Self {
        Self {
            files,
            record: Mutex::default(),
        }
    }

    fn record(&self) -> MutexGuard<'_, Record> {
        self.record.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// As [`Files::read`], at a pace that is told of bytes.
    ///
    /// # Errors
    /// As [`Files::read`].
    pub async fn read_by(&self, path: &Path, pace: &Pace) -> Result<Vec<u8>, Diagnostic> {
        let bytes = self.files.read(path)?;
        let mut one = crc32fast::Hasher::new();
        for stretch in bytes.chunks(QUICK_STRETCH) {
            one.update(stretch);
            pace.after(STRETCH).await;
        }
        self.take_note(path, || one.finalize());
        Ok(bytes)
    }

    /// Takes note that the file at `path`, whose bytes have this CRC-32, was read.
    fn take_note(&self, path: &Path, digest: impl FnOnce() -> u32) {
        let mut record = self.record();
        if record.known.insert(path.to_owned()) {
            record.read.push((path.to_owned(), digest()));
        }
    }

    /// Fingerprint of all files that were read so far: a CRC-32 that differs, but for chance, if
    /// one of them does.
    pub fn fingerprint(&self) -> u32 {
        let mut all = crc32fast::Hasher::new();
        for (_, one) in &self.record().read {
            all.update(&one.to_le_bytes());
        }
        all.finalize()
    }

    /// Paths of all files that were read so far, in the order in which they were first read.
    pub fn into_paths(self) -> Vec<PathBuf> {
        let record = self.record.into_inner();
        let record = record.unwrap_or_else(PoisonError::into_inner);
        record.read.into_iter().map(|(path, _)| path).collect()
    }
}

impl Files for Recorder<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let bytes = self.files.read(path)?;
        self.take_note(path, || crc32fast::hash(&bytes));
        Ok(bytes)
    }

    fn exists(&self, path: &Path) -> bool {
        self.files.exists(path)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        self.files.absolute(path)
    }

    fn real(&self, path: &Path) -> PathBuf {
        self.files.real(path)
    }
}
