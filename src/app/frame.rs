use super::application::AppError;
use super::compare::Comparison;
use super::globals;
use super::input_parts::parts;
use super::workspace::Workspace;
use crate::editor::Severity;
use crate::gpu::{Framebuffer, Gl, GpuError, Rect};
use crate::render::{Frame, Marks, RenderError, compose, read_picture, view_place};
use crate::revision::Revision;
use crate::ui;
use egui::{FullOutput, RawInput};
use std::time::{Duration, Instant};
use winit::dpi::PhysicalSize;

/// The pictures that a frame goes through, kept for as long as their sizes fit.
#[derive(Debug, Default)]
pub(super) struct FramePictures {
    scene: Option<Framebuffer>,
    window: Option<Framebuffer>,
    /// What the scene's picture shows: drawn again only when this changes.
    shown: Option<(Revision, Marks)>,
    /// Whether the last frame could not have pictures of the size it needed.
    has_wrong_size: bool,
}

impl FramePictures {
    /// Size of the view in pixels, once it was drawn.
    pub fn view_size(&self) -> Option<(u32, u32)> {
        self.scene
            .as_ref()
            .map(|scene| (scene.width(), scene.height()))
    }
}

/// What came of running the panels.
struct PanelRun {
    shown: ui::UiOutput,
    output: FullOutput,
    changed: bool,
}

impl PanelRun {
    fn join(before: Option<Self>, next: Option<Self>) -> Option<Self> {
        let (mut before, next) = match (before, next) {
            (Some(before), Some(next)) => (before, next),
            (before, next) => return before.or(next),
        };
        before.output.append(next.output);
        Some(Self {
            shown: next.shown,
            output: before.output,
            changed: before.changed || next.changed,
        })
    }
}

/// What the panels are run for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// To take what the user did.
    Input,
    /// To show what came of it. What panels and gestures paint over the scene would otherwise be
    /// a frame behind the scene.
    Display,
}

impl Workspace {
    /// Runs the panels, does what they ask, draws the scene if it changed, and shows it all.
    pub(super) fn draw_frame(&mut self, size: PhysicalSize<u32>) -> Result<Duration, AppError> {
        self.frame_rate.count(Instant::now());
        let input = self.egui.take_egui_input(self.window.window());
        if let Some(comparison) = &mut self.comparison {
            comparison.take_results(self.egui.egui_ctx());
        }
        // A dialog that closes in this frame is still in what the frame shows.
        let screenshot_due = self.pending_screenshot.is_some() && !self.dialogs.is_open();
        let without_events = RawInput {
            events: Vec::new(),
            dropped_files: Vec::new(),
            ..input.clone()
        };
        let mut run: Option<PanelRun> = None;
        for part in parts(input) {
            run = PanelRun::join(run, self.run_panels(part, Pass::Input));
        }
        if run.as_ref().is_some_and(|run| run.changed) {
            let shown = self.run_panels(without_events, Pass::Display);
            run = PanelRun::join(run, shown);
        }
        let Some(PanelRun {
            shown,
            output,
            changed,
        }) = run
        else {
            return Ok(Duration::MAX);
        };

        let delay = output
            .viewport_output
            .get(&egui::ViewportId::ROOT)
            .map_or(Duration::MAX, |viewport| viewport.repaint_delay);
        let place = Self::place(&shown, output.pixels_per_point, size);
        let fitted = self.fit_pictures(place, size);
        let drawn = self.draw_scene(matches!(fitted, Ok(true)));
        let has_wrong_size = matches!(fitted, Err(GpuError::Size { .. }));
        let mut told = self.tell_fault(fitted.map(drop).map_err(RenderError::from))?;
        self.pictures.has_wrong_size = has_wrong_size;
        told |= self.tell_fault(drawn)?;
        let compared = self.draw_comparison();
        self.show_frame(place, output, size, screenshot_due)?;
        // What is under the pointer now is known to the next frame.
        Ok(if changed || compared || told {
            Duration::ZERO
        } else {
            delay
        })
    }

    /// Runs the panels once and does what they ask.
    fn run_panels(&mut self, input: RawInput, pass: Pass) -> Option<PanelRun> {
        let context = self.egui.egui_ctx().clone();
        let (session, state, dialogs) = (&self.session, &mut self.ui, &mut self.dialogs);
        let compare = self.comparison.as_ref().map(Comparison::view);
        let view_input = ui::ViewInput {
            title: &self.title,
            builtin_characters: &self.builtin_characters,
            builtin_curves: &self.builtin_curves,
            hovered_shape: self.hovered_shape,
            frames_per_second: self.frame_rate.shown(),
            backend: &self.backend,
            gesture_under_way: state.gesture_under_way(),
            keys_are_taken: dialogs.is_open() || pass == Pass::Display,
            compare: compare.as_ref(),
        };
        let mut shown = None;
        let mut asked = Vec::new();
        let mut chosen = None;
        let mut output = context.run_ui(input, |ui| {
            // egui may run a frame twice to find its sizes: the last run says where things are,
            // but only the first got keys and clicks.
            let mut run = ui::show(ui, session, state, &view_input);
            asked.append(&mut run.actions);
            shown = Some(run);
            chosen = dialogs.show(ui.ctx()).or_else(|| chosen.take());
        });
        let platform = std::mem::take(&mut output.platform_output);
        self.egui
            .handle_platform_output(self.window.window(), platform);
        let shown = shown?;
        if pass == Pass::Input {
            self.hovered_shape =
                ui::view_gestures(&shown.view, &shown.places, session, state, &mut asked);
        }
        let changed = !asked.is_empty() || chosen.is_some();
        self.carry_out(asked);
        if let Some((purpose, path)) = chosen {
            self.use_chosen(purpose, path);
        }
        Some(PanelRun {
            shown,
            output,
            changed,
        })
    }

