use super::draft_detail::Detail;
use super::scene_picture::{Asked, ScenePicture};
use super::window_picture::WindowPicture;
use super::{ProgramError, globals};
use crate::geometry::Picture;
use crate::gpu::{Framebuffer, Gl, GpuError, Info, Reading, Rect};
use crate::render::{Frame, LargePicture, PictureParts, RenderError, Renderer, read_picture};
use crate::scene::Skinning;
use egui::FullOutput;
use std::time::Duration;

/// Everything that the program makes with OpenGL. When a context is lost, another is made in its
/// place, and the program goes on.
#[derive(Debug)]
pub struct Graphics {
    renderer: Renderer,
    scene: ScenePicture,
    /// The scene, as large as the picture that it is compared with.
    compared: Option<Framebuffer>,
    /// That on its way back.
    compared_reading: Option<Reading>,
    /// Scene and panels together, in hosts that leave painting the panels to the program.
    window: Option<WindowPicture>,
    /// Whether the last frame could not have pictures of the size it needed.
    has_wrong_size: bool,
    gl: Gl,
}

/// Properties of the graphics that the program shows and keeps to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GraphicsInfo {
    /// Version and renderer, for the status line.
    pub description: String,
    /// Longest side of a texture, in pixels.
    pub max_texture_side: usize,
}

impl Graphics {
    /// Compiles the shaders in the context of `gl`.
    ///
    /// # Errors
    /// When the driver refuses a shader or a buffer.
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let samples = globals::SAMPLES.min(gl.info().max_samples);
        Ok(Self {
            renderer: Renderer::new(gl)?,
            scene: ScenePicture::new(samples, first_drafts(gl.info())),
            compared: None,
            compared_reading: None,
            window: None,
            has_wrong_size: false,
            gl: gl.clone(),
        })
    }

    /// The same for pictures that are kept: with so many samples a pixel, 0 for none, of a number that
    /// the driver has, also while something is dragged.
    pub fn for_pictures(self, samples: u32) -> Self {
        Self {
            scene: ScenePicture::new(samples, None),
            ..self
        }
    }

    /// Properties of what draws.
    pub fn info(&self) -> GraphicsInfo {
        let info = self.gl.info();
        // Browsers say what their version is one of, and what they make it from.
        let version = match info.version.strip_prefix("WebGL ") {
            Some(rest) => format!("WebGL {}", rest.split(' ').next().unwrap_or_default()),
            None => format!("OpenGL {}", info.version),
        };
        GraphicsInfo {
            description: format!("{version} · {}", info.renderer),
            max_texture_side: info.max_texture_size as usize,
        }
    }

    /// The scene as it was drawn last, as large as the view or, while something moves, half as large.
    pub fn scene_picture(&self) -> Option<&Framebuffer> {
        self.scene.picture()
    }

    /// Scene and panels as they were composed last, as large as the window.
    pub fn window_picture(&self) -> Option<&Framebuffer> {
        self.window.as_ref()?.picture()
    }

    /// Chooses what deforms characters; whether pictures have to be drawn again.
    pub(super) fn set_skinning(&mut self, skinning: Option<Skinning>) {
        if self.renderer.set_skinning(skinning) {
            self.forget_scene();
        }
    }

    /// What the user should know about how pictures are drawn, each once.
    pub(super) fn take_notices(&mut self) -> Vec<String> {
        self.renderer.take_notices()
    }

    /// See [`ScenePicture::fit`].
    ///
    /// # Errors
    /// If the picture cannot be made.
    pub(super) fn fit_view(&mut self, size: (u32, u32)) -> Result<(), GpuError> {
        self.scene.fit(&self.gl, size)
    }

    /// Draws the scene anew when it is shown next.
    pub(super) fn forget_scene(&mut self) {
        self.scene.forget();
    }

    /// Makes the picture of the window fit its `size` in pixels, and the painter of the panels if
    /// there is none yet.
    ///
    /// # Errors
    /// If one of them cannot be made.
    pub(super) fn fit_window(&mut self, size: (u32, u32)) -> Result<(), ProgramError> {
        let window = match &mut self.window {
            Some(window) => window,
            none => none.insert(WindowPicture::new(&self.gl)?),
        };
        Ok(window.fit(&self.gl, size)?)
    }

    /// Whether the last pictures could not have the size that was needed; `wrong` is the same for
    /// this frame from now on.
    pub(super) fn replace_wrong_size(&mut self, wrong: bool) -> bool {
        std::mem::replace(&mut self.has_wrong_size, wrong)
    }

    /// See [`ScenePicture::draw`].
    ///
    /// # Errors
    /// When something cannot be drawn.
    pub(super) fn draw_scene(&mut self, asked: &Asked) -> Result<(), RenderError> {
        let drawn = (self.scene).draw((&self.gl, &mut self.renderer), asked);
        if let Some(window) = &mut self.window
            && self.scene.take_is_new()
        {
            window.scene_changes();
        }
        drawn
    }

    /// See [`ScenePicture::full_picture_after`].
    pub(super) fn full_picture_after(&self, now: Duration) -> Duration {
        self.scene.full_picture_after(now)
    }

    /// Draws `frame` in a size of its own, for a comparison. Pictures of the same size share their
    /// memory from one frame to the next.
    ///
    /// # Errors
    /// See [`Renderer::draw`], and when there is no room for the picture.
    pub(super) fn draw_compared(
        &mut self,
        frame: &Frame,
        size: (u32, u32),
        smooth_edges: bool,
    ) -> Result<(), RenderError> {
        let samples = if smooth_edges { self.samples() } else { 0 };
        let target = fit(&self.gl, &mut self.compared, size, samples)?;
        self.renderer.draw(frame, target)?;
        self.compared_reading = Some(Reading::begin(target, &self.gl)?);
        Ok(())
    }

    /// What [`Graphics::draw_compared`] has drawn, once; `None` while it is being drawn, which only a
    /// page does not wait for.
    ///
    /// # Errors
    /// When a GL error occurred.
    pub(super) fn compared_picture(&mut self) -> Result<Option<Picture>, RenderError> {
        let reading = self.compared_reading.take_if(|it| it.is_drawn());
        let (Some(reading), Some(target)) = (reading, &self.compared) else {
            return Ok(None);
        };
        Ok(Some(Picture {
            width: target.width(),
            height: target.height(),
            rgba: reading.finish(target)?,
        }))
    }

    /// Frees the memory of the picture that was compared.
    pub(super) fn end_comparison(&mut self) {
        self.compared = None;
        self.compared_reading = None;
    }

    /// Width and height of the view in pixels.
    pub(super) fn view_size(&self) -> (u32, u32) {
        self.scene.size().unwrap_or((800, 600))
    }

    /// Samples a pixel of pictures of the scene, 0 for none.
    pub(super) fn samples(&self) -> u32 {
        self.scene.samples()
    }

    /// The parts that `asked` is drawn in.
    pub(super) fn picture_parts(&self, asked: &LargePicture) -> PictureParts {
        PictureParts::new(asked, self.gl.info())
    }

    /// Draws the next of `parts`, which are those of `frame`.
    ///
    /// # Errors
    /// See [`PictureParts::draw_next`].
    pub(super) fn draw_part(
        &mut self,
        parts: &mut PictureParts,
        frame: &Frame,
    ) -> Result<(), RenderError> {
        parts.draw_next(&self.gl, &mut self.renderer, frame)
    }

    /// Puts the scene's picture at `place` of the window's and paints the panels over it, as far as they
    /// changed: egui asks for two frames after each that had input, which mostly are as that one.
    ///
    /// # Errors
    /// See [`Composer::compose`].
    pub(super) fn compose(
        &mut self,
        place: Rect,
        context: &egui::Context,
        output: FullOutput,
    ) -> Result<(), GpuError> {
        match (&mut self.window, self.scene.enlarged()?) {
            (Some(window), Some(scene)) => window.compose(scene, place, context, output),
            (Some(window), None) => {
                window.skip(output);
                Ok(())
            }
            (None, _) => Ok(()),
        }
    }

    /// Whether the window's picture has been composed anew since the last call.
    pub fn take_is_new(&mut self) -> bool {
        let window = self.window.as_mut();
        window.is_some_and(WindowPicture::take_is_new)
    }

    /// The window's picture as it was composed last.
    ///
    /// # Errors
    /// When a GL error occurred.
    pub(super) fn read_window(&self) -> Result<Option<Picture>, GpuError> {
        self.window_picture().map(read_picture).transpose()
    }
}

