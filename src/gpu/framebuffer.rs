//! Pictures to draw into, with depth, and with several samples a pixel if asked for.

use glow::HasContext as _;
use std::cell::Cell;

use super::blit::{Rect, blit, prepare_whole};
use super::framebuffer_object::FramebufferObject;
use super::{Gl, GpuError};

/// Color (RGBA, 8 bits each) and depth (24 bits) in memory of the graphics card.
///
/// With samples, drawing goes to a multisampled picture, which every reading operation first
/// [`resolve`](Self::resolve)s into a plain one.
pub struct Framebuffer {
    gl: Gl,
    width: u32,
    height: u32,
    samples: u32,
    drawn: FramebufferObject,
    resolved: Option<FramebufferObject>,
    /// Whether the samples may have changed since they were averaged.
    is_stale: Cell<bool>,
}

impl std::fmt::Debug for Framebuffer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "Framebuffer({}x{}, {} samples)",
            self.width, self.height, self.samples
        )
    }
}

impl Framebuffer {
    /// A picture of undefined content. Software drivers know 0 (none) and 4 samples only, and take
    /// 4 where 1 to 3 are asked for.
    ///
    /// # Errors
    /// A side of zero or beyond the driver's limit, too many samples, or no memory.
    pub fn new(gl: &Gl, width: u32, height: u32, samples: u32) -> Result<Self, GpuError> {
        let info = gl.info();
        let max = info.max_framebuffer_size;
        if !(1..=max).contains(&width) || !(1..=max).contains(&height) {
            return Err(GpuError::Size {
                what: "picture",
                width,
                height,
                max,
            });
        }
        if samples > info.max_samples {
            return Err(GpuError::Samples {
                asked: samples,
                max: info.max_samples,
            });
        }
        gl.check("what preceded a new picture")?;
        let drawn = FramebufferObject::new(gl, width, height, samples, true)?;
        let resolved = match samples {
            0 => None,
            _ => Some(FramebufferObject::new(gl, width, height, 0, false)?),
        };
        Ok(Self {
            gl: gl.clone(),
            width,
            height,
            samples,
            drawn,
            resolved,
            is_stale: Cell::new(true),
        })
    }

