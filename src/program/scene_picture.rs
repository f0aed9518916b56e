//! The picture of the scene in the view.

use super::graphics::{fit, fits};
use super::split_view::SplitView;
use crate::gpu::{Framebuffer, Gl, GpuError};
use crate::render::{Backdrop, Frame, GradualPicture, Marks, RenderError, Renderer};
use crate::revision::Revision;
use crate::scene::{Evaluated, ViewSettings};
use std::time::Duration;

/// The picture of the scene, as large as the view. It is drawn again when something changes, on software
/// OpenGL as a draft first while that goes on.
#[derive(Debug)]
pub(super) struct ScenePicture {
    picture: Option<Framebuffer>,
    /// Drafts of half its width and height.
    coarse: Option<Framebuffer>,
    /// Both parts of the view, while it is split.
    split: Option<SplitView>,
    /// The full picture while it is drawn, step by step, and a draft is shown.
    full: Option<GradualPicture>,
    /// The full picture without the lines round marked shapes, where drawing it takes so long that
    /// these are drawn over it when the pointer moves from shape to shape.
    without_outlines: Option<Framebuffer>,
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

/// What the picture of the scene shows.
#[derive(Debug)]
struct Shown {
    key: SceneKey,
    /// When a draft was drawn; `None` for the full picture.
    draft_since: Option<Duration>,
}

/// Time for which nothing has to move before the full picture takes the place of a draft.
const REST: Duration = Duration::from_millis(130);

/// Triangles of a scene from which on movements are shown in half the width and height, and every other change as a
/// draft first: software OpenGL takes more than a fifth of a second for the full picture, and nearly as long for a
/// draft of all pixels.
const MANY_TRIANGLES: usize = 200_000;

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

impl ScenePicture {
    /// None yet; later ones have so many samples a pixel, 0 for none, and may have drafts.
    pub fn new(samples: u32, drafts: bool) -> Self {
        Self {
            picture: None,
            coarse: None,
            split: None,
            full: None,
            without_outlines: None,
            shown: None,
            is_new: false,
            samples,
            drafts: drafts && samples > 0,
        }
    }

    /// The scene as it was drawn last: both parts of a view that is split, else the picture.
    pub fn picture(&self) -> Option<&Framebuffer> {
        let both = self.split.as_ref().and_then(SplitView::picture);
        both.or(self.picture.as_ref())
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
        since.map_or(Duration::MAX, |since| (since + REST).saturating_sub(now))
    }

