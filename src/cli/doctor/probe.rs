//! Ways to OpenGL, each tried in a process of its own: a driver that crashes or never answers ends
//! that process, and not the report.

use crate::gpu::{Backend, ContextError, Gl, HeadlessContext, Info, WindowContext};
use serde::{Deserialize, Serialize};
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};

/// Time that a driver has to answer. The slowest one seen takes two seconds on a busy machine.
const PATIENCE: Duration = Duration::from_secs(15);
/// Time between two looks at a process that has not ended yet.
const PAUSE: Duration = Duration::from_millis(10);

/// Variable of the environment that tells a process of ours which way to try. An option would be
/// among the completions of shells, which know of nothing hidden.
const VARIABLE: &str = "EDITOR_DOCTOR_TRIES";

/// Where a context of OpenGL comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// A window on the display.
    Window,
    /// EGL without a window.
    Egl,
    /// OSMesa, on the processor.
    Osmesa,
}

impl Way {
    const ALL: [Self; 3] = [Self::Window, Self::Egl, Self::Osmesa];

    fn name(self) -> &'static str {
        match self {
            Self::Window => "window",
            Self::Egl => "egl",
            Self::Osmesa => "osmesa",
        }
    }

    /// The way that this process was started to try, if it was.
    pub fn asked_for() -> Option<Self> {
        let name = std::env::var(VARIABLE).ok()?;
        Self::ALL.into_iter().find(|way| way.name() == name)
    }
}

/// What came of trying one way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Outcome {
    /// There is OpenGL.
    Works(OpenGl),
    /// There is none.
    Fails(Failure),
}

/// Driver and its limits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct OpenGl {
    pub version: String,
    pub renderer: String,
    pub vendor: String,
    /// Whether pictures are computed on the processor.
    pub software: bool,
    /// Longest side of a texture, in pixels.
    pub max_texture_side: u32,
    /// Longest side of a picture, in pixels.
    pub max_picture_side: u32,
    /// Most samples a pixel.
    pub max_samples: u32,
}

/// Reason why there is no OpenGL.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Failure {
    pub kind: FailureKind,
    pub message: String,
}

/// Kinds of failures that have a remedy of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum FailureKind {
    NoDisplay,
    NoLibrary,
    NoDevice,
    TooOld,
    Crashed,
    NoAnswer,
    Refused,
}

impl Outcome {
    /// The driver, if there is OpenGL.
    pub fn works(&self) -> Option<&OpenGl> {
        match self {
            Self::Works(driver) => Some(driver),
            Self::Fails(_) => None,
        }
    }

    /// The failure, if there is none.
    pub fn fails(&self) -> Option<&Failure> {
        match self {
            Self::Works(_) => None,
            Self::Fails(failure) => Some(failure),
        }
    }

    pub(super) fn failed(kind: FailureKind, message: impl Into<String>) -> Self {
        let message = message.into();
        Self::Fails(Failure { kind, message })
    }
}

impl From<&Info> for OpenGl {
    fn from(info: &Info) -> Self {
        Self {
            version: info.version.clone(),
            renderer: info.renderer.clone(),
            vendor: info.vendor.clone(),
            software: info.is_software,
            max_texture_side: info.max_texture_size,
            max_picture_side: info.max_framebuffer_size,
            max_samples: info.max_samples,
        }
    }
}

impl From<ContextError> for Outcome {
    /// The cause alone: what to do about it is for the report to say, once.
    fn from(error: ContextError) -> Self {
        let (kind, message) = match error {
            ContextError::NoDisplay { cause } => (FailureKind::NoDisplay, cause),
            ContextError::Library { library, cause } => {
                let message = format!("{library} cannot be loaded ({cause})");
                (FailureKind::NoLibrary, message)
            }
            ContextError::NoDevice { tried } => (FailureKind::NoDevice, tried.join("; ")),
            ContextError::TooOld { found } => {
                let message = format!("the driver has only OpenGL {found}");
                (FailureKind::TooOld, message)
            }
            ContextError::Osmesa { cause } | ContextError::Window { cause } => {
                (FailureKind::Refused, cause)
            }
            ContextError::NoBackend { .. } | ContextError::Native(_) => {
                (FailureKind::Refused, error.to_string())
            }
        };
        Self::failed(kind, message)
    }
}

