//! Drafts, and the full pictures that follow them.

use super::draft_detail::Detail;
use super::scene_picture::{Asked, REST, ScenePicture};
use crate::geometry::{Mesh, Poles, SharedMesh, sphere};
use crate::gpu::{Backend, Framebuffer, HeadlessContext};
use crate::render::{Frame, Marks, Passes, RenderError, Renderer};
use crate::revision::Revision;
use crate::scene::{Evaluated, Evaluator, Look, NewShape, Scene, ShapeId, ShapeKind, ViewSettings};
use glam::Vec3;
use std::time::Duration;

const SIZE: (u32, u32) = (200, 150);
const HALF: (u32, u32) = (100, 75);

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
    last_frame: Option<Duration>,
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
        let mut picture = ScenePicture::new(4, Some(Detail::Fine));
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
            last_frame: None,
        }
    }

    /// Draws a frame; whether the picture was drawn in it.
    fn frame(&mut self, moves: bool) -> bool {
        let frame = Frame {
            marks: self.marks.clone(),
            ..Frame::plain(&self.scene, &self.evaluated, &self.view)
        };
        let context = (self.headless.gl(), &mut self.renderer);
        let asked = Asked {
            frame: &frame,
            right: None,
            document: self.document,
            moves,
            now: self.now,
            last_frame: self.last_frame,
        };
        self.picture.draw(context, &asked).unwrap();
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
        self.shows_drawn(size, samples, Renderer::draw)
    }

    /// Whether it is one of half the width and height with fewer triangles, drawn by these `passes`.
    fn shows_coarse(&mut self, passes: Passes) -> bool {
        self.shows_drawn(HALF, 0, |renderer, frame, target| {
            renderer.draw_coarse(frame, target, passes)
        })
    }

    /// Whether it is what `draw` draws in this size, enlarged.
    fn shows_drawn(
        &mut self,
        size: (u32, u32),
        samples: u32,
        draw: impl FnOnce(&mut Renderer, &Frame, &Framebuffer) -> Result<(), RenderError>,
    ) -> bool {
        let frame = Frame {
            marks: self.marks.clone(),
            ..Frame::plain(&self.scene, &self.evaluated, &self.view)
        };
        let gl = self.headless.gl();
        let drawn = Framebuffer::new(gl, size.0, size.1, samples).unwrap();
        let mut renderer = Renderer::new(gl).unwrap();
        draw(&mut renderer, &frame, &drawn).unwrap();
        let expected = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).unwrap();
        drawn
            .blit_into(&expected, drawn.rect(), expected.rect())
            .unwrap();
        let found = self.picture.enlarged().unwrap().unwrap();
        let found = found.read_rgba().unwrap();
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
    // 160,000 triangles in seven steps, what comes after the surfaces, the mean of the samples, and the lines round
    // shapes.
    for _ in 0..9 {
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
    assert!(!viewed.frame(false));
    let next = viewed.picture.full_picture_after(viewed.now);
    assert_eq!(next, Duration::ZERO, "the end of a drag needs no rest");
    assert!(!viewed.frame(false));
    viewed.turn_camera();
    assert!(viewed.frame(true) && viewed.shows(0));
    assert!(!viewed.frame(false) && !viewed.frame(false));
    viewed.marks.hovered = Some(viewed.ball(0));
    assert_eq!(viewed.frames_until_new(), 8, "two steps were done");
    assert!(viewed.shows(4));
    viewed.marks.hovered = Some(viewed.ball(1));
    assert!(viewed.frame(false) && viewed.shows(4), "lines over it");
}

#[test]
fn every_change_of_a_scene_of_many_triangles_is_shown_as_a_draft_first() {
    for (triangles, is_draft) in [(80_000, false), (120_000, true)] {
        let mut viewed = Viewed::new(triangles);
        let is_as_expected = |viewed: &mut Viewed| match is_draft {
            true => viewed.shows_coarse(Passes::All) && !viewed.shows_enlarged(HALF, 0),
            false => viewed.shows(4),
        };
        assert!(viewed.frame(false) && is_as_expected(&mut viewed));
        if is_draft {
            viewed.frames_until_new();
        }
        viewed.marks.selected = Some(viewed.ball(0));
        assert!(viewed.frame(false) && is_as_expected(&mut viewed));
        if is_draft {
            viewed.frames_until_new();
        }
        assert!(viewed.shows(4));
        // The line round the shape under the pointer needs none.
        viewed.marks.hovered = Some(viewed.ball(1));
        let steps = if is_draft { 2 } else { 1 };
        assert_eq!(viewed.frames_until_new(), steps);
        assert!(viewed.shows(4));
    }
}

