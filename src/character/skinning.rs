//! Skeletal subspace deformation: `v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v` over every joint with a weight (assignment,
//! "SSD").

use super::{Attachments, Influence};
use crate::math::{Aabb, cofactors};
use glam::{Mat3, Mat4, Vec3, Vec4};

/// Skins positions: moves every bind position by the weighted sum of its joints' transforms. The
/// reference that faster ways are tested against.
///
/// `palette` is `T · B⁻¹` by joint, `bind` and `skinned` are in model space and have one entry per
/// vertex of `attachments`. Weights are used as they are: where they do not sum to one the vertex
/// shrinks towards the model's origin or grows away from it, as in the assignment's formula. A
/// vertex without any weight stays at its bind position.
///
/// # Panics
/// If the lengths differ or an influence names a joint that the palette lacks; [`super::Character`]
/// rules both out.
#[doc(alias = "updateMeshVertices")]
pub fn skin_positions(
    palette: &[Mat4],
    attachments: &Attachments,
    bind: &[Vec3],
    skinned: &mut [Vec3],
) {
    assert_eq!(bind.len(), attachments.vertex_count());
    assert_eq!(skinned.len(), bind.len());
    for ((influences, &bind), skinned) in attachments.vertices().zip(bind).zip(skinned) {
        *skinned = if influences.is_empty() {
            bind
        } else {
            let mut blended = [Vec4::ZERO; 4];
            for influence in influences {
                let model_from_bind = &palette[influence.joint as usize];
                blended[0] += model_from_bind.x_axis * influence.weight;
                blended[1] += model_from_bind.y_axis * influence.weight;
                blended[2] += model_from_bind.z_axis * influence.weight;
                blended[3] += model_from_bind.w_axis * influence.weight;
            }
            (blended[0] * bind.x + blended[1] * bind.y + blended[2] * bind.z + blended[3])
                .truncate()
        };
    }
}

/// Skins normals by the inverse transpose of the same weighted sum that moves the positions. Joints
/// only rotate and translate, but a sum of rotations is not a rotation, so the sum itself would
/// tilt normals where joints disagree.
///
/// `palette` is `T · B⁻¹` by joint. `vertices` gives for each vertex the index of the position
/// whose weights it has, and its unit normal in the bind pose, in model space. Returns unit
/// normals; where the sum is singular, the bind normal.
///
/// # Panics
/// If a vertex names a position that `attachments` lacks or an influence a joint that the palette
/// lacks; [`super::Character`] rules both out.
pub fn skin_normals(
    palette: &[Mat4],
    attachments: &Attachments,
    vertices: impl IntoIterator<Item = (u32, Vec3)>,
) -> Vec<Vec3> {
    vertices
        .into_iter()
        .map(|(position, bind)| {
            let influences = attachments.of_vertex(position as usize);
            if influences.is_empty() {
                return bind;
            }
            (cofactors(blend(palette, influences)) * bind).normalize_or(bind)
        })
        .collect()
}

fn blend(palette: &[Mat4], influences: &[Influence]) -> Mat3 {
    influences.iter().fold(Mat3::ZERO, |sum, influence| {
        sum + Mat3::from_mat4(palette[influence.joint as usize]) * influence.weight
    })
}

/// Relative error of sums of many numbers in `f32`.
const ROUNDING: f32 = 1e-5;

/// Conservative bounds of a skinned mesh: boxes around the vertices of each joint in the bind pose,
/// and the range of the sums of weights, from which a box under any pose follows without skinning.
#[derive(Clone, Debug)]
pub(super) struct ConservativeBounds {
    /// Boxes around what each joint moves, in the bind pose, by joint index.
    by_joint: Vec<(usize, Aabb)>,
    /// Box around the vertices without any weight, which stay at rest.
    at_rest: Aabb,
    /// Smallest and largest sum of a vertex' weights.
    sums: (f32, f32),
    /// Largest sum of the absolute weights of a vertex.
    most: f32,
}

impl ConservativeBounds {
    /// Bounds of vertices at `bind`, one for each vertex of `attachments`, whose joints are below
    /// `joints`.
    pub fn new(attachments: &Attachments, bind: &[Vec3], joints: usize) -> Self {
        let mut boxes = vec![Aabb::EMPTY; joints];
        let mut bounds = Self {
            by_joint: Vec::new(),
            at_rest: Aabb::EMPTY,
            sums: (f32::INFINITY, f32::NEG_INFINITY),
            most: 0.0,
        };
        for (influences, &position) in attachments.vertices().zip(bind) {
            let point = Aabb::from_points([position]);
            if influences.is_empty() {
                bounds.at_rest = bounds.at_rest.union(point);
                continue;
            }
            let (mut sum, mut most) = (0.0, 0.0);
            for influence in influences {
                let joint = &mut boxes[influence.joint as usize];
                *joint = joint.union(point);
                sum += influence.weight;
                most += influence.weight.abs();
            }
            bounds.sums = (bounds.sums.0.min(sum), bounds.sums.1.max(sum));
            bounds.most = bounds.most.max(most);
        }
        let used = boxes.into_iter().enumerate();
        bounds.by_joint = used.filter(|(_, aabb)| !aabb.is_empty()).collect();
        bounds
    }