    /// Draws `frame`, unless the picture shows just that already: at the time `now`, and while something `moves`
    /// on software OpenGL as a draft without samples, which cost it as much as all else. The full picture
    /// follows in steps, one at each call. With `right` the part at the right of a line, at a share of the
    /// width, shows another evaluation of the scene.
    ///
    /// # Errors
    /// See [`Renderer::draw`], and when there is no room for samples or a split view. What failed is not tried
    /// again before something changes.
    pub fn draw(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        frame: &Frame,
        right: Option<(&Evaluated, f32)>,
        document: Revision,
        moves: bool,
        now: Duration,
    ) -> Result<(), RenderError> {
        let Some((width, _)) = self.size() else {
            return Ok(());
        };
        let right = right.map(|(evaluated, line)| {
            let column = (width as f32 * line.clamp(0.0, 1.0)).round() as i32;
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
        // When what differs from `key` in lines round shapes at most was drawn as a draft; `Some(None)` if in full.
        let alike = (self.shown.as_ref())
            .filter(|shown| shown.key.without_outlines() == key.without_outlines())
            .map(|shown| shown.draft_since);
        let is_same = self.shown.as_ref().is_some_and(|shown| shown.key == key);
        let is_draft = match alike {
            Some(None) if is_same => return Ok(()),
            Some(None) => false,
            Some(Some(since)) if is_same && moves && now < since + REST => return Ok(()),
            Some(Some(_)) if is_same => false,
            Some(Some(_)) => moves,
            None => self.drafts && (moves || is_large(frame)),
        };
        if is_draft || alike.is_none() {
            self.full = None;
            self.without_outlines = None;
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
        if self.drafts && !is_draft && self.without_outlines.is_none() {
            // A draft stays meanwhile; what is no more is not shown until all is done.
            let in_steps = matches!(alike, Some(Some(_)));
            return self.draw_full((gl, renderer), frame, next, in_steps);
        }
        self.shows(next);
        if is_draft {
            return self.draw_draft((gl, renderer), frame, moves && is_large(frame));
        }
        let Some(target) = &self.picture else {
            return Ok(());
        };
        match &self.without_outlines {
            Some(kept) => {
                kept.blit_into(target, kept.rect(), kept.rect())?;
                renderer.draw_outlines_over(frame, target)
            }
            None => renderer.draw(frame, target),
        }
    }

    /// Draws `frame` without samples; a `coarse` draft has half the width and height.
    fn draw_draft(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        frame: &Frame,
        coarse: bool,
    ) -> Result<(), RenderError> {
        let Some(((width, height), target)) = self.size().zip(self.picture.as_ref()) else {
            return Ok(());
        };
        if !coarse {
            self.coarse = None;
            return renderer.draw_moving(frame, target);
        }
        let half = (width.div_ceil(2), height.div_ceil(2));
        let picture = fit(gl, &mut self.coarse, half, 0)?;
        let drawn = renderer.draw_moving(frame, picture);
        picture.blit_into(target, picture.rect(), target.rect())?;
        drawn
    }

    /// Goes on with the full picture of `frame`, by one step where the others may come later, and shows it when
    /// it is complete.
    fn draw_full(
        &mut self,
        (gl, renderer): (&Gl, &mut Renderer),
        frame: &Frame,
        next: Shown,
        in_steps: bool,
    ) -> Result<(), RenderError> {
        let Some((size, target)) = self.size().zip(self.picture.as_ref()) else {
            return Ok(());
        };
        let begun = match self.full.take() {
            Some(begun) => Ok(begun),
            None => GradualPicture::new(gl, size, self.samples),
        };
        let mut full = match begun {
            Ok(full) => full,
            // Edges are rough then, and the rest is there.
            Err(error) => {
                let drawn = renderer.draw(frame, target);
                self.shows(next);
                return drawn.and(Err(error.into()));
            }
        };
        let mut drawn = full.draw_next(renderer, frame);
        while !in_steps && !full.is_complete() {
            drawn = drawn.and(full.draw_next(renderer, frame));
        }
        if !full.is_complete() {
            self.full = Some(full);
            return drawn;
        }
        let picture = full.picture();
        picture.blit_into(target, picture.rect(), picture.rect())?;
        // Without room for it, the next picture is drawn as a whole.
        if let Ok(kept) = Framebuffer::new(gl, size.0, size.1, 0) {
            target.blit_into(&kept, target.rect(), kept.rect())?;
            self.without_outlines = Some(kept);
        }
        let outlines = renderer.draw_outlines_over(frame, target);
        self.shows(next);
        drawn.and(outlines)
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
        self.shown = Some(next);
        self.is_new = true;
    }
}

/// Whether drawing all of `frame` keeps software OpenGL busy for long.
fn is_large(frame: &Frame) -> bool {
    let triangles = frame
        .shapes()
        .map(|(_, it)| it.geometry.mesh.triangles.len());
    triangles.sum::<usize>() > MANY_TRIANGLES
}

/// Revisions of the geometry of each shape.
fn revisions(evaluated: &Evaluated) -> Vec<Revision> {
    let shapes = evaluated.shapes.iter();
    shapes.map(|shape| shape.geometry.revision).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, Poles, SharedMesh, sphere};
    use crate::gpu::{Backend, HeadlessContext};
    use crate::scene::{Evaluator, NewShape, Scene, ShapeId, ShapeKind};
    use glam::Vec3;

    const SIZE: (u32, u32) = (200, 150);

    /// A picture of a scene in a software driver, at a time that only the test moves on.
    struct Viewed {
        headless: HeadlessContext,
        renderer: Renderer,
        picture: ScenePicture,
        document: Revision,
        scene: Scene,
        evaluated: Evaluated,
        view: ViewSettings,
        marks: Marks,
        now: Duration,
    }

    impl Viewed {
        /// Of two balls, with so many triangles each.
        fn new(triangles: u32) -> Self {
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let renderer = Renderer::new(headless.gl()).unwrap();
            let ball = sphere(0.5, 100, triangles / 200, Poles::Y);
            let ball = SharedMesh::new(Mesh::new(ball.positions, ball.triangles));
            let mut scene = Scene::new();
            for x in [-0.7, 0.7] {
                let id = scene.add(NewShape::new("Ball", ShapeKind::Mesh(ball.clone())));
                scene.shape_mut(id).unwrap().placement.transform.position = Vec3::X * x;
            }
            let mut picture = ScenePicture::new(4, true);
            picture.fit(headless.gl(), SIZE).unwrap();
            Self {
                headless,
                renderer,
                picture,
                document: Revision::new(),
                evaluated: Evaluator::new().evaluate(&scene, 0.0),
                scene,
                view: ViewSettings::default(),
                marks: Marks::default(),
                now: Duration::ZERO,
            }
        }

        /// Draws a frame; whether the picture was drawn in it.
        fn frame(&mut self, moves: bool) -> bool {
            let frame = Frame {
                marks: self.marks.clone(),
                ..Frame::plain(&self.scene, &self.evaluated, &self.view)
            };
            let context = (self.headless.gl(), &mut self.renderer);
            let drawn = (self.picture).draw(context, &frame, None, self.document, moves, self.now);
            drawn.unwrap();
            self.picture.take_is_new()
        }

        /// Number of frames without anything moving until the picture is drawn.
        fn frames_until_new(&mut self) -> usize {
            (1..50).find(|_| self.frame(false)).unwrap()
        }

        fn turn_camera(&mut self) {
            self.view.camera.theta += 0.1;
        }

        fn ball(&self, index: usize) -> ShapeId {
            self.scene.shapes()[index].id
        }

        /// Whether the picture is the scene with so many samples.
        fn shows(&mut self, samples: u32) -> bool {
            self.shows_enlarged(SIZE, samples)
        }

        /// Whether it is a picture of this size that was enlarged.
        fn shows_enlarged(&mut self, size: (u32, u32), samples: u32) -> bool {
            let frame = Frame {
                marks: self.marks.clone(),
                ..Frame::plain(&self.scene, &self.evaluated, &self.view)
            };
            let gl = self.headless.gl();
            let drawn = Framebuffer::new(gl, size.0, size.1, samples).unwrap();
            let mut renderer = Renderer::new(gl).unwrap();
            renderer.draw(&frame, &drawn).unwrap();
            let expected = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).unwrap();
            drawn
                .blit_into(&expected, drawn.rect(), expected.rect())
                .unwrap();
            let found = self.picture.picture().unwrap().read_rgba().unwrap();
            found == expected.read_rgba().unwrap()
        }
    }

    #[test]
    fn while_something_moves_there_are_drafts_and_at_rest_the_full_picture_step_by_step() {
        let mut viewed = Viewed::new(80_000);
        assert!(viewed.frame(false) && viewed.shows(4), "the first at once");
        assert!(!viewed.frame(false), "nothing has changed");
        viewed.turn_camera();
        assert!(viewed.frame(true) && viewed.shows(0));
        assert!(!viewed.frame(true), "it may go on");
        assert_eq!(viewed.picture.full_picture_after(viewed.now), REST);
        viewed.now += REST;
        // 160,000 triangles in three steps, and the rest in a fourth.
        for _ in 0..3 {
            assert_eq!(
                viewed.picture.full_picture_after(viewed.now),
                Duration::ZERO
            );
            assert!(!viewed.frame(true), "the draft stays meanwhile");
        }
        assert!(viewed.frame(true) && viewed.shows(4));
        assert_eq!(viewed.picture.full_picture_after(viewed.now), Duration::MAX);
    }

    #[test]
    fn a_full_picture_that_is_under_way_gives_way_to_what_moves_and_takes_in_what_is_under_the_pointer()
     {
        let mut viewed = Viewed::new(80_000);
        viewed.frame(false);
        viewed.turn_camera();
        viewed.frame(true);
        assert!(!viewed.frame(false) && !viewed.frame(false));
        viewed.turn_camera();
        assert!(viewed.frame(true) && viewed.shows(0));
        assert!(!viewed.frame(false) && !viewed.frame(false));
        viewed.marks.hovered = Some(viewed.ball(0));
        assert_eq!(viewed.frames_until_new(), 2, "two steps were done");
        assert!(viewed.shows(4));
        viewed.marks.hovered = Some(viewed.ball(1));
        assert!(viewed.frame(false) && viewed.shows(4), "lines over it");
    }

    #[test]
    fn every_change_of_a_scene_of_many_triangles_is_shown_as_a_draft_first() {
        for (triangles, is_draft) in [(80_000, false), (120_000, true)] {
            let mut viewed = Viewed::new(triangles);
            assert!(viewed.frame(false) && viewed.shows(if is_draft { 0 } else { 4 }));
            if is_draft {
                viewed.frames_until_new();
            }
            viewed.marks.selected = Some(viewed.ball(0));
            assert!(viewed.frame(false) && viewed.shows(if is_draft { 0 } else { 4 }));
            if is_draft {
                viewed.frames_until_new();
            }
            assert!(viewed.shows(4));
            // The line round the shape under the pointer needs none.
            viewed.marks.hovered = Some(viewed.ball(1));
            assert!(viewed.frame(false) && viewed.shows(4));
        }
    }

    #[test]
    fn a_movement_in_a_scene_of_many_triangles_is_shown_in_half_the_width_and_height() {
        let mut viewed = Viewed::new(120_000);
        viewed.frame(false);
        for _ in 0..3 {
            viewed.turn_camera();
            assert!(viewed.frame(true) && viewed.shows_enlarged((100, 75), 0));
        }
        assert!(viewed.frames_until_new() > 3 && viewed.shows(4));
    }
}
