//! The painter of the panels: egui's own, tied to the context that it paints in.

use std::mem::ManuallyDrop;

use super::{ContextError, Framebuffer, Gl};
use egui::epaint::{ClippedPrimitive, ClippedShape, Primitive};

/// Paints what egui shows over a picture.
pub struct InterfacePainter {
    /// Holds entry points of the context: dropped before `gl`, whatever the order of the fields.
    painter: ManuallyDrop<egui_glow::Painter>,
    gl: Gl,
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
            .map_err(|error: ContextError| InterfaceError(error.to_string()))?;
        // SAFETY: the painter stays inside of this struct, which holds a `Gl` and drops the painter
        // first; each of its calls below comes after the context was made current, as here.
        let glow = unsafe { gl.shared_glow() };
        let painter = egui_glow::Painter::new(glow, "", None, false)
            .map_err(|error| InterfaceError(error.to_string()))?;
        Ok(Self {
            painter: ManuallyDrop::new(painter),
            gl: gl.clone(),
        })
    }

    /// Longest side of a texture in pixels, which egui asks for.
    pub fn max_texture_side(&self) -> usize {
        self.painter.max_texture_side()
    }

    /// Paints `output` over the content of `target`, which has no samples. Must be called for every
    /// output, in order, since textures change with them.
    ///
    /// Shapes with callbacks are left out: through them other code would get entry points of the
    /// context that could outlive it.
    pub fn paint(
        &mut self,
        context: &egui::Context,
        mut output: egui::FullOutput,
        target: &Framebuffer,
    ) {
        if !target.is_of(&self.gl) {
            let fault = "the interface cannot be painted into a picture of another context";
            self.gl.report(fault.to_owned());
            return self.skip(output);
        }
        if self.gl.current().is_none() {
            output.textures_delta.clear();
            return;
        }
        let primitives = primitives(context, output.shapes, output.pixels_per_point);
        target.bind();
        self.painter.paint_and_update_textures(
            [target.width(), target.height()],
            output.pixels_per_point,
            &primitives,
            &mut output.textures_delta,
        );
    }

    /// Paints shapes within `clip` as [`InterfacePainter::paint`] does, with the textures that there are; the
    /// target is one that this has painted on before.
    pub(crate) fn paint_again(
        &mut self,
        context: &egui::Context,
        (shapes, clip): (Vec<ClippedShape>, egui::Rect),
        pixels_per_point: f32,
        target: &Framebuffer,
    ) {
        if self.gl.current().is_none() {
            return;
        }
        let mut primitives = primitives(context, shapes, pixels_per_point);
        primitives.retain_mut(|shape| {
            shape.clip_rect = shape.clip_rect.intersect(clip);
            shape.clip_rect.is_positive()
        });
        target.bind();
        let size = [target.width(), target.height()];
        (self.painter).paint_primitives(size, pixels_per_point, &primitives);
    }

    /// Applies the textures of an output that is not painted.
    pub fn skip(&mut self, mut output: egui::FullOutput) {
        if self.gl.current().is_none() {
            output.textures_delta.clear();
            return;
        }
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

/// The triangles of shapes, without callbacks.
fn primitives(
    context: &egui::Context,
    shapes: Vec<ClippedShape>,
    pixels_per_point: f32,
) -> Vec<ClippedPrimitive> {
    let mut primitives = context.tessellate(shapes, pixels_per_point);
    primitives.retain(|shape| matches!(shape.primitive, Primitive::Mesh(_)));
    primitives
}

impl Drop for InterfacePainter {
    fn drop(&mut self) {
        // A context that cannot be made current any more takes its objects with it.
        if self.gl.current().is_some() {
            self.painter.destroy();
        }
        // SAFETY: dropped here and nowhere else, and not used afterwards. `gl` keeps the context
        // alive until after this body.
        unsafe { ManuallyDrop::drop(&mut self.painter) }
    }
}
