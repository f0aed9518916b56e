//! Places for the unsaved work of programs that run at the same time.

use crate::disk;
use crate::io::Diagnostic;
use crate::program::{NotStored, globals};
use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Number of programs that can keep unsaved work at the same time.
const SLOTS: usize = 64;

/// Size of the largest entry that is read, in bytes.
pub(super) const MOST_STORED: u64 = 256 << 20;

/// Number of files with unsaved work that was not wanted, for each slot.
const MOST_ASIDE: usize = 20;

/// The place of one running program: a file of the same name in each folder, of which the first that
/// can be written is used, and the newest counts. A lock beside it, which the system releases however
/// the program ends, tells what a running program keeps from what one left that has ended.
pub(super) struct Slot {
    number: usize,
    paths: Vec<PathBuf>,
    _locks: Vec<File>,
}

impl Slot {
    /// Takes a slot in `folders`: the next one after `after` with work that was left, or one that is
    /// free if there is none.
    pub fn take(folders: &[PathBuf], after: Option<&Self>) -> Option<Self> {
        let next = after.map_or(0, |slot| slot.number + 1);
        let is_left = |number: &usize| paths(folders, *number).iter().any(|path| path.exists());
        let left = (next..SLOTS).filter(is_left);
        let free = (0..SLOTS).filter(|number| !is_left(number));
        left.chain(free)
            .find_map(|number| Self::lock(folders, number))
    }

    /// The slot of that number, unless a running program has it.
    fn lock(folders: &[PathBuf], number: usize) -> Option<Self> {
        let mut locks = Vec::new();
        let paths = paths(folders, number);
        for path in &paths {
            let options = File::options().create(true).append(true).clone();
            // A folder that is full or gone has no lock; that of another will do.
            let Ok(lock) = options.open(path.with_extension("lock")) else {
                continue;
            };
            match lock.try_lock() {
                Ok(()) => locks.push(lock),
                Err(TryLockError::WouldBlock) => return None,
                Err(TryLockError::Error(_)) => {}
            }
        }
        (!locks.is_empty()).then_some(Self {
            number,
            paths,
            _locks: locks,
        })
    }

    /// Where the work is kept, in the order of preference.
    pub fn paths(&self) -> &[PathBuf] {
        &self.paths
    }

    /// The file of the newest work that is kept here, and when it was written.
    pub fn newest(&self) -> Option<(&Path, SystemTime)> {
        let written = |path: &PathBuf| path.metadata().and_then(|file| file.modified()).ok();
        let there = (self.paths.iter()).filter_map(|path| Some((path.as_path(), written(path)?)));
        there.max_by_key(|(_, written)| *written)
    }

    /// What is kept here.
    pub fn load(&self) -> Option<Vec<u8>> {
        disk::read_at_most(self.newest()?.0, MOST_STORED).ok()
    }

    /// Removes what is kept here.
    pub fn clear(&self) {
        for path in &self.paths {
            // What does not exist need not be removed.
            let _ = std::fs::remove_file(path);
        }
    }

    /// Gives what is kept here another name. Returns that of the newest, if there is any.
    pub fn put_aside(&self) -> Option<PathBuf> {
        let newest = self.newest()?.0;
        // What was put aside before is worth as much; of too many the one without a number gives way.
        let mut names = (0..MOST_ASIDE).map(|number| match number {
            0 => newest.with_extension("json~"),
            number => newest.with_extension(format!("json~{number}")),
        });
        let free = names.find(|name| !name.exists());
        let aside = free.unwrap_or_else(|| newest.with_extension("json~"));
        std::fs::rename(newest, &aside).ok()?;
        // Any other is an older state of the same work.
        self.clear();
        Some(aside)
    }
}

/// What to say where there is no folder at all, the first that was tried being `folder`.
pub(super) fn without_folder(folder: Option<&PathBuf>) -> NotStored {
    let folder = folder.map_or(Path::new(globals::SETTINGS_FOLDER), PathBuf::as_path);
    let message = "expected a folder of the program's own that can be written to";
    NotStored {
        error: Diagnostic::new(folder, message),
        kept_in: None,
    }
}

/// Writes `bytes` to the first of `paths`, or else to the next that can be written to. Returns the first.
///
/// # Errors
/// If that is not the first, or there is none.
pub(super) fn write_to_first<'a>(
    paths: &'a [PathBuf],
    bytes: &[u8],
) -> Result<&'a Path, NotStored> {
    let mut failure = None;
    for (at, path) in paths.iter().enumerate() {
        match disk::write_whole(path, bytes) {
            Ok(()) => {
                // A newer state in another place is older than this one, now.
                for other in &paths[at + 1..] {
                    let _ = std::fs::remove_file(other);
                }
                let kept_in = Some(path.clone());
                return failure.map_or(Ok(path), |error| Err(NotStored { error, kept_in }));
            }
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    Err(failure.map_or_else(
        || without_folder(None),
        |error| NotStored {
            error,
            kept_in: None,
        },
    ))
}

/// Files of a slot, one in each folder.
fn paths(folders: &[PathBuf], number: usize) -> Vec<PathBuf> {
    let file = format!("autosave-{number}.json");
    folders.iter().map(|folder| folder.join(&file)).collect()
}
