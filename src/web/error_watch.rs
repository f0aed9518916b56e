//! Errors of WebGL, asked for when nothing is drawn.
//!
//! A browser answers once everything is drawn that was drawn before, and the page would stand still
//! until then.

use super::browser;
use crate::gpu::{Fence, Gl};
use std::cell::Cell;
use std::rc::Rc;
use std::time::Duration;

/// Time between two looks whether everything is drawn.
const LOOK: Duration = Duration::from_millis(50);

/// Asks for errors between frames. The next check of the same context returns them.
pub(super) struct ErrorWatch {
    gl: Gl,
    /// Number of frames so far.
    frames: Rc<Cell<u64>>,
}

impl ErrorWatch {
    pub fn new(gl: &Gl) -> Self {
        Self {
            gl: gl.clone(),
            frames: Rc::default(),
        }
    }

    /// Has errors be asked for once this frame is drawn, unless another one comes before.
    pub fn end_frame(&self) {
        self.frames.set(self.frames.get() + 1);
        let watch = Look {
            gl: self.gl.clone(),
            frames: Rc::clone(&self.frames),
            frame: self.frames.get(),
        };
        // The frame is not complete yet: egui has still to be painted.
        browser::after(LOOK, move || {
            if let (true, Ok(fence)) = (watch.is_last(), Fence::new(&watch.gl)) {
                watch.ask_behind(fence);
            }
        });
    }
}

/// Waiting for a frame to be drawn.
struct Look {
    gl: Gl,
    frames: Rc<Cell<u64>>,
    frame: u64,
}

impl Look {
    fn is_last(&self) -> bool {
        self.frames.get() == self.frame
    }

    fn ask_behind(self, fence: Fence) {
        if !self.is_last() {
            return;
        }
        if fence.is_reached() {
            return self.gl.keep_errors();
        }
        browser::after(LOOK, move || self.ask_behind(fence));
    }
}
