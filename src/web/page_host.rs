//! The browser as the program's host.

use super::browser;
use super::fetching::{self, Fetching};
use super::given_files::{GivenFiles, brought_files};
use super::tabs::{self, Slots};
use crate::io::builtin::{WithBuiltin, absent};
use crate::io::image::PictureFormat;
use crate::io::{Diagnostic, Files, WithArchives, to_zip};
use crate::program::{
    FileRequest, Host, HostEvent, Job, JobResult, NotStored, Previous, RunningJob, StorageKey,
    Suggested,
};
use egui::Context;
use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;
use wasm_bindgen_futures::spawn_local;

/// Time for which a job may keep everything else waiting: less than a frame.
const SLICE: Duration = Duration::from_millis(10);

/// Name of jobs in the browser's measures.
const JOB: &str = "editor-job";

/// The browser: files come from the user's hands and go to the user's downloads.
pub(super) struct PageHost {
    given: GivenFiles,
    events: Events,
    /// Text that the user has the browser paste in this frame.
    pasted: Option<String>,
    fetching: Fetching,
    slots: Slots,
    /// Whether nothing is kept from one visit to the next.
    forgets: bool,
    last_frame: Rc<Cell<Option<Duration>>>,
}

/// Events that wait for the program. A clone is another handle to the same events.
#[derive(Clone, Default)]
struct Events {
    waiting: Rc<RefCell<VecDeque<HostEvent>>>,
    /// To be woken; none before the first frame.
    context: Rc<RefCell<Option<Context>>>,
}

impl Events {
    fn push(&self, event: HostEvent) {
        self.waiting.borrow_mut().push_back(event);
        if let Some(context) = &*self.context.borrow() {
            context.request_repaint();
        }
    }

    /// Adds what could be read to the files of the page, and tells of what could not. Returns the
    /// paths of the former.
    async fn take_in(
        &self,
        given: &GivenFiles,
        read: Vec<(PathBuf, Result<Vec<u8>, String>)>,
    ) -> Vec<PathBuf> {
        let mut files = Vec::new();
        for (path, bytes) in read {
            match bytes {
                Ok(bytes) => files.push((path, bytes)),
                Err(error) => self.push(HostEvent::Unreadable(Diagnostic::new(&path, error))),
            }
        }
        let names: Vec<PathBuf> = files.iter().map(|(path, _)| path.clone()).collect();
        let folder = given.place(files).await;
        names.into_iter().map(|path| folder.join(path)).collect()
    }

    /// Takes in what was dropped, and has the program use it.
    async fn tell_dropped(
        &self,
        given: &GivenFiles,
        read: Vec<(PathBuf, Result<Vec<u8>, String>)>,
    ) {
        let names = self.take_in(given, read).await;
        for path in brought_files(&names) {
            let files = all_files(given);
            self.push(HostEvent::Dropped { path, files });
        }
    }
}

impl PageHost {
    /// A host with the files of an earlier visit.
    pub fn new(given: GivenFiles, slots: Slots) -> Self {
        Self {
            given,
            events: Events::default(),
            pasted: None,
            fetching: Fetching::default(),
            slots,
            forgets: false,
            last_frame: Rc::default(),
        }
    }

    /// The host of a scene in somebody else's page, which keeps nothing.
    pub fn forgetting(self) -> Self {
        Self {
            forgets: true,
            ..self
        }
    }

    /// Takes in files that were dropped, by their ways from where they were dropped.
    pub fn take_files(&self, read: Vec<(PathBuf, Result<Vec<u8>, String>)>) {
        let (given, events) = (self.given.clone(), self.events.clone());
        spawn_local(async move { events.tell_dropped(&given, read).await });
    }

    /// Fetches the built-in files that opening `paths` reads, before there is a program.
    pub async fn fetch_for(&self, paths: &[PathBuf]) {
        let files = all_files(&self.given);
        let absent = paths.iter().flat_map(|path| absent(&*files, path));
        fetching::fetch_all(absent.collect(), &self.given).await;
    }

    /// Wakes `context` from now on when something has happened.
    pub fn wake(&self, context: &Context) {
        *self.events.context.borrow_mut() = Some(context.clone());
    }

