//! Bodies grown from a field, mirrored in x = 0, with weights that flow along their surface.
use super::super::mesh::{Mirrored, mirror};
use super::super::polygonize::{Grid, polygonize};
use super::super::remesh::{Target, remesh};
use super::super::rig::Joint;
use super::super::skin;
use super::model::{Bone, Rig, Weights};
use glam::DVec3;

/// What a body is grown from: the left half of its field, where that may be, and the wanted length
/// of edges at a place.
pub struct Seed<'a> {
    pub field: &'a dyn Fn(DVec3) -> f64,
    pub grid: Grid,
    pub size: &'a dyn Fn(DVec3) -> f64,
}

/// The whole body.
pub fn grow(seed: &Seed) -> Mirrored {
    let target = Target {
        field: seed.field,
        size: seed.size,
        rounds: 8,
    };
    mirror(&remesh(&polygonize(seed.field, &seed.grid), &target))
}

/// Adds a bone at `head`, and its reflection if the name says `Left`; tells the left one.
pub fn bone(rig: &mut Rig, name: &str, parent: &str, head: DVec3, tail: DVec3) {
    let find = |rig: &Rig, name: &str| rig.bones.iter().position(|bone| bone.name == name);
    let at = find(rig, parent);
    rig.bone(name, at, head, tail);
    if let Some(rest) = name.strip_prefix("Left ") {
        let other = |p: DVec3| DVec3::new(-p.x, p.y, p.z);
        let parent = parent.replacen("Left ", "Right ", 1);
        let at = find(rig, &parent);
        rig.bone(format!("Right {rest}"), at, other(head), other(tail));
    }
}

/// Weights for a body: `owner` names the bone of a place, whose border to the next is softened
/// over `reach` there.
pub fn weights(
    body: &Mirrored,
    bones: &[Bone],
    owner: &dyn Fn(DVec3) -> usize,
    reach: &dyn Fn(DVec3) -> f64,
) -> Vec<Weights> {
    let twin = |name: &str| {
        let other = match name.split_once(' ') {
            Some(("Left", rest)) => format!("Right {rest}"),
            Some(("Right", rest)) => format!("Left {rest}"),
            _ => return None,
        };
        bones.iter().position(|bone| bone.name == other)
    };
    let joint = |twin: usize| Joint {
        name: "",
        offset: DVec3::ZERO,
        parent: None,
        twin,
    };
    // Weights are spread for all joints but a first one, which moves nothing.
    let mut joints = vec![joint(0)];
    joints.extend(
        bones
            .iter()
            .enumerate()
            .map(|(i, bone)| joint(1 + twin(&bone.name).unwrap_or(i))),
    );
    let rows = skin::weights(body, &joints, &|p| 1 + owner(p), reach);
    let sparse = |row: Vec<f64>| row.into_iter().enumerate().filter(|w| w.1 > 0.0).collect();
    rows.into_iter().map(sparse).collect()
}
