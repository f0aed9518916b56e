//! Sixteen characters that all move, drawn as this program draws them and as the course's editor does.

use crate::course_editor::{CourseEditor, Savings};
use crate::frames::{SCENE, scene};
use crate::report::Report;
use cpu_time::ProcessTime;
use editor_core::character::Pose;
use editor_core::gpu::{Backend, Framebuffer, Gl, HeadlessContext};
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::math::Euler;
use editor_core::render::{Frame, Renderer};
use editor_core::scene::{Evaluator, Scene, ShapeId, Skinning, ViewSettings};
use glam::Vec3;
use std::collections::HashMap;
use std::path::Path;

const COUNT: usize = 16;
const SIZE: (u32, u32) = (800, 600);
const ROUNDS: usize = 7;
/// Pictures of a round.
const PICTURES: usize = 4;

pub fn run(report: &mut Report) {
    let what = "16 characters that all move against the course's way of drawing them";
    report.ratio(what, 0.5, || {
        let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
        let gl = headless.gl();
        let mut ours = Ours::new(gl);
        let mut course = CourseEditor::new(gl, &ours.scene, &ours.view, SIZE, Savings::default());
        let least = against(gl, |pose| ours.draw(pose), |pose| course.draw(pose));
        assert_eq!(
            covered(&ours.target),
            covered(&course.target),
            "both draw the same"
        );
        least
    });
    let none = Savings::default();
    #[rustfmt::skip]
    let savings = [
        ("without the triangles that face away", Savings { culls: true, ..none }),
        ("in one draw", Savings { batches: true, ..none }),
        ("with each vertex fetched by its index, without a normal", Savings { indexes: true, ..none }),
        ("with all three of these", Savings { culls: true, batches: true, indexes: true }),
    ];
    for (saving, savings) in savings {
        let what = format!("The course's way of drawing 16 characters {saving} against as it is");
        report.ratio(&what, 1.0, || course_against_itself(savings));
    }
}

/// Costs of the course's way with and without `savings`, in milliseconds.
fn course_against_itself(savings: Savings) -> (f64, f64) {
    let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
    let gl = headless.gl();
    let Ours { scene, view, .. } = Ours::new(gl);
    let mut saving = CourseEditor::new(gl, &scene, &view, SIZE, savings);
    let mut plain = CourseEditor::new(gl, &scene, &view, SIZE, Savings::default());
    let least = against(gl, |pose| saving.draw(pose), |pose| plain.draw(pose));
    let (one, other) = (covered(&saving.target), covered(&plain.target));
    // Where a pose turns a part inside out, triangles that face away are seen.
    let differing = one.abs_diff(other) as f64 / other as f64;
    let most = if savings.culls { 1e-3 } else { 0.0 };
    assert!(differing <= most, "{one} and {other} pixels are covered");
    least
}

/// The least CPU times of a picture drawn by `one` and by `other`, in milliseconds, in turns.
fn against(gl: &Gl, mut one: impl FnMut(&Pose), mut other: impl FnMut(&Pose)) -> (f64, f64) {
    let mut least = (f64::INFINITY, f64::INFINITY);
    for round in 0..ROUNDS {
        let poses = || (round * PICTURES..).take(PICTURES).map(pose);
        least.0 = least.0.min(cost(gl, poses(), &mut one));
        least.1 = least.1.min(cost(gl, poses(), &mut other));
    }
    least
}

/// CPU time of a picture of each pose, in milliseconds.
fn cost(gl: &Gl, poses: impl Iterator<Item = Pose>, mut draw: impl FnMut(&Pose)) -> f64 {
    let poses: Vec<Pose> = poses.collect();
    let start = ProcessTime::now();
    for pose in &poses {
        draw(pose);
        gl.finish();
    }
    start.elapsed().as_secs_f64() * 1e3 / poses.len() as f64
}

/// A pose in which every joint of the adult has turned.
pub fn pose(number: usize) -> Pose {
    let mut pose = Pose::new();
    for joint in 0..18 {
        let turn = (number as f32 * 0.7 + joint as f32).sin();
        let angles = Vec3::new(10.0, -20.0, 7.0) * turn;
        pose.set_joint_transform(joint, Euler::from_degrees(angles));
    }
    pose
}

/// Number of pixels that are not of the background.
fn covered(target: &Framebuffer) -> usize {
    let rgba = target.read_rgba().expect("the picture");
    let background = &rgba[..4].to_vec();
    rgba.chunks_exact(4)
        .filter(|pixel| pixel != background)
        .count()
}

struct Ours {
    scene: Scene,
    view: ViewSettings,
    evaluator: Evaluator,
    renderer: Renderer,
    target: Framebuffer,
}

impl Ours {
    fn new(gl: &Gl) -> Self {
        let mut loaded = Loaded::default();
        let text = scene(COUNT, "course");
        let path = Path::new(SCENE);
        let files = HashMap::from([(path.to_owned(), text.into_bytes())]);
        loaded.add(&WithBuiltin(files), path).expect("a scene");
        let mut scene = Scene::new();
        for shape in loaded.shapes {
            scene.add(shape);
        }
        let mut renderer = Renderer::new(gl).expect("a renderer");
        renderer.set_skinning(Some(Skinning::Cpu));
        Self {
            scene,
            view: ViewSettings {
                axis: false,
                ..loaded.view.expect("the scene's view")
            },
            evaluator: Evaluator::new(),
            renderer,
            target: Framebuffer::new(gl, SIZE.0, SIZE.1, 0).expect("a picture"),
        }
    }

    fn draw(&mut self, pose: &Pose) {
        let shapes: Vec<ShapeId> = self.scene.shapes().iter().map(|shape| shape.id).collect();
        for id in shapes {
            let character = self.scene.character_mut(id).expect("a character");
            character.set_pose(pose.clone());
        }
        let evaluated = self.evaluator.evaluate(&self.scene, 0.0);
        let frame = Frame::plain(&self.scene, &evaluated, &self.view);
        self.renderer
            .draw(&frame, &self.target)
            .expect("a drawn frame");
    }
}
