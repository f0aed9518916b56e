use super::CliError;
use super::render::frame;
use crate::editor::{Session, Tool, apply_edit, apply_view};
use crate::geometry::Picture;
use crate::gpu::{Framebuffer, Gl};
use crate::render::{InterfacePainter, Marks, Offscreen, compose, read_picture, view_place};
use crate::ui::{self, Action, COMMANDS, Command, Entry, UiState, ViewInput};
use egui::{Event, FullOutput, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};

/// Panels take a few frames to find their sizes.
const FRAMES: usize = 4;

/// Refuses a picture smaller than the window can be.
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

/// What a hand does in the window whose picture is drawn.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PanelOptions {
    /// The tool that is chosen.
    #[arg(long, requires = "ui", default_value = "select")]
    tool: ToolName,
    /// Press the left mouse button at a pixel of the picture and drag to another, without letting
    /// go; Z,W the same as X,Y is to point and click.
    #[arg(long, requires = "ui", value_name = "X,Y,Z,W", allow_hyphen_values = true, value_parser = drag)]
    drag: Option<Drag>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum ToolName {
    Select,
    Pose,
    Move,
    Ik,
}

impl ToolName {
    /// The press of the key that chooses it.
    fn key(self) -> Event {
        let tool = match self {
            Self::Select => Tool::Select,
            Self::Pose => Tool::Pose,
            Self::Move => Tool::Move,
            Self::Ik => Tool::Ik,
        };
        let is_it = |entry: &&Entry| entry.command == Command::SetTool(tool);
        let keys = COMMANDS.iter().find(is_it).map(|entry| entry.shortcuts);
        let key = keys.and_then(|keys| keys.first());
        Event::Key {
            key: key.map_or(egui::Key::V, |key| key.logical_key),
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        }
    }
}

/// From where to where, in pixels from the picture's upper left corner.
#[derive(Clone, Copy, Debug)]
struct Drag {
    from: Pos2,
    to: Pos2,
}

fn drag(text: &str) -> Result<Drag, String> {
    let numbers: Vec<f32> = text
        .split(',')
        .map_while(|n| n.trim().parse().ok())
        .collect();
    match numbers[..] {
        [x, y, z, w] if numbers.iter().all(|n| n.is_finite()) => Ok(Drag {
            from: pos2(x, y),
            to: pos2(z, w),
        }),
        _ => Err(format!("expected four numbers X,Y,Z,W, found {text}")),
    }
}

/// The window as it would look, drawn through the same panels.
pub(super) fn picture(
    options: &PanelOptions,
    session: Session,
    offscreen: &mut Offscreen,
    (width, height): (u32, u32),
    samples: u32,
) -> Result<Picture, CliError> {
    let gl: Gl = offscreen.gl().clone();
    let mut painter = InterfacePainter::new(&gl)?;
    let mut window = Window {
        context: egui::Context::default(),
        state: UiState::new(),
        session,
        size: vec2(width as f32, height as f32),
        texture_side: painter.max_texture_side(),
        view_rect: Rect::NOTHING,
        marks: Marks::default(),
    };
    window.state.theme = egui::ThemePreference::Dark;
    let tool = vec![options.tool.key()];
    for events in std::iter::once(tool).chain(gesture(options.drag)) {
        painter.skip(window.frame(events));
    }
    let output = window.frame(Vec::new());
    let (min, max) = (window.view_rect.min, window.view_rect.max);
    let place = view_place((min.x, min.y), (max.x, max.y), 1.0, (width, height));
    let size = (place.width.unsigned_abs(), place.height.unsigned_abs());
    let scene = offscreen.render(&frame(&window.session, window.marks), size, samples)?;
    let target = Framebuffer::new(&gl, width, height, 0)?;
    compose(
        &scene,
        place,
        &mut painter,
        &window.context,
        output,
        &target,
    )?;
    Ok(read_picture(&target)?)
}

/// What happens frame by frame, before the one that is drawn.
fn gesture(drag: Option<Drag>) -> Vec<Vec<Event>> {
    let mut frames = vec![Vec::new(); FRAMES];
    if let Some(Drag { from, to }) = drag {
        let button = |pos, pressed| Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        frames.push(vec![Event::PointerMoved(from)]);
        frames.push(vec![button(from, true)]);
        if from == to {
            frames.push(vec![button(to, false)]);
        } else {
            frames.push(vec![Event::PointerMoved(from.lerp(to, 0.5))]);
            frames.push(vec![Event::PointerMoved(to)]);
        }
        // What follows from it, such as a row that scrolls into sight.
        frames.extend(vec![Vec::new(); FRAMES]);
    }
    frames
}

/// The window without a window.
struct Window {
    context: egui::Context,
    state: UiState,
    session: Session,
    size: egui::Vec2,
    texture_side: usize,
    view_rect: Rect,
    marks: Marks,
}

impl Window {
    fn frame(&mut self, events: Vec<Event>) -> FullOutput {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            max_texture_side: Some(self.texture_side),
            time: Some(0.0),
            events,
            ..Default::default()
        };
        let mut actions = Vec::new();
        let mut hovered = None;
        let output = self.context.run_ui(input, |root| {
            let (session, state) = (&self.session, &mut self.state);
            let shown = ui::show(root, session, state, &ViewInput::default());
            self.view_rect = shown.view_rect;
            actions.extend(shown.actions);
            hovered = ui::view_gestures(&shown.view, &shown.places, session, state, &mut actions);
        });
        for action in actions {
            match action {
                Action::Edit(edit) => apply_edit(&mut self.session, edit),
                Action::View(view) => apply_view(&mut self.session, view),
                // What only a program with a window can do.
                Action::Ask(_) => {}
            }
        }
        self.marks = Marks {
            selected: self.session.selected(),
            hovered,
            selected_joint: self.session.selected_joint(),
            hovered_joint: self.session.hovered_joint(),
            hovered_control_point: self.session.hovered_control_point(),
        };
        output
    }
}
