//! Facts about a Collada file, for `editor check`.

use super::visual_scene::FileSpace;
use std::collections::BTreeMap;

/// Facts about a Collada file besides its characters and meshes.
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
    /// Content that this program does not use, by kind, with the number of each.
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

    /// Keeps `worst` if no other skin's agrees worse with the scene.
    pub(super) fn add_inverse_bind(&mut self, worst: &InverseBind) {
        let known = self.worst_inverse_bind.as_ref();
        if known.is_none_or(|known| known.difference < worst.difference) {
            self.worst_inverse_bind = Some(worst.clone());
        }
    }
}
