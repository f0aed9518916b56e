use crate::character::{Attachments, Influence};
use crate::math::cofactors;
use glam::{Mat3, Mat4, Vec3};

/// Turns normals as the surface around them is turned: by the inverse transpose of the same
/// weighted sum that moves the positions. Joints only turn and move, but a sum of rotations is no
/// rotation, so the sum's own rows would tilt normals where joints disagree.
///
/// `palette` is `T · B⁻¹` by joint. `vertices` gives for each vertex the position whose weights
/// it has and its unit normal in the bind pose, in model space. The normals returned are unit
/// length; where the sum flattens space to nothing the bind normal stays.
///
/// # Panics
/// If a vertex names a position that `attachments` lacks or an influence a joint that the
/// palette lacks; [`crate::character::Character`] rules both out.
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
