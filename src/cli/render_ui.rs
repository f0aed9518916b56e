//! `editor render --ui`: the window's panels in the picture, drawn by the program under a host of
//! its own.

use super::CliError;
use super::output::eprint_line;
use crate::disk;
use crate::editor::{Session, Severity, Tool};
use crate::geometry::Picture;
use crate::gpu::{Backend, Framebuffer, HeadlessContext};
use crate::io::Files;
use crate::program::{
    FileRequest, FrameInput, Graphics, GraphicsInfo, Host, HostEvent, Job, JobResult, Previous,
    Program, StorageKey, Suggested,
};
use crate::render::{OffscreenError, read_picture};
use crate::scene::Skinning;
use crate::ui::{self, COMMANDS, Command, Entry};
use egui::{Event, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Number of frames after which the panels have found their sizes.
const FRAMES: usize = 4;

/// Refuses a picture that is smaller than the window can be.
pub(super) fn check_size((width, height): (u32, u32)) -> Result<(), CliError> {
    let (least_width, least_height) = ui::LEAST_SIZE;
    if width >= least_width && height >= least_height {
        return Ok(());
    }
    Err(CliError::Usage(format!(
        "expected a --size of at least {least_width}x{least_height} with --ui, \
         found {width}x{height}"
    )))
}

/// Options of `--ui`: input before the picture is drawn.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PanelOptions {
    /// The tool that is chosen.
    #[arg(long, requires = "ui", default_value = "select")]
    tool: ToolName,
    /// Press a key, such as K, before the mouse is used; may be given several times.
    #[arg(long, requires = "ui", value_name = "KEY", value_parser = key)]
    press: Vec<egui::Key>,
    /// Press the left mouse button at a pixel of the picture and drag to another, without letting
    /// go; Z,W the same as X,Y is to point and click. May be given several times: all but the last
    /// are let go of.
    #[arg(long, requires = "ui", value_name = "X,Y,Z,W", allow_hyphen_values = true, value_parser = drag)]
    drag: Vec<Drag>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum ToolName {
    Select,
    Pose,
    Move,
    Rotate,
    Scale,
    Ik,
}

impl ToolName {
    /// Press of the key that selects the tool.
    fn key(self) -> Event {
        let tool = match self {
            Self::Select => Tool::Select,
            Self::Pose => Tool::Pose,
            Self::Move => Tool::Move,
            Self::Rotate => Tool::Rotate,
            Self::Scale => Tool::Scale,
            Self::Ik => Tool::Ik,
        };
        let is_it = |entry: &&Entry| entry.command == Command::SetTool(tool);
        let keys = COMMANDS.iter().find(is_it).map(|entry| entry.shortcuts);
        let key = keys.and_then(|keys| keys.first());
        press(key.map_or(egui::Key::V, |key| key.logical_key))
    }
}

fn press(key: egui::Key) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    }
}

fn key(text: &str) -> Result<egui::Key, String> {
    let key = egui::Key::from_name(text);
    key.ok_or_else(|| format!("expected the name of a key, such as K or F12, found {text}"))
}

/// Drag of the pointer, in pixels from the picture's upper left corner.
#[derive(Clone, Copy, Debug)]
struct Drag {
    from: Pos2,
    to: Pos2,
}

fn drag(text: &str) -> Result<Drag, String> {
    let number = |n: &str| n.trim().parse().ok().filter(|n: &f32| n.is_finite());
    let numbers: Option<Vec<f32>> = text.split(',').map(number).collect();
    match numbers.as_deref() {
        Some(&[x, y, z, w]) => Ok(Drag {
            from: pos2(x, y),
            to: pos2(z, w),
        }),
        _ => Err(format!("expected four numbers X,Y,Z,W, found {text}")),
    }
}

/// Properties of the window that is drawn.
pub(super) struct Window {
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Samples a pixel of the scene.
    pub samples: u32,
    /// Colors of the panels.
    pub theme: egui::ThemePreference,
}

