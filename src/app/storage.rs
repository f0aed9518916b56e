//! What is kept from one run to the next.

use super::own_folders;
use super::slot::{MOST_STORED, Slot, without_folder, write_to_first};
use crate::disk;
use crate::program::{NotStored, StorageKey};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

/// The user's folder of configuration, where preferences and unsaved work are kept. Unsaved work that
/// does not fit there is kept in a spare folder.
pub(super) struct Storage {
    preferences: Option<PathBuf>,
    /// Folders for unsaved work, in the order of preference.
    folders: Vec<PathBuf>,
    autosave: Option<Slot>,
    writing: Option<JoinHandle<Result<(), NotStored>>>,
    /// Why unsaved work is not where it should be, until somebody asks.
    failure: Option<NotStored>,
}

impl Storage {
    pub fn new() -> Self {
        let configuration = own_folders::configuration();
        let spare = own_folders::spare(configuration.as_deref());
        Self::at(configuration.into_iter().chain(spare).collect())
    }

    /// What is kept in `folders`: preferences in the first.
    fn at(folders: Vec<PathBuf>) -> Self {
        let in_folder = |folder: &PathBuf| folder.join(StorageKey::Preferences.name());
        Self {
            preferences: folders.first().map(in_folder),
            autosave: Slot::take(&folders, None),
            folders,
            writing: None,
            failure: None,
        }
    }

    /// Where unsaved work is kept, in the order of preference; empty if it cannot be.
    pub fn autosave_paths(&self) -> Vec<PathBuf> {
        let slot = self.autosave.as_ref();
        slot.map_or_else(Vec::new, |slot| slot.paths().to_vec())
    }

    pub fn load(&self, key: StorageKey) -> Option<Vec<u8>> {
        match key {
            StorageKey::Preferences => {
                disk::read_at_most(self.preferences.as_ref()?, MOST_STORED).ok()
            }
            StorageKey::Autosave => self.autosave.as_ref()?.load(),
        }
    }

    /// Time since unsaved work was stored.
    pub fn unsaved_work_since(&self) -> Option<Duration> {
        let (_, written) = self.autosave.as_ref()?.newest()?;
        written.elapsed().ok()
    }

    /// Goes on from the unsaved work of one earlier run to that of the next, and from the last to a
    /// slot that is free.
    pub fn pass_unsaved_work(&mut self) {
        self.wait();
        self.autosave = Slot::take(&self.folders, self.autosave.as_ref());
    }

    /// Stores `bytes`, unsaved work in the background.
    pub fn store(&mut self, key: StorageKey, bytes: Vec<u8>) {
        match key {
            StorageKey::Preferences => {
                if let Some(path) = &self.preferences {
                    // Nothing that the user made is lost.
                    let _ = disk::write_whole(path, &bytes);
                }
            }
            StorageKey::Autosave if self.autosave.is_some() => self.keep(Arc::new(bytes)),
            StorageKey::Autosave => self.failure = Some(without_folder(self.folders.first())),
        }
    }

    /// Writes unsaved work in the background, or at once if there is no thread to spare.
    fn keep(&mut self, bytes: Arc<Vec<u8>>) {
        self.wait();
        let paths = self.autosave_paths();
        let (there, copy) = (paths.clone(), Arc::clone(&bytes));
        let write = move || write_to_first(&there, &copy).map(drop);
        let thread = std::thread::Builder::new().name("autosave".to_owned());
        match thread.spawn(write) {
            Ok(writing) => self.writing = Some(writing),
            Err(_) => self.failure = write_to_first(&paths, &bytes).err(),
        }
    }

    /// Removes this run's unsaved work.
    pub fn remove_unsaved_work(&mut self) {
        self.wait();
        if let Some(slot) = &self.autosave {
            slot.clear();
        }
    }

    /// Gives unsaved work another name, so that who discarded it by mistake can still find it.
    /// Returns the name, if there is any.
    pub fn put_unsaved_work_aside(&mut self) -> Option<PathBuf> {
        self.wait();
        self.autosave.as_ref()?.put_aside()
    }

    /// The outcome of the last writing in the background, once, if unsaved work is not where it
    /// should be.
    pub fn failure(&mut self) -> Option<NotStored> {
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
}

impl Drop for Storage {
    fn drop(&mut self) {
        self.wait();
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
        let folders = vec![folder.to_owned()];
        let entry = |slot: usize| folder.join(format!("autosave-{slot}.json"));
        std::fs::write(entry(1), "1").unwrap();
        let running = Slot::take(&folders, None).unwrap();
        for slot in [0, 2, 3] {
            std::fs::write(entry(slot), slot.to_string()).unwrap();
        }
        let mut storage = Storage::at(folders);
        let mut left = Vec::new();
        while let Some(bytes) = storage.load(AUTOSAVE) {
            left.push(String::from_utf8(bytes).unwrap());
            if left.len() == 2 {
                storage.put_unsaved_work_aside().unwrap();
            }
            storage.pass_unsaved_work();
        }
        assert_eq!(left, ["0", "2", "3"]);
        storage.store(AUTOSAVE, b"own".to_vec());
        storage.wait();
        let there = |slot| std::fs::read_to_string(entry(slot));
        assert_eq!(there(0).unwrap(), "0");
        assert_eq!(there(1).unwrap(), "1");
        // The place of what was put aside is free again.
        assert_eq!(there(2).unwrap(), "own");
        drop(running);
    }

    #[test]
    fn work_that_does_not_fit_is_kept_in_the_spare_folder_and_the_newest_counts() {
        let folder = tempfile::tempdir().unwrap();
        let [first, spare] = ["first", "spare"].map(|name| folder.path().join(name));
        std::fs::create_dir(&spare).unwrap();
        let folders = vec![first.clone(), spare.clone()];
        let mut storage = Storage::at(folders.clone());
        storage.store(AUTOSAVE, b"old".to_vec());
        storage.wait();
        let failure = storage.failure().expect("there is no first folder");
        assert_eq!(failure.kept_in, Some(spare.join("autosave-0.json")));
        assert!(failure.error.to_string().contains("first"));
        assert!(storage.failure().is_none(), "told once");
        // Another program that runs has another place, where only one folder has a lock, too.
        std::fs::create_dir(&first).unwrap();
        let mut other = Storage::at(folders.clone());
        assert_eq!(other.load(AUTOSAVE), None);
        drop(storage);

        other.pass_unsaved_work();
        assert_eq!(other.load(AUTOSAVE), None, "none after its own");
        // From before the disk was full.
        let older = first.join("autosave-0.json");
        std::fs::write(&older, b"older").unwrap();
        let hour_ago = std::time::SystemTime::now() - Duration::from_secs(3600);
        let file = std::fs::File::options().write(true).open(&older).unwrap();
        file.set_modified(hour_ago).unwrap();
        let mut storage = Storage::at(folders);
        assert_eq!(storage.load(AUTOSAVE), Some(b"old".to_vec()));
        storage.store(AUTOSAVE, b"new".to_vec());
        storage.wait();
        assert!(storage.failure().is_none());
        assert_eq!(storage.load(AUTOSAVE), Some(b"new".to_vec()));
        assert!(!spare.join("autosave-0.json").exists(), "it is out of date");
        storage.remove_unsaved_work();
        assert_eq!(storage.load(AUTOSAVE), None);
    }

    #[test]
    fn without_any_folder_the_work_is_not_kept_and_that_is_said() {
        let mut storage = Storage::at(Vec::new());
        storage.store(AUTOSAVE, b"work".to_vec());
        let failure = storage.failure().expect("a failure");
        assert_eq!(failure.kept_in, None);
    }
}
