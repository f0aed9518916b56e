//! The picture of the scene in the view.

use super::draft_detail::{Detail, DraftDetail};
use super::full_picture::FullPicture;
use super::graphics::{fit, fits};
use super::scene_key::SceneKey;
use super::split_view::SplitView;
use crate::gpu::{Framebuffer, Gl, GpuError};
use crate::render::{Frame, Passes, RenderError, Renderer};
use crate::revision::Revision;
use crate::scene::Evaluated;
use std::time::Duration;

/// The picture of the scene, as large as the view. It is drawn again when something changes, on software
/// OpenGL as a draft first while that goes on.
#[derive(Debug)]
pub(super) struct ScenePicture {
    picture: Option<Framebuffer>,
    /// Drafts of half its width and height.
    half: Option<Framebuffer>,
    /// Whether the last of these has yet to be enlarged to the picture.
    is_smaller: bool,
    /// Detail of drafts while something moves.
    draft_detail: DraftDetail,
    /// That of the draft of a movement that the last frame drew, if it did.
    drew_draft: Option<Detail>,
    /// Triangles of the scene of the last draft.
    triangles: usize,
    /// Both parts of the view, while it is split.
    split: Option<SplitView>,
    /// The full picture while it is drawn, step by step, and what is kept of it.
    full: FullPicture,
    /// What the picture shows; `None` if it has to be drawn in any case.
    shown: Option<Shown>,
    /// Whether it was drawn since [`ScenePicture::take_is_new`] was called.
    is_new: bool,
    /// Samples a pixel.
    samples: u32,
    /// Whether the scene is drawn as a draft, without samples, while something moves, as on software OpenGL;
    /// then the picture has none, and those of the full one are there only while it is drawn.
    drafts: bool,
}

/// What the picture of the scene is to show.
#[derive(Clone, Debug)]
pub(super) struct Asked<'a> {
    pub frame: &'a Frame<'a>,
    /// Another evaluation of the scene, which the part at the right of a line shows, at a share of the width.
    pub right: Option<(&'a Evaluated, f32)>,
    pub document: Revision,
    /// Whether something is being moved.
    pub moves: bool,
    pub now: Duration,
    /// Time that the last frame took until it was shown, where that is known.
    pub last_frame: Option<Duration>,
}

/// What the picture of the scene shows.
#[derive(Debug)]
struct Shown {
    key: SceneKey,
    /// When a draft was drawn; `None` for the full picture.
    draft_since: Option<Duration>,
}

/// Time for which nothing has to move before the full picture takes the place of a draft.
pub(super) const REST: Duration = Duration::from_millis(130);

/// Triangles of a scene from which on drafts have half the width and height from the first on, and every change is
/// shown as one: software OpenGL takes more than a fifth of a second for the full picture, and nearly as long for a
/// draft of all pixels.
const MANY_TRIANGLES: usize = 200_000;

impl ScenePicture {
    /// None yet; later ones have so many samples a pixel, 0 for none, and drafts if there is a detail of the first.
    pub fn new(samples: u32, drafts: Option<Detail>) -> Self {
        Self {
            picture: None,
            half: None,
            is_smaller: false,
            draft_detail: DraftDetail::beginning_with(drafts.unwrap_or_default()),
            drew_draft: None,
            triangles: 0,
            split: None,
            full: FullPicture::default(),
            shown: None,
            is_new: false,
            samples,
            drafts: drafts.is_some() && samples > 0,
        }
    }

    /// The scene as it was drawn last, as large as the view or half as large: both parts of a view that is split,
    /// else the picture.
    pub fn picture(&self) -> Option<&Framebuffer> {
        let both = self.split.as_ref().and_then(SplitView::picture);
        let draft = self.half.as_ref().filter(|_| self.is_smaller);
        both.or(draft).or(self.picture.as_ref())
    }

    /// The same, as large as the view.
    ///
    /// # Errors
    /// When a GL error occurred.
    pub fn enlarged(&mut self) -> Result<Option<&Framebuffer>, GpuError> {
        if let (true, Some(half), Some(picture)) = (self.is_smaller, &self.half, &self.picture) {
            self.is_smaller = false;
            half.blit_into(picture, half.rect(), picture.rect())?;
        }
        Ok(self.picture())
    }

    /// Width and height of the view in pixels; `None` before it has been drawn.
    pub fn size(&self) -> Option<(u32, u32)> {
        let picture = self.picture.as_ref();
        picture.map(|picture| (picture.width(), picture.height()))
    }

    /// Samples a pixel of full pictures, 0 for none.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Makes the picture fit the view, whose size is in pixels. Where that cannot be, the one before stays and
    /// is stretched; without any it is a single pixel, so that the panels can be shown.
    ///
    /// # Errors
    /// If the picture cannot be made.
    pub fn fit(&mut self, gl: &Gl, size: (u32, u32)) -> Result<(), GpuError> {
        let samples = if self.drafts { 0 } else { self.samples };
        let fresh = !fits(self.picture.as_ref(), size, samples);
        let fitted = fit(gl, &mut self.picture, size, samples).map(drop);
        if self.picture.is_none() {
            fit(gl, &mut self.picture, (1, 1), 0)?;
        }
        if fresh && fitted.is_ok() {
            self.forget();
        }
        fitted
    }

    /// Draws the scene anew when it is shown next.
    pub fn forget(&mut self) {
        self.shown = None;
    }

    /// Whether the picture was drawn since the last call.
    pub fn take_is_new(&mut self) -> bool {
        std::mem::take(&mut self.is_new)
    }