    /// Box, in model space, that contains all vertices under `palette` (`T · B⁻¹` by joint).
    ///
    /// A vertex is the sum of wᵢ pᵢ, where pᵢ lies in the box of joint i after its transform. With
    /// c the center and h half the size of a box around all of those, that is Σwᵢ c + Σwᵢ (pᵢ - c),
    /// of which the second part is at most Σ|wᵢ| h. For weights that sum to one it is that box.
    pub fn under(&self, palette: &[Mat4]) -> Aabb {
        let mut moved = Aabb::EMPTY;
        let mut largest = Vec3::ZERO;
        for &(joint, bind) in &self.by_joint {
            let model_from_bind = palette[joint];
            moved = moved.union(bind.transformed(model_from_bind));
            let far = bind.min.abs().max(bind.max.abs());
            let [x, y, z, w] = [
                model_from_bind.x_axis,
                model_from_bind.y_axis,
                model_from_bind.z_axis,
                model_from_bind.w_axis,
            ]
            .map(|axis| axis.truncate().abs());
            largest = largest.max(x * far.x + y * far.y + z * far.z + w);
        }
        if moved.is_empty() {
            return self.at_rest;
        }
        let (center, half) = (moved.center(), moved.size() * 0.5);
        let ends = [center * self.sums.0, center * self.sums.1];
        let spread = half * self.most + largest * (self.most.max(1.0) * ROUNDING);
        let blended = Aabb {
            min: ends[0].min(ends[1]) - spread,
            max: ends[0].max(ends[1]) + spread,
        };
        blended.union(self.at_rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Quat;
    use proptest::prelude::*;

    fn one_vertex(influences: &[(u32, f32)]) -> Attachments {
        let mut attachments = Attachments::new();
        attachments.push_vertex(
            influences
                .iter()
                .map(|&(joint, weight)| Influence { joint, weight }),
        );
        attachments
    }

    #[test]
    fn a_rigid_joint_turns_normals_as_it_turns_positions() {
        let turn = Mat4::from_rotation_x(0.7) * Mat4::from_translation(Vec3::ONE);
        let bind = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        let skinned = skin_normals(&[turn], &one_vertex(&[(0, 1.0)]), [(0, bind)]);
        assert!(skinned[0].abs_diff_eq(turn.transform_vector3(bind), 1e-6));
    }

    #[test]
    fn normals_stay_at_right_angles_to_the_surface_where_joints_disagree() {
        let palette = [Mat4::from_rotation_z(1.2), Mat4::from_rotation_x(-0.4)];
        let attachments = one_vertex(&[(0, 0.6), (1, 0.4)]);
        let (u, v) = (Vec3::new(1.0, 0.5, 0.2), Vec3::new(-0.3, 1.0, 0.7));
        let bind = u.cross(v).normalize_or_zero();
        let blended = palette[0] * 0.6 + palette[1] * 0.4;
        let (u, v) = (blended.transform_vector3(u), blended.transform_vector3(v));
        let expected = u.cross(v).normalize_or_zero();
        let skinned = skin_normals(&palette, &attachments, [(0, bind)]);
        assert!(skinned[0].abs_diff_eq(expected, 1e-6), "{skinned:?}");
    }

    #[test]
    fn a_vertex_without_weights_and_one_flattened_to_nothing_keep_their_normal() {
        let opposite = [Mat4::IDENTITY, Mat4::from_scale(-Vec3::ONE)];
        let flat = one_vertex(&[(0, 0.5), (1, 0.5)]);
        assert_eq!(skin_normals(&opposite, &flat, [(0, Vec3::X)]), [Vec3::X]);
        assert_eq!(
            skin_normals(&opposite, &one_vertex(&[]), [(0, Vec3::Y)]),
            [Vec3::Y]
        );
    }

    fn vectors(size: f32) -> impl Strategy<Value = Vec3> {
        let side = -size..size;
        (side.clone(), side.clone(), side).prop_map(Vec3::from)
    }

    fn transforms() -> impl Strategy<Value = Mat4> {
        (vectors(5.0), vectors(3.0)).prop_map(|(angles, offset)| {
            let turn = Quat::from_euler(glam::EulerRot::XYZ, angles.x, angles.y, angles.z);
            Mat4::from_rotation_translation(turn, offset)
        })
    }

    fn weighted(pairs: &[Vec<(u32, f32)>]) -> Attachments {
        let mut attachments = Attachments::new();
        for vertex in pairs {
            let influence = |&(joint, weight)| Influence { joint, weight };
            attachments.push_vertex(vertex.iter().map(influence));
        }
        attachments
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_vertex_leaves_the_box_whatever_its_weights(
            bind in prop::collection::vec(vectors(100.0), 12),
            weights in prop::collection::vec(prop::collection::vec((0..4_u32, -0.5..1.5_f32), 0..5), 12),
            palette in prop::collection::vec(transforms(), 4),
        ) {
            let attachments = weighted(&weights);
            let around = ConservativeBounds::new(&attachments, &bind, 4).under(&palette);
            let mut skinned = vec![Vec3::ZERO; bind.len()];
            skin_positions(&palette, &attachments, &bind, &mut skinned);
            for vertex in skinned {
                prop_assert!(vertex.cmpge(around.min).all() && vertex.cmple(around.max).all());
            }
        }
    }

    #[test]
    fn where_weights_sum_to_one_it_is_the_box_around_what_the_joints_move() {
        let bind = [Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0), Vec3::splat(9.0)];
        let attachments = weighted(&[vec![(0, 1.0)], vec![(0, 0.25), (1, 0.75)], vec![]]);
        let up = Mat4::from_translation(Vec3::Y * 4.0);
        let around = ConservativeBounds::new(&attachments, &bind, 2).under(&[Mat4::IDENTITY, up]);
        assert!(around.min.abs_diff_eq(Vec3::ZERO, 1e-3), "{around:?}");
        assert_eq!(around.max, Vec3::splat(9.0));
    }

    #[test]
    fn without_vertices_it_is_empty() {
        let bounds = ConservativeBounds::new(&Attachments::new(), &[], 1);
        assert!(bounds.under(&[Mat4::IDENTITY]).is_empty());
    }
}
