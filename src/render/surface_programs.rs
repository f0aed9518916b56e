//! Shader programs that light surfaces: one for each look, with pictures and without.

use super::mesh_programs::MeshPrograms;
use crate::gpu::{Gl, GpuError};
use crate::scene::Look;

/// The looks in the order of their numbers.
pub(super) const LOOKS: [Look; 3] = [Look::Course, Look::Studio, Look::Mannequin];

/// The programs of all looks, each compiled when it is first needed.
#[derive(Debug)]
pub(super) struct SurfacePrograms([[MeshPrograms; 2]; 3]);

impl SurfacePrograms {
    pub fn new(gl: &Gl) -> Self {
        Self(LOOKS.map(|look| {
            [false, true]
                .map(|textured| MeshPrograms::new(gl, "surface", &surface_fragment(look, textured)))
        }))
    }

    /// Those that draw in this look what has a picture, or what has none.
    pub fn of(&self, look: Look, textured: bool) -> &MeshPrograms {
        &self.0[look as usize][usize::from(textured)]
    }

    /// Compiles those of a look that skin meshes, with pictures and without.
    pub fn add_skinned(&mut self, gl: &Gl, look: Look) -> Result<(), GpuError> {
        let mut programs = self.0[look as usize].iter_mut();
        programs.try_for_each(|programs| programs.add_skinned(gl))
    }
}

/// The fragment shader that lights a surface in one look.
pub(super) fn surface_fragment(look: Look, textured: bool) -> String {
    format!(
        "#define LOOK {}\n#define TEXTURED {}\n{}",
        look as usize,
        u8::from(textured),
        include_str!("../../shaders/surface_fragment.glsl")
    )
}
