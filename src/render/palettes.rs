use super::table::Table;
use crate::gpu::{Gl, GpuError};
use crate::revision::Revision;
use crate::scene::{Deformation, EvaluatedShape, ShapeId};

/// The joints' transforms of all characters that the graphics card skins, one after the other in
/// one table. Written when one of them has a new pose: some kilobytes, and no vertex.
#[derive(Debug, Default)]
pub(super) struct Palettes {
    table: Option<Table>,
    /// Whose transforms the table holds, of which revision, and where they start, in joints.
    held: Vec<(ShapeId, Revision, u32)>,
}

impl Palettes {
    /// Brings the table up to date with `shapes`; those that nothing deforms are passed over.
    pub fn update<'a>(
        &mut self,
        gl: &Gl,
        shapes: impl Iterator<Item = &'a EvaluatedShape>,
        most_rows: u32,
    ) -> Result<(), GpuError> {
        let deformed: Vec<(&EvaluatedShape, &Deformation)> = shapes
            .filter_map(|shape| Some((shape, shape.geometry.deformation.as_ref()?)))
            .collect();
        let is_held = |(held, (shape, _)): (&(ShapeId, Revision, u32), &(&EvaluatedShape, _))| {
            (held.0, held.1) == (shape.id, shape.geometry.revision)
        };
        if self.held.len() == deformed.len() && self.held.iter().zip(&deformed).all(is_held) {
            return Ok(());
        }
        self.held.clear();
        let mut cells = Vec::new();
        let mut held = Vec::with_capacity(deformed.len());
        for (shape, deformation) in deformed {
            held.push((shape.id, shape.geometry.revision, (cells.len() / 3) as u32));
            for model_from_bind in deformation.palette() {
                let rows = model_from_bind.transpose();
                cells.extend([rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.to_array()));
            }
        }
        match &self.table {
            Some(table) => table.update(cells, most_rows)?,
            None => self.table = Some(Table::new(gl, cells, most_rows)?),
        }
        self.held = held;
        Ok(())
    }

    /// Lets a `sampler2D` of `unit` read the table; where the joints of `id` start in it.
    pub fn bind(&self, unit: u32, id: ShapeId) -> Option<u32> {
        let &(_, _, first_joint) = self.held.iter().find(|held| held.0 == id)?;
        self.table.as_ref()?.bind(unit);
        Some(first_joint)
    }
}
