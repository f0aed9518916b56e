//! Where bones end. Collada has joints only; that a bone runs along its joint's own +Y is
//! Blender's custom, and how long it is takes some reading between the lines.

use super::document::{child, children};
use super::nodes::SceneNode;
use super::numbers::text;
use super::rigs::Rig;
use glam::{DMat4, DVec3};

/// A bone without any word of its length gets this share of its parent's.
const SHARE_OF_PARENT: f64 = 0.4;

/// The end of each joint's bone at rest, relative to the joint, in our axes; `None` where nothing
/// in the file says.
pub(super) fn of_joints(
    rig: &Rig,
    nodes: &[SceneNode],
    ours_from_joint: &[DMat4],
    parents: &[Option<usize>],
) -> Vec<Option<DVec3>> {
    let mut first_child = vec![None; parents.len()];
    for (joint, parent) in parents.iter().enumerate() {
        if let Some(parent) = *parent {
            first_child[parent].get_or_insert(joint);
        }
    }
    let mut tips: Vec<Option<DVec3>> = Vec::with_capacity(parents.len());
    for (joint, matrix) in ours_from_joint.iter().enumerate() {
        let along = matrix.y_axis.truncate();
        let to_child = first_child[joint].and_then(|child: usize| {
            let height = height_above(matrix, ours_from_joint[child].w_axis.truncate());
            height.map(|height| along * height)
        });
        let written = || {
            let length = blender_tip(&nodes[rig.nodes[joint]])?.length();
            (length > 0.0).then(|| along * length)
        };
        let share = || {
            let parent: DVec3 = tips[parents[joint]?]?;
            Some(along.try_normalize()? * parent.length() * SHARE_OF_PARENT)
        };
        let tip = to_child.or_else(written).or_else(share);
        tips.push(tip.filter(|tip| tip.is_finite() && *tip != DVec3::ZERO));
    }
    tips
}

/// How far along a joint's +Y `point` lies, in the joint's own units, if it does at all.
fn height_above(ours_from_joint: &DMat4, point: DVec3) -> Option<f64> {
    let determinant = ours_from_joint.determinant();
    let height = ours_from_joint.inverse().transform_point3(point).y;
    (determinant != 0.0 && height.is_finite() && height > 1e-6).then_some(height)
}

/// What Blender writes beside a bone that has no child to end at: from its head to its tip.
fn blender_tip(node: &SceneNode) -> Option<DVec3> {
    let technique = children(node.xml, "extra")
        .flat_map(|extra| children(extra, "technique"))
        .find(|technique| technique.attribute("profile") == Some("blender"))?;
    let number = |tag| text(child(technique, tag)?).parse::<f64>().ok();
    let tip = DVec3::new(number("tip_x")?, number("tip_y")?, number("tip_z")?);
    tip.is_finite().then_some(tip)
}
