//! Files that the page has been given: chosen, dropped or named in its address.

use super::browser;
use super::kept_files;
use crate::io::builtin::is_builtin;
use crate::io::{self, Diagnostic, Files, namesakes};
use std::collections::{HashMap, HashSet};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use wasm_bindgen_futures::spawn_local;

/// Files by name. All of them lie beside each other, since browsers do not tell where files are from.
/// A clone is another handle to the same files.
#[derive(Clone, Debug)]
pub(super) struct GivenFiles {
    files: Arc<Mutex<Table>>,
    /// Files that were looked for beside the page, which has them not.
    absent: Arc<Mutex<HashSet<PathBuf>>>,
    /// Whether they are kept for the next visit.
    are_kept: bool,
}

type Table = HashMap<PathBuf, Vec<u8>>;

impl GivenFiles {
    /// Those that an earlier visit left. Others are kept for the next one if they `are_kept` at all.
    pub fn of(files: Table, are_kept: bool) -> Self {
        Self {
            files: Arc::new(Mutex::new(files)),
            absent: Arc::default(),
            are_kept,
        }
    }

    fn table(&self) -> MutexGuard<'_, Table> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds files that came together, beside each other and so that none takes the place of another one that was
    /// given, in this tab or another. Returns the folder in which they are.
    pub async fn place(&self, files: Vec<(PathBuf, Vec<u8>)>) -> PathBuf {
        let names: Vec<PathBuf> = files.iter().map(|(path, _)| path.clone()).collect();
        let kept = if self.are_kept {
            kept_files::namesakes(&names).await
        } else {
            Table::new()
        };
        let folder = {
            let table = self.table();
            let is_same =
                |other: Option<&Vec<u8>>, bytes: &[u8]| other.is_none_or(|it| it == bytes);
            namesakes::folder_for(&files, |path, bytes| {
                is_same(table.get(path), bytes) && is_same(kept.get(path), bytes)
            })
        };
        let placed = files.into_iter();
        self.add(
            placed
                .map(|(path, bytes)| (folder.join(path), bytes))
                .collect(),
        );
        folder
    }

    /// Adds files, in place of others of the same names, and keeps them for the next visit, if that is wanted.
    pub fn add(&self, files: Vec<(PathBuf, Vec<u8>)>) {
        self.table().extend(files.iter().cloned());
        if !self.are_kept {
            return;
        }
        spawn_local(async move {
            if let Err(error) = kept_files::keep(&files).await {
                browser::warn(&format!("files are not kept for the next visit: {error}"));
            }
        });
    }

    /// Adds a built-in file that was fetched. The next visit fetches it again.
    pub fn add_builtin(&self, path: PathBuf, bytes: Vec<u8>) {
        self.table().insert(path, bytes);
    }

    /// Takes note of files that are not beside the page either.
    pub fn note_absent(&self, paths: impl Iterator<Item = PathBuf>) {
        let mut absent = self.absent.lock().unwrap_or_else(PoisonError::into_inner);
        absent.extend(paths);
    }

    /// Whether the file at `path` was looked for beside the page, in vain.
    fn is_absent(&self, path: &Path) -> bool {
        let absent = self.absent.lock().unwrap_or_else(PoisonError::into_inner);
        absent.contains(path)
    }

    /// `path`, or a name like it if a file of that name was given, in whatever folder: what is exported must not take
    /// the place of a model.
    pub fn free_name(&self, path: PathBuf) -> PathBuf {
        let files = self.table();
        let given = files.keys().filter(|file| !is_builtin(file));
        let names: HashSet<&OsStr> = given.filter_map(|file| file.file_name()).collect();
        namesakes::free_name(path, |path| {
            path.file_name().is_some_and(|name| names.contains(name))
        })
    }
}

/// The file at `path`. One in a folder that was made for files of the same name may have come again without it.
fn found<'a>(files: &'a Table, path: &Path) -> Option<&'a Vec<u8>> {
    files.get(path).or_else(|| {
        let (outside, folder) = namesakes::in_common_folder(path)?;
        let has_folder = files.keys().any(|path| path.starts_with(folder));
        files.get(outside).filter(|_| !has_folder)
    })
}

impl Files for GivenFiles {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        let files = self.table();
        found(&files, path).cloned().ok_or_else(|| {
            let message = match self.is_absent(path) {
                true => "there is no such file beside the page",
                false => {
                    "the page has not been given this file: choose or drop all files that belong \
                     together at once"
                }
            };
            Diagnostic::new(path, message)
        })
    }

    fn exists(&self, path: &Path) -> bool {
        found(&self.table(), path).is_some()
    }
}

/// Extensions of files that are opened by themselves. A scene names its models, and models their pictures.
const SCENES: &[&str] = &["scene", "zip"];
const MODELS: &[&str] = &io::IMPORTABLE;
const POSES: &[&str] = &["json"];
const PICTURES: &[&str] = &["png", "jpg", "jpeg", "gif"];

/// Of files that came together, those that are opened by themselves: others, such as the `.skel` of
/// an `.obj` or the pictures of a model, are read with them.
pub(super) fn main_files(names: &[PathBuf]) -> Vec<PathBuf> {
    let kinds = [SCENES, MODELS, POSES, PICTURES].into_iter();
    let found = kinds
        .map(|kind| of_kind(names, kind))
        .find(|found| !found.is_empty());
    found.unwrap_or_else(|| names.to_vec())
}

/// The same where a person has brought them: what came beside a scene may not be named there.
pub(super) fn brought_files(names: &[PathBuf]) -> Vec<PathBuf> {
    match of_kind(names, SCENES) {
        scenes if scenes.is_empty() => main_files(names),
        scenes => [scenes, of_kind(names, MODELS), of_kind(names, POSES)].concat(),
    }
}

fn of_kind(names: &[PathBuf], extensions: &[&str]) -> Vec<PathBuf> {
    let is = |path: &&PathBuf| extensions.contains(&&*io::extension(path));
    names.iter().filter(is).cloned().collect()
}
