use super::split_view::SplitView;
use super::window_picture::WindowPicture;
use super::{ProgramError, globals};
use crate::geometry::Picture;
use crate::gpu::{Framebuffer, Gl, GpuError, Reading, Rect};
use crate::render::{
    Backdrop, Frame, LargePicture, Marks, PictureParts, RenderError, Renderer, read_picture,
};
use crate::revision::Revision;
use crate::scene::{Evaluated, Skinning, ViewSettings};
use egui::FullOutput;
use std::time::Duration;

/// Everything that the program makes with OpenGL. When a context is lost, another is made in its
/// place, and the program goes on.
#[derive(Debug)]
pub struct Graphics {
    renderer: Renderer,
    /// The scene, as large as the view.
    scene: Option<Framebuffer>,
    /// The scene, as large as the picture that it is compared with.
    compared: Option<Framebuffer>,
    /// That on its way back.
    compared_reading: Option<Reading>,
    /// Both parts of the view, while it is split.
    split: Option<SplitView>,
    /// The full picture of the scene without the lines round marked shapes, where drawing it takes so long that
    /// these are drawn over it when the pointer moves from shape to shape.
    without_outlines: Option<Framebuffer>,
    /// What the picture of the scene shows: it is drawn again only when this changes.
    shown: Option<Shown>,
    /// Scene and panels together, in hosts that leave painting the panels to the program.
    window: Option<WindowPicture>,
    /// Whether the last frame could not have pictures of the size it needed.
    has_wrong_size: bool,
    /// Samples a pixel of pictures of the scene.
    samples: u32,
    /// Whether the scene is drawn as a draft, without samples, while something moves, as on software OpenGL;
    /// then its picture has none, and those of the full one are there only while it is drawn.
    drafts: bool,
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

/// What the picture of the scene shows.
#[derive(Debug)]
struct Shown {
    key: SceneKey,
    /// When a draft was drawn; `None` for the full picture.
    draft_since: Option<Duration>,
}

/// Time for which nothing has to move before the full picture takes the place of a draft.
const REST: Duration = Duration::from_millis(130);

/// State that a picture of the scene follows from.
#[derive(Clone, Debug, PartialEq)]
struct SceneKey {
    document: Revision,
    /// Geometry of each shape, which is not the document's while the view shows another one.
    geometry: Vec<Revision>,
    /// The same at the right of a line, and the column of the line, while the view is split.
    right: Option<(Vec<Revision>, i32)>,
    view: ViewSettings,
    backdrop: Backdrop,
    marks: Marks,
}

impl SceneKey {
    /// The same without the marks that are lines round shapes and nothing else.
    fn without_outlines(&self) -> Self {
        let mut key = self.clone();
        key.marks.hovered = None;
        key.marks.also_selected.clear();
        key
    }
}

impl Graphics {
    /// Compiles the shaders in the context of `gl`.
    ///
    /// # Errors
    /// When the driver refuses a shader or a buffer.
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        Ok(Self {
            renderer: Renderer::new(gl)?,
            scene: None,
            compared: None,
            compared_reading: None,
            split: None,
            without_outlines: None,
            shown: None,
            window: None,
            has_wrong_size: false,
            samples: globals::SAMPLES.min(gl.info().max_samples),
            drafts: gl.info().is_software,
            gl: gl.clone(),
        })
    }

