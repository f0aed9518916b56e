//! Names of files that fit but for capitals.

use crate::io::{Diagnostic, Files};
use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Files that take note of all that is looked for among them.
pub(super) struct Asked<'a> {
    files: &'a dyn Files,
    paths: Mutex<BTreeSet<PathBuf>>,
}

impl<'a> Asked<'a> {
    pub(super) fn new(files: &'a dyn Files) -> Self {
        Self {
            files,
            paths: Mutex::default(),
        }
    }

    fn take_note(&self, path: &Path) {
        let mut paths = self.paths.lock().unwrap_or_else(PoisonError::into_inner);
        paths.insert(path.to_owned());
    }

    /// In words each file beside `file`, or in folders there, whose name differs in capitals alone from one that was
    /// looked for. Whether such a file is found depends on the system.
    pub(super) fn other_capitals(&self, file: &Path) -> Vec<String> {
        let folder = file.parent().unwrap_or(Path::new(""));
        let paths = self.paths.lock().unwrap_or_else(PoisonError::into_inner);
        let beside = paths
            .iter()
            .filter_map(|path| path.strip_prefix(folder).ok());
        let other = beside.filter_map(|path| Some((path, in_other_capitals(folder, path)?)));
        let words = other.map(|(asked, found)| {
            format!(
                "{} is not called {}, as is looked for: Windows and macOS take the one for the other, Linux does not",
                found.display(),
                asked.display()
            )
        });
        words.collect()
    }
}

/// The path of a file in `folder` that differs from `path` in capitals, if there is one and none at `path` itself.
fn in_other_capitals(folder: &Path, path: &Path) -> Option<PathBuf> {
    let mut found = PathBuf::new();
    for part in path.components() {
        let Component::Normal(name) = part else {
            found.push(part);
            continue;
        };
        let listed = match folder.join(&found) {
            here if here.as_os_str().is_empty() => std::fs::read_dir("."),
            within => std::fs::read_dir(within),
        };
        let names: Vec<_> = listed
            .ok()?
            .flatten()
            .map(|entry| entry.file_name())
            .collect();
        if names.iter().any(|other| other == name) {
            found.push(name);
            continue;
        }
        let lower = name.to_string_lossy().to_lowercase();
        let mut alike = names
            .iter()
            .filter(|other| other.to_string_lossy().to_lowercase() == lower);
        found.push(alike.next()?);
    }
    (found != path).then_some(found)
}

impl Files for Asked<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        self.take_note(path);
        self.files.read(path)
    }

    fn exists(&self, path: &Path) -> bool {
        self.take_note(path);
        self.files.exists(path)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        self.files.absolute(path)
    }

    fn real(&self, path: &Path) -> PathBuf {
        self.files.real(path)
    }
}
