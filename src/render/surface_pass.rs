use super::frame::{Frame, PassContext};
use super::lights::set_lights;
use super::mesh_cache::MeshCache;
use super::mesh_programs::MeshPrograms;
use crate::geometry::Mesh;
use crate::gpu::{Blend, DepthTest, DrawState, Gl, GpuError, Primitive};
use crate::scene::{EvaluatedShape, ModelDisplay, Shape, ShapeKind, SurfaceVisibility};
use glam::{Mat3, Mat4, Vec3};

/// How much of a mesh is seen where its skeleton shows through.
const SEEN_THROUGH: f32 = 0.55;

/// Draws the surfaces of shapes.
#[derive(Debug)]
pub(super) struct SurfacePass {
    programs: MeshPrograms,
}

impl SurfacePass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let fragment = include_str!("../../shaders/surface_fragment.glsl");
        let programs = MeshPrograms::new(gl, "surface", fragment)?;
        Ok(Self { programs })
    }

    /// Gets ready for meshes that the vertex shader moves.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.programs.add_skinned(gl)
    }

    /// Everything that hides what lies behind it.
    pub fn draw_opaque(&self, gl: &Gl, context: &PassContext, frame: &Frame, meshes: &MeshCache) {
        DrawState::opaque(context.width, context.height).apply(gl);
        self.prepare(context, frame);
        for (shape, evaluated) in shapes(frame, ModelDisplay::Mesh) {
            self.draw_mesh(shape, evaluated, meshes, 1.0);
        }
    }

    /// The characters shown together with their skeletons, which are there already. Depth comes
    /// first, so that of every mesh just the nearest surface is blended.
    pub fn draw_translucent(
        &self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
    ) {
        let opaque = DrawState::opaque(context.width, context.height);
        let depth_only = DrawState {
            color_mask: [false; 4],
            ..opaque
        };
        let blended = DrawState {
            depth_test: DepthTest::LessEqual,
            depth_write: false,
            blend: Blend::Alpha,
            ..opaque
        };
        self.prepare(context, frame);
        for (shape, evaluated) in shapes(frame, ModelDisplay::Both) {
            depth_only.apply(gl);
            self.draw_mesh(shape, evaluated, meshes, SEEN_THROUGH);
            blended.apply(gl);
            self.draw_mesh(shape, evaluated, meshes, SEEN_THROUGH);
        }
    }

    fn prepare(&self, context: &PassContext, frame: &Frame) {
        for program in self.programs.all() {
            program.set_mat4("clip_from_world", context.clip_from_world);
            set_lights(program, frame.view.look, &frame.view.camera);
        }
    }

    fn draw_mesh(&self, shape: &Shape, evaluated: &EvaluatedShape, meshes: &MeshCache, alpha: f32) {
        let Some(cached) = meshes.get(shape.id) else {
            return;
        };
        let program = self.programs.of(cached);
        meshes.bind_skin(program, shape.id);
        program.set_mat4("world_from_model", evaluated.world_from_model);
        program.set_mat3(
            "world_from_model_normal",
            normal_matrix(evaluated.world_from_model),
        );
        program.set_i32("flat_normals", i32::from(cached.is_flat()));
        program.set_f32("alpha", alpha);
        let own = shape.placement.color.rgb();
        for (triangles, color) in colored_ranges(&evaluated.geometry.mesh, own) {
            program.set_vec3("color", color);
            let indices = triangles.start as u32 * 3..triangles.end as u32 * 3;
            cached
                .vertex_array
                .draw_indexed(program, Primitive::Triangles, indices);
        }
    }
}

/// Takes normals along: the inverse transpose, so that they stay square to a surface that is
/// scaled unevenly.
pub(super) fn normal_matrix(world_from_model: Mat4) -> Mat3 {
    Mat3::from_mat4(world_from_model).inverse().transpose()
}

/// The shapes whose mesh is drawn in this way; all but characters count as [`ModelDisplay::Mesh`].
fn shapes<'a>(
    frame: &'a Frame,
    mode: ModelDisplay,
) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)> {
    let shapes = frame.scene.shapes().iter().zip(&frame.evaluated.shapes);
    shapes.filter(move |(shape, _)| match &shape.kind {
        ShapeKind::Character(character) => character.display.mode == mode,
        ShapeKind::Curve(curve) => {
            mode == ModelDisplay::Mesh && curve.display.surface == SurfaceVisibility::Shaded
        }
        _ => mode == ModelDisplay::Mesh,
    })
}

/// Runs of triangles with their colors. A material's color is tinted by the shape's own, which
/// starts white, so that the panel's color works on every shape.
fn colored_ranges(mesh: &Mesh, own: Vec3) -> Vec<(std::ops::Range<usize>, Vec3)> {
    let mut ranges = Vec::with_capacity(mesh.groups.len() + 1);
    let mut done = 0;
    for group in &mesh.groups {
        if done < group.triangles.start {
            ranges.push((done..group.triangles.start, own));
        }
        ranges.push((group.triangles.clone(), group.material.color * own));
        done = group.triangles.end;
    }
    if done < mesh.triangles.len() {
        ranges.push((done..mesh.triangles.len(), own));
    }
    ranges
}
