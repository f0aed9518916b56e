use super::workspace::Workspace;
use crate::gpu::{ContextError, GpuError};
use crate::render::{InterfaceError, RenderError};
use crate::scene::Skinning;
use egui_winit::accesskit_winit;
use std::path::PathBuf;
use std::time::Instant;
use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::WindowId;

/// What the program is started with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Scenes to open and files to import, in order.
    pub files: Vec<PathBuf>,
    /// Title of the window; the one of [`super::globals`] if `None`.
    pub title: Option<String>,
    /// What deforms characters, in place of what the preferences say.
    pub skinning: Option<Skinning>,
}

/// Why the window did not open, or closed by itself. Each names its remedy.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// No window or no OpenGL in it.
    #[error(transparent)]
    Context(#[from] ContextError),
    /// OpenGL failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The scene could not be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The panels cannot be painted.
    #[error(transparent)]
    Interface(#[from] InterfaceError),
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
    let event_loop = EventLoop::<Wake>::with_user_event()
        .build()
        .map_err(|error| ContextError::no_display(&error))?;
    let mut application = Application {
        options,
        proxy: event_loop.create_proxy(),
        workspace: None,
        redraw_at: None,
        failure: None,
    };
    event_loop
        .run_app(&mut application)
        .map_err(|error| AppError::EventLoop(error.to_string()))?;
    application.failure.map_or(Ok(()), Err)
}

/// What wakes the event loop from outside.
#[derive(Debug)]
pub(super) enum Wake {
    /// An assistive technology asks for something.
    Accessibility(accesskit_winit::Event),
    /// Something about a comparison has been found out.
    Measured,
}

impl From<accesskit_winit::Event> for Wake {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}

struct Application {
    options: Options,
    proxy: EventLoopProxy<Wake>,
    workspace: Option<Workspace>,
    /// When egui wants to be drawn next, for what moves by itself, like a blinking cursor.
    redraw_at: Option<Instant>,
    failure: Option<AppError>,
}

impl Application {
    fn finish(&mut self, event_loop: &ActiveEventLoop, result: Result<(), AppError>) {
        if let Err(error) = result {
            self.failure = Some(error);
        }
        // Everything made with OpenGL goes before the window and the event loop do.
        if let Some(workspace) = self.workspace.take() {
            workspace.save_preferences();
        }
        event_loop.exit();
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        let Some(workspace) = &mut self.workspace else {
            return;
        };
        match workspace.redraw() {
            Ok(after) => {
                if workspace.wants_to_quit() {
                    self.finish(event_loop, Ok(()));
                    return;
                }
                // A delay too far away to be a time means never.
                self.redraw_at = Instant::now().checked_add(after);
                if after.is_zero() {
                    workspace.request_redraw();
                }
            }
            Err(error) => self.finish(event_loop, Err(error)),
        }
    }
}

impl ApplicationHandler<Wake> for Application {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.workspace.is_some() {
            return;
        }
        match Workspace::new(event_loop, &self.proxy, &self.options) {
            Ok(workspace) => {
                workspace.request_redraw();
                self.workspace = Some(workspace);
            }
            Err(error) => self.finish(event_loop, Err(error)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(workspace) = &mut self.workspace else {
            return;
        };
        match event {
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::CloseRequested => return self.finish(event_loop, Ok(())),
            WindowEvent::Resized(size) => workspace.resize(size),
            _ => {}
        }
        if workspace.on_window_event(&event) {
            workspace.request_redraw();
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, wake: Wake) {
        if let Some(workspace) = &mut self.workspace {
            if let Wake::Accessibility(event) = wake {
                workspace.on_accessibility(event);
            }
            workspace.request_redraw();
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let flow = match self.redraw_at {
            Some(at) if at <= Instant::now() => {
                self.redraw_at = None;
                if let Some(workspace) = &self.workspace {
                    workspace.request_redraw();
                }
                ControlFlow::Wait
            }
            Some(at) => ControlFlow::WaitUntil(at),
            None => ControlFlow::Wait,
        };
        event_loop.set_control_flow(flow);
    }
}
