use crate::disk;
use crate::io::Diagnostic;
use crate::program::{StorageKey, globals};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

/// Size of the largest file of the program's own that is read, in bytes.
const MOST_STORED: u64 = 256 << 20;

/// Number of files with unsaved work that was not wanted, for each slot.
const MOST_ASIDE: usize = 20;

/// Number of programs that can keep unsaved work at the same time.
const SLOTS: usize = 64;

/// The user's folder of configuration, where preferences and unsaved work are kept.
///
/// Each running program has a file of its own for unsaved work, and a lock on it that the system
/// releases however the program ends: a file whose lock is free was left by one that has ended.
pub(super) struct Storage {
    folder: Option<PathBuf>,
    autosave: Option<Slot>,
    writing: Option<JoinHandle<Result<(), Diagnostic>>>,
    /// Why unsaved work could not be kept last, until somebody asks.
    failure: Option<Diagnostic>,
}

struct Slot {
    path: PathBuf,
    _lock: File,
}

impl Storage {
    pub fn new() -> Self {
        let folder = directories::ProjectDirs::from("", "", globals::SETTINGS_FOLDER)
            .map(|folders| folders.config_dir().to_owned())
            .filter(|folder| std::fs::create_dir_all(folder).is_ok());
        Self::at(folder)
    }

    /// What is kept in `folder`; nothing if there is none.
    fn at(folder: Option<PathBuf>) -> Self {
        let autosave = folder.as_ref().and_then(|folder| {
            // One that was left comes before one that is free.
            let left = slots(folder).filter(|path| path.exists());
            left.chain(slots(folder)).find_map(Slot::take)
        });
        Self {
            folder,
            autosave,
            writing: None,
            failure: None,
        }
    }

    /// Where unsaved work is kept; `None` if it cannot be.
    pub fn autosave_path(&self) -> Option<PathBuf> {
        self.autosave.as_ref().map(|slot| slot.path.clone())
    }

    pub fn load(&self, key: StorageKey) -> Option<Vec<u8>> {
        disk::read_at_most(&self.path(key)?, MOST_STORED).ok()
    }

    /// Time since an entry was written.
    pub fn stored_since(&self, key: StorageKey) -> Option<Duration> {
        let written = self.path(key)?.metadata().ok()?.modified().ok()?;
        written.elapsed().ok()
    }

    /// Goes on from the unsaved work of one earlier run to that of the next, and from the last to a
    /// slot that is free.
    pub fn pass_unsaved_work(&mut self) {
        self.wait();
        let Some(folder) = &self.folder else {
            return;
        };
        let at = self.autosave_path();
        let others = slots(folder).skip_while(|path| at.as_ref().is_some_and(|at| path != at));
        let left = others.skip(1).filter(|path| path.exists());
        let free = slots(folder).filter(|path| !path.exists());
        self.autosave = left.chain(free).find_map(Slot::take);
    }

    /// Stores `bytes`, unsaved work in the background.
    pub fn store(&mut self, key: StorageKey, bytes: Vec<u8>) {
        match (key, self.path(key)) {
            (StorageKey::Preferences, Some(path)) => {
                // Nothing that the user made is lost.
                let _ = disk::write_whole(&path, &bytes);
            }
            (StorageKey::Preferences, None) => {}
            (StorageKey::Autosave, Some(path)) => self.keep(path, Arc::new(bytes)),
            (StorageKey::Autosave, None) => {
                let folder = self.folder.clone();
                let folder = folder.unwrap_or_else(|| PathBuf::from(globals::SETTINGS_FOLDER));
                self.failure = Some(Diagnostic::new(
                    &folder,
                    "expected a folder of the program's own that can be written to",
                ));
            }
        }
    }

