use super::Host;
use super::click_duration::allow_for_slow_frames;
use super::comparison::{Comparison, DRAWING, Drawn};
use super::graphics::Graphics;
use super::input_parts::input_parts;
use super::running::{Program, Shown};
use super::scene_picture::Asked;
use crate::editor::{Session, Severity};
use crate::gpu::GpuError;
use crate::render::{Backdrop, Frame, InterfaceError, Marks, RenderError, view_place};
use egui::{Context, FullOutput, RawInput};
use std::time::Duration;

/// Input of a frame, from a host that leaves running egui to the program.
#[derive(Clone, Debug)]
pub struct FrameInput {
    /// Context of egui.
    pub context: Context,
    /// Input since the last frame.
    pub raw: RawInput,
    /// Width and height of the window in pixels, neither of them 0.
    pub size: (u32, u32),
}

/// Purpose for which the panels are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// To take the user's input.
    Input,
    /// To show its effect. Whatever panels and gestures paint over the scene would otherwise be a
    /// frame behind the scene.
    Display,
}

/// Why the program cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum ProgramError {
    /// OpenGL failed.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The panels cannot be painted.
    #[error(transparent)]
    Interface(#[from] InterfaceError),
}

impl From<GpuError> for ProgramError {
    fn from(error: GpuError) -> Self {
        Self::Render(error.into())
    }
}

/// Result of running egui once or more.
struct PanelRun {
    shown: Shown,
    output: FullOutput,
}

impl PanelRun {
    fn join(before: Option<Self>, next: Option<Self>) -> Option<Self> {
        let (mut before, next) = match (before, next) {
            (Some(before), Some(next)) => (before, next),
            (before, next) => return before.or(next),
        };
        before.output.append(next.output);
        Some(Self {
            shown: Shown {
                changed: before.shown.changed || next.shown.changed,
                ..next.shown
            },
            output: before.output,
        })
    }
}

impl Program {
    /// Runs the panels, does what they ask, draws the scene if it changed, and composes it all in
    /// [`Graphics::window_picture`]. Returns how long no frame is needed unless an event comes.
    ///
    /// # Errors
    /// If nothing can be drawn any more, or nothing ever could.
    pub fn frame(
        &mut self,
        graphics: &mut Graphics,
        input: FrameInput,
        host: &mut dyn Host,
    ) -> Result<Duration, ProgramError> {
        let FrameInput { context, raw, size } = input;
        allow_for_slow_frames(&context, raw.time);
        let came_in = self.begin_frame(host);
        let without_events = RawInput {
            events: Vec::new(),
            dropped_files: Vec::new(),
            ..raw.clone()
        };
        let mut run: Option<PanelRun> = None;
        for part in input_parts(raw, context.text_edit_focused()) {
            run = PanelRun::join(run, self.run_panels(&context, part, Pass::Input, host));
            if self.ui.is_beginning() {
                let begun = self.run_panels(&context, without_events.clone(), Pass::Input, host);
                run = PanelRun::join(run, begun);
            }
        }
        if run.as_ref().is_some_and(|run| run.shown.changed) {
            let shown = self.run_panels(&context, without_events, Pass::Display, host);
            run = PanelRun::join(run, shown);
        }
        let Some(PanelRun { shown, output }) = run else {
            return Ok(Duration::MAX);
        };
        let delay = output
            .viewport_output
            .get(&egui::ViewportId::ROOT)
            .map_or(Duration::MAX, |viewport| viewport.repaint_delay);
        let (min, max) = (shown.panels.view_rect.min, shown.panels.view_rect.max);
        let pixels_per_point = output.pixels_per_point;
        let place = view_place((min.x, min.y), (max.x, max.y), pixels_per_point, size);

        let view_size = (place.width.unsigned_abs(), place.height.unsigned_abs());
        let messages = self.session.messages.count();
        let wait = self.draw(graphics, view_size, Some(size), host)?;
        graphics.compose(place, &context, output)?;
        let wait = wait.min(self.finish_frame(graphics, host));
        // The panels have shown neither what was carried out last nor messages about drawing.
        let told = self.session.messages.count() != messages;
        Ok(if came_in || shown.changed || told {
            Duration::ZERO
        } else {
            delay.min(wait)
        })
    }

