//! Textures: pictures to show, and tables of numbers to look up in a shader.
//!
//! Making or updating one binds it to the [`SPARE_UNIT`], so that no unit that a draw reads changes.

use std::cell::Cell;

use bytemuck::cast_slice;
use glow::HasContext as _;

use super::{Gl, GpuError};

/// The texture unit for making and updating textures. Draws use the first few; OpenGL ES 3.0 and
/// WebGL 2 promise 32.
pub(in crate::gpu) const SPARE_UNIT: u32 = 31;

/// Color between the centers of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Filter {
    /// The nearest pixel.
    Nearest,
    /// A mixture of the neighbors.
    #[default]
    Linear,
}

/// Color outside of 0..1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Wrap {
    /// The pixel at the edge.
    #[default]
    Clamp,
    /// The picture again.
    Repeat,
}

/// Sampling of a [`Texture`] in a shader.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sampling {
    /// Between pixels.
    pub filter: Filter,
    /// Outside of 0..1.
    pub wrap: Wrap,
    /// Whether smaller versions are made, for a quiet picture from far away.
    pub mipmaps: bool,
}

/// A picture: red, green, blue, alpha, 8 bits each.
pub struct Texture {
    raw: Raw,
}

impl std::fmt::Debug for Texture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Texture")
    }
}

impl Texture {
    /// `pixels`: `4 * width * height` bytes, rows without gaps. The first row is at v = 0.
    ///
    /// # Errors
    /// A side of zero or beyond the driver's limit, data of another length, or no memory.
    pub fn new(
        gl: &Gl,
        width: u32,
        height: u32,
        pixels: &[u8],
        sampling: Sampling,
    ) -> Result<Self, GpuError> {
        let raw = Raw::new(gl)?;
        raw.write(glow::RGBA8, glow::UNSIGNED_BYTE, [width, height], pixels, 4)?;
        let (min, mag) = match (sampling.filter, sampling.mipmaps) {
            (Filter::Nearest, false) => (glow::NEAREST, glow::NEAREST),
            (Filter::Nearest, true) => (glow::NEAREST_MIPMAP_LINEAR, glow::NEAREST),
            (Filter::Linear, false) => (glow::LINEAR, glow::LINEAR),
            (Filter::Linear, true) => (glow::LINEAR_MIPMAP_LINEAR, glow::LINEAR),
        };
        let wrap = match sampling.wrap {
            Wrap::Clamp => glow::CLAMP_TO_EDGE,
            Wrap::Repeat => glow::REPEAT,
        };
        raw.set_sampling(min, mag, wrap);
        if sampling.mipmaps
            && let Some(glow) = raw.bind(SPARE_UNIT)
        {
            // SAFETY: current context; the texture is bound and has its first level.
            unsafe { glow.generate_mipmap(glow::TEXTURE_2D) };
        }
        gl.check("making a texture")?;
        Ok(Self { raw })
    }

    /// Binds it to `unit`, where a `sampler2D` reads it.
    pub fn bind(&self, unit: u32) {
        let _ = self.raw.bind(unit);
    }
}

/// A table of four `f32` a cell, read with `texelFetch`: matrix palettes, for example.
pub struct FloatTexture {
    raw: Raw,
}

impl std::fmt::Debug for FloatTexture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("FloatTexture")
    }
}

impl FloatTexture {
    /// `cells`: `width * height` of them, row after row; cell (x, y) is
    /// `texelFetch(table, ivec2(x, y), 0)`.
    ///
    /// # Errors
    /// A side of zero or beyond the driver's limit, data of another length, or no memory.
    pub fn new(gl: &Gl, width: u32, height: u32, cells: &[[f32; 4]]) -> Result<Self, GpuError> {
        let raw = Raw::new(gl)?;
        raw.set_sampling(glow::NEAREST, glow::NEAREST, glow::CLAMP_TO_EDGE);
        let texture = Self { raw };
        texture.update(width, height, cells)?;
        Ok(texture)
    }

    /// Replaces the content, of any size.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn update(&self, width: u32, height: u32, cells: &[[f32; 4]]) -> Result<(), GpuError> {
        self.raw.write(
            glow::RGBA32F,
            glow::FLOAT,
            [width, height],
            cast_slice(cells),
            16,
        )?;
        self.raw.gl.check("writing a float texture")
    }

    /// Replaces whole rows from the row `first` on.
    ///
    /// # Errors
    /// When they are no whole rows of the table, or a GL error occurred.
    pub fn update_rows(&self, first: u32, cells: &[[f32; 4]]) -> Result<(), GpuError> {
        self.raw.write_rows(first, cells)?;
        self.raw.gl.check("writing rows of a float texture")
    }

    /// Binds it to `unit`, where a `sampler2D` reads it.
    pub fn bind(&self, unit: u32) {
        let _ = self.raw.bind(unit);
    }
}

struct Raw {
    gl: Gl,
    raw: glow::Texture,
    /// Width and height that were written last.
    size: Cell<[u32; 2]>,
}