impl From<&Gl> for Outcome {
    fn from(gl: &Gl) -> Self {
        Self::Works(gl.info().into())
    }
}

/// Tries `way` in this process.
pub(super) fn try_here(way: Way) -> Outcome {
    let offscreen = |backend| match HeadlessContext::new(backend) {
        Ok(context) => context.gl().into(),
        Err(error) => error.into(),
    };
    match way {
        Way::Egl => offscreen(Backend::Egl),
        Way::Osmesa => offscreen(Backend::Osmesa),
        Way::Window => in_a_window(),
    }
}

/// Opens a window that is never shown.
fn in_a_window() -> Outcome {
    struct Hidden(Option<Outcome>);

    impl ApplicationHandler for Hidden {
        fn resumed(&mut self, event_loop: &ActiveEventLoop) {
            let attributes = Window::default_attributes().with_visible(false);
            self.0 = Some(match WindowContext::new(event_loop, attributes) {
                Ok(context) => context.gl().into(),
                Err(error) => error.into(),
            });
            event_loop.exit();
        }

        fn window_event(&mut self, _: &ActiveEventLoop, _: WindowId, _: WindowEvent) {}
    }

    let event_loop = match EventLoop::new() {
        Ok(event_loop) => event_loop,
        Err(error) => return ContextError::no_display(&error).into(),
    };
    let mut hidden = Hidden(None);
    let ran = event_loop.run_app(&mut hidden);
    let no_window = || match ran {
        Ok(()) => "the window system gives no window".to_owned(),
        Err(error) => error.to_string(),
    };
    hidden
        .0
        .unwrap_or_else(|| Outcome::failed(FailureKind::Refused, no_window()))
}

/// A way that is being tried in a process of its own.
pub(super) struct Trial(Result<Child, Outcome>);

impl Trial {
    /// Starts to try `way`.
    pub fn start(way: Way) -> Self {
        let started = std::env::current_exe().and_then(|program| {
            Command::new(program)
                .arg("doctor")
                .env(VARIABLE, way.name())
                .stdin(Stdio::null())
                .stdout(Stdio::piped())
                // Drivers print warnings there, and the outcome says what matters.
                .stderr(Stdio::null())
                .spawn()
        });
        Self(started.map_err(|error| {
            let message = format!("it could not be tried ({error})");
            Outcome::failed(FailureKind::Refused, message)
        }))
    }

    /// Waits for the outcome, and not longer than [`PATIENCE`].
    pub fn outcome(self) -> Outcome {
        let mut child = match self.0 {
            Ok(child) => child,
            Err(outcome) => return outcome,
        };
        let deadline = Instant::now() + PATIENCE;
        while matches!(child.try_wait(), Ok(None)) {
            if Instant::now() >= deadline {
                // It may have ended by itself in the meantime.
                let _ = child.kill();
                let _ = child.wait();
                let seconds = PATIENCE.as_secs();
                let message = format!("the driver did not answer within {seconds} seconds");
                return Outcome::failed(FailureKind::NoAnswer, message);
            }
            std::thread::sleep(PAUSE);
        }
        let mut printed = String::new();
        if let Some(mut output) = child.stdout.take() {
            // Without an outcome in it, it counts as a crash.
            let _ = output.read_to_string(&mut printed);
        }
        // Drivers may print there as well, before it.
        let last = printed.lines().next_back().unwrap_or_default();
        serde_json::from_str(last).unwrap_or_else(|_| {
            Outcome::failed(
                FailureKind::Crashed,
                "the driver crashed when it was started",
            )
        })
    }
}
