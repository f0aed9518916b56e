//! A mark behind all that was drawn so far.

use glow::HasContext as _;

use super::{Gl, GpuError};

/// Nanoseconds to wait for a mark at a time. A page may not wait at all: the browser needs the thread.
const PATIENCE: i32 = if cfg!(target_arch = "wasm32") {
    0
} else {
    i32::MAX
};

/// A mark that is reached once everything is drawn that was drawn before it.
#[derive(Debug)]
pub struct Fence {
    gl: Gl,
    raw: glow::Fence,
}

impl Fence {
    /// Marks the end of what was drawn so far.
    ///
    /// # Errors
    /// When the context is lost or the driver refuses.
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let glow = gl.current_for("marking what was drawn")?;
        // SAFETY: current context; the condition and the flags are the only ones that there are.
        let raw = unsafe { glow.fence_sync(glow::SYNC_GPU_COMMANDS_COMPLETE, 0) };
        let raw = raw.map_err(|why| GpuError::Create { what: "fence", why })?;
        // What is never sent is never done.
        // SAFETY: current context.
        unsafe { glow.flush() };
        Ok(Self {
            gl: gl.clone(),
            raw,
        })
    }

    /// Whether the mark is reached. Off a page it waits until that is so. In a context that fails there
    /// is nothing to wait for.
    #[must_use]
    pub fn is_reached(&self) -> bool {
        let Some(glow) = self.gl.current() else {
            return true;
        };
        // SAFETY: current context, which the fence is of.
        let status = unsafe { glow.client_wait_sync(self.raw, 0, PATIENCE) };
        status != glow::TIMEOUT_EXPIRED
    }
}

impl Drop for Fence {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context, which it is of; nothing uses it any more.
            unsafe { glow.delete_sync(self.raw) }
        }
    }
}
