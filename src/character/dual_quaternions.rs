//! Skinning with dual quaternions (Kavan, Collins, Žára, O'Sullivan 2007): every vertex is moved by a
//! rigid motion blended from its joints' motions, so that a twisted limb keeps its girth.

use super::{Attachments, Influence};
use crate::math::cofactors;
use glam::{Mat3, Mat4, Quat, Vec3};

/// Steps of Newton's iteration for the polar rotation; a rotation stays as it is from the first.
const POLAR_STEPS: usize = 12;

/// Norm of a blend below which joints cancel out.
const SMALLEST_NORM: f32 = 1e-6;

/// Rigid motion as a dual quaternion, in model space.
#[derive(Clone, Copy, Debug)]
struct DualQuaternion {
    real: Quat,
    dual: Quat,
}

impl DualQuaternion {
    /// Rotation and translation of `model_from_bind`. Scale and shear are left out: the rotation is
    /// that of the polar decomposition, the nearest one. A matrix that mirrors or flattens has none
    /// and only translates.
    fn from_matrix(model_from_bind: &Mat4) -> Self {
        let real = polar_rotation(Mat3::from_mat4(*model_from_bind));
        let offset = model_from_bind.w_axis.truncate() * 0.5;
        let dual = Quat::from_xyzw(offset.x, offset.y, offset.z, 0.0) * real;
        Self { real, dual }
    }

    /// Blend of the motions of `influences`, divided by its norm, so that only the ratios of the
    /// weights matter. Motions are added in the sign that is nearer to that of the largest weight,
    /// which is the short way round; where they cancel out, that one alone is the blend.
    fn blend(motions: &[Self], influences: &[Influence]) -> Option<Self> {
        let mut strongest = influences.first()?;
        for influence in influences {
            if influence.weight > strongest.weight {
                strongest = influence;
            }
        }
        let pivot = motions[strongest.joint as usize];
        let zero = Quat::from_xyzw(0.0, 0.0, 0.0, 0.0);
        let (mut real, mut dual) = (zero, zero);
        for influence in influences {
            let motion = &motions[influence.joint as usize];
            let is_antipodal = motion.real.dot(pivot.real) < 0.0;
            let weight = influence.weight * if is_antipodal { -1.0 } else { 1.0 };
            real += motion.real * weight;
            dual += motion.dual * weight;
        }
        let norm = real.length();
        Some(if norm > SMALLEST_NORM {
            Self {
                real: real / norm,
                dual: dual / norm,
            }
        } else {
            pivot
        })
    }

    fn transform_point(self, point: Vec3) -> Vec3 {
        let half = (self.dual * self.real.conjugate()).xyz();
        self.real * point + half * 2.0
    }
}

/// Rotation nearest to a matrix, by Newton's iteration; none of one that mirrors or flattens.
fn polar_rotation(matrix: Mat3) -> Quat {
    if !(matrix.determinant() > 0.0 && matrix.is_finite()) {
        return Quat::IDENTITY;
    }
    let mut rotation = matrix;
    for _ in 0..POLAR_STEPS {
        let determinant = rotation.determinant();
        rotation = (rotation + cofactors(rotation) * determinant.recip()) * 0.5;
    }
    if rotation.is_finite() {
        Quat::from_mat3(&rotation).normalize()
    } else {
        Quat::IDENTITY
    }
}

fn motions(palette: &[Mat4]) -> Vec<DualQuaternion> {
    palette.iter().map(DualQuaternion::from_matrix).collect()
}

/// Skins positions with dual quaternions.
///
/// `palette` is `T · B⁻¹` by joint, `bind` is in model space and has one entry per vertex of
/// `attachments`. Weights count by their ratios, so a sum other than 1 does not shrink the mesh as in
/// linear blending. A vertex without any weight stays at its bind position.
///
/// # Panics
/// If the lengths differ or an influence names a joint that the palette lacks; [`super::Character`]
/// rules both out.
pub fn skin_positions(palette: &[Mat4], attachments: &Attachments, bind: &[Vec3]) -> Vec<Vec3> {
    assert_eq!(bind.len(), attachments.vertex_count());
    let motions = motions(palette);
    let moved = attachments.vertices().zip(bind);
    moved
        .map(|(influences, &bind)| {
            let motion = DualQuaternion::blend(&motions, influences);
            motion.map_or(bind, |motion| motion.transform_point(bind))
        })
        .collect()
}