    /// Writes unsaved work in the background, or at once if there is no thread to spare.
    fn keep(&mut self, path: PathBuf, bytes: Arc<Vec<u8>>) {
        self.wait();
        let (there, copy) = (path.clone(), Arc::clone(&bytes));
        let write = move || disk::write_whole(&there, &copy);
        let thread = std::thread::Builder::new().name("autosave".to_owned());
        match thread.spawn(write) {
            Ok(writing) => self.writing = Some(writing),
            Err(_) => self.failure = disk::write_whole(&path, &bytes).err(),
        }
    }

    /// Removes an entry.
    pub fn remove(&mut self, key: StorageKey) {
        self.wait();
        if let Some(path) = self.path(key) {
            // What does not exist need not be removed.
            let _ = std::fs::remove_file(path);
        }
    }

    /// Gives an entry another name, so that who discarded it by mistake can still find it. Returns
    /// the name, if there was such an entry.
    pub fn put_aside(&mut self, key: StorageKey) -> Option<PathBuf> {
        self.wait();
        let path = self.path(key)?;
        // What was put aside before is worth as much; of too many the one without a number gives way.
        let mut names = (0..MOST_ASIDE).map(|number| match number {
            0 => path.with_extension("json~"),
            number => path.with_extension(format!("json~{number}")),
        });
        let free = names.find(|name| !name.exists());
        let aside = free.unwrap_or_else(|| path.with_extension("json~"));
        std::fs::rename(&path, &aside).ok()?;
        Some(aside)
    }

    /// The outcome of the last writing in the background, once, if it failed.
    pub fn failure(&mut self) -> Option<Diagnostic> {
        if self.writing.as_ref().is_some_and(JoinHandle::is_finished) {
            self.wait();
        }
        self.failure.take()
    }

    /// Waits until nothing is being written.
    pub fn wait(&mut self) {
        if let Some(writing) = self.writing.take() {
            // A thread that panicked wrote nothing, and the hook has told of it.
            self.failure = writing.join().ok().and_then(Result::err);
        }
    }

    fn path(&self, key: StorageKey) -> Option<PathBuf> {
        match key {
            StorageKey::Preferences => Some(self.folder.as_ref()?.join(key.name())),
            StorageKey::Autosave => self.autosave_path(),
        }
    }
}

/// Files of all slots for unsaved work.
fn slots(folder: &Path) -> impl Iterator<Item = PathBuf> {
    (0..SLOTS).map(|slot| folder.join(format!("autosave-{slot}.json")))
}

impl Drop for Storage {
    fn drop(&mut self) {
        self.wait();
    }
}

impl Slot {
    /// Takes the slot of `path`, unless a running program has it.
    fn take(path: PathBuf) -> Option<Self> {
        let options = File::options().create(true).append(true).clone();
        let lock = options.open(path.with_extension("lock")).ok()?;
        lock.try_lock().ok()?;
        Some(Self { path, _lock: lock })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AUTOSAVE: StorageKey = StorageKey::Autosave;

    #[test]
    fn the_work_of_each_run_that_has_ended_is_passed_once_and_that_of_a_running_one_never() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        for (slot, path) in slots(folder).take(4).enumerate() {
            std::fs::write(path, slot.to_string()).unwrap();
        }
        let running = Slot::take(folder.join("autosave-1.json")).unwrap();
        let mut storage = Storage::at(Some(folder.to_owned()));
        let mut left = Vec::new();
        while let Some(bytes) = storage.load(AUTOSAVE) {
            left.push(String::from_utf8(bytes).unwrap());
            if left.len() == 2 {
                storage.put_aside(AUTOSAVE).unwrap();
            }
            storage.pass_unsaved_work();
        }
        assert_eq!(left, ["0", "2", "3"]);
        storage.store(AUTOSAVE, b"own".to_vec());
        storage.wait();
        let there = |slot| std::fs::read_to_string(folder.join(format!("autosave-{slot}.json")));
        assert_eq!(there(0).unwrap(), "0");
        assert_eq!(there(1).unwrap(), "1");
        // The place of what was put aside is free again.
        assert_eq!(there(2).unwrap(), "own");
        drop(running);
    }
}
