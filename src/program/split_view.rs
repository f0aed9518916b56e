//! A view that shows two evaluations of the scene, one at each side of a line.

use super::graphics::fit;
use crate::gpu::{Framebuffer, Gl, Rect};
use crate::render::{Frame, RenderError, Renderer};
use crate::scene::Evaluated;

/// Pictures of a view that is split.
#[derive(Debug, Default)]
pub(super) struct SplitView {
    /// What is at the right of the line, in all of the view.
    right: Option<Framebuffer>,
    /// Both.
    both: Option<Framebuffer>,
}

impl SplitView {
    /// The view, once it has been drawn.
    pub(super) fn picture(&self) -> Option<&Framebuffer> {
        self.both.as_ref()
    }

    /// Draws `frame` into the picture `left`, with `evaluated` into one like it, and puts of the one what is
    /// left of `column` beside what is right of it of the other.
    ///
    /// # Errors
    /// See [`Renderer::draw`], and when there is no room for the pictures.
    pub(super) fn draw(
        &mut self,
        gl: &Gl,
        renderer: &mut Renderer,
        (frame, left): (&Frame, &Framebuffer),
        (evaluated, column): (&Evaluated, i32),
    ) -> Result<(), RenderError> {
        let size = (left.width(), left.height());
        let right = fit(gl, &mut self.right, size, left.samples())?;
        let both = fit(gl, &mut self.both, size, 0)?;
        let of_left = renderer.draw(frame, left);
        let of_right = Frame {
            evaluated,
            ..frame.clone()
        };
        let of_right = renderer.draw(&of_right, right);
        let (width, height) = (size.0 as i32, size.1 as i32);
        for (part, from, to) in [(left, 0, column), (right, column, width)] {
            let columns = Rect {
                x: from,
                y: 0,
                width: to - from,
                height,
            };
            if columns.width > 0 {
                part.blit_into(both, columns, columns)?;
            }
        }
        of_left.and(of_right)
    }
}