    /// Time after which [`ScenePicture::draw`] goes on with the full picture, if a draft is shown.
    pub fn full_picture_after(&self, now: Duration) -> Duration {
        let since = self.shown.as_ref().and_then(|shown| shown.draft_since);
        if self.full.is_under_way(since.is_some()) {
            return Duration::ZERO;
        }
        since.map_or(Duration::MAX, |since| (since + REST).saturating_sub(now))
    }

    /// Draws what is `asked`, unless the picture shows just that already; while something moves on software
    /// OpenGL as a draft without samples, which cost it as much as all else. The full picture follows in steps,
    /// one at each call.
    ///
    /// # Errors
    /// See [`Renderer::draw`], and when there is no room for samples or a split view. What failed is not tried
    /// again before something changes.
    pub fn draw(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        asked: &Asked,
    ) -> Result<(), RenderError> {
        let &Asked {
            frame,
            right,
            moves,
            now,
            last_frame,
            ..
        } = asked;
        if let Some((detail, took)) = self.drew_draft.take().zip(last_frame) {
            let is_large = self.triangles > MANY_TRIANGLES;
            self.draft_detail.count(took, detail, is_large);
        }
        let Some((width, _)) = self.size() else {
            return Ok(());
        };
        let right = right.map(|(evaluated, line)| {
            let column = (width as f32 * line.clamp(0.0, 1.0)).round() as i32;
            (evaluated, column)
        });
        let key = SceneKey::of(asked, right);
        // When what differs from `key` in lines round shapes at most was drawn as a draft; `Some(None)` if in full.
        let alike = (self.shown.as_ref())
            .filter(|shown| shown.key.without_outlines() == key.without_outlines())
            .map(|shown| shown.draft_since);
        let is_same = self.shown.as_ref().is_some_and(|shown| shown.key == key);
        let is_draft = match alike {
            Some(None) if is_same => {
                self.full.forget_outlines();
                return Ok(());
            }
            Some(None) => false,
            Some(Some(since)) if is_same && moves && now < since + REST => return Ok(()),
            Some(Some(_)) if is_same => false,
            Some(Some(_)) => moves,
            None => self.drafts && (moves || triangles(frame) > MANY_TRIANGLES),
        };
        if is_draft || alike.is_none() {
            self.full = FullPicture::default();
        }
        let next = Shown {
            key,
            draft_since: is_draft.then_some(now),
        };
        if let Some(right) = right {
            self.shows(next);
            return self.draw_split((gl, renderer), frame, right, is_draft);
        }
        self.split = None;
        if let (true, false, Some(target)) = (self.drafts, is_draft, &self.picture) {
            // What is shown stays meanwhile; what is no more is not shown until all is done.
            let in_steps = alike.is_some();
            let of = (frame, &next.key, self.samples);
            let (is_shown, drawn) = (self.full).go_on((gl, renderer), of, target, in_steps);
            if is_shown {
                self.shows(next);
            }
            return drawn;
        }
        self.shows(next);
        if is_draft {
            let detail = self.detail_for(triangles(frame));
            self.drew_draft = moves.then_some(detail);
            return self.draw_draft((gl, renderer), frame, detail);
        }
        match &self.picture {
            Some(target) => renderer.draw(frame, target),
            None => Ok(()),
        }
    }

    /// Detail of a draft of a scene with so many triangles.
    fn detail_for(&mut self, triangles: usize) -> Detail {
        let before = std::mem::replace(&mut self.triangles, triangles);
        if triangles <= MANY_TRIANGLES {
            return self.draft_detail.next();
        }
        // The larger part of a large scene is new, and has yet to be uploaded.
        if triangles > before.max(MANY_TRIANGLES / 2) * 2 {
            self.draft_detail = DraftDetail::beginning_with(Detail::Coarse);
        }
        self.draft_detail.next().max(Detail::Half)
    }

    /// Draws `frame` without samples.
    fn draw_draft(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        frame: &Frame,
        detail: Detail,
    ) -> Result<(), RenderError> {
        let Some(((width, height), target)) = self.size().zip(self.picture.as_ref()) else {
            return Ok(());
        };
        if detail == Detail::Fine {
            self.half = None;
            return renderer.draw_moving(frame, target);
        }
        let half = (width.div_ceil(2), height.div_ceil(2));
        let picture = fit(gl, &mut self.half, half, 0)?;
        self.is_smaller = true;
        match detail {
            Detail::Fine | Detail::Half => renderer.draw_moving(frame, picture),
            Detail::Coarse => renderer.draw_coarse(frame, picture, Passes::All),
            Detail::Sketch => renderer.draw_coarse(frame, picture, Passes::Sketch),
        }
    }

    /// Draws both parts of a split view.
    fn draw_split(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        frame: &Frame,
        right: (&Evaluated, i32),
        is_draft: bool,
    ) -> Result<(), RenderError> {
        let Some(((width, height), target)) = self.size().zip(self.picture.as_ref()) else {
            return Ok(());
        };
        let has_own_samples = self.drafts && !is_draft;
        let full = has_own_samples
            .then(|| Framebuffer::new(gl, width, height, self.samples))
            .transpose();
        let picture = full.as_ref().ok().and_then(Option::as_ref);
        let parts = (frame, picture.unwrap_or(target));
        let split = self.split.get_or_insert_default();
        let drawn = split.draw(gl, renderer, parts, right);
        // Without room for samples edges are rough, and the rest is there.
        drawn.and(full.map(drop).map_err(RenderError::from))
    }

    fn shows(&mut self, next: Shown) {
        self.is_smaller = false;
        self.shown = Some(next);
        self.is_new = true;
    }
}

/// Triangles of all that is drawn.
fn triangles(frame: &Frame) -> usize {
    let each = frame
        .shapes()
        .map(|(_, it)| it.geometry.mesh.triangles.len());
    each.sum()
}