/// Skins normals with dual quaternions: they turn by the rotations that move the positions.
///
/// `vertices` gives for each vertex the index of the position whose weights it has, and its unit normal
/// in the bind pose, in model space.
///
/// # Panics
/// If a vertex names a position that `attachments` lacks or an influence a joint that the palette
/// lacks; [`super::Character`] rules both out.
pub fn skin_normals(
    palette: &[Mat4],
    attachments: &Attachments,
    vertices: impl IntoIterator<Item = (u32, Vec3)>,
) -> Vec<Vec3> {
    let motions = motions(palette);
    vertices
        .into_iter()
        .map(|(position, bind)| {
            let influences = attachments.of_vertex(position as usize);
            let motion = DualQuaternion::blend(&motions, influences);
            motion.map_or(bind, |motion| motion.real * bind)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::skinning;
    use proptest::prelude::*;
    use std::f32::consts::PI;

    fn weighted(vertices: &[&[(u32, f32)]]) -> Attachments {
        let mut attachments = Attachments::new();
        for vertex in vertices {
            let influence = |&(joint, weight)| Influence { joint, weight };
            attachments.push_vertex(vertex.iter().map(influence));
        }
        attachments
    }

    fn linear(palette: &[Mat4], attachments: &Attachments, bind: &[Vec3]) -> Vec<Vec3> {
        let mut skinned = vec![Vec3::ZERO; bind.len()];
        skinning::skin_positions(palette, attachments, bind, &mut skinned);
        skinned
    }

    #[test]
    fn the_middle_of_a_limb_twisted_by_half_a_turn_keeps_its_radius_where_linear_blending_collapses()
     {
        let ring: Vec<Vec3> = (0..16)
            .map(|step| Quat::from_rotation_x(step as f32 * PI / 8.0) * Vec3::Y)
            .collect();
        let attachments = weighted(&[[(0, 0.5), (1, 0.5)].as_slice(); 16]);
        let palette = [Mat4::IDENTITY, Mat4::from_rotation_x(PI)];
        for vertex in linear(&palette, &attachments, &ring) {
            assert!(vertex.length() < 1e-5, "{vertex}");
        }
        for vertex in skin_positions(&palette, &attachments, &ring) {
            assert!((vertex.length() - 1.0).abs() < 1e-5, "{vertex}");
        }
    }

    #[test]
    fn a_twisted_cylinder_keeps_its_volume_and_loses_most_of_it_by_linear_blending() {
        use crate::geometry::enclosed_volume;
        const RINGS: u32 = 32;
        const SIDES: u32 = 16;
        let (mut bind, mut attachments) = (Vec::new(), Attachments::new());
        for ring in 0..=RINGS {
            let along = ring as f32 / RINGS as f32;
            for side in 0..SIDES {
                let turn = Quat::from_rotation_x(side as f32 * 2.0 * PI / SIDES as f32);
                bind.push(turn * Vec3::Y + Vec3::X * along * 4.0);
                let weights = [(0, 1.0 - along), (1, along)];
                attachments.push_vertex(weights.map(|(joint, weight)| Influence { joint, weight }));
            }
        }
        let mut triangles = Vec::new();
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            for start in (0..RINGS).map(|ring| ring * SIDES) {
                let [a, b, c, d] = [side, next, SIDES + next, SIDES + side].map(|v| v + start);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
            let end = RINGS * SIDES;
            triangles.extend([[0, next, side], [end, end + side, end + next]]);
        }
        let palette = [Mat4::IDENTITY, Mat4::from_rotation_x(PI)];
        let volume = |positions: &[Vec3]| enclosed_volume(positions, &triangles).unwrap();
        let kept = |positions: &[Vec3]| volume(positions) / volume(&bind);
        let by_dual_quaternions = kept(&skin_positions(&palette, &attachments, &bind));
        assert!(
            (0.97..1.01).contains(&by_dual_quaternions),
            "{by_dual_quaternions}"
        );
        let linearly = kept(&linear(&palette, &attachments, &bind));
        assert!(linearly < 0.4, "{linearly}");
    }

    #[test]
    fn quaternions_of_opposite_signs_are_blended_the_short_way() {
        // The quaternions that are made of these two matrices lie on opposite sides.
        let palette = [40.0_f32, -100.0].map(|angle| Mat4::from_rotation_x(angle.to_radians()));
        let attachments = weighted(&[&[(0, 0.5), (1, 0.5)]]);
        let skinned = skin_positions(&palette, &attachments, &[Vec3::Y]);
        let half_way = Quat::from_rotation_x(-PI / 6.0) * Vec3::Y;
        assert!(skinned[0].abs_diff_eq(half_way, 1e-5), "{skinned:?}");
    }

    #[test]
    fn signs_go_by_the_strongest_influence_wherever_it_is_listed() {
        // Only to the middle one all others are near.
        let turned = |angle: f32| Mat4::from_rotation_x(angle.to_radians());
        let palette = [-120.0, 0.0, 120.0].map(turned);
        let at = |order: [usize; 3]| {
            let weights = [0.3, 0.4, 0.3];
            let row: Vec<(u32, f32)> = order.map(|at| (at as u32, weights[at])).into();
            skin_positions(&palette, &weighted(&[&row]), &[Vec3::Y])[0]
        };
        for order in [[1, 0, 2], [0, 1, 2], [2, 0, 1]] {
            assert!(at(order).abs_diff_eq(Vec3::Y, 1e-5), "{order:?}");
        }
    }

    #[test]
    fn where_motions_cancel_out_the_strongest_alone_counts() {
        let palette = [Mat4::from_translation(Vec3::X), Mat4::from_rotation_y(0.0)];
        let attachments = weighted(&[&[(0, 0.5), (1, -0.5)]]);
        let skinned = skin_positions(&palette, &attachments, &[Vec3::Z]);
        assert_eq!(skinned[0], Vec3::Z + Vec3::X);
    }

    #[test]
    fn scale_of_a_joint_is_left_out_and_its_rotation_and_translation_stay() {
        let turn = Quat::from_rotation_y(0.8);
        let scaled = Mat4::from_scale_rotation_translation(Vec3::new(1.0, 3.0, 0.5), turn, Vec3::X);
        let skinned = skin_positions(&[scaled], &weighted(&[&[(0, 1.0)]]), &[Vec3::ONE]);
        assert!(
            skinned[0].abs_diff_eq(turn * Vec3::ONE + Vec3::X, 1e-5),
            "{skinned:?}"
        );
        let mirrored = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
        let skinned = skin_positions(&[mirrored], &weighted(&[&[(0, 1.0)]]), &[Vec3::ONE]);
        assert_eq!(skinned[0], Vec3::ONE);
    }

    #[test]
    fn weights_count_by_their_ratios_and_a_vertex_without_any_stays() {
        let palette = [Mat4::from_translation(Vec3::Y), Mat4::from_rotation_z(0.5)];
        let half = weighted(&[&[(0, 0.25), (1, 0.25)], &[]]);
        let whole = weighted(&[&[(0, 0.5), (1, 0.5)], &[]]);
        let bind = [Vec3::X, Vec3::Z];
        let [half, whole] = [half, whole].map(|weights| skin_positions(&palette, &weights, &bind));
        assert!(half[0].abs_diff_eq(whole[0], 1e-6));
        assert_eq!(half[1], Vec3::Z);
    }

    fn vectors(size: f32) -> impl Strategy<Value = Vec3> {
        let side = -size..size;
        (side.clone(), side.clone(), side).prop_map(Vec3::from)
    }

    fn transforms(angle: f32) -> impl Strategy<Value = Mat4> {
        (vectors(angle), vectors(3.0)).prop_map(|(angles, offset)| {
            let turn = Quat::from_euler(glam::EulerRot::XYZ, angles.x, angles.y, angles.z);
            Mat4::from_rotation_translation(turn, offset)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn what_one_joint_moves_is_where_linear_blending_has_it(
            motion in transforms(3.0),
            bind in vectors(5.0),
        ) {
            let attachments = weighted(&[&[(0, 1.0)]]);
            let expected = linear(&[motion], &attachments, &[bind])[0];
            let skinned = skin_positions(&[motion], &attachments, &[bind])[0];
            prop_assert!(skinned.abs_diff_eq(expected, 2e-5), "{skinned} {expected}");
            let normal = bind.normalize_or(Vec3::X);
            let turned = skin_normals(&[motion], &attachments, [(0, normal)])[0];
            prop_assert!(turned.abs_diff_eq(motion.transform_vector3(normal), 1e-5));
        }

        #[test]
        fn moving_all_joints_together_moves_the_mesh_with_them(
            palette in prop::collection::vec(transforms(0.5), 3),
            all in transforms(3.0),
            bind in vectors(5.0),
            weights in [0.1..1.0_f32, 0.1..1.0, 0.1..1.0],
        ) {
            let [a, b, c] = weights;
            let attachments = weighted(&[&[(0, a), (1, b), (2, c)]]);
            let moved: Vec<Mat4> = palette.iter().map(|motion| all * *motion).collect();
            let expected = all.transform_point3(skin_positions(&palette, &attachments, &[bind])[0]);
            let skinned = skin_positions(&moved, &attachments, &[bind])[0];
            prop_assert!(skinned.abs_diff_eq(expected, 1e-4), "{skinned} {expected}");
        }
    }
}
