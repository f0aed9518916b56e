//! The program in a place of the test's own: files in memory, a clock that the test turns.

use editor_core::io::builtin::WithBuiltin;
use editor_core::io::{Diagnostic, Files, WithArchives};
use editor_core::program::{
    FileRequest, FrameInput, Graphics, Host, HostEvent, Job, Previous, Program, Purpose,
    StorageKey, Suggested,
};
use egui::{Event, Pos2, RawInput, Rect, vec2};
use std::collections::{BTreeMap, HashMap, HashSet, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Files by path.
pub type Table = HashMap<PathBuf, Vec<u8>>;

/// A request for a file that nobody has answered yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    pub purpose: Purpose,
    request: FileRequest,
    pub folder: Option<PathBuf>,
    pub recent: Vec<PathBuf>,
    pub name: String,
}

/// A place with everything in memory.
#[derive(Default)]
pub struct MemoryHost {
    pub files: Table,
    pub written: BTreeMap<PathBuf, Vec<u8>>,
    /// Why nothing can be written, if so.
    pub write_fault: Option<String>,
    pub watched: Vec<PathBuf>,
    pub clipboard: String,
    pub stored: HashMap<StorageKey, Vec<u8>>,
    /// Time since what is stored was stored.
    pub stored_since: Option<Duration>,
    /// Unsaved work of earlier runs that was left for a later one.
    pub left: Vec<Vec<u8>>,
    /// Unsaved work of earlier runs after the one that is stored.
    pub more: VecDeque<Vec<u8>>,
    pub time: Duration,
    pub requests: Vec<Request>,
    pub dialog_is_open: bool,
    pub is_maximized: bool,
    /// Jobs that wait for [`MemoryHost::run_jobs`].
    pub jobs: Vec<Job>,
    /// Whether all jobs wait, even those that are worth waiting for.
    pub is_slow: bool,
    pub title: String,
    pub quits: bool,
    pub cursor: Option<egui::CursorIcon>,
    /// The newest widgets, as assistive technologies see them.
    pub widgets: Option<egui::accesskit::TreeUpdate>,
    /// Built-in files that have to be brought before they can be read.
    pub absent: Arc<Mutex<HashSet<PathBuf>>>,
    /// Those that the program asked for and that did not come yet.
    pub asked: Vec<PathBuf>,
    pub events: VecDeque<HostEvent>,
}

/// Files of which some are not there yet.
struct Without<F> {
    files: F,
    absent: Arc<Mutex<HashSet<PathBuf>>>,
}

impl<F: Files> Files for Without<F> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        if self.absent.lock().unwrap().contains(path) {
            return Err(Diagnostic::new(path, "it has not been brought"));
        }
        self.files.read(path)
    }

    fn exists(&self, path: &Path) -> bool {
        !self.absent.lock().unwrap().contains(path) && self.files.exists(path)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        self.files.absolute(path)
    }
}

impl MemoryHost {
    /// Draws one frame of `program` in a window of `size` pixels, in which `events` happen. Returns how
    /// long no other is needed.
    pub fn frame(
        &mut self,
        program: &mut Program,
        graphics: &mut Graphics,
        context: &egui::Context,
        size: (u32, u32),
        events: Vec<Event>,
    ) -> Duration {
        let screen = vec2(size.0 as f32, size.1 as f32);
        let raw = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, screen)),
            max_texture_side: Some(4096),
            time: Some(self.time.as_secs_f64()),
            events,
            ..RawInput::default()
        };
        let input = FrameInput {
            context: context.clone(),
            raw,
            size,
        };
        let wait = program.frame(graphics, input, self);
        self.time += Duration::from_millis(16);
        wait.expect("the program goes on")
    }

    /// Brings what was asked for, or says why it cannot be had.
    pub fn answer_asked(&mut self, result: Result<(), Diagnostic>) {
        for path in self.asked.drain(..) {
            if result.is_ok() {
                self.absent.lock().unwrap().remove(&path);
            }
        }
        self.events.push_back(HostEvent::Brought(result));
    }

    /// Does the jobs that were started since, in order; how many there were.
    pub fn run_jobs(&mut self) -> usize {
        let jobs = std::mem::take(&mut self.jobs);
        let count = jobs.len();
        self.events
            .extend(jobs.into_iter().map(|job| HostEvent::Finished(job.run())));
        count
    }

    /// Answers the newest request with `path`.
    pub fn choose(&mut self, path: &str) {
        self.choose_together(path, &[]);
    }

    /// Answers the newest request with `path` and `others`.
    pub fn choose_together(&mut self, path: &str, others: &[&str]) {
        let request = self.requests.last().expect("a file was asked for");
        self.events.push_back(HostEvent::Chosen {
            request: request.request,
            path: path.into(),
            others: others.iter().map(PathBuf::from).collect(),
            files: self.files(),
        });
    }

    /// Drops a file on the window.
    pub fn drop_file(&mut self, path: &str) {
        let (path, files) = (path.into(), self.files());
        self.events.push_back(HostEvent::Dropped { path, files });
    }

    /// What was written to `path`, as text.
    pub fn text(&self, path: &str) -> String {
        let bytes = self.written.get(Path::new(path)).expect("it was written");
        String::from_utf8(bytes.clone()).expect("it is text")
    }
}

