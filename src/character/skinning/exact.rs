use crate::character::Attachments;
use glam::{Mat4, Vec3, Vec4};

/// Moves every bind position by the weighted sum of its joints' transforms: the reference that
/// any faster way is held to.
///
/// `palette` is `T · B⁻¹` by joint, `bind` and `skinned` are in model space and have one entry
/// per vertex of `attachments`. Weights are used as they are: where they do not sum to one the
/// vertex shrinks towards the model's origin or grows away from it, as in the assignment's
/// formula. A vertex without any weight stays at its bind position.
///
/// # Panics
/// If the lengths differ or an influence names a joint that the palette lacks;
/// [`crate::character::Character`] rules both out.
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
