use super::file_dialog::WindowFileDialog;
use super::storage::Storage;
use super::watcher::Watcher;
use crate::disk;
use crate::gpu::WindowContext;
use crate::io::{Diagnostic, Files};
use crate::program::{
    FileRequest, Host, HostEvent, Job, JobResult, NotStored, Previous, StorageKey, Suggested,
};
use egui_winit::accesskit_winit;
use std::collections::{HashMap, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};
use winit::event::{KeyEvent, WindowEvent};
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::keyboard::{Key, ModifiersState};

/// Event that wakes the event loop from outside.
#[derive(Debug)]
pub(super) enum Wake {
    /// An assistive technology asks for something.
    Accessibility(accesskit_winit::Event),
    /// A job has finished.
    JobFinished,
    /// A watched file has changed.
    FileChanged(PathBuf),
    /// The system asks the program to end.
    Terminate,
}

impl From<accesskit_winit::Event> for Wake {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}

/// Whether an event is Ctrl+V, with these keys held.
fn is_paste(event: &KeyEvent, held: ModifiersState) -> bool {
    let is_v = matches!(&event.logical_key, Key::Character(key) if key.eq_ignore_ascii_case("v"));
    let command = held.control_key() || cfg!(target_os = "macos") && held.super_key();
    is_v && command && event.state.is_pressed()
}

/// The window as the place where the program runs.
pub(super) struct WindowHost {
    egui: egui_winit::State,
    dialog: WindowFileDialog,
    /// Keys such as Ctrl that are held.
    held: ModifiersState,
    events: VecDeque<HostEvent>,
    finished: Receiver<JobResult>,
    finish: Sender<JobResult>,
    /// CRC-32 of the files that were written, as they were written last.
    written: HashMap<PathBuf, u32>,
    proxy: EventLoopProxy<Wake>,
    started: Instant,
    last_frame: Option<Duration>,
    quits: bool,
    storage: Storage,
    watcher: Watcher,
    window: WindowContext,
}

impl WindowHost {
    /// The place behind `window`, which is still hidden: accessibility must be set up before it is
    /// first shown.
    pub fn new(
        window: WindowContext,
        event_loop: &ActiveEventLoop,
        proxy: &EventLoopProxy<Wake>,
        storage: Storage,
    ) -> Self {
        let mut egui = egui_winit::State::new(
            egui::Context::default(),
            egui::ViewportId::ROOT,
            event_loop,
            Some(window.window().scale_factor() as f32),
            event_loop.system_theme(),
            Some(window.gl().info().max_texture_size as usize),
        );
        egui.init_accesskit(event_loop, window.window(), proxy.clone());
        let (finish, finished) = channel();
        Self {
            egui,
            dialog: WindowFileDialog::default(),
            held: ModifiersState::empty(),
            events: VecDeque::new(),
            finished,
            finish,
            written: HashMap::new(),
            proxy: proxy.clone(),
            started: Instant::now(),
            last_frame: None,
            quits: false,
            storage,
            watcher: Watcher::new(proxy.clone()),
            window,
        }
    }

    /// The window and its OpenGL.
    pub fn window(&self) -> &WindowContext {
        &self.window
    }

    /// Where unsaved work is kept, in the order of preference; empty if it cannot be.
    pub fn autosave_paths(&self) -> Vec<PathBuf> {
        self.storage.autosave_paths()
    }

    /// Takes note that a frame took so long until it was shown.
    pub fn end_frame(&mut self, took: Duration) {
        self.last_frame = Some(took);
    }

    /// Whether the program wants to end.
    pub fn quits(&self) -> bool {
        self.quits
    }

    /// Where egui keeps what it remembers.
    pub fn context(&self) -> &egui::Context {
        self.egui.egui_ctx()
    }

    /// Input since the last frame.
    pub fn take_input(&mut self) -> egui::RawInput {
        self.egui.take_egui_input(self.window.window())
    }

    /// Takes in an event of the window; whether a frame is needed.
    pub fn on_window_event(&mut self, event: &WindowEvent) -> bool {
        if let WindowEvent::DroppedFile(path) = event {
            self.events.push_back(HostEvent::Dropped {
                path: path.clone(),
                files: self.files(),
            });
        }
        let told = self.egui.on_window_event(self.window.window(), event);
        match event {
            WindowEvent::ModifiersChanged(held) => self.held = held.state(),
            WindowEvent::KeyboardInput { event, .. } if is_paste(event, self.held) => {
                self.paste_nothing();
            }
            _ => {}
        }
        told.repaint
    }

    /// Takes in Ctrl+V where there is no text on the clipboard, which egui leaves out: the program says so.
    fn paste_nothing(&mut self) {
        let events = &mut self.egui.egui_input_mut().events;
        if !matches!(events.last(), Some(egui::Event::Paste(_))) {
            events.push(egui::Event::Paste(String::new()));
        }
    }

    /// Takes in that another program has changed a watched file.
    pub fn on_file_changed(&mut self, path: PathBuf) {
        self.events.push_back(HostEvent::Changed(path));
    }

    /// Takes in that the user closes the window.
    pub fn on_close_requested(&mut self) {
        self.events.push_back(HostEvent::CloseRequested);
    }

