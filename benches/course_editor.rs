//! The course's way of drawing characters, made again, and what could be saved of it.

use crate::skinning::Course;
use editor_core::character::{Character, Pose};
use editor_core::gpu::{
    Attribute, Buffer, DrawState, Framebuffer, Gl, IndexBuffer, Primitive, Program, Usage,
    VertexArray,
};
use editor_core::scene::{Scene, ViewSettings};
use glam::{Mat4, Vec3};
use std::sync::Arc;

/// What is saved of the course's way, each by itself.
#[derive(Clone, Copy, Default)]
pub struct Savings {
    /// Triangles that face away from the eye are left out.
    pub culls: bool,
    /// All characters are uploaded and drawn at once.
    pub batches: bool,
    /// Each vertex is uploaded once, without a normal, and found by its index.
    pub indexes: bool,
}

/// The course's editor: each character is skinned by the loop of the assignment, the corners of all its
/// triangles with their normals are collected and uploaded, and drawn, in each picture anew.
pub struct CourseEditor {
    gl: Gl,
    savings: Savings,
    character: Arc<Character>,
    world_from_model: Vec<Mat4>,
    clip_from_world: Mat4,
    eye: Vec3,
    skinning: Course,
    bind: Vec<Mat4>,
    program: Program,
    uploads: Vec<Upload>,
    pub target: Framebuffer,
}

/// Corners of triangles with normals, or vertices without and the indices of the corners.
struct Upload {
    corners: Buffer<[Vec3; 2]>,
    from_corners: VertexArray,
    vertices: Buffer<Vec3>,
    indices: IndexBuffer,
    from_vertices: VertexArray,
}

/// What is drawn at once, in world space.
#[derive(Default)]
struct Collected {
    corners: Vec<[Vec3; 2]>,
    vertices: Vec<Vec3>,
    indices: Vec<u32>,
}

impl Upload {
    fn new(gl: &Gl) -> Self {
        let corners = Buffer::vertices(gl, Usage::Stream, &[]).expect("a buffer");
        let vertices = Buffer::vertices(gl, Usage::Stream, &[]).expect("a buffer");
        let indices = IndexBuffer::new(gl, Usage::Stream, &[]).expect("a buffer");
        let from_corners = VertexArray::builder(gl)
            .attribute(&corners, Attribute::f32(0, 3))
            .attribute(&corners, Attribute::f32(1, 3).offset(12));
        let from_vertices = VertexArray::builder(gl)
            .attribute(&vertices, Attribute::f32(0, 3))
            .indices(&indices);
        Self {
            from_corners: from_corners.build().expect("a vertex array"),
            from_vertices: from_vertices.build().expect("a vertex array"),
            corners,
            vertices,
            indices,
        }
    }

    fn draw(&self, program: &Program, collected: &Collected) {
        let Collected {
            corners,
            vertices,
            indices,
        } = collected;
        if indices.is_empty() {
            self.corners.update(corners).expect("an upload");
            let count = corners.len() as u32;
            (self.from_corners).draw(program, Primitive::Triangles, 0..count);
        } else {
            self.vertices.update(vertices).expect("an upload");
            self.indices.update(indices).expect("an upload");
            let count = indices.len() as u32;
            (self.from_vertices).draw_indexed(program, Primitive::Triangles, 0..count);
        }
    }
}

