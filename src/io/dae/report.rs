//! What a file holds, for those who want to know.

use super::instances::Binding;
use super::nodes::SceneNode;
use super::space::FileSpace;
use glam::DMat4;
use std::collections::BTreeMap;

/// What was found in a Collada file besides the characters and meshes made of it.
#[derive(Clone, Debug, PartialEq)]
pub struct DaeReport {
    /// Its axes and unit.
    pub space: FileSpace,
    /// Skinned meshes.
    pub skins: usize,
    /// Smallest and largest sum of a position's weights before they were divided by it; `None`
    /// without weights.
    pub weight_sums: Option<(f32, f32)>,
    /// Positions of skins that no joint moves.
    pub unweighted: usize,
    /// The joint whose inverse bind matrix agrees worst with the scene's rest pose; `None`
    /// without any.
    pub worst_inverse_bind: Option<InverseBind>,
    /// What the file has and this program has no use for, and how often.
    pub ignored: BTreeMap<String, usize>,
}

/// How an inverse bind matrix agrees with the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct InverseBind {
    /// The joint's name.
    pub joint: String,
    /// The largest number by which the product of its matrix in the scene and its inverse bind
    /// matrix differs from the identity; lengths in the file's unit.
    pub difference: f64,
}

/// Above this a difference of bind matrices is worth a warning: files written with seven digits
/// stay well below.
const NOTEWORTHY: f64 = 1e-3;

impl DaeReport {
    pub(super) fn new(space: FileSpace) -> Self {
        Self {
            space,
            skins: 0,
            weight_sums: None,
            unweighted: 0,
            worst_inverse_bind: None,
            ignored: BTreeMap::new(),
        }
    }

    pub(super) fn add_weight_sum(&mut self, sum: f32) {
        let (least, most) = self.weight_sums.unwrap_or((sum, sum));
        self.weight_sums = Some((least.min(sum), most.max(sum)));
    }

    /// Compares a skin's inverse bind matrices with the scene; what there is to warn of.
    pub(super) fn add_inverse_binds(
        &mut self,
        binding: &Binding,
        nodes: &[SceneNode],
    ) -> Option<String> {
        let pairs = binding.joints.iter().zip(&binding.skin.inverse_binds);
        let worst = pairs
            .filter_map(|(&node, inverse_bind)| {
                let node = &nodes[node?];
                let product = node.world * *inverse_bind - DMat4::IDENTITY;
                let numbers = product.to_cols_array();
                let difference = numbers.iter().fold(0.0, |most: f64, n| most.max(n.abs()));
                let joint = node.name().to_owned();
                Some(InverseBind { joint, difference })
            })
            .max_by(|a, b| a.difference.total_cmp(&b.difference))?;
        let warning = (worst.difference > NOTEWORTHY).then(|| {
            format!(
                "expected inverse bind matrices that agree with the scene's rest pose, found a difference of {:.3e} at {}: the scene's is used",
                worst.difference,
                super::quoted(&worst.joint)
            )
        });
        let known = self.worst_inverse_bind.as_ref();
        if known.is_none_or(|known| known.difference < worst.difference) {
            self.worst_inverse_bind = Some(worst);
        }
        warning
    }
}
