//! Reading a picture back without waiting until it is drawn.

#[cfg(target_arch = "wasm32")]
use glow::HasContext as _;

use super::{Fence, Framebuffer, Gl, GpuError};

/// A picture as it was at some moment, on its way back from the graphics card.
///
/// On a page the card writes it into a buffer of its own, from which it is copied once it is there: a
/// browser that reads a picture waits for everything that was drawn before, panels included. Elsewhere
/// it is read from where it was drawn, which [`Reading::finish`] has to wait for anyway.
#[derive(Debug)]
pub struct Reading {
    #[cfg(target_arch = "wasm32")]
    gl: Gl,
    /// Behind all that the picture needs.
    fence: Fence,
    #[cfg(target_arch = "wasm32")]
    buffer: glow::Buffer,
}

impl Reading {
    /// Begins to read `picture`, which is to stay as it is until the end.
    ///
    /// # Errors
    /// When the context is lost or the driver refuses.
    pub fn begin(picture: &Framebuffer, gl: &Gl) -> Result<Self, GpuError> {
        picture.resolve();
        #[cfg(target_arch = "wasm32")]
        let buffer = picture.copy_into_buffer()?;
        Ok(Self {
            #[cfg(target_arch = "wasm32")]
            gl: gl.clone(),
            fence: Fence::new(gl)?,
            #[cfg(target_arch = "wasm32")]
            buffer,
        })
    }

    /// Whether the picture is drawn, so that nothing has to wait for it. Off a page it waits until that is
    /// so. In a context that fails there is nothing to wait for.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        self.fence.is_reached()
    }

    /// The picture: red, green, blue, alpha, 8 bits each, the top row first. It has to be drawn, or this
    /// waits. `picture` is the one that it was begun with.
    ///
    /// # Errors
    /// As [`Framebuffer::read_rgba`].
    pub fn finish(self, picture: &Framebuffer) -> Result<Vec<u8>, GpuError> {
        #[cfg(target_arch = "wasm32")]
        return picture.read_buffer(self.buffer);
        #[cfg(not(target_arch = "wasm32"))]
        picture.read_rgba()
    }
}

#[cfg(target_arch = "wasm32")]
impl Drop for Reading {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context, which it is of; nothing uses it any more.
            unsafe { glow.delete_buffer(self.buffer) }
        }
    }
}
