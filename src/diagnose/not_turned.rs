//! Poses that lack one joint: the plainest reason why a mesh is off.

use super::formula::{Formula, VertexOrder};
use super::search::Search;
use super::skin::Skinner;
use crate::math::Euler;
use crate::steps::Pace;

/// A joint without whose rotation the exact formula gives the mesh.
pub(super) struct NotTurned {
    pub(super) joint: usize,
    /// What is left: the largest distance.
    pub(super) error: f64,
}

/// Joints each of which, left as it is in the bind pose, gives the mesh of `search`, with vertices in `order`. Where no other
/// joint is turned that is the whole pose, and none is told.
pub(super) async fn find(search: &Search<'_>, order: VertexOrder, pace: &Pace) -> Vec<NotTurned> {
    let formula = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let mut found = Vec::new();
    for joint in 0..search.model.skeleton().joints().len() {
        if search.pose.rotation(joint) == Euler::default() {
            continue;
        }
        let mut pose = search.pose.clone();
        pose.set_joint_transform(joint, Euler::default());
        if pose.is_bind() {
            continue;
        }
        let mut skinner = Skinner::new(search.model, &pose, &formula);
        let given = search.explained_by(&mut skinner, Vec::new(), pace).await;
        found.extend(given.map(|given| NotTurned {
            joint,
            error: given.error,
        }));
    }
    found
}
