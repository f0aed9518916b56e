//! Meshes that come of skinning the result of another test in place of the mesh at rest, as programs give them that
//! skin what they have skinned before.

use crate::character::{Character, Pose};
use crate::diagnose::measure;
use crate::geometry::Mesh;
use glam::Vec3;

/// Another test of the same character, the result of which a program may have kept.
pub(super) struct Earlier<'a> {
    pub name: &'a str,
    pub pose: &'a Pose,
}

/// Of which results `theirs` comes when they are skinned in `pose`, in words, and how far it is from that by the size:
/// of one that is `before` or `after` this test, or of all before it one upon the other.
pub(super) fn find(
    character: &Character,
    pose: &Pose,
    theirs: &Mesh,
    before: &[Earlier<'_>],
    after: &[Earlier<'_>],
) -> Option<(String, f64)> {
    let alone = before.iter().chain(after).map(std::slice::from_ref);
    let all_before = Some(before).filter(|before| before.len() > 1);
    let mut left = alone.chain(all_before).filter_map(|tests| {
        let mut poses = tests.iter().map(|test| test.pose).chain([pose]);
        let rest = character.bind_mesh().positions.clone();
        let skinned = poses.try_fold(rest, |places, pose| skinned(character, places, pose));
        let measured = measure(character, &skinned?, &theirs.positions)?;
        let names: Vec<&str> = tests.iter().map(|test| test.name).collect();
        let told = match &names[..] {
            [name] => format!("that of {name}"),
            names => format!("that of {} one upon the other", names.join(", ")),
        };
        (measured.off == 0).then(|| (told, measured.worst / measured.size))
    });
    left.next()
}

/// What the formula makes of vertices at `places` in model space instead of those at rest.
fn skinned(character: &Character, places: Vec<Vec3>, pose: &Pose) -> Option<Vec<Vec3>> {
    let mesh = Mesh::new(places, character.bind_mesh().triangles.clone());
    let attachments = character.attachments().clone();
    let placed = Character::new(character.skeleton().clone(), attachments, mesh);
    Some(placed.ok()?.skin_pose(pose))
}
