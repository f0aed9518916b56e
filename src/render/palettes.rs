//! Places, colors and joints of all characters that the graphics card skins, in one table.

use super::skinning_tables::{Table, WIDTH};
use super::surface_pass::normal_matrix;
use crate::gpu::{Gl, GpuError};
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedShape, ShapeId};
use glam::{Mat3, Mat4, Vec3};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Cells of a character before those of its joints. `shaders/skinning.glsl` depends on it.
const PLACE: usize = 8;

/// What the vertex shader needs to know of each character, in one table, so that it draws many copies
/// at once. Of those that stand still nothing is written: a pose takes some kilobytes, and no vertices.
#[derive(Debug, Default)]
pub(super) struct Palettes {
    table: Option<Table>,
    /// The cells of the table, with those that are not written yet.
    cells: Vec<[f32; 4]>,
    slots: HashMap<ShapeId, Slot>,
    /// First cells of slots that are free, and their sizes.
    free: Vec<(usize, usize)>,
}

/// The cells of a character.
#[derive(Debug)]
struct Slot {
    first: usize,
    size: usize,
    /// What is in them.
    holds: Option<Content>,
}

/// What the cells of a character follow from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Content {
    pose: Revision,
    world_from_model: Mat4,
    color: Vec3,
}

impl Palettes {
    /// Updates the table for `skinned`, each with its color, without those that nothing deforms. Others
    /// that are `present` keep their cells.
    ///
    /// # Errors
    /// When the table takes more than `most_rows` rows, or more memory than there is.
    pub fn update<'a>(
        &mut self,
        gl: &Gl,
        present: &HashSet<ShapeId>,
        skinned: impl Iterator<Item = (&'a EvaluatedShape, Vec3)>,
        most_rows: u32,
    ) -> Result<(), GpuError> {
        self.forget_deleted(present);
        let mut changed = BTreeSet::new();
        for (shape, color) in skinned {
            let Some(deformation) = &shape.geometry.deformation else {
                continue;
            };
            let content = Content {
                pose: shape.geometry.revision,
                world_from_model: shape.world_from_model,
                color,
            };
            let joints = deformation.model_from_joint().len();
            let slot = self.slot(shape.id, PLACE + 3 * joints);
            if slot.holds == Some(content) {
                continue;
            }
            slot.holds = Some(content);
            let cells = slot.first..slot.first + slot.size;
            let row = |cell: usize| cell / WIDTH as usize;
            changed.extend(row(cells.start)..=row(cells.end - 1));
            for (cell, value) in self.cells[cells]
                .iter_mut()
                .zip(written(content, deformation))
            {
                *cell = value;
            }
        }
        let written = self.write(gl, &changed, most_rows);
        if written.is_err() {
            *self = Self::default();
        }
        written
    }

    /// Binds the table to a texture unit.
    pub fn bind(&self, unit: u32) {
        if let Some(table) = &self.table {
            table.bind(unit);
        }
    }

    /// First cell of the shape `id` in the table.
    pub fn first_cell(&self, id: ShapeId) -> Option<i32> {
        i32::try_from(self.slots.get(&id)?.first).ok()
    }

    fn forget_deleted(&mut self, present: &HashSet<ShapeId>) {
        let free = &mut self.free;
        self.slots.retain(|id, slot| {
            let is_present = present.contains(id);
            if !is_present {
                free.push((slot.first, slot.size));
            }
            is_present
        });
    }

    /// The slot of a shape, of `size` cells.
    fn slot(&mut self, id: ShapeId, size: usize) -> &mut Slot {
        let Self {
            cells, slots, free, ..
        } = self;
        let mut take = || {
            let fitting = free.iter().position(|&(_, free)| free == size);
            let first = match fitting {
                Some(fitting) => free.swap_remove(fitting).0,
                None => {
                    cells.resize(cells.len() + size, [0.0; 4]);
                    cells.len() - size
                }
            };
            Slot {
                first,
                size,
                holds: None,
            }
        };
        let slot = slots.entry(id).or_insert_with(&mut take);
        if slot.size != size {
            let other = std::mem::replace(slot, take());
            free.push((other.first, other.size));
        }
        slot
    }

    /// Writes the rows that have changed; all of them if the table has to grow.
    fn write(&mut self, gl: &Gl, rows: &BTreeSet<usize>, most_rows: u32) -> Result<(), GpuError> {
        let width = WIDTH as usize;
        let needed = self.cells.len().div_ceil(width);
        let held = self.table.as_ref().map_or(0, Table::rows);
        let Some(table) = self.table.as_ref().filter(|_| needed <= held) else {
            if !rows.is_empty() {
                // Room for as many more, so that it does not grow with each character.
                let room = needed.next_power_of_two().min(most_rows as usize);
                let mut cells = self.cells.clone();
                cells.resize(room.max(needed) * width, [0.0; 4]);
                self.table = Some(Table::new(gl, cells, most_rows)?);
            }
            return Ok(());
        };
        let mut left = rows.iter().copied().peekable();
        while let Some(first) = left.next() {
            let mut end = first + 1;
            while left.next_if_eq(&end).is_some() {
                end += 1;
            }
            let there = self.cells.len().min(end * width);
            let mut cells = self.cells[first * width..there].to_vec();
            cells.resize((end - first) * width, [0.0; 4]);
            table.update_rows(first as u32, &cells)?;
        }
        Ok(())
    }
}

/// The cells of a character as `shaders/skinning.glsl` reads them.
fn written(content: Content, deformation: &Deformation) -> impl Iterator<Item = [f32; 4]> {
    let world_from_model = content.world_from_model;
    let Mat3 {
        x_axis,
        y_axis,
        z_axis,
    } = normal_matrix(world_from_model);
    let others = [x_axis, y_axis, z_axis, content.color].map(|v| v.extend(0.0).to_array());
    let joints = deformation
        .palette()
        .into_iter()
        .flat_map(|model_from_bind| {
            let rows = model_from_bind.transpose();
            [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.to_array())
        });
    let columns = world_from_model.to_cols_array_2d();
    columns.into_iter().chain(others).chain(joints)
}
