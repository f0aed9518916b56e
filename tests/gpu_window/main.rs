//! Opens a window, draws into it, resizes it, and closes it, on the display or else on Xvfb.
//! Its own `main`, since event loops want the main thread.

use std::io::{BufRead as _, BufReader};
use std::process::{Command, ExitCode, ExitStatus, Stdio};

use editor_core::gpu::{ContextError, Framebuffer, Rect, WindowContext};
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};

/// Draws this many pictures, then leaves.
const PICTURES: u32 = 5;

#[derive(Default)]
struct Test {
    context: Option<WindowContext>,
    pictures: u32,
    failure: Option<String>,
}

impl Test {
    fn draw(&self, context: &WindowContext) -> Result<(), Box<dyn std::error::Error>> {
        let PhysicalSize { width, height } = context.window().inner_size();
        context.resize(width, height);
        let framebuffer = Framebuffer::new(context.gl(), width, height, 4)?;
        framebuffer.clear([1.0, 0.0, 0.0, 1.0]);
        let [width, height] = [i32::try_from(width)?, i32::try_from(height)?];
        framebuffer.blit_to_window(Rect {
            x: 0,
            y: 0,
            width,
            height,
        });
        context.gl().check("drawing into the window")?;
        context.swap_buffers()?;
        Ok(())
    }
}

impl ApplicationHandler for Test {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        let attributes = Window::default_attributes().with_inner_size(PhysicalSize::new(320, 240));
        match WindowContext::new(event_loop, attributes) {
            Ok(context) => {
                eprintln!("{}", context.gl().info().version);
                context.window().request_redraw();
                self.context = Some(context);
            }
            Err(error) => {
                self.failure = Some(error.to_string());
                event_loop.exit();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(context) = &self.context else { return };
        if event != WindowEvent::RedrawRequested {
            return;
        }
        if let Err(error) = self.draw(context) {
            self.failure = Some(error.to_string());
        }
        let _ = context
            .window()
            .request_inner_size(PhysicalSize::new(320 + self.pictures * 10, 240));
        context.window().request_redraw();
        self.pictures += 1;
        if self.pictures == PICTURES || self.failure.is_some() {
            self.context = None;
            event_loop.exit();
        }
    }
}

fn run() -> Result<(), String> {
    let event_loop = EventLoop::new().map_err(|e| ContextError::no_display(&e).to_string())?;
    let mut test = Test::default();
    event_loop
        .run_app(&mut test)
        .map_err(|error| error.to_string())?;
    match test.failure {
        Some(failure) => Err(failure),
        None if test.pictures == PICTURES => Ok(()),
        None => Err(format!("{} pictures of {PICTURES}", test.pictures)),
    }
}

/// Runs this program again on a display of its own. None if there is no `Xvfb`.
fn run_on_xvfb() -> Option<std::io::Result<ExitStatus>> {
    let mut server = Command::new("Xvfb")
        .args([
            "-displayfd",
            "1",
            "-screen",
            "0",
            "1024x768x24",
            "-nolisten",
            "tcp",
        ])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    let mut number = String::new();
    let told = match server.stdout.take() {
        Some(stdout) => BufReader::new(stdout).read_line(&mut number),
        None => Ok(0),
    };
    let status = told.and_then(|_| {
        let display = format!(":{}", number.trim());
        Command::new(std::env::current_exe()?)
            .env("DISPLAY", display)
            .status()
    });
    // It may have ended by itself, which the status tells.
    let _ = server.kill();
    let _ = server.wait();
    Some(status)
}

fn main() -> ExitCode {
    let outcome = if ["DISPLAY", "WAYLAND_DISPLAY"]
        .iter()
        .any(|name| std::env::var_os(name).is_some())
    {
        run()
    } else {
        match run_on_xvfb() {
            Some(Ok(status)) if status.success() => Ok(()),
            Some(Ok(status)) => Err(format!("on Xvfb: {status}")),
            Some(Err(error)) => Err(format!("Xvfb: {error}")),
            None => {
                eprintln!("left out: a window can be drawn into (no display, and no Xvfb)");
                Ok(())
            }
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("a window cannot be drawn into: {failure}");
            ExitCode::FAILURE
        }
    }
}
