//! Sixteen characters that all move, drawn as this program draws them and as the course's editor does.

use crate::frames::{SCENE, scene};
use crate::report::Report;
use crate::skinning::Course;
use cpu_time::ProcessTime;
use editor_core::character::{Character, Pose};
use editor_core::gpu::{
    Attribute, Backend, Buffer, DrawState, Framebuffer, Gl, HeadlessContext, Primitive, Program,
    Usage, VertexArray,
};
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::math::Euler;
use editor_core::render::{Frame, Renderer};
use editor_core::scene::{Evaluator, Scene, ShapeId, Skinning, ViewSettings};
use glam::{Mat4, Vec3};
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

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
        let mut course = CourseEditor::new(gl, &ours.scene, &ours.view);
        let mut least = (f64::INFINITY, f64::INFINITY);
        for round in 0..ROUNDS {
            let poses = || (round * PICTURES..).take(PICTURES).map(pose);
            least.0 = least.0.min(cost(gl, poses(), |pose| ours.draw(pose)));
            least.1 = least.1.min(cost(gl, poses(), |pose| course.draw(pose)));
        }
        assert_eq!(
            covered(&ours.target),
            covered(&course.target),
            "both draw the same"
        );
        least
    });
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

/// The course's editor: each character is skinned by the loop of the assignment, the corners of all its
/// triangles with their normals are collected and uploaded, and drawn, in each picture anew.
struct CourseEditor {
    gl: Gl,
    character: Arc<Character>,
    world_from_model: Vec<Mat4>,
    clip_from_world: Mat4,
    skinning: Course,
    bind: Vec<Mat4>,
    program: Program,
    corners: Vec<Buffer<[Vec3; 2]>>,
    arrays: Vec<VertexArray>,
    target: Framebuffer,
}

impl CourseEditor {
    fn new(gl: &Gl, scene: &Scene, view: &ViewSettings) -> Self {
        let shapes = scene.shapes();
        let first = scene.character(shapes[0].id).expect("a character");
        let character = Arc::clone(&first.character);
        let skeleton = character.skeleton();
        let world_from_model =
            (shapes.iter()).map(|shape| shape.placement.transform.world_from_model());
        let zeros = vec![[Vec3::ZERO; 2]; character.bind_mesh().triangles.len() * 3];
        let corners: Vec<Buffer<[Vec3; 2]>> = shapes
            .iter()
            .map(|_| Buffer::vertices(gl, Usage::Stream, &zeros).expect("a buffer"))
            .collect();
        let arrays = corners.iter().map(|corners| {
            VertexArray::builder(gl)
                .attribute(corners, Attribute::f32(0, 3))
                .attribute(corners, Attribute::f32(1, 3).offset(12))
                .build()
                .expect("a vertex array")
        });
        Self {
            gl: gl.clone(),
            skinning: Course::new(character.attachments(), skeleton.joints().len()),
            bind: skeleton.update_current_joint_to_world_transforms(&Pose::new()),
            world_from_model: world_from_model.collect(),
            clip_from_world: view.camera.clip_from_world(SIZE.0 as f32 / SIZE.1 as f32),
            program: Program::new(gl, "course", VERTEX, FRAGMENT).expect("a program"),
            arrays: arrays.collect(),
            corners,
            target: Framebuffer::new(gl, SIZE.0, SIZE.1, 0).expect("a picture"),
            character,
        }
    }

    fn draw(&mut self, pose: &Pose) {
        self.target.clear([0.1, 0.1, 0.1, 1.0]);
        DrawState::opaque(SIZE.0, SIZE.1).apply(&self.gl);
        self.program
            .set_mat4("clip_from_world", self.clip_from_world);
        let mesh = self.character.bind_mesh();
        for (at, &world_from_model) in self.world_from_model.iter().enumerate() {
            let skeleton = self.character.skeleton();
            let current = skeleton.update_current_joint_to_world_transforms(pose);
            let mut positions = Vec::new();
            (self.skinning).skin(&current, &self.bind, mesh, &mut positions);
            let mut corners = Vec::with_capacity(mesh.triangles.len() * 3);
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|index| positions[index as usize]);
                let normal = (b - a).cross(c - a).normalize_or_zero();
                corners.extend([[a, normal], [b, normal], [c, normal]]);
            }
            self.corners[at].update(&corners).expect("an upload");
            self.program.set_mat4("world_from_model", world_from_model);
            let count = corners.len() as u32;
            self.arrays[at].draw(&self.program, Primitive::Triangles, 0..count);
        }
    }
}

const VERTEX: &str = "
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_world;
uniform mat4 world_from_model;
out vec3 world_position;
out vec3 world_normal;
void main() {
    vec4 world = world_from_model * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = mat3(world_from_model) * normal;
    gl_Position = clip_from_world * world;
}
";

const FRAGMENT: &str = "
in vec3 world_position;
in vec3 world_normal;
out vec4 fragment_color;
void main() {
    vec3 n = normalize(world_normal);
    vec3 l = normalize(vec3(10.0, 10.0, 30.0) - world_position);
    vec3 v = normalize(-world_position);
    float diffuse = max(dot(n, l), 0.0);
    float specular = pow(max(dot(v, reflect(-l, n)), 0.0), 32.0);
    fragment_color = vec4(vec3(0.0, 0.5, 0.0) * (0.2 + 0.8 * diffuse) + vec3(0.4 * specular), 1.0);
}
";
