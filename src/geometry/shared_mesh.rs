use super::Mesh;
use crate::revision::Revision;
use std::ops::Deref;
use std::sync::Arc;

/// An immutable mesh shared by reference, with the revision that caches compare.
#[derive(Clone, Debug)]
pub struct SharedMesh {
    mesh: Arc<Mesh>,
    revision: Revision,
}

impl SharedMesh {
    /// Shares `mesh` under a new revision.
    pub fn new(mesh: Mesh) -> Self {
        Self {
            mesh: Arc::new(mesh),
            revision: Revision::new(),
        }
    }

    /// The revision, the same for all copies.
    pub fn revision(&self) -> Revision {
        self.revision
    }
}

impl Deref for SharedMesh {
    type Target = Mesh;

    fn deref(&self) -> &Mesh {
        &self.mesh
    }
}
