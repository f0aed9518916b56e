//! Tables of numbers for shaders: as many cells of four as there are, in rows of one width.

use crate::gpu::{FloatTexture, Gl, GpuError};

/// Cells a row: what every driver can hold. `shaders/skinning.glsl` counts on it.
const WIDTH: u32 = 1024;

/// A table that is written again whenever its content changes.
#[derive(Debug)]
pub(super) struct Table {
    texture: FloatTexture,
}

impl Table {
    /// Holds `cells`, which may be none; shaders find cell `i` at (`i & 1023`, `i >> 10`).
    ///
    /// # Errors
    /// When that takes more than `most_rows` rows, or more memory than there is.
    pub fn new(gl: &Gl, cells: Vec<[f32; 4]>, most_rows: u32) -> Result<Self, GpuError> {
        let (rows, cells) = rows(cells, most_rows)?;
        let texture = FloatTexture::new(gl, WIDTH, rows, &cells)?;
        Ok(Self { texture })
    }

    /// Holds other cells.
    ///
    /// # Errors
    /// As [`Table::new`].
    pub fn update(&self, cells: Vec<[f32; 4]>, most_rows: u32) -> Result<(), GpuError> {
        let (rows, cells) = rows(cells, most_rows)?;
        self.texture.update(WIDTH, rows, &cells)
    }

    /// A `sampler2D` of this unit reads it from now on.
    pub fn bind(&self, unit: u32) {
        self.texture.bind(unit);
    }
}

/// `cells` filled up to whole rows, and how many these are.
fn rows(mut cells: Vec<[f32; 4]>, most: u32) -> Result<(u32, Vec<[f32; 4]>), GpuError> {
    let rows = cells.len().div_ceil(WIDTH as usize).max(1);
    let Some(rows) = u32::try_from(rows).ok().filter(|&rows| rows <= most) else {
        return Err(GpuError::Size {
            what: "table of weights",
            width: WIDTH,
            height: u32::try_from(rows).unwrap_or(u32::MAX),
            max: most,
        });
    };
    cells.resize(rows as usize * WIDTH as usize, [0.0; 4]);
    Ok((rows, cells))
}
