//! Scene and panels together, as a window shows them.

use super::graphics::{fit, fits};
use crate::gpu::{Framebuffer, Gl, GpuError, Rect};
use crate::render::{Composer, InterfaceError, InterfacePainter, Placed};
use egui::FullOutput;

/// The picture of a window, and the painter of its panels.
#[derive(Debug)]
pub(super) struct WindowPicture {
    picture: Option<Framebuffer>,
    painter: InterfacePainter,
    composer: Composer,
    /// Whether the picture of the scene was drawn since it was composed.
    has_new_scene: bool,
    /// Whether anything was painted since [`WindowPicture::take_is_new`] was called.
    is_new: bool,
}

impl WindowPicture {
    /// None yet, and its painter.
    ///
    /// # Errors
    /// When the driver refuses the painter's shaders.
    pub fn new(gl: &Gl) -> Result<Self, InterfaceError> {
        Ok(Self {
            picture: None,
            painter: InterfacePainter::new(gl)?,
            composer: Composer::default(),
            has_new_scene: true,
            is_new: false,
        })
    }

    /// The picture as it was composed last.
    pub fn picture(&self) -> Option<&Framebuffer> {
        self.picture.as_ref()
    }

    /// Makes the picture fit the window's `size` in pixels.
    ///
    /// # Errors
    /// If it cannot be made; then it stays as it is.
    pub fn fit(&mut self, gl: &Gl, size: (u32, u32)) -> Result<(), GpuError> {
        if !fits(self.picture.as_ref(), size, 0) {
            self.composer.forget();
        }
        fit(gl, &mut self.picture, size, 0).map(drop)
    }

    /// Takes note that the picture of the scene is drawn anew.
    pub fn scene_changes(&mut self) {
        self.has_new_scene = true;
    }

    /// Puts the picture of the scene at `place` and paints the panels over it, as far as they changed: egui
    /// asks for two frames after each that had input, which mostly are as that one.
    ///
    /// # Errors
    /// See [`Composer::compose`].
    pub fn compose(
        &mut self,
        scene: &Framebuffer,
        place: Rect,
        context: &egui::Context,
        output: FullOutput,
    ) -> Result<(), GpuError> {
        let Some(target) = &self.picture else {
            self.skip(output);
            return Ok(());
        };
        let placed = Placed {
            scene,
            is_new: std::mem::take(&mut self.has_new_scene),
            place,
        };
        let painter = &mut self.painter;
        let composed = (self.composer).compose(placed, painter, context, output, target);
        self.is_new |= *composed.as_ref().unwrap_or(&true);
        composed.map(drop)
    }

    /// Takes in the textures of an output that is not painted.
    pub fn skip(&mut self, output: FullOutput) {
        self.painter.skip(output);
    }

    /// Whether the picture was composed anew since the last call.
    pub fn take_is_new(&mut self) -> bool {
        std::mem::take(&mut self.is_new)
    }
}
