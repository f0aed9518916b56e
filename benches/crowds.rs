//! Crowds: copies of one character with poses of their own, all in view.

use crate::moving::pose;
use crate::report::Report;
use cpu_time::ProcessTime;
use editor_core::gpu::{Backend, Framebuffer, HeadlessContext};
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::render::{Frame, RenderError, Renderer};
use editor_core::scene::{Evaluator, FitArea, Scene, ShapeId, ViewSettings};
use std::collections::HashMap;
use std::path::Path;

const SIZE: (u32, u32) = (800, 600);
const COUNTS: [usize; 4] = [1, 16, 100, 1000];
const ROUNDS: usize = 3;

pub fn run(report: &mut Report) {
    report.growth(
        "Drawing characters while the camera turns",
        "characters",
        1.05,
        || {
            let cost = |count| Crowd::new(count).least(Crowd::turn);
            COUNTS.map(|count| (count as f64, cost(count))).to_vec()
        },
    );
    report.ratio(
        "A character that moves among 1,000 against one alone, drawn as while it is dragged",
        1.3,
        || {
            let least = |count| Crowd::new(count).least(Crowd::move_one);
            (least(1000), least(1))
        },
    );
    report.ratio(
        "1,000 characters out of sight against one that is seen",
        0.2,
        || {
            let away = Crowd::new(1000).least(Crowd::look_away);
            (away, Crowd::new(1).least(Crowd::turn))
        },
    );
}

/// Copies of one character, and all that draws them.
pub struct Crowd {
    scene: Scene,
    view: ViewSettings,
    evaluator: Evaluator,
    renderer: Renderer,
    target: Framebuffer,
    pub headless: HeadlessContext,
    /// Number of pictures drawn so far.
    drawn: usize,
}

impl Crowd {
    /// So many adults in rows, each in another pose.
    pub fn new(count: usize) -> Self {
        let side = (count as f64).sqrt().ceil() as usize;
        let shapes: Vec<String> = (0..count)
            .map(|number| {
                let [x, z] = [number % side, number / side].map(|at| at as f64 - side as f64 * 0.5);
                format!(r#"{{"source": "builtin:adult", "position": [{x}, 0, {z}]}}"#)
            })
            .collect();
        let text = format!(
            r#"{{"format": "editor-scene", "version": 1, "view": {{"look": "course"}}, "shapes": [{}]}}"#,
            shapes.join(", ")
        );
        let path = Path::new("bench.scene");
        let files = HashMap::from([(path.to_owned(), text.into_bytes())]);
        let mut loaded = Loaded::default();
        loaded.add(&WithBuiltin(files), path).expect("a scene");
        let mut scene = Scene::new();
        for shape in loaded.shapes {
            scene.add(shape);
        }
        let mut view = loaded.view.expect("the scene's view");
        (view.camera.theta, view.camera.phi) = (1.2, 0.4);
        let bounds = Evaluator::new().evaluate(&scene, 0.0).world_bounds();
        let area = FitArea::whole(SIZE.0 as f32 / SIZE.1 as f32);
        view.camera.fit(&bounds, area);
        let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
        let gl = headless.gl();
        let mut crowd = Self {
            renderer: Renderer::new(gl).expect("a renderer"),
            target: Framebuffer::new(gl, SIZE.0, SIZE.1, 0).expect("a picture"),
            evaluator: Evaluator::new(),
            drawn: 0,
            scene,
            view,
            headless,
        };
        for number in 0..count {
            crowd.pose(number, number);
        }
        crowd
    }

    fn pose(&mut self, index: usize, number: usize) {
        let id: ShapeId = self.scene.shapes()[index].id;
        let character = self.scene.character_mut(id).expect("a character");
        character.set_pose(pose(number));
    }

    fn turn(&mut self) {
        self.view.camera.theta += 0.01;
        self.draw(Renderer::draw);
    }

    fn move_one(&mut self) {
        self.pose(self.scene.shapes().len() / 2, 5000 + self.drawn);
        self.draw(Renderer::draw_moving);
    }

    /// Number of vertices of all of them.
    pub fn vertices(&self) -> usize {
        let characters = self.scene.shapes().iter();
        let characters = characters.filter_map(|shape| self.scene.character(shape.id));
        characters
            .map(|it| it.character.bind_mesh().positions.len())
            .sum()
    }

    /// Draws all of them in poses in which none was before.
    pub fn move_all(&mut self) {
        for number in 0..self.scene.shapes().len() {
            self.pose(number, number + self.drawn + 1);
        }
        self.draw(Renderer::draw);
    }

    fn look_away(&mut self) {
        self.view.camera.target.x += 500.0;
        self.draw(Renderer::draw);
    }

    fn draw(
        &mut self,
        by: impl FnOnce(&mut Renderer, &Frame, &Framebuffer) -> Result<(), RenderError>,
    ) {
        let evaluated = self.evaluator.evaluate(&self.scene, 0.0);
        let frame = Frame::plain(&self.scene, &evaluated, &self.view);
        by(&mut self.renderer, &frame, &self.target).expect("a drawn frame");
        self.drawn += 1;
    }

    /// The least CPU time of a picture, in milliseconds, after two that upload what stays.
    fn least(mut self, mut step: impl FnMut(&mut Self)) -> f64 {
        let mut least = f64::INFINITY;
        for round in 0..ROUNDS + 2 {
            let start = ProcessTime::now();
            step(&mut self);
            self.headless.gl().finish();
            let cost = start.elapsed().as_secs_f64() * 1e3;
            if round >= 2 {
                least = least.min(cost);
            }
        }
        least
    }
}
