use super::background_pass::whole_picture;
use super::frame::PassContext;
use super::lights::MANNEQUIN_LIGHT;
use crate::gpu::{DepthTest, DrawState, Gl, GpuError, Primitive, Program, VertexArray};
use crate::scene::Camera;

/// Height of the floor in the world, and the side of a tile.
const HEIGHT: f32 = -2.0;
const TILE: f32 = 5.0;

/// The Mannequin look's floor: black and white tiles to the horizon.
#[derive(Debug)]
pub(super) struct FloorPass {
    program: Program,
    whole_picture: VertexArray,
}

impl FloorPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        Ok(Self {
            program: Program::new(
                gl,
                "floor",
                include_str!("../../shaders/floor_vertex.glsl"),
                include_str!("../../shaders/floor_fragment.glsl"),
            )?,
            whole_picture: whole_picture(gl)?,
        })
    }

    /// Drawn first: it hides what is below it, and is hidden by what stands on it.
    pub fn draw(&self, gl: &Gl, context: &PassContext, camera: &Camera) {
        let state = DrawState {
            depth_test: DepthTest::Always,
            ..DrawState::opaque(context.width, context.height)
        };
        state.apply(gl);
        let half_height = (camera.fovy * 0.5).tan();
        let half_width = half_height * context.width as f32 / context.height as f32;
        let program = &self.program;
        let ahead = camera.up().cross(camera.right());
        program.set_vec3("ahead", ahead);
        program.set_vec3("across", camera.right() * half_width);
        program.set_vec3("upwards", camera.up() * half_height);
        program.set_vec3("eye", camera.eye());
        program.set_vec3("light", MANNEQUIN_LIGHT);
        program.set_f32("height", HEIGHT);
        program.set_f32("tile", TILE);
        program.set_f32("near", camera.near);
        program.set_f32("far", camera.far);
        self.whole_picture.draw(program, Primitive::Triangles, 0..3);
    }
}