    /// Begins a frame: counts it and takes in the events of the host, of which it returns whether
    /// there were any. A host that calls [`Program::show`] itself calls this before.
    pub fn begin_frame(&mut self, host: &mut dyn Host) -> bool {
        self.frame_rate.count(host.now());
        // A dialog that closes in this frame is still in what the frame shows.
        if !host.is_dialog_open() {
            self.due_pictures.append(&mut self.pending_pictures);
        }
        self.take_events(host)
    }

    /// Ends a frame: draws a part of the pictures that were asked for, and stores preferences that
    /// changed and unsaved work.
    /// Returns how long no frame is needed for their sake. A host that calls [`Program::show`] and
    /// [`Program::draw`] itself calls this after.
    pub fn finish_frame(&mut self, graphics: &mut Graphics, host: &mut dyn Host) -> Duration {
        let more_pictures = self.save_pictures(graphics, host);
        let answered = self.take_events(host);
        let has_start_picture = self.draw_start_picture(graphics, host);
        self.keep_preferences(host);
        self.show_title(host);
        let wait = self.autosave(host).min(self.reading_wait(host.now()));
        self.watch_files(host);
        let pictures_due = !self.pending_pictures.is_empty() && !host.is_dialog_open();
        if answered || pictures_due || more_pictures || has_start_picture {
            Duration::ZERO
        } else {
            wait
        }
    }

    /// Draws the scene in a picture of `view` pixels, if something changed, or the comparison that
    /// is under way; and makes the picture of the window fit `window`, if the program composes it.
    /// Failures become messages. Returns how long no frame is needed for the drawing's sake.
    ///
    /// # Errors
    /// If nothing can be drawn any more, or nothing ever could.
    pub fn draw(
        &mut self,
        graphics: &mut Graphics,
        view: (u32, u32),
        window: Option<(u32, u32)>,
        host: &mut dyn Host,
    ) -> Result<Duration, ProgramError> {
        let composed = match window.map(|size| graphics.fit_window(size)) {
            // Without any picture not even the panels could say what is wrong.
            Some(Err(error)) if graphics.window_picture().is_none() => return Err(error),
            Some(composed) => composed,
            None => Ok(()),
        };
        let fitted = graphics.fit_view(view);
        let drawn = self.draw_scene(graphics, host);
        let fitted = composed.and(fitted.map_err(ProgramError::from));
        let wrong_size = fitted.as_ref().is_err_and(is_about_size);
        let was_wrong = graphics.replace_wrong_size(wrong_size);
        self.tell_fault(fitted, was_wrong)?;
        self.tell_fault(drawn.map_err(ProgramError::from), false)?;
        let compared = self.draw_comparison(graphics, host);
        for notice in graphics.take_notices() {
            self.tell(Severity::Warning, notice);
        }
        let wait = self.comparison.as_mut().and_then(|c| c.advance(host));
        let meshes = self.mesh_comparison.as_mut();
        let wait = wait.or(meshes.and_then(|c| c.advance(&self.session, host)));
        let wait = wait.unwrap_or(Duration::MAX).min(compared);
        Ok(wait.min(graphics.full_picture_after(host.now())))
    }

    /// Runs egui once, and with it the panels.
    fn run_panels(
        &mut self,
        context: &Context,
        input: RawInput,
        pass: Pass,
        host: &mut dyn Host,
    ) -> Option<PanelRun> {
        let mut run: Option<Shown> = None;
        let mut output = context.run_ui(input, |ui| {
            // egui may run a frame twice to find its sizes: the last run says where things are,
            // but only the first got keys and clicks.
            let shown = self.show(ui, pass, host);
            let changed = run.as_ref().is_some_and(|run| run.changed) || shown.changed;
            run = Some(Shown { changed, ..shown });
        });
        host.handle_platform_output(std::mem::take(&mut output.platform_output));
        Some(PanelRun {
            shown: run?,
            output,
        })
    }

