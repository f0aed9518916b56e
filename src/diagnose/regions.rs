//! Where vertices are off, by the joints that move them most.

use super::Region;
use crate::character::Joint;

/// What each of `joints` moves and is off by the `distances` of vertices, the one with the farthest vertex first.
/// `limits` are the distance up to which vertices agree, and the size. `joint_of` tells the joint that
/// moves a vertex most, or the number of joints if none does.
pub(super) fn regions(
    joints: &[Joint],
    distances: &[f64],
    (tolerance, size): (f64, f64),
    joint_of: impl Fn(usize) -> usize,
) -> Vec<Region> {
    let name = |joint: usize| joints.get(joint).map(|joint| joint.name.clone());
    let mut regions: Vec<Region> = (0..=joints.len())
        .map(|joint| Region {
            joint: name(joint),
            joint_index: (joint < joints.len()).then_some(joint),
            vertices: 0,
            off: 0,
            share: 0.0,
            worst: 0.0,
            worst_vertex: 0,
        })
        .collect();
    for (index, &distance) in distances.iter().enumerate() {
        let region = &mut regions[joint_of(index)];
        region.vertices += 1;
        if distance > tolerance {
            region.off += 1;
            if distance / size > region.worst {
                region.worst = distance / size;
                region.worst_vertex = index;
            }
        }
    }
    regions.retain(|region| region.off > 0);
    for region in &mut regions {
        region.share = region.off as f64 / region.vertices as f64;
    }
    regions.sort_by(|a, b| b.worst.total_cmp(&a.worst));
    regions
}
