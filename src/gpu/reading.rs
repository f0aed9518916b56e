//! Reading a picture back without waiting until it is drawn.

use glow::HasContext as _;

use super::{Framebuffer, Gl, GpuError};

/// Nanoseconds to wait for a picture at a time. A page may not wait at all: the browser needs the thread.
const PATIENCE: i32 = if cfg!(target_arch = "wasm32") {
    0
} else {
    i32::MAX
};

/// A picture as it was at some moment, on its way back from the graphics card.
///
/// On a page the card writes it into a buffer of its own, from which it is copied once it is there: a
/// browser that reads a picture waits for everything that was drawn before, panels included. Elsewhere
/// it is read from where it was drawn, which [`Reading::finish`] has to wait for anyway.
#[derive(Debug)]
pub struct Reading {
    gl: Gl,
    /// Behind all that the picture needs.
    fence: glow::Fence,
    #[cfg(target_arch = "wasm32")]
    buffer: glow::Buffer,
}

impl Reading {
    /// Begins to read `picture`, which is to stay as it is until the end.
    ///
    /// # Errors
    /// When the context is lost or the driver refuses.
    pub fn begin(picture: &Framebuffer, gl: &Gl) -> Result<Self, GpuError> {
        let create = |why| GpuError::Create {
            what: "picture to read",
            why,
        };
        picture.resolve();
        #[cfg(target_arch = "wasm32")]
        let buffer = picture.copy_into_buffer()?;
        let glow = gl.current_for("reading a picture back")?;
        // SAFETY: current context; the condition and the flags are the only ones that there are.
        let fence = unsafe { glow.fence_sync(glow::SYNC_GPU_COMMANDS_COMPLETE, 0) };
        let fence = fence.map_err(create)?;
        // What is never sent is never done.
        // SAFETY: current context.
        unsafe { glow.flush() };
        Ok(Self {
            gl: gl.clone(),
            fence,
            #[cfg(target_arch = "wasm32")]
            buffer,
        })
    }

    /// Whether the picture is drawn, so that nothing has to wait for it. Off a page it waits until that is
    /// so. In a context that fails there is nothing to wait for.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        let Some(glow) = self.gl.current() else {
            return true;
        };
        // SAFETY: current context, which the fence is of.
        let status = unsafe { glow.client_wait_sync(self.fence, 0, PATIENCE) };
        status != glow::TIMEOUT_EXPIRED
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

impl Drop for Reading {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context, which both are of; nothing uses them any more.
            unsafe {
                glow.delete_sync(self.fence);
                #[cfg(target_arch = "wasm32")]
                glow.delete_buffer(self.buffer);
            }
        }
    }
}