impl Host for MemoryHost {
    fn now(&self) -> Duration {
        self.time
    }

    fn files(&self) -> Arc<dyn Files> {
        Arc::new(Without {
            files: WithBuiltin(WithArchives::new(self.files.clone())),
            absent: Arc::clone(&self.absent),
        })
    }

    fn bring(&mut self, builtin: Vec<PathBuf>) {
        self.asked.extend(builtin);
    }

    fn part_brought(&self) -> Option<f32> {
        (!self.asked.is_empty()).then_some(0.5)
    }

    fn choose_file(&mut self, request: FileRequest, suggested: Suggested) {
        self.requests.push(Request {
            purpose: request.purpose,
            request,
            folder: suggested.folder,
            recent: suggested.recent,
            name: suggested.name,
        });
    }

    fn is_maximized(&self) -> bool {
        self.is_maximized
    }

    fn is_dialog_open(&self) -> bool {
        self.dialog_is_open
    }

    fn write_file(&mut self, path: &Path, bytes: Vec<u8>, previous: Previous) {
        let result = match &self.write_fault {
            Some(fault) => Err(Diagnostic::new(path, fault.clone())),
            None => {
                if let Some(old) = self.files.insert(path.to_owned(), bytes.clone())
                    && (previous == Previous::KeepBeside || self.written.get(path) != Some(&old))
                {
                    self.files
                        .insert(format!("{}~", path.display()).into(), old);
                }
                self.written.insert(path.to_owned(), bytes);
                Ok(())
            }
        };
        let path = path.to_owned();
        self.events.push_back(HostEvent::Written { path, result });
    }

    fn write_files(&mut self, path: &Path, files: Vec<(PathBuf, Vec<u8>)>, previous: Previous) {
        let result = match &self.write_fault {
            Some(fault) => Err(Diagnostic::new(path, fault.clone())),
            None => {
                for (path, bytes) in files {
                    let before = self.files.insert(path.clone(), bytes.clone());
                    if let Some(old) = before
                        && old != bytes
                        && (previous == Previous::KeepBeside
                            || self.written.get(&path) != Some(&old))
                    {
                        let beside = format!("{}~", path.display());
                        self.files.insert(beside.into(), old);
                    }
                    self.written.insert(path, bytes);
                }
                Ok(())
            }
        };
        let path = path.to_owned();
        self.events.push_back(HostEvent::Written { path, result });
    }

    fn watch(&mut self, files: Vec<PathBuf>) {
        self.watched = files;
    }

    fn copy_text(&mut self, text: String) {
        self.clipboard = text;
    }

    fn request_paste(&mut self) {
        let text = self.clipboard.clone();
        self.events.push_back(HostEvent::Pasted(text));
    }

    fn load(&self, key: StorageKey) -> Option<Vec<u8>> {
        self.stored.get(&key).cloned()
    }

    fn unsaved_work_since(&self) -> Option<Duration> {
        let is_stored = self.stored.contains_key(&StorageKey::Autosave);
        self.stored_since.filter(|_| is_stored)
    }

    fn pass_unsaved_work(&mut self) {
        self.left.extend(self.stored.remove(&StorageKey::Autosave));
        let next = self.more.pop_front();
        self.stored
            .extend(next.map(|bytes| (StorageKey::Autosave, bytes)));
    }

    fn store(&mut self, key: StorageKey, bytes: Vec<u8>) {
        self.stored.insert(key, bytes);
    }

    fn remove_unsaved_work(&mut self) {
        self.stored.remove(&StorageKey::Autosave);
    }

    fn start_job(&mut self, job: Job) {
        if job.patience().is_zero() || self.is_slow {
            self.jobs.push(job);
        } else {
            self.events.push_back(HostEvent::Finished(job.run()));
        }
    }

    fn set_title(&mut self, title: &str) {
        self.title = title.to_owned();
    }

    fn handle_platform_output(&mut self, output: egui::PlatformOutput) {
        self.cursor = Some(output.cursor_icon);
        self.widgets = output.accesskit_update.or(self.widgets.take());
    }

    fn quit(&mut self) {
        self.quits = true;
    }

    fn next_event(&mut self) -> Option<HostEvent> {
        self.events.pop_front()
    }
}
