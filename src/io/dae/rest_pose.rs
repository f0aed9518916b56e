//! Skins in the scene's rest pose, which need not be the pose that they were bound in.
//!
//! Skeleton and mesh are shown as the nodes of the scene have them, and all angles are 0 there. A
//! position of a skin is at `Σ weight · world of the joint · its inverse bind matrix · bind
//! shape · position` (Collada 1.4.1, chapter 4, "Skin deformation"). The node that shows the skin
//! takes no part: where skeleton and mesh were bound with different turns, the inverse bind
//! matrices hold the difference. three.js and assimp show the same; Blender leaves the node out, too,
//! but opens skeleton and mesh in the bind pose.
//!
//! Poses deform the mesh of the rest pose, as after Blender's "Apply Pose as Rest Pose". This is
//! exact for positions whose joints share one transform from bind to rest pose, such as those with
//! a single influence. Others do not return quite to the bound mesh when the pose does.

use super::instances::Binding;
use super::report::InverseBind;
use super::visual_scene::SceneNode;
use crate::character::Influence;
use glam::{DMat3, DMat4, Vec3};
use std::collections::HashMap;

/// Differences of matrices up to this are rounding: files written with seven digits stay well
/// below. Translations are measured by the size of the skin.
const ROUNDING: f64 = 1e-3;

/// Transforms of a skin from its bind pose to the scene's rest pose, in the file's space.
pub(super) struct RestPose {
    /// By joint of the rig, for those with an inverse bind matrix.
    rest_from_bind: HashMap<u32, DMat4>,
    /// Transform of the first joint that has one; the identity if none does.
    first: DMat4,
    /// Whether all joints share one transform, so that the mesh is moved as a whole.
    pub as_a_whole: bool,
    /// The joint whose inverse bind matrix agrees worst with the scene.
    pub worst: Option<InverseBind>,
    /// Number of inverse bind matrices that cannot be inverted and are left out.
    pub singular: usize,
}

impl RestPose {
    /// Rest pose of `binding`, whose mesh has these `positions`. `joint_of_node` gives the rig's
    /// joint for each node.
    pub fn new(
        binding: &Binding,
        positions: &[Vec3],
        nodes: &[SceneNode],
        joint_of_node: &HashMap<usize, u32>,
    ) -> Self {
        let mut rest = Self {
            rest_from_bind: HashMap::new(),
            first: DMat4::IDENTITY,
            as_a_whole: true,
            worst: None,
            singular: 0,
        };
        if binding.skin.inverse_binds.is_empty() {
            return rest;
        }
        let size = size(binding, positions, nodes);
        let rounding = |a: &DMat4, b: &DMat4| {
            let [x, y, z, place] = [0, 1, 2, 3].map(|column| (a.col(column) - b.col(column)).abs());
            let linear = x.max(y).max(z).max_element();
            linear <= ROUNDING && place.max_element() <= ROUNDING * size
        };
        for (&node, inverse_bind) in binding.joints.iter().zip(&binding.skin.inverse_binds) {
            let Some(node) = node else { continue };
            if DMat3::from_mat4(*inverse_bind).determinant() == 0.0 {
                rest.singular += 1;
                continue;
            }
            let Some(&joint) = joint_of_node.get(&node) else {
                continue;
            };
            let exact = nodes[node].world * *inverse_bind;
            rest.keep_worst(&nodes[node], &exact);
            let agrees = rounding(&exact, &DMat4::IDENTITY);
            let matrix = if agrees { DMat4::IDENTITY } else { exact };
            if rest.rest_from_bind.is_empty() {
                rest.first = matrix;
            }
            rest.as_a_whole &= rounding(&matrix, &rest.first);
            rest.rest_from_bind.entry(joint).or_insert(matrix);
        }
        rest
    }

    fn keep_worst(&mut self, node: &SceneNode, rest_from_bind: &DMat4) {
        let numbers = (*rest_from_bind - DMat4::IDENTITY).to_cols_array();
        let difference = numbers.iter().fold(0.0, |most: f64, n| most.max(n.abs()));
        let known = self.worst.as_ref();
        if known.is_none_or(|known| known.difference < difference) {
            let joint = node.name().to_owned();
            self.worst = Some(InverseBind { joint, difference });
        }
    }

    /// Transform of the mesh if it is moved as a whole, and of positions without weights.
    pub fn first(&self) -> DMat4 {
        self.first
    }

    /// Transform of a position with these influences: the weighted mean of the joints' transforms;
    /// joints without an inverse bind matrix count as the first.
    pub fn of_influences(&self, influences: &[Influence]) -> DMat4 {
        let (mut sum, mut weights) = (DMat4::ZERO, 0.0);
        for &Influence { joint, weight } in influences {
            let matrix = self.rest_from_bind.get(&joint).unwrap_or(&self.first);
            sum += *matrix * f64::from(weight);
            weights += f64::from(weight);
        }
        if weights > 0.0 {
            sum * weights.recip()
        } else {
            self.first
        }
    }
}

/// The largest coordinate of the mesh as it was bound and of its joints in the scene.
fn size(binding: &Binding, positions: &[Vec3], nodes: &[SceneNode]) -> f64 {
    let bind_shape = binding.skin.bind_shape;
    let positions = positions
        .iter()
        .map(|position| bind_shape.transform_point3(position.as_dvec3()));
    let joints = binding.joints.iter().flatten();
    let places = joints.map(|&node| nodes[node].world.w_axis.truncate());
    positions
        .chain(places)
        .map(|place| place.abs().max_element())
        .fold(0.0, f64::max)
}