    /// Draws the scene with what is marked in it, if it is shown.
    fn draw_scene(&mut self, graphics: &mut Graphics, host: &dyn Host) -> Result<(), RenderError> {
        let now = host.now();
        graphics.set_skinning(self.ui.skinning);
        if self.comparison.is_some() {
            // Its pictures lie over the whole view, which may change its size meanwhile.
            graphics.forget_scene();
            return Ok(());
        }
        let marks = Marks {
            selected: self.session.selected(),
            also_selected: self
                .session
                .selected_shapes()
                .map(|shape| shape.id)
                .filter(|&id| Some(id) != self.session.selected())
                .collect(),
            hovered: self.hovered_shape,
            selected_joint: self.session.selected_joint(),
            hovered_joint: self.session.hovered_joint(),
            hovered_control_point: self.session.hovered_control_point(),
            ..self.marks_of_meshes(now)
        };
        let shown = self.ui.shown_scene(&self.session);
        let mut frame = frame(&self.session, self.backdrop, marks);
        let mut right = None;
        if let Some(shown) = &shown {
            frame.evaluated = &shown.evaluated;
            right = shown.right.as_ref();
        }
        graphics.draw_scene(&Asked {
            frame: &frame,
            right: right.map(|(evaluated, line)| (evaluated, *line)),
            document: self.session.document(),
            moves: self.session.is_in_gesture() || self.ui.is_moving_camera(),
            now,
            last_frame: host.last_frame(),
        })
    }

    /// Draws the scene in the size of the picture that it is compared with, if it changed. Returns how
    /// long no frame is needed for its sake: none if the panels have something new to show. A comparison
    /// that cannot be drawn ends, and the scene stays.
    fn draw_comparison(&mut self, graphics: &mut Graphics, host: &mut dyn Host) -> Duration {
        let Some(comparison) = &mut self.comparison else {
            graphics.end_comparison();
            return Duration::MAX;
        };
        let wanted = Drawn {
            document: self.session.document(),
            view: *self.session.view(),
            smooth_edges: comparison.settings().smooth_edges,
            skinning: self.ui.skinning,
        };
        // Marks would count as differences, and so would a backdrop that goes with the panels.
        let frame = frame(&self.session, comparison.backdrop(), Marks::default());
        match compare_view(comparison, wanted, &frame, graphics, host.now()) {
            Ok(wait) => wait,
            Err(error) => {
                self.end_comparison();
                let text = format!("The comparison ended, since it cannot be drawn: {error}");
                self.tell(Severity::Error, text);
                Duration::ZERO
            }
        }
    }

    /// Reports a failure of drawing, once, so that work can go on. While the size of the window
    /// changes, so does the text of what is the same failure, `again`.
    ///
    /// # Errors
    /// If nothing can be drawn any more, or nothing ever could.
    fn tell_fault(
        &mut self,
        drawn: Result<(), ProgramError>,
        again: bool,
    ) -> Result<(), ProgramError> {
        let error = match drawn {
            Ok(()) => return Ok(()),
            Err(ProgramError::Render(RenderError::Gpu(error @ GpuError::Lost { .. }))) => {
                return Err(error.into());
            }
            Err(error @ ProgramError::Render(_)) => error,
            Err(error @ ProgramError::Interface(_)) => return Err(error),
        };
        let is_same = is_about_size(&error) && again;
        let text = format!("The picture is not as it should be: {error}");
        let mut before = self.session.messages.history().iter();
        if !is_same && !before.any(|message| message.text == text) {
            self.tell(Severity::Error, text);
        }
        Ok(())
    }
}

/// Has `comparison` show `frame`, in the state `wanted`, if it does not yet. A state that changes while
/// the one before is drawn is drawn after that. Returns how long no frame is needed for its sake.
fn compare_view(
    comparison: &mut Comparison,
    wanted: Drawn,
    frame: &Frame,
    graphics: &mut Graphics,
    now: Duration,
) -> Result<Duration, RenderError> {
    if !comparison.is_drawing() {
        if !comparison.needs(&wanted) {
            return Ok(Duration::MAX);
        }
        graphics.draw_compared(frame, comparison.size(), wanted.smooth_edges)?;
        comparison.begin_drawing(wanted);
    }
    let Some(picture) = graphics.compared_picture()? else {
        return Ok(DRAWING);
    };
    let is_new = comparison.take_live(picture, now);
    Ok(if is_new || comparison.needs(&wanted) {
        Duration::ZERO
    } else {
        Duration::MAX
    })
}

/// Whether a picture could not have the size that it needs.
fn is_about_size(error: &ProgramError) -> bool {
    matches!(
        error,
        ProgramError::Render(RenderError::Gpu(GpuError::Size { .. }))
    )
}

fn frame(session: &Session, backdrop: Backdrop, marks: Marks) -> Frame<'_> {
    Frame {
        scene: session.scene(),
        evaluated: session.evaluated(),
        view: session.view(),
        backdrop,
        marks,
    }
}