    /// The kept framebuffer, if it has this size and, as all of these, no samples; otherwise a new
    /// one takes its place.
    ///
    /// # Errors
    /// As [`Framebuffer::new`]; then none is kept.
    pub(crate) fn fitting<'a>(
        kept: &'a mut Option<Self>,
        gl: &Gl,
        width: u32,
        height: u32,
    ) -> Result<&'a Self, GpuError> {
        let fits = |it: &Self| (it.width(), it.height()) == (width, height);
        let fitting = match kept.take().filter(fits) {
            Some(fitting) => fitting,
            None => Self::new(gl, width, height, 0)?,
        };
        Ok(kept.insert(fitting))
    }

    /// In pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// In pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The number asked for; 0 for none.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Draws go here from now on, until another framebuffer is bound or this one is read. The viewport
    /// is the draw state's.
    pub fn bind(&self) {
        self.is_stale.set(true);
        self.bind_raw();
    }

    fn bind_raw(&self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context.
            unsafe { glow.bind_framebuffer(glow::FRAMEBUFFER, Some(self.drawn.raw)) }
        }
    }

    /// Binds it, fills it with `color` (red, green, blue, alpha in 0..1) and puts its depth to the
    /// farthest, whatever state is set. A [`DrawState`](super::DrawState) is to be applied next.
    pub fn clear(&self, [red, green, blue, alpha]: [f32; 4]) {
        self.bind();
        let Some(glow) = self.gl.current() else {
            return;
        };
        // SAFETY: current context.
        unsafe {
            prepare_whole(glow, self.gl.info().is_gles);
            glow.color_mask(true, true, true, true);
            glow.depth_mask(true);
            glow.clear_color(red, green, blue, alpha);
            // The function of `f32` is not in OpenGL 3.3, that of `f64` not in OpenGL ES: this is
            // whichever there is.
            glow.clear_depth(1.0);
            glow.clear(glow::COLOR_BUFFER_BIT | glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Binds it and fills a part of it with `color`, as [`Framebuffer::clear`] does; its depth stays.
    pub fn clear_area(&self, area: Rect, [red, green, blue, alpha]: [f32; 4]) {
        self.bind();
        let Some(glow) = self.gl.current() else {
            return;
        };
        // SAFETY: current context.
        unsafe {
            prepare_whole(glow, self.gl.info().is_gles);
            glow.enable(glow::SCISSOR_TEST);
            glow.scissor(area.x, area.y, area.width, area.height);
            glow.color_mask(true, true, true, true);
            glow.clear_color(red, green, blue, alpha);
            glow.clear(glow::COLOR_BUFFER_BIT);
            glow.disable(glow::SCISSOR_TEST);
        }
    }

    /// Averages the samples into the picture that is read. Without samples, or where nothing was drawn
    /// since, there is nothing to do. Whoever goes on to draw binds it again.
    pub fn resolve(&self) {
        if let Some(resolved) = &self.resolved
            && self.is_stale.replace(false)
        {
            let whole = self.rect();
            blit(&self.gl, self.drawn.raw, whole, Some(resolved.raw), whole);
        }
        self.bind_raw();
    }

    /// The picture: red, green, blue, alpha, 8 bits each, the top row first.
    ///
    /// # Errors
    /// Every fault that [`Gl::check`] returns, so that no broken picture is taken for a good one.
    pub fn read_rgba(&self) -> Result<Vec<u8>, GpuError> {
        self.resolve();
        let row = self.width as usize * 4;
        let mut pixels = vec![0; row * self.height as usize];
        let Rect { width, height, .. } = self.rect();
        let glow = self.gl.current_for("reading a picture back")?;
        // SAFETY: current context; rows are packed without gaps, so they fill the slice exactly.
        unsafe {
            glow.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(self.readable()));
            glow.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            glow.pixel_store_i32(glow::PACK_ALIGNMENT, 4);
            glow.pixel_store_i32(glow::PACK_ROW_LENGTH, 0);
            glow.pixel_store_i32(glow::PACK_SKIP_ROWS, 0);
            glow.pixel_store_i32(glow::PACK_SKIP_PIXELS, 0);
            let data = glow::PixelPackData::Slice(Some(&mut pixels));
            glow.read_pixels(0, 0, width, height, glow::RGBA, glow::UNSIGNED_BYTE, data);
        }
        self.bind_raw();
        self.gl.check("reading a picture back")?;
        turn_rows(&mut pixels, row);
        Ok(pixels)
    }

    /// Has the graphics card copy the picture, once it is drawn, into a buffer of its own.
    ///
    /// # Errors
    /// When the context is lost or the driver refuses.
    #[cfg(target_arch = "wasm32")]
    pub(in crate::gpu) fn copy_into_buffer(&self) -> Result<glow::Buffer, GpuError> {
        let Rect { width, height, .. } = self.rect();
        let glow = self.gl.current_for("reading a picture back")?;
        // SAFETY: current context; rows are packed without gaps, so they fill the buffer exactly.
        unsafe {
            let buffer = glow.create_buffer().map_err(|why| GpuError::Create {
                what: "picture to read",
                why,
            })?;
            let size = width.saturating_mul(height).saturating_mul(4);
            glow.bind_buffer(glow::PIXEL_PACK_BUFFER, Some(buffer));
            glow.buffer_data_size(glow::PIXEL_PACK_BUFFER, size, glow::STREAM_READ);
            glow.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(self.readable()));
            glow.pixel_store_i32(glow::PACK_ALIGNMENT, 4);
            glow.pixel_store_i32(glow::PACK_ROW_LENGTH, 0);
            glow.pixel_store_i32(glow::PACK_SKIP_ROWS, 0);
            glow.pixel_store_i32(glow::PACK_SKIP_PIXELS, 0);
            let data = glow::PixelPackData::BufferOffset(0);
            glow.read_pixels(0, 0, width, height, glow::RGBA, glow::UNSIGNED_BYTE, data);
            glow.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            self.bind_raw();
            Ok(buffer)
        }
    }

    /// The picture that [`copy_into_buffer`](Self::copy_into_buffer) put into `buffer`, as
    /// [`read_rgba`](Self::read_rgba) returns it.
    ///
    /// # Errors
    /// As [`read_rgba`](Self::read_rgba).
    #[cfg(target_arch = "wasm32")]
    pub(in crate::gpu) fn read_buffer(&self, buffer: glow::Buffer) -> Result<Vec<u8>, GpuError> {
        let row = self.width as usize * 4;
        let mut pixels = vec![0; row * self.height as usize];
        let glow = self.gl.current_for("reading a picture back")?;
        // SAFETY: current context; the buffer has the size of the slice.
        unsafe {
            glow.bind_buffer(glow::PIXEL_PACK_BUFFER, Some(buffer));
            glow.get_buffer_sub_data(glow::PIXEL_PACK_BUFFER, 0, &mut pixels);
            glow.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
        }
        self.gl.check("reading a picture back")?;
        turn_rows(&mut pixels, row);
        Ok(pixels)
    }

    /// Copies the picture into `target` of the window, scaled if sizes differ. Afterwards the
    /// window is bound.
    pub fn blit_to_window(&self, target: Rect) {
        self.resolve();
        blit(&self.gl, self.readable(), self.rect(), None, target);
        self.gl.bind_window();
    }

    /// Copies `source` of this picture into `target` of another of the same context, scaled if
    /// sizes differ. Afterwards the other is bound.
    ///
    /// # Errors
    /// When the other has samples, which OpenGL cannot copy into, or is of another context.
    pub fn blit_into(&self, other: &Self, source: Rect, target: Rect) -> Result<(), GpuError> {
        let refused = |problem: &str| GpuError::Data {
            what: "framebuffer",
            problem: problem.to_owned(),
        };
        if other.samples > 0 {
            return Err(refused("a picture with samples cannot be copied into"));
        }
        if !other.is_of(&self.gl) {
            return Err(refused("a picture cannot be copied into another context"));
        }
        self.resolve();
        blit(
            &self.gl,
            self.readable(),
            source,
            Some(other.drawn.raw),
            target,
        );
        other.bind();
        Ok(())
    }

    /// Copies colors and depth into another picture of the same size and context; both have no samples.
    /// Afterwards the other is bound.
    ///
    /// # Errors
    /// When they are not such pictures.
    pub fn copy_into(&self, other: &Self) -> Result<(), GpuError> {
        if self.samples > 0 || (self.width, self.height) != (other.width, other.height) {
            return Err(GpuError::Data {
                what: "framebuffer",
                problem:
                    "colors and depth are copied between pictures of one size, without samples"
                        .to_owned(),
            });
        }
        self.blit_into(other, self.rect(), other.rect())?;
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; blitting the colors has bound and prepared both.
            unsafe {
                glow.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(self.drawn.raw));
                let Rect { width, height, .. } = self.rect();
                glow.blit_framebuffer(
                    0,
                    0,
                    width,
                    height,
                    0,
                    0,
                    width,
                    height,
                    glow::DEPTH_BUFFER_BIT,
                    glow::NEAREST,
                );
            }
        }
        other.bind();
        Ok(())
    }

    /// Binds the picture to a texture unit, where a `sampler2D` reads it, unfiltered; not while it
    /// is drawn into.
    pub fn bind_texture(&self, unit: u32) {
        let _ = self.bind_filtered(unit, glow::NEAREST, glow::NEAREST);
    }

    /// As [`bind_texture`](Self::bind_texture), but neighbors are mixed, and smaller versions of
    /// the picture, as it is now, are made for `textureLod` and for distance.
    pub fn bind_texture_with_mipmaps(&self, unit: u32) {
        if let Some(glow) = self.bind_filtered(unit, glow::LINEAR_MIPMAP_LINEAR, glow::LINEAR) {
            // SAFETY: current context; the texture is bound to the active unit and has its first
            // level.
            unsafe { glow.generate_mipmap(glow::TEXTURE_2D) };
        }
    }

    fn bind_filtered(&self, unit: u32, min: u32, mag: u32) -> Option<&glow::Context> {
        self.resolve();
        let target = self.resolved.as_ref().unwrap_or(&self.drawn);
        let glow = self.gl.current()?;
        // SAFETY: current context; a target without samples has a texture.
        unsafe {
            glow.active_texture(glow::TEXTURE0.saturating_add(unit));
            glow.bind_texture(glow::TEXTURE_2D, target.texture);
            // A sampler object left there by other code would replace the texture's sampling.
            glow.bind_sampler(unit, None);
            for (name, value) in [
                (glow::TEXTURE_MIN_FILTER, min),
                (glow::TEXTURE_MAG_FILTER, mag),
            ] {
                glow.tex_parameter_i32(glow::TEXTURE_2D, name, value.cast_signed());
            }
        }
        Some(glow)
    }

    /// Whether it is an object of the context of `gl`.
    pub(in crate::gpu) fn is_of(&self, gl: &Gl) -> bool {
        self.gl.is_same(gl)
    }

    pub(crate) fn rect(&self) -> Rect {
        let side = |pixels| i32::try_from(pixels).unwrap_or(i32::MAX);
        Rect {
            x: 0,
            y: 0,
            width: side(self.width),
            height: side(self.height),
        }
    }

    fn readable(&self) -> glow::Framebuffer {
        self.resolved.as_ref().unwrap_or(&self.drawn).raw
    }
}

/// Puts the top row first, of rows of so many bytes: OpenGL counts them from the bottom.
fn turn_rows(pixels: &mut [u8], row: usize) {
    let (mut top, mut bottom) = (0, pixels.len() / row);
    while top + 1 < bottom {
        bottom -= 1;
        let (upper, lower) = pixels.split_at_mut(bottom * row);
        upper[top * row..(top + 1) * row].swap_with_slice(&mut lower[..row]);
        top += 1;
    }
}
