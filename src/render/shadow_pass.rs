use super::frame::{Frame, PassContext};
use super::mesh_cache::MeshCache;
use super::mesh_programs::MeshPrograms;
use super::surface_pass::surfaces;
use crate::gpu::{DepthTest, DrawState, Framebuffer, Gl, GpuError, Primitive};
use glam::{Mat4, Vec3, Vec4};

/// From the ground to the light that throws shadows: the key light as it stands for the first
/// view. It stays there when the camera turns, for shadows that wander over the ground would look
/// as if the shapes did.
const LIGHT: Vec3 = Vec3::new(-0.45, 1.0, 0.55);

/// Draws what the Studio look's ground is kept from light: every surface, flattened onto the plane
/// of the ground along the light, as the camera sees it there. No size of the scene needs to be known for
/// that, which a shadow map would have to be fitted to, and edges are as fine as pixels.
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

    /// Gets ready for meshes that the vertex shader moves.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.programs.add_skinned(gl)
    }

    /// A picture as large as the one that is drawn, white where the ground is in shadow. It is
    /// bound afterwards.
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
