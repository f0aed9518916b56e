//! The context of a canvas on a page.

use std::rc::Rc;
use std::sync::Arc;

use web_sys::WebGl2RenderingContext;

use super::NativeContext;
use crate::gpu::{ContextError, Gl};

/// WebGL 2 in a canvas, which somebody else draws into as well.
#[derive(Debug)]
pub struct CanvasContext {
    gl: Gl,
}

impl CanvasContext {
    /// Shares `context`, whose entry points are `glow`.
    ///
    /// # Errors
    /// If the browser has taken the context away.
    pub fn new(
        context: WebGl2RenderingContext,
        glow: Arc<glow::Context>,
    ) -> Result<Self, ContextError> {
        let gl = Gl::of_canvas(Rc::new(Canvas(context)), glow)?;
        Ok(Self { gl })
    }

    /// The handle to make objects from.
    #[must_use]
    pub fn gl(&self) -> &Gl {
        &self.gl
    }
}

struct Canvas(WebGl2RenderingContext);

impl NativeContext for Canvas {
    fn make_current(&self) -> Result<(), String> {
        // Calls name the context that they are for: there is none to be made current.
        if self.0.is_context_lost() {
            return Err("the browser has taken the graphics away".to_owned());
        }
        Ok(())
    }

    fn release(&self) {}
}
