//! The driver's object behind a framebuffer.

use glow::HasContext as _;

use super::texture::SPARE_UNIT;
use super::{Gl, GpuError};

/// A framebuffer object with its attachments: renderbuffers, and without samples a texture for the
/// color, so that later passes can read it.
pub(in crate::gpu) struct FramebufferObject {
    gl: Gl,
    pub(in crate::gpu) raw: glow::Framebuffer,
    pub(in crate::gpu) texture: Option<glow::Texture>,
    attachments: Vec<glow::Renderbuffer>,
}

impl FramebufferObject {
    pub(in crate::gpu) fn new(
        gl: &Gl,
        width: u32,
        height: u32,
        samples: u32,
        depth: bool,
    ) -> Result<Self, GpuError> {
        let create = |why| GpuError::Create {
            what: "picture",
            why,
        };
        let glow = gl.current_for("making a picture")?;
        // SAFETY: current context.
        let raw = unsafe { glow.create_framebuffer() }.map_err(create)?;
        let mut target = Self {
            gl: gl.clone(),
            raw,
            texture: None,
            attachments: Vec::new(),
        };
        // SAFETY: current context.
        unsafe { glow.bind_framebuffer(glow::FRAMEBUFFER, Some(raw)) };
        let size = [width, height, samples].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        if samples == 0 {
            target.attach_texture(glow, size).map_err(create)?;
        } else {
            target
                .attach(glow, glow::COLOR_ATTACHMENT0, glow::RGBA8, size)
                .map_err(create)?;
        }
        if depth {
            target
                .attach(glow, glow::DEPTH_ATTACHMENT, glow::DEPTH_COMPONENT24, size)
                .map_err(create)?;
        }
        gl.check("making a picture")
            .map_err(|error| create(error.to_string()))?;
        // WebGL promises these formats, and a browser answers only once everything is drawn.
        if !cfg!(target_arch = "wasm32") {
            // SAFETY: current context.
            let status = unsafe { glow.check_framebuffer_status(glow::FRAMEBUFFER) };
            if status != glow::FRAMEBUFFER_COMPLETE {
                return Err(create(format!("incomplete, status 0x{status:04x}")));
            }
        }
        Ok(target)
    }

    fn attach_texture(
        &mut self,
        glow: &glow::Context,
        [width, height, _]: [i32; 3],
    ) -> Result<(), String> {
        // SAFETY: `new` passes a current context in which this framebuffer is bound; no data is
        // passed, and the driver checks the sizes.
        unsafe {
            let raw = glow.create_texture()?;
            self.texture = Some(raw);
            glow.active_texture(glow::TEXTURE0 + SPARE_UNIT);
            glow.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
            glow.bind_texture(glow::TEXTURE_2D, Some(raw));
            for (name, value) in [
                (glow::TEXTURE_MIN_FILTER, glow::NEAREST),
                (glow::TEXTURE_MAG_FILTER, glow::NEAREST),
                (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
            ] {
                glow.tex_parameter_i32(glow::TEXTURE_2D, name, value.cast_signed());
            }
            glow.tex_image_2d(
                glow::TEXTURE_2D,
                0,
                glow::RGBA8.cast_signed(),
                width,
                height,
                0,
                glow::RGBA,
                glow::UNSIGNED_BYTE,
                glow::PixelUnpackData::Slice(None),
            );
            glow.framebuffer_texture_2d(
                glow::FRAMEBUFFER,
                glow::COLOR_ATTACHMENT0,
                glow::TEXTURE_2D,
                Some(raw),
                0,
            );
        }
        Ok(())
    }

    fn attach(
        &mut self,
        glow: &glow::Context,
        point: u32,
        format: u32,
        [width, height, samples]: [i32; 3],
    ) -> Result<(), String> {
        // SAFETY: `new` passes a current context in which this framebuffer is bound, and the driver
        // checks the sizes.
        unsafe {
            let raw = glow.create_renderbuffer()?;
            self.attachments.push(raw);
            glow.bind_renderbuffer(glow::RENDERBUFFER, Some(raw));
            if samples == 0 {
                glow.renderbuffer_storage(glow::RENDERBUFFER, format, width, height);
            } else {
                glow.renderbuffer_storage_multisample(
                    glow::RENDERBUFFER,
                    samples,
                    format,
                    width,
                    height,
                );
            }
            glow.framebuffer_renderbuffer(glow::FRAMEBUFFER, point, glow::RENDERBUFFER, Some(raw));
            glow.bind_renderbuffer(glow::RENDERBUFFER, None);
        }
        Ok(())
    }
}

impl Drop for FramebufferObject {
    fn drop(&mut self) {
        let Some(glow) = self.gl.current() else {
            return;
        };
        // SAFETY: current context; each is deleted once.
        unsafe {
            glow.delete_framebuffer(self.raw);
            self.attachments
                .iter()
                .for_each(|&attachment| glow.delete_renderbuffer(attachment));
            if let Some(texture) = self.texture {
                glow.delete_texture(texture);
            }
        }
    }
}
