use super::{DiagnoseError, Diagnosis, diagnose_by};
use crate::character::{Character, Pose};
use crate::geometry::SharedMesh;
use crate::steps::Steps;
use std::sync::Arc;

/// Vertices that a step works on, each of which is skinned once.
const STEP: usize = 1 << 12;

/// What [`super::diagnose`] needs, to be carried out elsewhere than where it was begun.
#[derive(Clone, Debug)]
pub struct MeshJob {
    /// The character.
    pub character: Arc<Character>,
    /// The pose that the mesh should have.
    pub pose: Pose,
    /// The mesh, in model space.
    pub theirs: SharedMesh,
}

impl MeshJob {
    /// The diagnosis, with the errors of [`super::diagnose`], in steps of some milliseconds.
    pub fn diagnose(self) -> Steps<'static, Result<Diagnosis, DiagnoseError>> {
        Steps::new(STEP, |pace| async move {
            diagnose_by(&self.character, &self.pose, &self.theirs, pace).await
        })
    }
}