impl CourseEditor {
    /// One for the characters of `scene`, all of them copies of one.
    pub fn new(
        gl: &Gl,
        scene: &Scene,
        view: &ViewSettings,
        (width, height): (u32, u32),
        savings: Savings,
    ) -> Self {
        let shapes = scene.shapes();
        let first = scene.character(shapes[0].id).expect("a character");
        let character = Arc::clone(&first.character);
        let skeleton = character.skeleton();
        let world_from_model =
            (shapes.iter()).map(|shape| shape.placement.transform.world_from_model());
        let uploads = if savings.batches { 1 } else { shapes.len() };
        let fragment = if savings.indexes {
            FACE_NORMAL
        } else {
            CORNER_NORMAL
        };
        let fragment = format!("{fragment}{FRAGMENT}");
        Self {
            gl: gl.clone(),
            savings,
            skinning: Course::new(character.attachments(), skeleton.joints().len()),
            bind: skeleton.update_current_joint_to_world_transforms(&Pose::new()),
            world_from_model: world_from_model.collect(),
            clip_from_world: view.camera.clip_from_world(width as f32 / height as f32),
            eye: view.camera.eye(),
            program: Program::new(gl, "course", VERTEX, &fragment).expect("a program"),
            uploads: (0..uploads).map(|_| Upload::new(gl)).collect(),
            target: Framebuffer::new(gl, width, height, 0).expect("a picture"),
            character,
        }
    }

    pub fn draw(&mut self, pose: &Pose) {
        self.target.clear([0.1, 0.1, 0.1, 1.0]);
        let (width, height) = (self.target.width(), self.target.height());
        DrawState::opaque(width, height).apply(&self.gl);
        self.program
            .set_mat4("clip_from_world", self.clip_from_world);
        let mut collected = Collected::default();
        for (at, &world_from_model) in self.world_from_model.iter().enumerate() {
            // Characters that share a draw have no matrix of their own in it.
            let (collected_from_model, world_from_collected) = if self.savings.batches {
                (world_from_model, Mat4::IDENTITY)
            } else {
                (Mat4::IDENTITY, world_from_model)
            };
            self.collect(
                pose,
                collected_from_model,
                world_from_collected,
                &mut collected,
            );
            if !self.savings.batches {
                self.program
                    .set_mat4("world_from_model", world_from_collected);
                self.uploads[at].draw(&self.program, &collected);
                collected = Collected::default();
            }
        }
        if self.savings.batches {
            self.program.set_mat4("world_from_model", Mat4::IDENTITY);
            self.uploads[0].draw(&self.program, &collected);
        }
    }

    /// Adds a character in `pose` to what is drawn at once.
    fn collect(
        &self,
        pose: &Pose,
        collected_from_model: Mat4,
        world_from_collected: Mat4,
        collected: &mut Collected,
    ) {
        let (skeleton, mesh) = (self.character.skeleton(), self.character.bind_mesh());
        let current = skeleton.update_current_joint_to_world_transforms(pose);
        let mut positions = Vec::new();
        (self.skinning).skin(&current, &self.bind, mesh, &mut positions);
        if self.savings.batches {
            for position in &mut positions {
                *position = collected_from_model.transform_point3(*position);
            }
        }
        let eye = world_from_collected.inverse().transform_point3(self.eye);
        let first = collected.vertices.len() as u32;
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|index| positions[index as usize]);
            let across = (b - a).cross(c - a);
            if self.savings.culls && across.dot(eye - a) <= 0.0 {
                continue;
            }
            if self.savings.indexes {
                collected
                    .indices
                    .extend(triangle.map(|index| first + index));
            } else {
                let normal = across.normalize_or_zero();
                let corners = [[a, normal], [b, normal], [c, normal]];
                collected.corners.extend(corners);
            }
        }
        if self.savings.indexes {
            collected.vertices.append(&mut positions);
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

const CORNER_NORMAL: &str = "
in vec3 world_position;
in vec3 world_normal;
vec3 normal() { return normalize(world_normal); }
";

const FACE_NORMAL: &str = "
in vec3 world_position;
vec3 normal() { return normalize(cross(dFdx(world_position), dFdy(world_position))); }
";

const FRAGMENT: &str = "
out vec4 fragment_color;
void main() {
    vec3 n = normal();
    vec3 l = normalize(vec3(10.0, 10.0, 30.0) - world_position);
    vec3 v = normalize(-world_position);
    float diffuse = max(dot(n, l), 0.0);
    float specular = pow(max(dot(v, reflect(-l, n)), 0.0), 32.0);
    fragment_color = vec4(vec3(0.0, 0.5, 0.0) * (0.2 + 0.8 * diffuse) + vec3(0.4 * specular), 1.0);
}
";