/// Picture of the window, drawn by the program under a host whose clock stands still.
pub(super) fn picture(
    options: &PanelOptions,
    session: Session,
    backend: Backend,
    window: &Window,
    skinning: Option<Skinning>,
) -> Result<Picture, CliError> {
    let (size, samples) = (window.size, window.samples);
    let offscreen = HeadlessContext::new(backend).map_err(OffscreenError::from)?;
    // Fails before any work if the driver does not have as many samples.
    drop(Framebuffer::new(offscreen.gl(), 1, 1, samples)?);
    let mut graphics = Graphics::new(offscreen.gl())?.for_pictures(samples);
    let no_name = GraphicsInfo {
        // It differs between machines.
        description: String::new(),
        ..graphics.info()
    };
    let max_texture_side = no_name.max_texture_side;
    let mut program = Program::showing(session, no_name);
    program.ui_mut().theme = window.theme;
    program.ui_mut().skinning = skinning;
    let context = egui::Context::default();
    let (width, height) = size;
    let screen = Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32));
    let tool = vec![options.tool.key()];
    let keys = options.press.iter().map(|&key| vec![press(key)]);
    let last = options.drag.len().saturating_sub(1);
    let gestures = options.drag.iter().enumerate();
    let gestures = gestures.flat_map(|(index, &drag)| gesture(drag, index == last));
    let frames = std::iter::once(tool)
        .chain(still())
        .chain(keys)
        .chain(still())
        .chain(gestures);
    for events in frames.chain(std::iter::once(Vec::new())) {
        let raw = RawInput {
            screen_rect: Some(screen),
            max_texture_side: Some(max_texture_side),
            time: Some(0.0),
            events,
            ..RawInput::default()
        };
        let context = context.clone();
        let input = FrameInput { context, raw, size };
        program.frame(&mut graphics, input, &mut StillHost::default())?;
    }
    for message in program.session().messages.history() {
        match message.severity {
            Severity::Error => return Err(CliError::Other(message.text.clone())),
            Severity::Info | Severity::Warning => {
                eprint_line(format_args!("warning: {}", message.text));
            }
        }
    }
    let window = graphics.window_picture();
    let nothing = || CliError::Other("no picture of the window could be made".to_owned());
    Ok(read_picture(window.ok_or_else(nothing)?)?)
}

/// Frames in which nothing happens, for what follows from the one before, such as a row that scrolls
/// into view.
fn still() -> Vec<Vec<Event>> {
    vec![Vec::new(); FRAMES]
}

/// Events of the frames of a drag. One that is the last and does not end where it began is not let go
/// of.
fn gesture(Drag { from, to }: Drag, is_last: bool) -> Vec<Vec<Event>> {
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let mut frames = vec![vec![Event::PointerMoved(from)], vec![button(from, true)]];
    if from != to {
        frames.push(vec![Event::PointerMoved(from.lerp(to, 0.5))]);
        frames.push(vec![Event::PointerMoved(to)]);
    }
    if from == to || !is_last {
        frames.push(vec![button(to, false)]);
    }
    frames.extend(still());
    frames
}

/// Host without clock, clipboard and storage, which writes no files.
#[derive(Default)]
struct StillHost {
    finished: Option<JobResult>,
}

impl Host for StillHost {
    fn now(&self) -> Duration {
        Duration::ZERO
    }

    fn files(&self) -> Arc<dyn Files> {
        Arc::new(disk::files())
    }

    fn choose_file(&mut self, _: FileRequest, _: Suggested) {}

    fn write_file(&mut self, _: &Path, _: Vec<u8>, _: Previous) {}

    fn write_files(&mut self, _: &Path, _: Vec<(PathBuf, Vec<u8>)>, _: Previous) {}

    fn watch(&mut self, _: Vec<PathBuf>) {}

    fn copy_text(&mut self, _: String) {}

    fn request_paste(&mut self) {}

    fn load(&self, _: StorageKey) -> Option<Vec<u8>> {
        None
    }

    fn pass_unsaved_work(&mut self) {}

    fn store(&mut self, _: StorageKey, _: Vec<u8>) {}

    fn remove_unsaved_work(&mut self) {}

    fn start_job(&mut self, job: Job) {
        // Comparisons go on as long as the panels move.
        if !job.patience().is_zero() {
            self.finished = Some(job.run());
        }
    }

    fn set_title(&mut self, _: &str) {}

    fn handle_platform_output(&mut self, _: egui::PlatformOutput) {}

    fn quit(&mut self) {}

    fn next_event(&mut self) -> Option<HostEvent> {
        self.finished.take().map(HostEvent::Finished)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_is_four_numbers_and_nothing_else() {
        let found = drag("1, 2,-3,4.5").unwrap();
        assert_eq!((found.from, found.to), (pos2(1.0, 2.0), pos2(-3.0, 4.5)));
        for bad in ["", "1,2,3", "1,2,3,4,5", "1,2,3,4,x", "1,2,3,NaN"] {
            assert!(drag(bad).is_err(), "{bad}");
        }
    }
}
