//! The passes before the shapes: the background, the Mannequin look's floor, and the axes.

use super::frame::{Background, PassContext};
use super::surface_pass::MANNEQUIN_LIGHT;
use crate::gpu::{
    Attribute, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, Immediate, Mode, Primitive,
    Program, Usage, VertexArray,
};
use crate::scene::{Camera, Look};
use glam::{Vec2, Vec3};

/// Gray of the course's background: 0.1, which is 26 of 255.
pub(super) const COURSE: f32 = 0.1;

/// The Mannequin look's background.
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
        let program = Program::when_used(
            gl,
            "background",
            include_str!("../../shaders/whole_picture_vertex.glsl"),
            include_str!("../../shaders/background_fragment.glsl"),
        );
        Ok(Self {
            program,
            triangle: whole_picture(gl)?,
        })
    }

    pub fn draw(&self, gl: &Gl, context: &PassContext, look: Look, target: &Framebuffer) {
        if context.background == Background::Transparent {
            target.clear([0.0; 4]);
            return;
        }
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
        set_gradient(&self.program, context);
        self.triangle
            .draw(&self.program, Primitive::Triangles, 0..3);
    }
}

/// Sets the colors of the Studio look's background, from the bottom of the picture to its top.
pub(super) fn set_gradient(program: &Program, context: &PassContext) {
    program.set_vec3("top", context.colors.top);
    program.set_vec3("bottom", context.colors.bottom);
    let (half, center) = context.tile.in_picture();
    program.set_f32("lowest", 0.5 * (center.y + 1.0 - half.y));
    program.set_f32("part", half.y);
}

/// Height of the floor in the world, unless shapes reach below: it would hide them.
const FLOOR_HEIGHT: f32 = -2.0;
/// Side of a tile in the world.
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
            program: Program::when_used(
                gl,
                "floor",
                include_str!("../../shaders/floor_vertex.glsl"),
                include_str!("../../shaders/floor_fragment.glsl"),
            ),
            whole_picture: whole_picture(gl)?,
        })
    }

    /// Draws it, before everything else: it covers what is below it, and what stands on it covers it.
    pub fn draw(&self, gl: &Gl, context: &PassContext, camera: &Camera) {
        let height = context.ground.min(FLOOR_HEIGHT);
        // From below the floor would hide all that stands on it.
        if camera.eye().y < height {
            return;
        }
        let state = DrawState {
            depth_test: DepthTest::Always,
            ..DrawState::opaque(context.width, context.height)
        };
        state.apply(gl);
        let half_height = (camera.fovy * 0.5).tan();
        let half_width = half_height * context.tile.aspect();
        let (across, upwards) = (camera.right() * half_width, camera.up() * half_height);
        let (half, center) = context.tile.in_picture();
        let program = &self.program;
        let ahead = camera.up().cross(camera.right());
        program.set_vec3("ahead", ahead + across * center.x + upwards * center.y);
        program.set_vec3("across", across * half.x);
        program.set_vec3("upwards", upwards * half.y);
        program.set_vec3("eye", camera.eye());
        program.set_vec3("light", MANNEQUIN_LIGHT);
        program.set_f32("height", height);
        program.set_f32("tile", TILE);
        program.set_f32("near", camera.near);
        program.set_f32("far", camera.far);
        self.whole_picture.draw(program, Primitive::Triangles, 0..3);
    }
}

/// Length of each half of an axis in the world.
const AXIS_REACH: f32 = 50.0;

/// Depth below a floor, in the world, at which an axis still counts as lying on it.
const ON_FLOOR: f32 = 1e-3;

/// Draws the world's axes through the compatibility layer: X red, Y green, Z blue. With `floor`, only
/// what is not below that height in the world.
pub(super) fn draw_axis(
    gl: &Gl,
    immediate: &mut Immediate,
    context: &PassContext,
    floor: Option<f32>,
) {
    DrawState::opaque(context.width, context.height).apply(gl);
    immediate.load_matrix(context.clip_from_world);
    immediate.line_width(1.0);
    immediate.begin(Mode::Lines);
    for (axis, color) in [Vec3::X, Vec3::Y, Vec3::Z]
        .into_iter()
        .zip(context.colors.axes)
    {
        let ends = [axis * -AXIS_REACH, axis * AXIS_REACH];
        let lowest = floor.unwrap_or(f32::NEG_INFINITY) - ON_FLOOR;
        if ends[1].y < lowest {
            continue;
        }
        immediate.color(color);
        for end in ends {
            immediate.vertex(end.with_y(end.y.max(lowest)));
        }
    }
    immediate.end();
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