#[test]
fn the_line_round_a_shape_of_many_triangles_comes_in_steps() {
    let mut viewed = Viewed::new(240_000);
    viewed.frame(false);
    viewed.frames_until_new();
    assert!(viewed.shows(4));
    viewed.marks.hovered = Some(viewed.ball(0));
    assert!(!viewed.frame(false), "what is shown stays meanwhile");
    let next = viewed.picture.full_picture_after(viewed.now);
    assert_eq!(next, Duration::ZERO);
    viewed.marks.hovered = Some(viewed.ball(1));
    assert!(!viewed.frame(false), "another one begins anew");
    assert!(viewed.frame(false) && viewed.shows(4));
    let next = viewed.picture.full_picture_after(viewed.now);
    assert_eq!(next, Duration::MAX);
    viewed.marks.hovered = Some(viewed.ball(0));
    assert!(!viewed.frame(false));
    viewed.marks.hovered = Some(viewed.ball(1));
    assert!(
        !viewed.frame(false) && viewed.shows(4),
        "it is shown already"
    );
    let next = viewed.picture.full_picture_after(viewed.now);
    assert_eq!(next, Duration::MAX);
}

#[test]
fn a_movement_in_a_scene_of_many_triangles_is_shown_with_fewer_unless_there_is_time_for_all() {
    let mut viewed = Viewed::new(120_000);
    viewed.frame(false);
    let turned = |viewed: &mut Viewed, milliseconds| {
        viewed.last_frame = Some(Duration::from_millis(milliseconds));
        viewed.turn_camera();
        assert!(viewed.frame(true));
    };
    for _ in 0..3 {
        turned(&mut viewed, 50);
        assert!(viewed.shows_coarse(Passes::All));
    }
    for _ in 0..20 {
        turned(&mut viewed, 10);
    }
    assert!(
        viewed.shows_enlarged(HALF, 0),
        "all pixels would take too long"
    );
    for _ in 0..20 {
        turned(&mut viewed, 130);
    }
    assert!(viewed.shows_coarse(Passes::Sketch));
    viewed.now += REST;
    viewed.last_frame = None;
    assert!(viewed.frames_until_new() > 3 && viewed.shows(4));
}

#[test]
fn what_is_added_to_a_scene_of_many_triangles_is_shown_with_fewer_first() {
    let mut viewed = Viewed::new(120_000);
    viewed.frame(false);
    for _ in 0..20 {
        viewed.last_frame = Some(Duration::from_millis(10));
        viewed.turn_camera();
        viewed.frame(true);
    }
    assert!(viewed.shows_enlarged(HALF, 0));
    let ball = viewed.scene.shapes()[0].kind.clone();
    for _ in 0..3 {
        viewed.scene.add(NewShape::new("Ball", ball.clone()));
    }
    viewed.evaluated = Evaluator::new().evaluate(&viewed.scene, 0.0);
    viewed.document = Revision::new();
    assert!(viewed.frame(false) && viewed.shows_coarse(Passes::All));
}

#[test]
fn where_movements_follow_the_hand_badly_they_are_shown_in_half_the_width_and_height() {
    let mut viewed = Viewed::new(20_000);
    viewed.frame(false);
    let mut turned = |milliseconds| {
        viewed.last_frame = Some(Duration::from_millis(milliseconds));
        viewed.turn_camera();
        assert!(viewed.frame(true));
        viewed.shows_enlarged(HALF, 0)
    };
    assert!((0..20).all(|_| !turned(30)));
    assert!((0..20).any(|_| turned(130)) && turned(60));
    assert!((0..20).any(|_| !turned(15)) && !turned(15));
    // Frames without a draft take as long as they like.
    for _ in 0..20 {
        viewed.last_frame = Some(Duration::from_secs(1));
        viewed.frame(false);
    }
    viewed.last_frame = Some(Duration::from_millis(15));
    viewed.turn_camera();
    assert!(viewed.frame(true) && viewed.shows(0));
}

#[test]
fn where_that_is_not_enough_shadows_and_outlines_wait_for_the_end_of_a_turn() {
    let mut viewed = Viewed::new(20_000);
    viewed.view.look = Look::Studio;
    viewed.view.grid = true;
    viewed.frame(false);
    viewed.marks.selected = Some(viewed.ball(0));
    let turned = |viewed: &mut Viewed, milliseconds| {
        viewed.last_frame = Some(Duration::from_millis(milliseconds));
        viewed.turn_camera();
        assert!(viewed.frame(true));
        let without_line = |viewed: &mut Viewed| {
            let marks = std::mem::take(&mut viewed.marks);
            let shows = viewed.shows_enlarged(HALF, 0);
            viewed.marks = marks;
            shows
        };
        (viewed.shows_enlarged(HALF, 0), without_line(viewed))
    };
    assert!((0..20).any(|_| turned(&mut viewed, 130).0));
    // Neither the picture with all, nor the one without the line alone: the shadows are missing, too.
    assert!((0..20).any(|_| turned(&mut viewed, 130) == (false, false)));
    viewed.now += REST;
    viewed.last_frame = None;
    viewed.frames_until_new();
    assert!(viewed.shows(4));
    assert!((0..20).any(|_| turned(&mut viewed, 15).0));
}