    /// Takes in what was dropped on the page since the last frame.
    pub fn take_dropped(&self, context: &Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        if dropped.is_empty() {
            return;
        }
        let (given, events) = (self.given.clone(), self.events.clone());
        spawn_local(async move {
            let mut read = Vec::new();
            for file in dropped {
                read.push((file.path().to_owned(), file.bytes_async().await));
            }
            events.tell_dropped(&given, read).await;
        });
    }

    /// Name of the entry in the browser's storage.
    fn entry(&self, key: StorageKey) -> String {
        match key {
            StorageKey::Autosave => tabs::entry(self.slots.own()),
            StorageKey::Preferences => key.name().to_owned(),
        }
    }

    /// The entry for unsaved work; `None` if none is kept.
    pub fn autosave_entry(&self) -> Option<String> {
        (!self.forgets).then(|| self.entry(StorageKey::Autosave))
    }

    /// Takes note that a frame begins: it is over when the browser can take the next.
    pub fn begin_frame(&self) {
        let begun = browser::now();
        let last_frame = self.last_frame.clone();
        browser::at_next_frame(move || {
            last_frame.set(Some(browser::now().saturating_sub(begun)));
        });
    }

    /// Takes note of the text that the user has the browser paste in this frame, if any.
    pub fn set_pasted(&mut self, text: Option<String>) {
        self.pasted = text;
    }

    /// Asks the user for files, and answers `request` with those that are read by themselves, the first of
    /// which suits it, if any does.
    fn read_chosen(&self, request: FileRequest) {
        let (given, events) = (self.given.clone(), self.events.clone());
        browser::choose_files(move |chosen| {
            spawn_local(async move {
                let mut read = Vec::new();
                for file in chosen {
                    let bytes = browser::bytes(&file).await;
                    let bytes = bytes.map_err(|error| browser::words(&error));
                    read.push((PathBuf::from(file.name()), bytes));
                }
                let names = events.take_in(&given, read).await;
                let files = all_files(&given);
                let suits = |path: &PathBuf| request.purpose.offers(&*files, path);
                let mut chosen = brought_files(&names);
                if !chosen.iter().any(suits) && names.iter().any(suits) {
                    chosen = names.into_iter().filter(suits).collect();
                }
                // One that does not suit gets the message that says why.
                chosen.sort_by_key(|path| !suits(path));
                let mut chosen = chosen.into_iter();
                if let Some(path) = chosen.next() {
                    events.push(HostEvent::Chosen {
                        request,
                        path,
                        others: chosen.collect(),
                        files,
                    });
                }
            });
        });
    }
}

/// What the program can read: files that were given, also inside archives, and those built in.
fn all_files(given: &GivenFiles) -> Arc<dyn Files> {
    Arc::new(WithBuiltin(WithArchives::new(given.clone())))
}

impl Host for PageHost {
    fn now(&self) -> Duration {
        browser::now()
    }

    fn last_frame(&self) -> Option<Duration> {
        self.last_frame.get()
    }

    fn files(&self) -> Arc<dyn Files> {
        all_files(&self.given)
    }

    fn is_page(&self) -> bool {
        true
    }

    fn choose_file(&mut self, request: FileRequest, suggested: Suggested) {
        if request.purpose.written().is_empty() {
            return self.read_chosen(request);
        }
        // Where a download goes is between the user and the browser.
        let path = PathBuf::from(suggested.name);
        self.events.push(HostEvent::Chosen {
            request,
            path: if request.purpose.is_export() {
                self.given.free_name(path)
            } else {
                path
            },
            others: Vec::new(),
            files: self.files(),
        });
    }

    fn write_file(&mut self, path: &Path, bytes: Vec<u8>, _: Previous) {
        let result = download(path, &bytes);
        if result.is_ok() && PictureFormat::of(path).is_err() {
            // What was saved can be opened again.
            self.given.add(vec![(path.to_owned(), bytes)]);
        }
        let path = path.to_owned();
        self.events.push(HostEvent::Written { path, result });
    }

