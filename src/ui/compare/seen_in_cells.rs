//! Which shape is seen where in the live view, cell by cell: to look at every pixel takes too long for a frame.

use crate::editor::Session;
use crate::scene::{ShapeId, shape_seen_by};
use glam::Vec2;
use std::cell::RefCell;
use std::collections::HashMap;

/// Sides of a cell, by how far pixels are apart that stand for those around them.
const CELL: u32 = 2;

/// The shapes that are seen in the cells of a live view that were asked about.
pub(super) struct SeenInCells<'a> {
    session: &'a Session,
    /// Of the live view, in pixels.
    size: Vec2,
    /// Sides of a cell in pixels.
    cell: u32,
    found: RefCell<HashMap<[u32; 2], Option<ShapeId>>>,
}

impl<'a> SeenInCells<'a> {
    /// For pixels so far `apart` in a live view of `size` pixels.
    pub fn new(session: &'a Session, size: Vec2, apart: u32) -> Self {
        Self {
            session,
            size,
            cell: CELL * apart.max(1),
            found: RefCell::default(),
        }
    }

    /// The live view that this is about, and its size in pixels.
    pub fn view(&self) -> (&'a Session, Vec2) {
        (self.session, self.size)
    }

    /// The shape that is seen in the middle of the cell in which a pixel lies; `None` if that is nothing.
    pub fn shape_at(&self, pixel: Vec2) -> Option<ShapeId> {
        let cell = [pixel.x, pixel.y].map(|along| along as u32 / self.cell);
        let seen = || {
            let [x, y] = cell.map(|at| (at * self.cell + self.cell / 2) as f32);
            let camera = &self.session.view().camera;
            let ray = camera.ray(Vec2::new(x, y) + 0.5, self.size);
            shape_seen_by(self.session.evaluated(), &ray)
        };
        *self.found.borrow_mut().entry(cell).or_insert_with(seen)
    }
}
