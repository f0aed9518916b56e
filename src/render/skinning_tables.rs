//! Tables that the vertex shaders skin with, and the influences of vertices in one.

use crate::character::{Attachments, Character};
use crate::gpu::{FloatTexture, Gl, GpuError};

/// Influences of a vertex in the table: the first cell, and the number of cells.
pub(super) type Run = [u32; 2];

/// The weights of a character in the memory of the graphics card, where its vertex shader reads
/// them. They depend on the character alone: a pose changes nothing here.
#[derive(Debug)]
pub(super) struct Skin {
    influences: Table,
}

impl Skin {
    /// Uploads the weights. The runs, one a position, are attributes of the vertices.
    pub fn new(
        gl: &Gl,
        character: &Character,
        most_rows: u32,
    ) -> Result<(Self, Vec<Run>), GpuError> {
        let (cells, runs) = pairs(character.attachments());
        let skin = Self {
            influences: Table::new(gl, cells, most_rows)?,
        };
        Ok((skin, runs))
    }

    /// Binds the influences to a texture unit.
    pub fn bind(&self, unit: u32) {
        self.influences.bind(unit);
    }
}

/// Two influences a cell, each run from the start of a cell; a joint's number is exact in `f32` up
/// to 16 million.
fn pairs(attachments: &Attachments) -> (Vec<[f32; 4]>, Vec<Run>) {
    let mut cells = Vec::new();
    let runs = attachments
        .vertices()
        .map(|influences| {
            let start = cells.len() as u32;
            cells.extend(influences.chunks(2).map(|pair| {
                let number = |i: usize| pair.get(i).map_or(0.0, |i| i.joint as f32);
                let weight = |i: usize| pair.get(i).map_or(0.0, |i| i.weight);
                [number(0), weight(0), number(1), weight(1)]
            }));
            [start, cells.len() as u32 - start]
        })
        .collect();
    (cells, runs)
}

/// Cells in a row: as many as every driver can hold. `shaders/skinning.glsl` depends on it.
pub(super) const WIDTH: u32 = 1024;

/// A float texture of any number of cells, four numbers a cell, in rows of one width.
#[derive(Debug)]
pub(super) struct Table {
    texture: FloatTexture,
    rows: u32,
}

impl Table {
    /// Uploads `cells`, of which there may be none; cell `i` is at (`i & 1023`, `i >> 10`).
    ///
    /// # Errors
    /// When that takes more than `most_rows` rows, or more memory than there is.
    pub fn new(gl: &Gl, cells: Vec<[f32; 4]>, most_rows: u32) -> Result<Self, GpuError> {
        let (rows, cells) = rows(cells, most_rows)?;
        let texture = FloatTexture::new(gl, WIDTH, rows, &cells)?;
        Ok(Self { texture, rows })
    }

    /// Replaces whole rows of cells from the row `first` on.
    ///
    /// # Errors
    /// When the table has no such rows.
    pub fn update_rows(&self, first: u32, cells: &[[f32; 4]]) -> Result<(), GpuError> {
        self.texture.update_rows(first, cells)
    }

    /// Number of its rows.
    pub fn rows(&self) -> usize {
        self.rows as usize
    }

    /// Binds it to a texture unit.
    pub fn bind(&self, unit: u32) {
        self.texture.bind(unit);
    }
}

/// The number of rows, and `cells` padded to whole rows.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Influence;

    #[test]
    fn every_influence_is_in_its_vertex_run_two_a_cell() {
        let mut attachments = Attachments::new();
        for count in [3, 0, 2, 1] {
            attachments.push_vertex((0..count).map(|joint| Influence {
                joint,
                weight: 0.5 + joint as f32,
            }));
        }
        let (cells, runs) = pairs(&attachments);
        assert_eq!(runs, [[0, 2], [2, 0], [2, 1], [3, 1]]);
        assert_eq!(cells[0], [0.0, 0.5, 1.0, 1.5]);
        assert_eq!(cells[1], [2.0, 2.5, 0.0, 0.0]);
        assert_eq!(cells[2..], [[0.0, 0.5, 1.0, 1.5], [0.0, 0.5, 0.0, 0.0]]);
    }
}