    /// Takes in what an assistive technology asks for.
    pub fn on_accessibility(&mut self, event: accesskit_winit::Event) {
        use accesskit_winit::WindowEvent;
        match event.window_event {
            WindowEvent::InitialTreeRequested => self.egui.egui_ctx().enable_accesskit(),
            WindowEvent::ActionRequested(request) => {
                self.egui.on_accesskit_action_request(request);
            }
            WindowEvent::AccessibilityDeactivated => self.egui.egui_ctx().disable_accesskit(),
        }
    }

    fn write_keeping(
        &mut self,
        files: &[(PathBuf, Vec<u8>)],
        previous: Previous,
    ) -> Result<(), Diagnostic> {
        let is_own = |path: &Path, bytes: &[u8]| {
            let known = self.written.get(path);
            previous == Previous::KeepForeign && known == Some(&crc32fast::hash(bytes))
        };
        disk::write_all_keeping(files, &is_own)?;
        let digests = files
            .iter()
            .map(|(path, bytes)| (path.clone(), crc32fast::hash(bytes)));
        self.written.extend(digests);
        Ok(())
    }

    /// Waits until everything is stored; why unsaved work is not where it should be, if so.
    pub fn finish_storing(&mut self) -> Option<NotStored> {
        self.storage.wait();
        self.storage.failure()
    }
}

impl Host for WindowHost {
    fn now(&self) -> Duration {
        self.started.elapsed()
    }

    fn last_frame(&self) -> Option<Duration> {
        self.last_frame
    }

    fn files(&self) -> Arc<dyn Files> {
        Arc::new(disk::files())
    }

    fn choose_file(&mut self, request: FileRequest, suggested: Suggested) {
        self.dialog.open(request, suggested);
    }

    fn show_dialogs(&mut self, context: &egui::Context) {
        if let Some((request, path)) = self.dialog.show(context) {
            self.events.push_back(HostEvent::Chosen {
                request,
                path,
                others: Vec::new(),
                files: self.files(),
            });
        }
    }

    fn is_maximized(&self) -> bool {
        self.window.window().is_maximized()
    }

    fn is_dialog_open(&self) -> bool {
        self.dialog.is_open()
    }

    fn write_file(&mut self, path: &Path, bytes: Vec<u8>, previous: Previous) {
        let path = path.to_owned();
        let result = self.write_keeping(&[(path.clone(), bytes)], previous);
        self.events.push_back(HostEvent::Written { path, result });
    }

    fn write_files(&mut self, path: &Path, files: Vec<(PathBuf, Vec<u8>)>, previous: Previous) {
        let paths = files.iter().map(|(path, _)| &**path);
        let result = disk::in_new_folders(paths, || self.write_keeping(&files, previous));
        let path = path.to_owned();
        self.events.push_back(HostEvent::Written { path, result });
    }

    fn watch(&mut self, files: Vec<PathBuf>) {
        self.watcher.watch(files);
    }

    fn copy_text(&mut self, text: String) {
        self.egui.set_clipboard_text(text);
    }

    fn request_paste(&mut self) {
        let text = self.egui.clipboard_text().unwrap_or_default();
        self.events.push_back(HostEvent::Pasted(text));
    }

    fn load(&self, key: StorageKey) -> Option<Vec<u8>> {
        self.storage.load(key)
    }

    fn unsaved_work_since(&self) -> Option<Duration> {
        self.storage.unsaved_work_since()
    }

    fn pass_unsaved_work(&mut self) {
        self.storage.pass_unsaved_work();
    }

    fn store(&mut self, key: StorageKey, bytes: Vec<u8>) {
        self.storage.store(key, bytes);
    }

    fn remove_unsaved_work(&mut self) {
        self.storage.remove_unsaved_work();
    }

    fn put_unsaved_work_aside(&mut self) -> Option<PathBuf> {
        self.storage.put_unsaved_work_aside()
    }

    fn start_job(&mut self, job: Job) {
        let (finish, proxy) = (self.finish.clone(), self.proxy.clone());
        let copy = job.clone();
        let (done, is_done) = channel();
        let work = move || {
            // A window that is gone needs neither the result nor waking.
            let _ = finish.send(copy.run());
            let _ = done.send(());
            let _ = proxy.send_event(Wake::JobFinished);
        };
        let thread = std::thread::Builder::new().name("job".to_owned());
        if thread.spawn(work).is_err() {
            // Without a thread to spare the window has to wait for it.
            self.events.push_back(HostEvent::Finished(job.run()));
        } else {
            let _ = is_done.recv_timeout(job.patience());
        }
    }

    fn set_title(&mut self, title: &str) {
        self.window.window().set_title(title);
    }

    fn handle_platform_output(&mut self, output: egui::PlatformOutput) {
        self.egui
            .handle_platform_output(self.window.window(), output);
    }

    fn quit(&mut self) {
        self.quits = true;
    }

    fn next_event(&mut self) -> Option<HostEvent> {
        let finished = || self.finished.try_recv().ok().map(HostEvent::Finished);
        let event = self.events.pop_front().or_else(finished);
        event.or_else(|| self.storage.failure().map(HostEvent::StoreFailed))
    }
}
