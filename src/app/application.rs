use super::rescue;
use super::storage::Storage;
use super::window_host::{Wake, WindowHost};
use crate::gpu::{ContextError, GpuError, Rect, WindowContext};
use crate::io::builtin;
use crate::program::{
    FrameInput, Graphics, NotStored, Options, Program, ProgramError, StorageKey, globals,
    last_window,
};
use crate::revision::Revision;
use crate::ui;
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

/// Why the window did not open, or closed by itself. Each names its remedy.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// No window or no OpenGL in it.
    #[error(transparent)]
    Context(#[from] ContextError),
    /// OpenGL failed before there was a program.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The program cannot go on.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// The window system went away.
    #[error("the window system ended the program: {0}")]
    EventLoop(String),
}

/// Opens the window and runs until it is closed.
///
/// # Errors
/// When there is no display or OpenGL 3.3 to show it with; the message says what to do.
#[doc(alias = "Application")]
pub fn run(options: Options) -> Result<(), AppError> {
    let options = Options {
        // What is restored after a crash may be read from another folder.
        files: options.files.into_iter().map(absolute).collect(),
        ..options
    };
    let event_loop = EventLoop::<Wake>::with_user_event()
        .build()
        .map_err(|error| ContextError::no_display(&error))?;
    let mut application = Application {
        options,
        proxy: event_loop.create_proxy(),
        running: None,
        redraw_at: None,
        failure: None,
    };
    rescue::write_on_panic();
    rescue::watch_signals(application.proxy.clone());
    event_loop
        .run_app(&mut application)
        .map_err(|error| AppError::EventLoop(error.to_string()))?;
    application.failure.map_or(Ok(()), Err)
}

/// The whole path of a file, if there is one.
fn absolute(path: PathBuf) -> PathBuf {
    if builtin::is_builtin(&path) {
        return path;
    }
    std::path::absolute(&path).unwrap_or(path)
}

struct Application {
    options: Options,
    proxy: EventLoopProxy<Wake>,
    running: Option<Running>,
    /// When egui wants to be drawn next, for what moves by itself, like a blinking cursor.
    redraw_at: Option<Instant>,
    failure: Option<AppError>,
}

/// Height, in points, that a title bar and a task bar take away from the screen.
const BARS: f64 = 72.0;

/// Width and height, in points, of a window that is to be `size`: no larger than the screen has room for.
fn on_screen(event_loop: &ActiveEventLoop, (width, height): (f64, f64)) -> (f64, f64) {
    let screens = event_loop.available_monitors();
    let Some(screen) = event_loop
        .primary_monitor()
        .into_iter()
        .chain(screens)
        .next()
    else {
        return (width, height);
    };
    let room: LogicalSize<f64> = screen.size().to_logical(screen.scale_factor());
    let (least_width, least_height) = ui::LEAST_SIZE;
    let most_width = room.width.max(least_width.into());
    let most_height = (room.height - BARS).max(least_height.into());
    (width.min(most_width), height.min(most_height))
}

/// Everything that exists while the window is open.
struct Running {
    program: Program,
    graphics: Graphics,
    host: WindowHost,
    /// Unsaved document that is at hand for a panic.
    remembered: Option<Revision>,
    /// When the window was last given a picture.
    presented: Option<Instant>,
}

/// Time after which a window is given a picture again that it shows already, if there is a frame. X servers
/// without a compositor forget what other windows have covered, and ask for it in a way that cannot be told
/// from a frame that the program itself has asked for.
const SHOWN: Duration = Duration::from_millis(250);

impl Running {
    fn new(
        event_loop: &ActiveEventLoop,
        proxy: &EventLoopProxy<Wake>,
        options: &Options,
    ) -> Result<Self, AppError> {
        let storage = Storage::new();
        let preferences = storage.load(StorageKey::Preferences);
        let last = preferences.as_deref().map(last_window).unwrap_or_default();
        let size = last.size;
        let size = size.map(|(width, height)| (f64::from(width), f64::from(height)));
        let (width, height) = size.unwrap_or(globals::WINDOW_SIZE);
        let (width, height) = on_screen(event_loop, (width, height));
        let (least_width, least_height) = ui::LEAST_SIZE;
        let attributes = Window::default_attributes()
            .with_inner_size(LogicalSize::new(width, height))
            .with_min_inner_size(LogicalSize::new(least_width, least_height))
            .with_visible(false);
        let window = WindowContext::new(event_loop, attributes)?;
        let graphics = Graphics::new(window.gl())?;
        let mut host = WindowHost::new(window, event_loop, proxy, storage);
        let program = Program::start(options, graphics.info(), &mut host);
        host.window().window().set_visible(true);
        if last.is_maximized {
            // X window managers take no notice of windows that are not shown yet.
            host.window().window().set_maximized(true);
        }
        Ok(Self {
            program,
            graphics,
            host,
            remembered: None,
            presented: None,
        })
    }

