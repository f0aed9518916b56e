use super::{Comparison, Textured};
use crate::app::globals;
use crate::app::workspace::Workspace;
use crate::editor::Severity;
use crate::geometry::Picture;
use crate::gpu::Framebuffer;
use crate::render::{Frame, Marks, RenderError, read_picture};

impl Workspace {
    /// Draws the scene in the reference's size if it changed, and has the two measured. Whether
    /// the panels have something new to show. A comparison that cannot be drawn ends, and the
    /// scene stays.
    pub(in crate::app) fn draw_comparison(&mut self) -> bool {
        let Some(mut comparison) = self.comparison.take() else {
            return false;
        };
        match self.draw_compared(&mut comparison) {
            Ok(changed) => {
                self.comparison = Some(comparison);
                changed
            }
            Err(error) => {
                let text = format!("The comparison ended, since it cannot be drawn: {error}");
                self.session.messages.tell(Severity::Error, text);
                true
            }
        }
    }

    fn draw_compared(&mut self, comparison: &mut Comparison) -> Result<bool, RenderError> {
        let smooth = comparison.settings.smooth_edges;
        let now = Some((self.session.revision(), smooth));
        if comparison.drawn == now {
            return Ok(false);
        }
        let gl = self.window.gl();
        let most = gl.info().max_samples;
        let samples = if smooth {
            globals::SAMPLES.min(most)
        } else {
            0
        };
        if comparison.target.samples() != samples {
            let (width, height) = (comparison.target.width(), comparison.target.height());
            comparison.target = Framebuffer::new(gl, width, height, samples)?;
        }
        let frame = Frame {
            scene: self.session.scene(),
            evaluated: self.session.evaluated(),
            view: self.session.view(),
            // They would count as differences.
            marks: Marks::default(),
        };
        self.renderer.draw(&frame, &comparison.target)?;
        let picture = read_picture(&comparison.target)?;
        comparison.drawn = now;
        Ok(comparison.take_live(self.egui.egui_ctx(), picture))
    }
}

impl Comparison {
    /// Whether it is another picture than the one before.
    fn take_live(&mut self, context: &egui::Context, picture: Picture) -> bool {
        if self
            .live
            .as_ref()
            .is_some_and(|live| *live.picture == picture)
        {
            return false;
        }
        self.live = Some(Textured::new(context, "live view", picture));
        self.measure();
        true
    }
}