    /// The same for pictures that are kept: with so many samples a pixel, 0 for none, of a number that
    /// the driver has, also while something is dragged.
    pub fn for_pictures(self, samples: u32) -> Self {
        Self {
            samples,
            drafts: false,
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

    /// The scene as it was drawn last, as large as the view.
    pub fn scene_picture(&self) -> Option<&Framebuffer> {
        shown_picture(&self.split, &self.scene)
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

    /// Makes the scene's picture fit the view, whose size is in pixels. Where that cannot be, the
    /// one before stays and is stretched; without any it is a single pixel, so that the panels can
    /// be shown.
    ///
    /// # Errors
    /// If the picture cannot be made.
    pub(super) fn fit_view(&mut self, size: (u32, u32)) -> Result<(), GpuError> {
        let samples = if self.drafts { 0 } else { self.samples };
        let fresh = !fits(self.scene.as_ref(), size, samples);
        let fitted = fit(&self.gl, &mut self.scene, size, samples).map(drop);
        if self.scene.is_none() {
            fit(&self.gl, &mut self.scene, (1, 1), 0)?;
        }
        if fresh && fitted.is_ok() {
            self.forget_scene();
        }
        fitted
    }

    /// Draws the scene anew when it is shown next.
    pub(super) fn forget_scene(&mut self) {
        self.shown = None;
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

    /// Draws `frame` into the scene's picture, unless it shows just that already: at the time `now`,
    /// and while something `moves` on software OpenGL as a draft without samples, which cost it as much
    /// as all else. With `right` the part at the right of a line, at a share of the width, shows another
    /// evaluation of the scene.
    ///
    /// # Errors
    /// See [`Renderer::draw`], and when there is no room for a split view. What failed is not tried again before something changes.
    pub(super) fn draw_scene(
        &mut self,
        frame: &Frame,
        right: Option<(&Evaluated, f32)>,
        document: Revision,
        moves: bool,
        now: Duration,
    ) -> Result<(), RenderError> {
        let Some(target) = &self.scene else {
            return Ok(());
        };
        let size = (target.width(), target.height());
        let right = right.map(|(evaluated, line)| {
            let column = (size.0 as f32 * line.clamp(0.0, 1.0)).round() as i32;
            (evaluated, column)
        });
        let key = SceneKey {
            document,
            geometry: revisions(frame.evaluated),
            right: right.map(|(evaluated, column)| (revisions(evaluated), column)),
            view: *frame.view,
            backdrop: frame.backdrop,
            marks: frame.marks.clone(),
        };
        let drafts = moves && self.drafts && self.samples > 0;
        let shown = self.shown.as_ref().filter(|shown| shown.key == key);
        let is_draft = match shown.map(|shown| shown.draft_since) {
            Some(None) => return Ok(()),
            Some(Some(since)) if drafts && now < since + REST => return Ok(()),
            Some(Some(_)) => false,
            None => drafts,
        };
        if let Some(window) = &mut self.window {
            window.scene_changes();
        }
        let other_outlines = self.shown.as_ref().is_some_and(|shown| {
            shown.draft_since.is_none() && shown.key.without_outlines() == key.without_outlines()
        });
        self.shown = Some(Shown {
            key,
            draft_since: is_draft.then_some(now),
        });
        if is_draft || !other_outlines {
            self.without_outlines = None;
        }
        if let Some(kept) = &self.without_outlines {
            kept.blit_into(target, kept.rect(), kept.rect())?;
            return self.renderer.draw_outlines_over(frame, target);
        }
        let has_own_samples = self.drafts && self.samples > 0 && !is_draft;
        let (full, room) = match has_own_samples
            .then(|| Framebuffer::new(&self.gl, size.0, size.1, self.samples))
            .transpose()
        {
            Ok(full) => (full, Ok(())),
            // Edges are rough then, and the rest is there.
            Err(error) => (None, Err(error.into())),
        };
        let picture = full.as_ref().unwrap_or(target);
        let drawn = if let Some((evaluated, column)) = right {
            let split = self.split.get_or_insert_default();
            let right = (evaluated, column);
            split.draw(&self.gl, &mut self.renderer, (frame, picture), right)
        } else {
            self.split = None;
            match &full {
                None if is_draft => self.renderer.draw_moving(frame, picture),
                None => self.renderer.draw(frame, picture),
                Some(full) => {
                    let drawn = self.renderer.draw_without_outlines(frame, full);
                    full.blit_into(target, full.rect(), full.rect())?;
                    // Without room for it, the next picture is drawn as a whole.
                    if let Ok(kept) = Framebuffer::new(&self.gl, size.0, size.1, 0) {
                        target.blit_into(&kept, target.rect(), kept.rect())?;
                        self.without_outlines = Some(kept);
                    }
                    drawn.and(self.renderer.draw_outlines_over(frame, target))
                }
            }
        };
        drawn.and(room)
    }

    /// Time after which the full picture has to take the place of a draft, if one is shown.
    pub(super) fn full_picture_after(&self, now: Duration) -> Duration {
        let since = self.shown.as_ref().and_then(|shown| shown.draft_since);
        since.map_or(Duration::MAX, |since| (since + REST).saturating_sub(now))
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
        let samples = if smooth_edges { self.samples } else { 0 };
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
        let view = self.scene.as_ref().map(|s| (s.width(), s.height()));
        view.unwrap_or((800, 600))
    }

    /// Samples a pixel of pictures of the scene, 0 for none.
    pub(super) fn samples(&self) -> u32 {
        self.samples
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
        match (&mut self.window, shown_picture(&self.split, &self.scene)) {
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

/// Both parts of a view that is split, else the picture of the scene.
fn shown_picture<'a>(
    split: &'a Option<SplitView>,
    scene: &'a Option<Framebuffer>,
) -> Option<&'a Framebuffer> {
    let both = split.as_ref().and_then(SplitView::picture);
    both.or(scene.as_ref())
}

/// Revisions of the geometry of each shape.
fn revisions(evaluated: &Evaluated) -> Vec<Revision> {
    let shapes = evaluated.shapes.iter();
    shapes.map(|shape| shape.geometry.revision).collect()
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
