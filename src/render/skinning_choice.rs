//! Where characters are skinned: on the graphics card, or by the processor.

use super::frame::Frame;
use super::renderer::Renderer;
use super::sight::Sight;
use crate::gpu::{Gl, GpuError, Info};
use crate::scene::Skinning;

/// Textures that a skinning vertex shader reads: palettes and influences.
const TEXTURES_NEEDED: u32 = 2;

/// Choice of where skinning is done: as asked for, and as in use.
#[derive(Debug)]
pub(super) struct SkinningChoice {
    asked: Option<Skinning>,
    in_use: Skinning,
}

impl SkinningChoice {
    pub fn automatic(info: &Info) -> Self {
        Self::new(None, info)
    }

    fn new(asked: Option<Skinning>, info: &Info) -> Self {
        // On software OpenGL both are the processor, and the vertex shader is the slower way.
        let automatic = if info.is_software {
            Skinning::Cpu
        } else {
            Skinning::Gpu
        };
        Self {
            asked,
            in_use: asked.unwrap_or(automatic),
        }
    }
}

impl Renderer {
    /// Chooses where characters are skinned. `None` leaves it to the driver: on the graphics card if
    /// there is one, on the processor if that draws as well. Whether this makes a difference.
    pub fn set_skinning(&mut self, asked: Option<Skinning>) -> bool {
        if asked == self.skinning.asked {
            return false;
        }
        let before = self.skinning();
        self.skinning = SkinningChoice::new(asked, self.gl.info());
        before != self.skinning()
    }

    /// Where characters are skinned. On the processor, once the graphics card has refused to: see
    /// [`Renderer::take_notices`].
    pub fn skinning(&self) -> Skinning {
        self.skinning.in_use
    }

    /// Uploads the meshes in `sight` that have changed, skinned by the processor if the graphics card cannot.
    pub(super) fn update_meshes(&mut self, frame: &Frame, sight: &Sight) -> Result<(), GpuError> {
        if self.skinning() == Skinning::Gpu
            && let Err(error) = self
                .prepare_skinning(frame)
                .and_then(|()| self.update_meshes_by(frame, sight, Skinning::Gpu))
        {
            self.notices.push(format!(
                "The graphics card cannot skin the characters, so the processor does: {error}"
            ));
            self.skinning.in_use = Skinning::Cpu;
        }
        self.update_meshes_by(frame, sight, self.skinning())?;
        self.notices.extend(self.meshes.take_notices());
        Ok(())
    }

    /// Uploads the next part of the large meshes in `sight`; whether there is no more of them.
    pub(super) fn upload_part(&mut self, frame: &Frame, sight: &Sight) -> bool {
        let skinning = self.skinning();
        self.meshes.upload_part(&self.gl, frame, sight, skinning)
    }

    fn update_meshes_by(
        &mut self,
        frame: &Frame,
        sight: &Sight,
        skinning: Skinning,
    ) -> Result<(), GpuError> {
        self.meshes.update(&self.gl, frame, sight, skinning)
    }

    fn prepare_skinning(&mut self, frame: &Frame) -> Result<(), GpuError> {
        let gl: &Gl = &self.gl;
        let available = gl.info().max_vertex_textures;
        if available < TEXTURES_NEEDED {
            return Err(GpuError::Create {
                what: "vertex shader that skins",
                why: format!("{TEXTURES_NEEDED} textures are needed in it, {available} possible"),
            });
        }
        self.surfaces.add_skinned(gl, frame.view.look)?;
        self.shadows.add_skinned(gl)?;
        self.outline.add_skinned(gl)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};

    #[test]
    fn software_leaves_skinning_to_the_processor_and_hardware_takes_it() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let mut info = context.gl().info().clone();
        info.is_software = true;
        assert_eq!(SkinningChoice::automatic(&info).in_use, Skinning::Cpu);
        info.is_software = false;
        assert_eq!(SkinningChoice::automatic(&info).in_use, Skinning::Gpu);
        assert_eq!(
            SkinningChoice::new(Some(Skinning::Cpu), &info).in_use,
            Skinning::Cpu
        );
    }
}
