//! The file of a document, and how much of the document is in it.

use super::document::Next;
use crate::io::Files;
use crate::revision::Revision;
use crate::scene::{ShapeId, Source};
use std::path::{Path, PathBuf};

/// File of the document, and how much of the document is in it.
pub(super) struct DocumentFile {
    /// File that Save writes; `None` until there is one.
    pub path: Option<PathBuf>,
    /// Revision of the document that is in the file, or that was opened.
    pub saved: Revision,
    /// CRC-32 of the file's bytes as they were read or written last: other bytes are another
    /// program's.
    pub digest: Option<u32>,
    /// Write under way.
    pub writing: Option<Writing>,
    /// Continuation of the next save, for which a file is being chosen.
    pub then: Option<Next>,
    /// Name without an extension that files made from the document are offered, while it has no
    /// file: that of what was opened.
    pub stem: Option<String>,
    /// Revision of the document of which the user has said that changes are not wanted, while what
    /// comes after it still waits for something else.
    pub discarded: Option<Revision>,
    /// What `saved` was before the file disappeared, in case it comes back.
    pub saved_in_lost_file: Option<Revision>,
}

/// Write after which the document is saved.
pub(super) struct Writing {
    pub path: PathBuf,
    /// Revision of the document that is written.
    pub document: Revision,
    /// CRC-32 of the bytes that are written.
    pub digest: u32,
    /// Files that shapes come from in what is written, where these are others than now.
    pub sources: Vec<(ShapeId, Source)>,
    pub then: Option<Next>,
}

impl DocumentFile {
    /// A document without a file, of which `saved` is no loss.
    pub fn untitled(saved: Revision) -> Self {
        Self {
            path: None,
            saved,
            digest: None,
            writing: None,
            then: None,
            stem: None,
            discarded: None,
            saved_in_lost_file: None,
        }
    }

    /// A document that is not in its file, of which an earlier run knew `digest`.
    pub fn restored(path: Option<PathBuf>, digest: Option<u32>) -> Self {
        Self {
            path,
            digest,
            ..Self::untitled(Revision::new())
        }
    }

    /// File that Save writes; `None` until there is one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether the file is as it was read or written last; so is one that is gone.
    pub fn is_on_disk(&self, files: &dyn Files) -> bool {
        let found = self.path.as_deref().and_then(|path| digest_at(path, files));
        found.is_none() || found == self.digest
    }

    /// Takes note that the file has disappeared or is another's: nothing of the document is saved any
    /// more.
    pub fn lose(&mut self) {
        let saved = std::mem::replace(&mut self.saved, Revision::new());
        self.saved_in_lost_file.get_or_insert(saved);
    }

    /// Whether `document` was in the file before this was replaced or deleted.
    pub fn was_saved(&self, document: Revision) -> bool {
        self.saved_in_lost_file == Some(document)
    }

    /// Takes note that the file is there, as it was read or written last.
    pub fn find(&mut self) {
        if let Some(saved) = self.saved_in_lost_file.take() {
            self.saved = saved;
        }
    }

    /// Digest of the file's bytes as they were read or written last.
    pub fn digest(&self) -> Option<u32> {
        self.digest
    }
}

/// Digest of a file; `None` if it cannot be read.
pub(super) fn digest_at(path: &Path, files: &dyn Files) -> Option<u32> {
    files.read(path).ok().map(|bytes| crc32fast::hash(&bytes))
}