    fn place(shown: &ui::UiOutput, pixels_per_point: f32, size: PhysicalSize<u32>) -> Rect {
        let (min, max) = (shown.view_rect.min, shown.view_rect.max);
        let size = (size.width, size.height);
        view_place((min.x, min.y), (max.x, max.y), pixels_per_point, size)
    }

    /// Makes the pictures fit the view and the window; whether that of the view is a new one. Where
    /// they cannot be made, those before stay and are stretched.
    fn fit_pictures(&mut self, place: Rect, size: PhysicalSize<u32>) -> Result<bool, GpuError> {
        let gl = self.window.gl();
        let samples = globals::SAMPLES.min(gl.info().max_samples);
        let pictures = &mut self.pictures;
        let window = fit(gl, &mut pictures.window, (size.width, size.height), 0);
        let view = (place.width.unsigned_abs(), place.height.unsigned_abs());
        let scene = fit(gl, &mut pictures.scene, view, samples);
        if pictures.scene.is_none() {
            // The panels can be shown without the view.
            fit(gl, &mut pictures.scene, (1, 1), 0)?;
        }
        let fresh = scene?;
        window.map(|_| fresh)
    }

    /// Draws the scene, if something changed or its picture is `fresh`.
    fn draw_scene(&mut self, fresh: bool) -> Result<(), RenderError> {
        let marks = Marks {
            selected: self.session.selected(),
            hovered: self.hovered_shape,
            selected_joint: self.session.selected_joint(),
            hovered_joint: self.session.hovered_joint(),
            hovered_control_point: self.session.hovered_control_point(),
        };
        let now = Some((self.session.revision(), marks));
        let fresh = self.renderer.set_skinning(self.ui.skinning) || fresh;
        if !fresh && self.pictures.shown == now {
            return Ok(());
        }
        if self.comparison.is_some() {
            // Its pictures lie over the whole view.
            self.pictures.shown = None;
            return Ok(());
        }
        let Some(target) = &self.pictures.scene else {
            return Ok(());
        };
        let frame = Frame {
            scene: self.session.scene(),
            evaluated: self.session.evaluated(),
            view: self.session.view(),
            marks,
        };
        let drawn = self.renderer.draw(&frame, target);
        // What failed is not tried again before something changes.
        self.pictures.shown = now;
        for notice in self.renderer.take_notices() {
            self.session.messages.tell(Severity::Warning, notice);
        }
        drawn
    }

    /// Tells what went wrong with drawing, once, so that work can go on; whether there is something
    /// new to tell.
    ///
    /// # Errors
    /// If nothing can be drawn any more, or nothing ever could.
    fn tell_fault(&mut self, drawn: Result<(), RenderError>) -> Result<bool, AppError> {
        let Err(error) = drawn else {
            return Ok(false);
        };
        if matches!(error, RenderError::Gpu(GpuError::Lost { .. }))
            || self.pictures.window.is_none()
        {
            return Err(error.into());
        }
        // While the size of the window changes, so does the text of what is the same failure.
        let is_same = matches!(error, RenderError::Gpu(GpuError::Size { .. }))
            && self.pictures.has_wrong_size;
        let text = format!("The picture is not as it should be: {error}");
        let mut told = self.session.messages.history().iter();
        if is_same || told.any(|message| message.text == text) {
            return Ok(false);
        }
        self.session.messages.tell(Severity::Error, text);
        Ok(true)
    }

    fn show_frame(
        &mut self,
        place: Rect,
        output: egui::FullOutput,
        size: PhysicalSize<u32>,
        screenshot_due: bool,
    ) -> Result<(), AppError> {
        let pictures = &self.pictures;
        let (Some(scene), Some(target)) = (&pictures.scene, &pictures.window) else {
            self.painter.skip(output);
            return Ok(());
        };
        let context = self.egui.egui_ctx();
        compose(scene, place, &mut self.painter, context, output, target)?;
        let whole = Rect {
            x: 0,
            y: 0,
            width: size.width as i32,
            height: size.height as i32,
        };
        target.blit_to_window(whole);
        self.window.window().pre_present_notify();
        self.window.swap_buffers()?;
        if let Some(path) = self.pending_screenshot.take_if(|_| screenshot_due) {
            match read_picture(target) {
                Ok(picture) => self.save_picture(&path, &picture),
                Err(error) => self.tell_undrawn(&error.into()),
            }
        }
        Ok(())
    }
}

/// Makes `picture` anew if it has another size; whether it did.
fn fit(
    gl: &Gl,
    picture: &mut Option<Framebuffer>,
    (width, height): (u32, u32),
    samples: u32,
) -> Result<bool, GpuError> {
    let fits = |p: &Framebuffer| (p.width(), p.height(), p.samples()) == (width, height, samples);
    if picture.as_ref().is_some_and(fits) {
        return Ok(false);
    }
    *picture = Some(Framebuffer::new(gl, width, height, samples)?);
    Ok(true)
}
