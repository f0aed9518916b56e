//! The full picture of the scene on software OpenGL, which follows a draft step by step.

use super::scene_key::SceneKey;
use crate::gpu::{Framebuffer, Gl};
use crate::render::{Frame, GradualOutlines, GradualPicture, RenderError, Renderer};

/// The steps that are done, and the picture without the lines round marked shapes: these are drawn over it when the
/// pointer moves from shape to shape, since drawing it takes so long.
#[derive(Debug, Default)]
pub(super) struct FullPicture {
    gradual: Option<GradualPicture>,
    without_outlines: Option<Framebuffer>,
    /// The lines while it is found out what they go round, and the picture that they belong to.
    outlines: Option<(SceneKey, GradualOutlines)>,
}

impl FullPicture {
    /// Whether the next step follows at once, while a draft is shown or not.
    pub fn is_under_way(&self, is_draft: bool) -> bool {
        let next_is_outlines = is_draft && self.without_outlines.is_some();
        self.gradual.is_some() || self.outlines.is_some() || next_is_outlines
    }

    /// Forgets the lines that were begun with.
    pub fn forget_outlines(&mut self) {
        self.outlines = None;
    }

    /// Goes on with the picture of `frame`, which follows from `key` and has so many samples, by one step if they come
    /// `in_steps`. Whether it is in `target` now: what failed is not tried again.
    pub fn go_on(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        (frame, key, samples): (&Frame, &SceneKey, u32),
        target: &Framebuffer,
        in_steps: bool,
    ) -> (bool, Result<(), RenderError>) {
        let mut drawn = Ok(());
        if self.without_outlines.is_none() {
            let size = (target.width(), target.height());
            let begun = match self.gradual.take() {
                Some(begun) => Ok(begun),
                None => GradualPicture::new(gl, size, samples),
            };
            let mut gradual = match begun {
                Ok(gradual) => gradual,
                // Edges are rough then, and the rest is there.
                Err(error) => {
                    let drawn = renderer.draw(frame, target);
                    return (true, drawn.and(Err(error.into())));
                }
            };
            while !gradual.is_complete() {
                drawn = drawn.and(gradual.draw_next(renderer, frame));
                if in_steps {
                    self.gradual = Some(gradual);
                    return (false, drawn);
                }
            }
            let picture = gradual.picture();
            let kept = match Framebuffer::new(gl, size.0, size.1, 0) {
                Ok(kept) => kept,
                // The lines are missing then, and the rest is there.
                Err(error) => {
                    let shown = picture.blit_into(target, picture.rect(), target.rect());
                    return (true, shown.and(Err(error)).map_err(RenderError::from));
                }
            };
            if let Err(error) = picture.blit_into(&kept, picture.rect(), kept.rect()) {
                return (true, Err(error.into()));
            }
            self.without_outlines = Some(kept);
            if in_steps {
                return (false, drawn);
            }
        }
        let (is_shown, outlines) =
            self.draw_outlines((gl, renderer), (frame, key), target, in_steps);
        (is_shown, drawn.and(outlines))
    }

    /// The same for the lines round marked shapes, the last steps.
    fn draw_outlines(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        (frame, key): (&Frame, &SceneKey),
        target: &Framebuffer,
        in_steps: bool,
    ) -> (bool, Result<(), RenderError>) {
        let Some(kept) = &self.without_outlines else {
            return (false, Ok(()));
        };
        let begun = self.outlines.take().filter(|(of, _)| of == key);
        let begun = match begun {
            Some((_, outlines)) => Ok(outlines),
            None => GradualOutlines::new(gl, (kept.width(), kept.height())),
        };
        let lines = match begun {
            Ok(mut outlines) => loop {
                match outlines.draw_next(renderer, frame) {
                    Ok(false) if in_steps => {
                        self.outlines = Some((key.clone(), outlines));
                        return (false, Ok(()));
                    }
                    Ok(false) => {}
                    Ok(true) => break Ok(outlines),
                    Err(error) => break Err(error),
                }
            },
            Err(error) => Err(error.into()),
        };
        let shown = kept.blit_into(target, kept.rect(), target.rect());
        let drawn = lines.and_then(|lines| lines.draw_over(renderer, frame, target));
        (true, shown.map_err(RenderError::from).and(drawn))
    }
}
