//! The Studio look's ground and the shadows on it.

use super::backdrop_pass::set_gradient;
use super::mesh_cache::MeshCache;
use super::mesh_programs::MeshPrograms;
use super::renderer::{Background, Frame, PassContext};
use super::surface_pass::surfaces;
use crate::gpu::{
    Attribute, Blend, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive, Program,
    Usage, VertexArray,
};
use crate::scene::Camera;
use glam::{Mat4, Vec2, Vec3, Vec4};

/// From the ground to the light that throws shadows: the key light as it stands for the first
/// view. It stays there when the camera turns, for shadows that wander over the ground would look
/// as if the shapes did.
const LIGHT: Vec3 = Vec3::new(-0.45, 1.0, 0.55);

/// Draws the shadows on the Studio look's ground: every surface, flattened onto the plane of the
/// ground along the light, as the camera sees it there. A shadow map would have to be fitted to the
/// size of the scene, which need not be known here, and edges are as fine as pixels.
#[derive(Debug)]
pub(super) struct ShadowPass {
    programs: MeshPrograms,
    shadows: Option<Framebuffer>,
}

impl ShadowPass {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let fragment = include_str!("../../shaders/shadow_fragment.glsl");
        Ok(Self {
            programs: MeshPrograms::new(gl, "shadow", fragment)?,
            shadows: None,
        })
    }

    /// Compiles the programs for skinned meshes.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.programs.add_skinned(gl)
    }

    /// A picture as large as the one that is drawn, white where the ground is in shadow. Afterwards it
    /// is bound.
    pub fn draw(
        &mut self,
        gl: &Gl,
        context: &PassContext,
        frame: &Frame,
        meshes: &MeshCache,
    ) -> Result<&Framebuffer, GpuError> {
        let (width, height) = (context.width, context.height);
        let shadows = Framebuffer::fitting(&mut self.shadows, gl, width, height)?;
        shadows.clear([0.0; 4]);
        let state = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(width, height)
        };
        state.apply(gl);
        let clip_from_world = context.clip_from_world * ground_from_world(context.ground);
        for (shape, evaluated) in surfaces(frame) {
            let Some(cached) = meshes.get(shape.id) else {
                continue;
            };
            let program = self.programs.of(cached);
            meshes.bind_skin(program, shape.id);
            program.set_mat4("clip_from_world", clip_from_world);
            program.set_mat4("world_from_model", evaluated.world_from_model);
            program.set_f32("ground", context.ground);
            let indices = 0..cached.vertex_array.index_count();
            cached
                .vertex_array
                .draw_indexed(program, Primitive::Triangles, indices);
        }
        Ok(shadows)
    }
}

/// Moves every point along the light onto the plane y = `ground`.
fn ground_from_world(ground: f32) -> Mat4 {
    let along = LIGHT / LIGHT.y;
    let mut flattened = Mat4::IDENTITY;
    flattened.y_axis = Vec4::new(-along.x, 0.0, -along.z, 0.0);
    flattened.w_axis = (along * ground).extend(1.0);
    flattened
}

/// Texture unit of the shadows.
const SHADOWS: u32 = 0;
/// Share of what is behind the ground that its light covers, in the middle.
const LIT: f32 = 0.6;
/// Width of a shadow's fading edge in the world.
const SOFTNESS: f32 = 0.07;

/// The Studio look's ground: a grid, one unit wide, every tenth line stronger,
/// and shadows with soft edges. Before a transparent background only the shadows.
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

    /// Draws it, after everything opaque: seen from above it hides what is below, but from below
    /// everything is seen through it. `shadows` is a picture as large
    /// as `target`, white where the ground is in shadow.
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
        // As far as it can be distinguished from the horizon, around the camera's target; not
        // beyond the far plane.
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
        let is_shown = context.background == Background::Look;
        let is_opaque = hides_below(context, camera);
        self.program.set_f32("opaque", f32::from(is_opaque));
        self.program
            .set_f32("lit", if is_opaque { LIT } else { 0.0 });
        self.program.set_f32("grid", f32::from(is_shown));
        set_gradient(&self.program, context);
        self.program
            .set_f32("picture_height", context.height as f32);
        self.program.set_vec3("ground", context.colors.ground);
        self.program.set_vec3("line_color", context.colors.grid);
        self.program.set_f32("darkness", context.colors.darkness);
        self.square
            .draw(&self.program, Primitive::TriangleStrip, 0..4);
    }
}

/// Whether the ground hides what is below it: seen from below, or without a background, it does not.
pub(super) fn hides_below(context: &PassContext, camera: &Camera) -> bool {
    camera.eye().y > context.ground && context.background == Background::Look
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_go_along_the_light_to_the_ground_and_those_on_it_stay() {
        let flattened = ground_from_world(-0.5);
        let on_ground = Vec3::new(1.0, -0.5, -2.0);
        let stays = flattened.transform_point3(on_ground);
        assert!(stays.abs_diff_eq(on_ground, 1e-6), "{stays}");
        let above = on_ground + LIGHT * 3.0;
        let found = flattened.transform_point3(above);
        assert!(found.abs_diff_eq(on_ground, 1e-6), "{found}");
    }
}
