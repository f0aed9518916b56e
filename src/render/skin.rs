use super::table::Table;
use crate::character::{Attachments, Character};
use crate::gpu::{Gl, GpuError};
use std::sync::Arc;

/// Where a vertex' influences are in the table: the first cell, and how many.
pub(super) type Run = [u32; 2];

/// The weights of a character in the memory of the graphics card, where its vertex shader reads
/// them. They depend on the character alone: a pose changes nothing here.
#[derive(Debug)]
pub(super) struct Skin {
    character: Arc<Character>,
    influences: Table,
}

impl Skin {
    /// Uploads the weights. The runs, one a position, are for the vertices to carry.
    pub fn new(
        gl: &Gl,
        character: &Arc<Character>,
        most_rows: u32,
    ) -> Result<(Self, Vec<Run>), GpuError> {
        let (cells, runs) = pairs(character.attachments());
        let skin = Self {
            character: character.clone(),
            influences: Table::new(gl, cells, most_rows)?,
        };
        Ok((skin, runs))
    }

    /// Whether these are the weights of `character`.
    pub fn is_of(&self, character: &Arc<Character>) -> bool {
        Arc::ptr_eq(&self.character, character)
    }

    /// A `sampler2D` of this unit reads the influences from now on.
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
