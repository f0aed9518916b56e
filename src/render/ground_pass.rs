use super::frame::PassContext;
use crate::gpu::{
    Attribute, Blend, Buffer, DrawState, Framebuffer, Gl, GpuError, Primitive, Program, Usage,
    VertexArray,
};
use crate::scene::Camera;
use glam::Vec2;

/// Texture unit of the shadows.
const SHADOWS: u32 = 0;
/// How much of what is behind the ground its light covers, in the middle.
const LIT: f32 = 0.6;
/// How far the edge of a shadow fades, in the world.
const SOFTNESS: f32 = 0.07;

/// The Studio look's ground: a grid, one unit wide, every tenth line stronger,
/// and shadows with soft edges.
#[derive(Debug)]
pub(super) struct GroundPass {
    program: Program,
    square: VertexArray,
}

impl GroundPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let program = Program::new(
            gl,
            "ground",
            include_str!("../../shaders/ground_vertex.glsl"),
            include_str!("../../shaders/ground_fragment.glsl"),
        )?;
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
        let buffer = Buffer::vertices(gl, Usage::Static, &corners.map(|(x, z)| Vec2::new(x, z)))?;
        let square = VertexArray::builder(gl)
            .attribute(&buffer, Attribute::f32(0, 2))
            .build()?;
        Ok(Self { program, square })
    }

    /// Drawn after everything opaque, since it lets through what lies behind it.
    /// `shadows` is a picture as large as `target`, white where the ground has no light.
    pub fn draw(
        &self,
        gl: &Gl,
        context: &PassContext,
        camera: &Camera,
        shadows: Option<&Framebuffer>,
        target: &Framebuffer,
    ) {
        if let Some(shadows) = shadows {
            shadows.bind_texture_with_mipmaps(SHADOWS);
        }
        target.bind();
        let state = DrawState {
            depth_write: false,
            blend: Blend::Premultiplied,
            ..DrawState::opaque(context.width, context.height)
        };
        state.apply(gl);
        // Reaches as far as it can be told from the horizon, and follows the camera. The far plane
        // may be nearer than the least of it.
        let reach = (camera.radius * 12.0).max(20.0).min(camera.far);
        self.program
            .set_mat4("clip_from_world", context.clip_from_world);
        self.program
            .set_vec2("center", Vec2::new(camera.target.x, camera.target.z));
        self.program.set_f32("reach", reach);
        self.program.set_f32("height", context.ground);
        self.program.set_sampler("shadows", SHADOWS);
        self.program
            .set_i32("has_shadows", i32::from(shadows.is_some()));
        self.program.set_f32("softness", SOFTNESS);
        let is_above = camera.eye().y > context.ground;
        let lit = if is_above { LIT } else { 0.0 };
        self.program.set_f32("lit", lit);
        self.square
            .draw(&self.program, Primitive::TriangleStrip, 0..4);
    }
}
