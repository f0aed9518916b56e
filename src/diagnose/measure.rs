use super::model::strongest;
use super::precision::Written;
use super::regions::regions;
use super::skin::Placed;
use super::{Region, size_of};
use crate::character::Character;
use glam::Vec3;

/// How far the vertices of a mesh are from the exact ones, which it has in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMeasure {
    /// Of each vertex, in model space; infinite where it has no place.
    pub distances: Vec<f64>,
    /// Diagonal of the box around the exact mesh.
    pub size: f64,
    /// Distance up to which vertices agree.
    pub tolerance: f64,
    /// Number of vertices that do not.
    pub off: usize,
    /// The largest distance.
    pub worst: f64,
    /// The vertex that is farthest off, from 0; `None` if all agree.
    pub worst_vertex: Option<usize>,
    /// Mean distance of all vertices.
    pub mean: f64,
    /// Where vertices are off, by the joints that move them most, the one with the most first.
    pub regions: Vec<Region>,
}

/// Measures how far `theirs` are from the vertices of `character`, which are at `exact` in the pose
/// that they should have; `None` unless there are as many of each. A vertex without weights may be in
/// its place or at the origin.
pub fn measure(character: &Character, exact: &[Vec3], theirs: &[Vec3]) -> Option<MeshMeasure> {
    let attachments = character.attachments();
    if exact.len() != theirs.len() || attachments.vertex_count() != exact.len() || exact.is_empty()
    {
        return None;
    }
    let pairs = exact.iter().zip(theirs).zip(attachments.vertices());
    let distances: Vec<f64> = pairs
        .map(|((exact, theirs), influences)| {
            let placed = Placed {
                at: exact.as_dvec3(),
                is_unweighted: influences.is_empty(),
            };
            placed.distance(theirs.as_dvec3())
        })
        .collect();
    let size = size_of(exact.iter().copied());
    let tolerance = Written::of(theirs, exact.iter().copied()).tolerance(size);
    let is_off = |distance: &&f64| **distance > tolerance;
    let worst = distances.iter().copied().fold(0.0, f64::max);
    let farthest = (0..distances.len()).max_by(|&a, &b| distances[a].total_cmp(&distances[b]));
    let joints = character.skeleton().joints();
    let joint_of = |index: usize| strongest(attachments.of_vertex(index)).unwrap_or(joints.len());
    Some(MeshMeasure {
        size,
        tolerance,
        off: distances.iter().filter(is_off).count(),
        worst,
        worst_vertex: farthest.filter(|_| worst > tolerance),
        mean: distances.iter().sum::<f64>() / distances.len() as f64,
        regions: regions(joints, &distances, (tolerance, size), joint_of),
        distances,
    })
}
