use crate::gpu::{Framebuffer, Gl};

/// Paints what egui wants to show over a picture.
pub struct InterfacePainter {
    gl: Gl,
    painter: egui_glow::Painter,
}

impl std::fmt::Debug for InterfacePainter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("InterfacePainter")
    }
}

/// Why the interface cannot be painted.
#[derive(Debug, thiserror::Error)]
#[error("the interface's shaders do not work here: {0}")]
pub struct InterfaceError(String);

impl InterfacePainter {
    /// Makes the painter in the context of `gl`.
    ///
    /// # Errors
    /// When the driver refuses its shaders.
    pub fn new(gl: &Gl) -> Result<Self, InterfaceError> {
        gl.make_current()
            .map_err(|error| InterfaceError(error.to_string()))?;
        let painter = egui_glow::Painter::new(gl.glow_context(), "", None, false)
            .map_err(|error| InterfaceError(error.to_string()))?;
        Ok(Self {
            gl: gl.clone(),
            painter,
        })
    }

    /// Longest side of a texture, which egui wants to know.
    pub fn max_texture_side(&self) -> usize {
        self.painter.max_texture_side()
    }

    /// Paints `output` over what is in `target`, which has no samples. Must be called for every
    /// output, in order, since textures change with them.
    pub fn paint(
        &mut self,
        context: &egui::Context,
        mut output: egui::FullOutput,
        target: &Framebuffer,
    ) {
        let pixels_per_point = output.pixels_per_point;
        let primitives = context.tessellate(output.shapes, pixels_per_point);
        target.bind();
        self.painter.paint_and_update_textures(
            [target.width(), target.height()],
            pixels_per_point,
            &primitives,
            &mut output.textures_delta,
        );
    }

    /// Takes in the textures of an output that is not painted.
    pub fn skip(&mut self, mut output: egui::FullOutput) {
        for (id, deltas) in output.textures_delta.set.drain() {
            for delta in deltas {
                self.painter.set_texture(id, &delta);
            }
        }
        for id in output.textures_delta.free.drain() {
            self.painter.free_texture(id);
        }
    }
}

impl Drop for InterfacePainter {
    fn drop(&mut self) {
        // A context that is gone has taken its objects with it.
        if self.gl.make_current().is_ok() {
            self.painter.destroy();
        }
    }
}