impl Raw {
    fn new(gl: &Gl) -> Result<Self, GpuError> {
        let create = |why| GpuError::Create {
            what: "texture",
            why,
        };
        let glow = gl.current_for("making a texture")?;
        // SAFETY: current context.
        let raw = unsafe { glow.create_texture() }.map_err(create)?;
        Ok(Self {
            gl: gl.clone(),
            raw,
            size: Cell::default(),
        })
    }

    /// Binds it to `unit` and makes that the active one; the entry points to go on with.
    fn bind(&self, unit: u32) -> Option<&glow::Context> {
        let glow = self.gl.current()?;
        // SAFETY: current context; the driver reports a unit that does not exist.
        unsafe {
            glow.active_texture(glow::TEXTURE0.saturating_add(unit));
            glow.bind_texture(glow::TEXTURE_2D, Some(self.raw));
            // A sampler object left there by other code would replace the texture's sampling.
            glow.bind_sampler(unit, None);
        }
        Some(glow)
    }

    fn set_sampling(&self, min: u32, mag: u32, wrap: u32) {
        let Some(glow) = self.bind(SPARE_UNIT) else {
            return;
        };
        let set = |parameter, value: u32| {
            // SAFETY: current context; the texture is bound, the constants are OpenGL's.
            unsafe {
                glow.tex_parameter_i32(glow::TEXTURE_2D, parameter, value.cast_signed());
            };
        };
        set(glow::TEXTURE_MIN_FILTER, min);
        set(glow::TEXTURE_MAG_FILTER, mag);
        set(glow::TEXTURE_WRAP_S, wrap);
        set(glow::TEXTURE_WRAP_T, wrap);
    }

    fn write(
        &self,
        format: u32,
        component: u32,
        [width, height]: [u32; 2],
        bytes: &[u8],
        bytes_per_cell: usize,
    ) -> Result<(), GpuError> {
        let max = self.gl.info().max_texture_size;
        if !(1..=max).contains(&width) || !(1..=max).contains(&height) {
            return Err(GpuError::Size {
                what: "texture",
                width,
                height,
                max,
            });
        }
        let expected = width as usize * height as usize * bytes_per_cell;
        if bytes.len() != expected {
            let problem = format!("{} bytes, {expected} expected", bytes.len());
            return Err(GpuError::Data {
                what: "texture",
                problem,
            });
        }
        let glow = self.gl.current_for("writing a texture")?;
        self.bind(SPARE_UNIT);
        self.size.set([width, height]);
        // SAFETY: current context; the texture is bound, and the data has exactly the length that the driver will read,
        // since rows are unpacked without gaps. Sizes and formats fit i32.
        unsafe {
            unpack_without_gaps(glow);
            glow.tex_image_2d(
                glow::TEXTURE_2D,
                0,
                format as i32,
                width as i32,
                height as i32,
                0,
                glow::RGBA,
                component,
                glow::PixelUnpackData::Slice(Some(bytes)),
            );
        }
        Ok(())
    }

    /// Replaces whole rows of four `f32` a cell.
    fn write_rows(&self, first: u32, cells: &[[f32; 4]]) -> Result<(), GpuError> {
        let [width, height] = self.size.get();
        let rows = (cells.len() / width.max(1) as usize) as u32;
        let is_whole = rows as usize * width as usize == cells.len();
        if !is_whole || u64::from(first) + u64::from(rows) > u64::from(height) {
            return Err(GpuError::Data {
                what: "texture",
                problem: format!(
                    "{} cells from row {first} on of {width}x{height}",
                    cells.len()
                ),
            });
        }
        let glow = self.gl.current_for("writing rows of a texture")?;
        self.bind(SPARE_UNIT);
        // SAFETY: current context; the texture is bound and has these rows, and the data has exactly the
        // length that the driver will read, since rows are unpacked without gaps. Sizes fit i32.
        unsafe {
            unpack_without_gaps(glow);
            glow.tex_sub_image_2d(
                glow::TEXTURE_2D,
                0,
                0,
                first as i32,
                width as i32,
                rows as i32,
                glow::RGBA,
                glow::FLOAT,
                glow::PixelUnpackData::Slice(Some(cast_slice(cells))),
            );
        }
        Ok(())
    }
}

/// Lets the driver read pictures from memory, row after row.
///
/// # Safety
/// The context of `glow` is current.
unsafe fn unpack_without_gaps(glow: &glow::Context) {
    // SAFETY: by this function's contract.
    unsafe {
        glow.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
        glow.pixel_store_i32(glow::UNPACK_ALIGNMENT, 4);
        glow.pixel_store_i32(glow::UNPACK_ROW_LENGTH, 0);
        glow.pixel_store_i32(glow::UNPACK_SKIP_ROWS, 0);
        glow.pixel_store_i32(glow::UNPACK_SKIP_PIXELS, 0);
    }
}

impl Drop for Raw {
    fn drop(&mut self) {
        if let Some(glow) = self.gl.current() {
            // SAFETY: current context; deleted once.
            unsafe { glow.delete_texture(self.raw) }
        }
    }
}