/// Whether there is a picture of this size, in pixels, and with so many samples.
pub(super) fn fits(
    picture: Option<&Framebuffer>,
    (width, height): (u32, u32),
    samples: u32,
) -> bool {
    picture.is_some_and(|p| (p.width(), p.height(), p.samples()) == (width, height, samples))
}

/// Makes `picture` anew if it has another size.
///
/// # Errors
/// If it cannot be made; then `picture` is as it was.
pub(super) fn fit<'a>(
    gl: &Gl,
    picture: &'a mut Option<Framebuffer>,
    (width, height): (u32, u32),
    samples: u32,
) -> Result<&'a Framebuffer, GpuError> {
    let fitting = match picture.take() {
        Some(kept) if fits(Some(&kept), (width, height), samples) => kept,
        before => match Framebuffer::new(gl, width, height, samples) {
            Ok(made) => made,
            Err(error) => {
                *picture = before;
                return Err(error);
            }
        },
    };
    Ok(picture.insert(fitting))
}

/// Detail of the first draft; `None` where whole pictures are fast. What browsers have takes several times as long as
/// Mesa, and is slow with the program's own scenes.
fn first_drafts(info: &Info) -> Option<Detail> {
    info.is_software.then_some(match info.is_gles {
        true => Detail::Half,
        false => Detail::Fine,
    })
}
