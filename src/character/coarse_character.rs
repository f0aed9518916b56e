//! Characters with fewer triangles, for pictures that are seen for a moment.

use super::{Attachments, Character};
use crate::geometry::{CoarseMesh, SharedMesh};

impl Character {
    /// The same with about one of `fewer` triangles, see [`CoarseMesh::new`]. Its vertices are some of this one's, with
    /// their weights. Those that hang on different joints most stay apart: fingers and thighs are near each other at
    /// rest. `None` for a mesh without an area.
    pub fn coarse(&self, fewer: u32) -> Option<Self> {
        let rows = self.attachments();
        let main_joint = |position: u32| {
            let influences = rows.of_vertex(position as usize);
            Attachments::strongest(influences).unwrap_or(u32::MAX)
        };
        let mesh = self.bind_mesh();
        let coarse = CoarseMesh::new(mesh, fewer, main_joint)?;
        let mut kept = Attachments::new();
        for &position in &coarse.positions {
            kept.push_vertex(rows.of_vertex(position as usize).iter().copied());
        }
        let bind_mesh = SharedMesh::with_bounds(coarse.mesh, mesh.bounds());
        Some(self.with_some_vertices(kept, bind_mesh))
    }
}
