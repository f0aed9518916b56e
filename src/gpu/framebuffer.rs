//! Pictures to draw into, with depth, and with several samples a pixel if asked for.

use glow::HasContext as _;

use super::target::Target;
use super::{Gl, GpuError};

/// A rectangle of pixels, counted from the bottom left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rect {
    /// Left side.
    pub x: i32,
    /// Lower side.
    pub y: i32,
    /// In pixels.
    pub width: i32,
    /// In pixels.
    pub height: i32,
}

/// Color (RGBA, 8 bits each) and depth (24 bits) in memory of the graphics card.
///
/// With samples, drawing goes to a multisampled picture, which every reading operation first
/// [`resolve`](Self::resolve)s into a plain one.
pub struct Framebuffer {
    gl: Gl,
    width: u32,
    height: u32,
    samples: u32,
    drawn: Target,
    resolved: Option<Target>,
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
        let drawn = Target::new(gl, width, height, samples, true)?;
        let resolved = match samples {
            0 => None,
            _ => Some(Target::new(gl, width, height, 0, false)?),
        };
        Ok(Self {
            gl: gl.clone(),
            width,
            height,
            samples,
            drawn,
            resolved,
        })
    }

    /// The one that was kept if it has this size and, as all of these, no samples; otherwise a new
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

    /// Draws go here from now on. The viewport is the draw state's.
    pub fn bind(&self) {
        // SAFETY: current context.
        unsafe {
            self.gl
                .raw()
                .bind_framebuffer(glow::FRAMEBUFFER, Some(self.drawn.raw))
        }
    }

    /// Binds it, fills it with `color` (red, green, blue, alpha in 0..1) and puts its depth to the
    /// farthest, whatever state is set. A [`DrawState`](super::DrawState) is to be applied next.
    pub fn clear(&self, [red, green, blue, alpha]: [f32; 4]) {
        self.bind();
        prepare_whole(&self.gl);
        let glow = self.gl.raw();
        // SAFETY: current context.
        unsafe {
            glow.color_mask(true, true, true, true);
            glow.depth_mask(true);
            glow.clear_color(red, green, blue, alpha);
            // The function of `f32` is not in OpenGL 3.3, that of `f64` not in OpenGL ES: this is
            // whichever there is.
            glow.clear_depth(1.0);
            glow.clear(glow::COLOR_BUFFER_BIT | glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Averages the samples into the picture that is read. Without samples there is nothing to do.
    /// Afterwards this framebuffer is bound.
    pub fn resolve(&self) {
        if let Some(resolved) = &self.resolved {
            let whole = self.rect();
            blit(&self.gl, self.drawn.raw, whole, Some(resolved.raw), whole);
        }
        self.bind();
    }

    /// The picture: red, green, blue, alpha, 8 bits each, the top row first. Afterwards this
    /// framebuffer is bound.
    ///
    /// # Errors
    /// What [`Gl::check`] finds, so that no broken picture is taken for a good one.
    pub fn read_rgba(&self) -> Result<Vec<u8>, GpuError> {
        self.resolve();
        let row = self.width as usize * 4;
        let mut pixels = vec![0; row * self.height as usize];
        let Rect { width, height, .. } = self.rect();
        let glow = self.gl.raw();
        // SAFETY: current context; rows are packed without gaps, so they fill the buffer exactly.
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
        self.bind();
        self.gl.check("reading a picture back")?;
        // OpenGL counts rows from the bottom.
        let (mut top, mut bottom) = (0, self.height as usize);
        while top + 1 < bottom {
            bottom -= 1;
            let (upper, lower) = pixels.split_at_mut(bottom * row);
            upper[top * row..(top + 1) * row].swap_with_slice(&mut lower[..row]);
            top += 1;
        }
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
    /// When the other has samples: OpenGL cannot copy into those.
    pub fn blit_into(&self, other: &Self, source: Rect, target: Rect) -> Result<(), GpuError> {
        if other.samples > 0 {
            let problem = "a picture with samples cannot be copied into".to_owned();
            return Err(GpuError::Data {
                what: "framebuffer",
                problem,
            });
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

    /// A `sampler2D` of this unit reads the picture from now on, unfiltered; not while it is
    /// drawn into. Afterwards this framebuffer is bound.
    pub fn bind_texture(&self, unit: u32) {
        self.bind_filtered(unit, glow::NEAREST, glow::NEAREST);
    }

    /// As [`bind_texture`](Self::bind_texture), but neighbors are mixed, and smaller versions of
    /// the picture, as it is now, are made for `textureLod` and for distance.
    pub fn bind_texture_with_mipmaps(&self, unit: u32) {
        self.bind_filtered(unit, glow::LINEAR_MIPMAP_LINEAR, glow::LINEAR);
        // SAFETY: current context; the texture is bound to the active unit and has its first level.
        unsafe { self.gl.raw().generate_mipmap(glow::TEXTURE_2D) };
    }

    fn bind_filtered(&self, unit: u32, min: u32, mag: u32) {
        self.resolve();
        let target = self.resolved.as_ref().unwrap_or(&self.drawn);
        // SAFETY: current context; a target without samples has a texture.
        unsafe {
            let glow = self.gl.raw();
            glow.active_texture(glow::TEXTURE0.saturating_add(unit));
            glow.bind_texture(glow::TEXTURE_2D, target.texture);
            // A sampler object left there by somebody else would win over the texture's sampling.
            glow.bind_sampler(unit, None);
            for (name, value) in [
                (glow::TEXTURE_MIN_FILTER, min),
                (glow::TEXTURE_MAG_FILTER, mag),
            ] {
                glow.tex_parameter_i32(glow::TEXTURE_2D, name, value.cast_signed());
            }
        }
    }

    fn rect(&self) -> Rect {
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

/// Copying and clearing obey the scissor test and sRGB conversion, so both go off.
fn prepare_whole(gl: &Gl) {
    let glow = gl.raw();
    // SAFETY: current context; OpenGL ES has no such conversion to switch.
    unsafe {
        glow.disable(glow::SCISSOR_TEST);
        glow.disable(glow::RASTERIZER_DISCARD);
        glow.disable(glow::DITHER);
        if !gl.info().is_gles {
            glow.disable(glow::FRAMEBUFFER_SRGB);
        }
    }
}

fn blit(
    gl: &Gl,
    from: glow::Framebuffer,
    source: Rect,
    to: Option<glow::Framebuffer>,
    target: Rect,
) {
    prepare_whole(gl);
    let same_size = (source.width, source.height) == (target.width, target.height);
    let filter = if same_size {
        glow::NEAREST
    } else {
        glow::LINEAR
    };
    let glow = gl.raw();
    // SAFETY: current context; parts outside of a picture are left out by the driver.
    unsafe {
        glow.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(from));
        glow.bind_framebuffer(glow::DRAW_FRAMEBUFFER, to);
        glow.blit_framebuffer(
            source.x,
            source.y,
            source.x.saturating_add(source.width),
            source.y.saturating_add(source.height),
            target.x,
            target.y,
            target.x.saturating_add(target.width),
            target.y.saturating_add(target.height),
            glow::COLOR_BUFFER_BIT,
            filter,
        );
    }
}
