use super::Mesh;
use std::ops::Deref;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Says whether something changed: two equal revisions mean equal content. All come from one
/// counter and none is used twice, so going back to an older state brings its revision back and
/// whatever was cached for it is right again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Revision(u64);

impl Revision {
    /// A revision that nothing else has.
    #[allow(clippy::new_without_default, reason = "every call gives another value")]
    pub fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// A mesh that is shared and never changes, with the revision by which caches know it.
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
