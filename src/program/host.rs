//! The place where the program runs, as far as places differ.

use super::{FileRequest, Job, JobResult, Suggested};
use crate::io::{Diagnostic, Files};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Services of the place where the program runs: files, a clipboard, storage, jobs, a clock and a
/// window.
///
/// No call waits: whatever takes time, or a person, is answered later by a [`HostEvent`]. Paths are
/// names that the host understands; none has to be on a disk.
pub trait Host {
    /// Time since any fixed moment. It never goes back.
    fn now(&self) -> Duration;

    /// Time that the last frame took until it was shown, where the host can tell: software OpenGL keeps a window or
    /// page for longer than the program's own work takes.
    fn last_frame(&self) -> Option<Duration> {
        None
    }

    /// The files that a path names without asking anybody, those that the program brings among
    /// them.
    fn files(&self) -> Arc<dyn Files>;

    /// Lets the user choose a file to read or to write. Answered by [`HostEvent::Chosen`], or not at
    /// all.
    fn choose_file(&mut self, request: FileRequest, suggested: Suggested);

    /// Whether this is a page of a browser, which alone closes it and takes pictures of its panels.
    fn is_page(&self) -> bool {
        false
    }

    /// Whether the window is maximized.
    fn is_maximized(&self) -> bool {
        false
    }

    /// Shows those dialogs that the host draws with egui itself. Called in every pass, after the
    /// panels.
    fn show_dialogs(&mut self, _context: &egui::Context) {}

    /// Whether a dialog of [`Host::show_dialogs`] is open: the keyboard is its own then, and a
    /// picture of the window has to wait until it is gone.
    fn is_dialog_open(&self) -> bool {
        false
    }

    /// Writes a file whole or not at all. Answered by [`HostEvent::Written`].
    fn write_file(&mut self, path: &Path, bytes: Vec<u8>, previous: Previous);

    /// Writes several files that belong together, all of them or none, and makes the folders that they
    /// need. Answered by one [`HostEvent::Written`] about `path`.
    fn write_files(&mut self, path: &Path, files: Vec<(PathBuf, Vec<u8>)>, previous: Previous);

    /// Watches these files, and no others, for changes by other programs, which are
    /// [`HostEvent::Changed`].
    fn watch(&mut self, files: Vec<PathBuf>);

    /// Brings built-in files that [`Host::files`] does not have, also for those who have asked for its
    /// files before. Answered by [`HostEvent::Brought`]. Hosts that have all of them are never asked.
    fn bring(&mut self, _builtin: Vec<PathBuf>) {}

    /// The part of what [`Host::bring`] asked for that is there, from 0 to 1; `None` if all of it is.
    fn part_brought(&self) -> Option<f32> {
        None
    }

    /// The address of a page that shows what `fragment` says, behind a `#`; `None` where there is no
    /// such page.
    fn link(&self, _fragment: &str) -> Option<String> {
        None
    }

    /// Puts text on the clipboard.
    fn copy_text(&mut self, text: String);

    /// Asks for the text on the clipboard. Answered by [`HostEvent::Pasted`].
    fn request_paste(&mut self);

    /// Bytes that an earlier run stored under `key`, if it did.
    fn load(&self, key: StorageKey) -> Option<Vec<u8>>;

    /// Time since unsaved work was stored, if there is any and the host knows it.
    fn unsaved_work_since(&self) -> Option<Duration> {
        None
    }

    /// Goes on from the unsaved work of one earlier run, which stays as it is, to that of another one
    /// that was not loaded yet. If there is none, what this run stores is stored in a place of its own.
    fn pass_unsaved_work(&mut self);

    /// Stores `bytes` for later runs. May end in [`HostEvent::StoreFailed`].
    fn store(&mut self, key: StorageKey, bytes: Vec<u8>);

    /// Removes stored unsaved work, if there is any.
    fn remove_unsaved_work(&mut self);

    /// Puts stored unsaved work out of the way, where the user can still find it. Returns that place,
    /// if there is one.
    fn put_unsaved_work_aside(&mut self) -> Option<PathBuf> {
        self.remove_unsaved_work();
        None
    }

    /// Runs `job` beside the program, once it has taken longer than its [`Job::patience`]. Always
    /// answered by [`HostEvent::Finished`].
    fn start_job(&mut self, job: Job);

    /// Names the window.
    fn set_title(&mut self, title: &str);

    /// Carries out requests of egui: the cursor, links, text that was copied in a field.
    fn handle_platform_output(&mut self, output: egui::PlatformOutput);

    /// Ends the program, after this frame.
    fn quit(&mut self);

    /// The next answer or event, in the order in which they came.
    fn next_event(&mut self) -> Option<HostEvent>;
}

/// Fate of the file that another takes the place of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Previous {
    /// It stays beside the new one, where the host can do that: on a disk as `NAME~`.
    KeepBeside,
    /// So it does unless this program has written it since it was started: what was there before that
    /// must not give way to what was tried a moment ago.
    KeepForeign,
}

/// Why unsaved work is not where it should be.
#[derive(Debug)]
pub struct NotStored {
    /// What went wrong there.
    pub error: Diagnostic,
    /// Where it is kept for now instead; `None` if nowhere.
    pub kept_in: Option<PathBuf>,
}

/// Event of a host: the answer to a call, or something that happened there.
pub enum HostEvent {
    /// A file was chosen.
    Chosen {
        /// The request that this answers.
        request: FileRequest,
        /// The file.
        path: PathBuf,
        /// Files that were chosen together with it, where several can be.
        others: Vec<PathBuf>,
        /// Where they and the files beside them are read.
        files: Arc<dyn Files>,
    },
    /// A file was dropped on the window.
    Dropped {
        /// The file.
        path: PathBuf,
        /// Where it and the files beside it are read.
        files: Arc<dyn Files>,
    },
    /// A file that was chosen or dropped could not be read.
    Unreadable(Diagnostic),
    /// A file was written, or could not be.
    Written {
        /// The file.
        path: PathBuf,
        /// Outcome.
        result: Result<(), Diagnostic>,
    },
    /// All built-in files that were asked for are there, or one of them could not be had.
    Brought(Result<(), Diagnostic>),
    /// A watched file has changed, appeared or gone.
    Changed(PathBuf),
    /// Unsaved work could not be stored where it should be.
    StoreFailed(NotStored),
    /// The user closes the window.
    CloseRequested,
    /// The text on the clipboard; empty if there is none.
    Pasted(String),
    /// A job has finished.
    Finished(JobResult),
}

/// Entry that is stored from one run to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StorageKey {
    /// Choices of the user that are not part of a document, as JSON.
    Preferences,
    /// Unsaved work. Each running program has its own, and finds that of one earlier run that has
    /// ended.
    Autosave,
}

impl StorageKey {
    /// A name for a file or an entry.
    pub fn name(self) -> &'static str {
        match self {
            Self::Preferences => "preferences.json",
            Self::Autosave => "autosave.json",
        }
    }
}