    fn write_files(&mut self, path: &Path, files: Vec<(PathBuf, Vec<u8>)>, previous: Previous) {
        if let [(only, bytes)] = &files[..] {
            return self.write_file(only, bytes.clone(), previous);
        }
        // A page that downloads several files asks whether it may.
        let zip = to_zip(&files);
        let result = zip.and_then(|zip| download(&path.with_extension("zip"), &zip));
        let path = path.to_owned();
        self.events.push(HostEvent::Written { path, result });
    }

    fn watch(&mut self, _: Vec<PathBuf>) {}

    fn bring(&mut self, builtin: Vec<PathBuf>) {
        let events = self.events.clone();
        self.fetching.begin(builtin, &self.given, move |result| {
            events.push(HostEvent::Brought(result));
        });
    }

    fn part_brought(&self) -> Option<f32> {
        self.fetching.part()
    }

    fn link(&self, fragment: &str) -> Option<String> {
        browser::link(fragment)
    }

    fn copy_text(&mut self, text: String) {
        browser::copy_text(&text);
    }

    fn request_paste(&mut self) {
        let events = self.events.clone();
        if let Some(text) = self.pasted.take() {
            return events.push(HostEvent::Pasted(text));
        }
        spawn_local(async move {
            let text = browser::pasted_text().await.unwrap_or_default();
            events.push(HostEvent::Pasted(text));
        });
    }

    fn load(&self, key: StorageKey) -> Option<Vec<u8>> {
        if self.forgets {
            return None;
        }
        browser::stored(&self.entry(key)).map(String::into_bytes)
    }

    fn pass_unsaved_work(&mut self) {
        self.slots.pass();
    }

    fn store(&mut self, key: StorageKey, bytes: Vec<u8>) {
        if self.forgets {
            return;
        }
        let text = String::from_utf8_lossy(&bytes);
        if !browser::store(&self.entry(key), &text) && key == StorageKey::Autosave {
            let error = Diagnostic::new(
                Path::new(key.name()),
                "the browser has no room for it, or keeps nothing for this page",
            );
            let kept_in = None;
            let failure = NotStored { error, kept_in };
            self.events.push(HostEvent::StoreFailed(failure));
        }
    }

    fn remove_unsaved_work(&mut self) {
        if !self.forgets {
            browser::remove(&self.entry(StorageKey::Autosave));
        }
    }

    fn start_job(&mut self, job: Job) {
        browser::begin_measure(JOB);
        let patience = job.patience();
        let mut job = job.begin();
        match slice(&mut job, patience) {
            Some(result) => self.events.push(HostEvent::Finished(result)),
            None => go_on(job, self.events.clone()),
        }
    }

    fn set_title(&mut self, title: &str) {
        if let Some(document) = browser::document() {
            document.set_title(title);
        }
    }

    // Whoever runs egui on the page takes care of the cursor and of links.
    fn handle_platform_output(&mut self, _: egui::PlatformOutput) {}

    // A page is closed by its browser.
    fn quit(&mut self) {}

    fn next_event(&mut self) -> Option<HostEvent> {
        self.events.waiting.borrow_mut().pop_front()
    }
}

/// Does `job` a slice of time after the other, between which the browser gets its turn.
fn go_on(mut job: RunningJob, events: Events) {
    browser::after(Duration::ZERO, move || match slice(&mut job, SLICE) {
        Some(result) => events.push(HostEvent::Finished(result)),
        None => go_on(job, events),
    });
}

/// Goes on with `job` for that long, unless it is done before: then its result.
fn slice(job: &mut RunningJob, length: Duration) -> Option<JobResult> {
    let begun = browser::now();
    while browser::now().saturating_sub(begun) < length {
        if let Some(result) = job.step() {
            browser::end_measure(JOB);
            return Some(result);
        }
    }
    None
}

fn download(path: &Path, bytes: &[u8]) -> Result<(), Diagnostic> {
    let name = path.file_name().unwrap_or(path.as_os_str());
    browser::download(&name.to_string_lossy(), bytes).map_err(|error| {
        let message = format!(
            "the browser refuses the download: {}",
            browser::words(&error)
        );
        Diagnostic::new(path, message)
    })
}