    fn request_redraw(&self) {
        self.host.window().window().request_redraw();
    }

    /// Keeps unsaved work at hand for a panic.
    fn remember_unsaved(&mut self) {
        let document = self.program.session().document();
        let now = self.program.is_modified().then_some(document);
        if self.remembered != now {
            self.remembered = now;
            let unsaved = self.program.unsaved();
            rescue::remember(unsaved.map(|unsaved| (unsaved, self.host.autosave_paths())));
        }
    }

    /// Time for which the window need not be given a picture that it shows already; `None` once that is over.
    fn shown_for(&self) -> Option<Duration> {
        let until = self.presented? + SHOWN;
        let left = until.saturating_duration_since(Instant::now());
        (!left.is_zero()).then_some(left)
    }

    /// Draws one frame and shows it. Returns how long no frame is needed unless an event comes.
    fn redraw(&mut self) -> Result<Duration, AppError> {
        let PhysicalSize { width, height } = self.host.window().window().inner_size();
        if width == 0 || height == 0 {
            return Ok(Duration::MAX);
        }
        let begun = Instant::now();
        let input = FrameInput {
            context: self.host.context().clone(),
            raw: self.host.take_input(),
            size: (width, height),
        };
        let wait = self
            .program
            .frame(&mut self.graphics, input, &mut self.host)?;
        self.remember_unsaved();
        let is_new = self.graphics.take_is_new();
        if let Some(left) = self.shown_for().filter(|_| !is_new) {
            return Ok(wait.min(left));
        }
        if let Some(picture) = self.graphics.window_picture() {
            let window = self.host.window();
            picture.blit_to_window(Rect {
                x: 0,
                y: 0,
                width: width as i32,
                height: height as i32,
            });
            window.window().pre_present_notify();
            window.swap_buffers()?;
            self.presented = Some(Instant::now());
            self.host.end_frame(begun.elapsed());
        }
        Ok(wait)
    }
}

impl Application {
    fn finish(&mut self, event_loop: &ActiveEventLoop, result: Result<(), AppError>) {
        if let Err(error) = result {
            self.failure = Some(error);
        }
        // Everything made with OpenGL goes before the window and the event loop do.
        self.running = None;
        event_loop.exit();
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        let Some(running) = &mut self.running else {
            return;
        };
        match running.redraw() {
            Ok(_) if running.host.quits() => self.finish(event_loop, Ok(())),
            Ok(after) => {
                // A delay too far away to be a time means never.
                self.redraw_at = Instant::now().checked_add(after);
            }
            Err(error) => self.finish(event_loop, Err(error)),
        }
    }
}

impl ApplicationHandler<Wake> for Application {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.running.is_some() {
            return;
        }
        match Running::new(event_loop, &self.proxy, &self.options) {
            Ok(running) => {
                running.request_redraw();
                self.running = Some(running);
            }
            Err(error) => self.finish(event_loop, Err(error)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(running) = &mut self.running else {
            return;
        };
        match event {
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::CloseRequested => running.host.on_close_requested(),
            WindowEvent::Resized(size) => running.host.window().resize(size.width, size.height),
            _ => {}
        }
        if running.host.on_window_event(&event) {
            running.request_redraw();
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, wake: Wake) {
        let Some(running) = &mut self.running else {
            return;
        };
        match wake {
            Wake::Accessibility(event) => running.host.on_accessibility(event),
            Wake::JobFinished => {}
            Wake::FileChanged(path) => running.host.on_file_changed(path),
            Wake::Terminate => {
                // What has come in is typed first, and then taken over. Without these frames only that is
                // lost.
                let _ = running.redraw();
                running.program.prepare_to_end();
                let _ = running.redraw();
                running.program.end(&mut running.host);
                if let Some(failure) = running.host.finish_storing() {
                    // Whoever does not listen need not be told.
                    let _ = writeln!(std::io::stderr(), "{}", at_end(&failure));
                }
                return self.finish(event_loop, Ok(()));
            }
        }
        running.request_redraw();
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let flow = match self.redraw_at {
            Some(at) if at <= Instant::now() => {
                self.redraw_at = None;
                if let Some(running) = &self.running {
                    running.request_redraw();
                }
                ControlFlow::Wait
            }
            Some(at) => ControlFlow::WaitUntil(at),
            None => ControlFlow::Wait,
        };
        event_loop.set_control_flow(flow);
    }
}

/// What to tell the user of unsaved work at the end of the program.
fn at_end(NotStored { error, kept_in }: &NotStored) -> String {
    match kept_in {
        Some(place) => format!(
            "warning: unsaved work is in {}, which may be cleared when the computer shuts down: {error}",
            place.display()
        ),
        None => format!("error: unsaved work could not be kept: {error}"),
    }
}
