use super::frame::PassContext;
use crate::gpu::{
    Attribute, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive, Program, Usage,
    VertexArray,
};
use crate::scene::Look;
use glam::{Vec2, Vec3};

/// The course's background: 0.1, which is 26 of 255.
const COURSE: f32 = 0.1;
const STUDIO_TOP: Vec3 = Vec3::new(0.30, 0.33, 0.37);
const STUDIO_BOTTOM: Vec3 = Vec3::new(0.12, 0.13, 0.15);

/// The Mannequin look's.
const TEAL: [f32; 4] = [0.0, 0.3725, 0.3725, 1.0];

/// Clears the picture: one color in the Course and Mannequin looks, a vertical gradient in the
/// Studio look.
#[derive(Debug)]
pub(super) struct BackgroundPass {
    program: Program,
    triangle: VertexArray,
}

impl BackgroundPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let program = Program::new(
            gl,
            "background",
            include_str!("../../shaders/whole_picture_vertex.glsl"),
            include_str!("../../shaders/background_fragment.glsl"),
        )?;
        Ok(Self {
            program,
            triangle: whole_picture(gl)?,
        })
    }

    pub fn draw(&self, gl: &Gl, context: &PassContext, look: Look, target: &Framebuffer) {
        match look {
            Look::Mannequin => target.clear(TEAL),
            Look::Course | Look::Studio => target.clear([COURSE, COURSE, COURSE, 1.0]),
        }
        if look != Look::Studio {
            return;
        }
        let state = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(context.width, context.height)
        };
        state.apply(gl);
        self.program.set_vec3("top", STUDIO_TOP);
        self.program.set_vec3("bottom", STUDIO_BOTTOM);
        self.triangle
            .draw(&self.program, Primitive::Triangles, 0..3);
    }
}

/// One triangle that covers the whole picture, in clip space.
pub(super) fn whole_picture(gl: &Gl) -> Result<VertexArray, GpuError> {
    let corners = [
        Vec2::new(-1.0, -1.0),
        Vec2::new(3.0, -1.0),
        Vec2::new(-1.0, 3.0),
    ];
    let buffer = Buffer::vertices(gl, Usage::Static, &corners)?;
    VertexArray::builder(gl)
        .attribute(&buffer, Attribute::f32(0, 2))
        .build()
}
