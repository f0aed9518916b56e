//! Meshes in the colors of numbers at their vertices.

use super::cached_mesh::CachedMesh;
use super::frame::{Frame, PassContext};
use super::mesh_programs::MeshPrograms;
use crate::gpu::{Filter, Gl, GpuError, Program, Sampling, Texture};
use crate::scene::{SCALE_GRAY, VertexNumbers, scale_color};

/// Colors in the texture of the scale.
const CELLS: u32 = 256;
/// Texture unit of the scale.
const SCALE: u32 = 0;

/// The programs that draw meshes in the colors of numbers, and the scale.
#[derive(Debug)]
pub(super) struct NumberColors {
    programs: MeshPrograms,
    scale: Texture,
}

impl NumberColors {
    pub fn new(gl: &Gl) -> Result<Self, GpuError> {
        let fragment = include_str!("../../shaders/numbers_fragment.glsl");
        let colors = (0..CELLS).flat_map(|cell| {
            let color = scale_color(cell as f32 / (CELLS - 1) as f32) * 255.0;
            let [red, green, blue] = color.to_array().map(|channel| channel.round() as u8);
            [red, green, blue, u8::MAX]
        });
        let colors: Vec<u8> = colors.collect();
        let sampling = Sampling {
            filter: Filter::Linear,
            ..Sampling::default()
        };
        Ok(Self {
            programs: MeshPrograms::new(gl, "numbers", fragment),
            scale: Texture::new(gl, CELLS, 1, &colors, sampling)?,
        })
    }

    /// Compiles the programs for skinned meshes.
    pub fn add_skinned(&mut self, gl: &Gl) -> Result<(), GpuError> {
        self.programs.add_skinned(gl)
    }

    /// Sets what all meshes of a picture share.
    pub fn prepare(&self, context: &PassContext, frame: &Frame) {
        for program in self.programs.all() {
            program.set_mat4("clip_from_world", context.clip_from_world);
            program.set_vec3("eye", frame.view.camera.eye());
            program.set_vec3("gray", SCALE_GRAY);
            program.set_sampler("scale", SCALE);
        }
    }

    /// The program that draws `mesh` by `numbers`, ready but for what it shares with other programs
    /// for meshes.
    pub fn program(&self, mesh: &CachedMesh, numbers: &VertexNumbers) -> &Program {
        let program = self.programs.of(mesh);
        program.set_f32("low", numbers.low);
        program.set_f32("high", numbers.high);
        program.set_f32("gray_up_to", numbers.gray_up_to.unwrap_or(f32::MIN));
        self.scale.bind(SCALE);
        program
    }
}
