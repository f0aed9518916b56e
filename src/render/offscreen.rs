//! Pictures without a window.

use super::{Frame, LargePicture, PictureParts, RenderError, Renderer, read_picture};
use crate::geometry::Picture;
use crate::gpu::{Backend, ContextError, Framebuffer, Gl, GpuError, HeadlessContext};

/// Draws pictures without a window.
#[derive(Debug)]
pub struct Offscreen {
    renderer: Renderer,
    context: HeadlessContext,
}

/// Why no picture could be drawn.
#[derive(Debug, thiserror::Error)]
pub enum OffscreenError {
    /// There is no OpenGL to draw with.
    #[error(transparent)]
    Context(#[from] ContextError),
    /// OpenGL refused something.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl Offscreen {
    /// A context of `backend` with a renderer in it.
    ///
    /// # Errors
    /// When there is no such backend or it lacks OpenGL 3.3; the message names the remedy.
    pub fn new(backend: Backend) -> Result<Self, OffscreenError> {
        let context = HeadlessContext::new(backend)?;
        let renderer = Renderer::new(context.gl())?;
        Ok(Self { renderer, context })
    }

    /// The context that pictures are drawn with.
    pub fn gl(&self) -> &Gl {
        self.context.gl()
    }

    /// The renderer, for its settings and notices.
    pub fn renderer(&mut self) -> &mut Renderer {
        &mut self.renderer
    }

    /// The backend that was found.
    pub fn backend(&self) -> Backend {
        self.context.backend()
    }

    /// Draws `frame` in a picture of `width` by `height` pixels with `samples` samples a pixel,
    /// 0 for none.
    ///
    /// # Errors
    /// When the size or the number of samples is beyond the driver's limits, or drawing fails.
    pub fn render(
        &mut self,
        frame: &Frame,
        (width, height): (u32, u32),
        samples: u32,
    ) -> Result<Framebuffer, RenderError> {
        let target = Framebuffer::new(self.context.gl(), width, height, samples)?;
        self.renderer.draw(frame, &target)?;
        target.resolve();
        Ok(target)
    }

    /// As [`Offscreen::render`], read into memory.
    ///
    /// # Errors
    /// As [`Offscreen::render`].
    pub fn picture(
        &mut self,
        frame: &Frame,
        size: (u32, u32),
        samples: u32,
    ) -> Result<Picture, RenderError> {
        Ok(read_picture(&self.render(frame, size, samples)?)?)
    }

    /// As [`Offscreen::picture`], but of any size: one beyond the driver's limits, or of so many
    /// samples that they would fill the memory, is drawn in parts. `drawn` hears of each of several
    /// parts: how many there are already, and of how many.
    ///
    /// # Errors
    /// As [`Offscreen::render`], but for the size.
    pub fn large_picture(
        &mut self,
        frame: &Frame,
        asked: &LargePicture,
        mut drawn: impl FnMut(usize, usize),
    ) -> Result<Picture, RenderError> {
        let mut parts = PictureParts::new(asked, self.gl().info());
        let mut drawn = |parts: &PictureParts| {
            if parts.count() > 1 {
                drawn(parts.done(), parts.count());
            }
        };
        while !parts.is_complete() {
            drawn(&parts);
            parts.draw_next(self.context.gl(), &mut self.renderer, frame)?;
        }
        drawn(&parts);
        Ok(parts.into_picture())
    }
}
