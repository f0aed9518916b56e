use super::Euler;
use glam::{Mat3, Mat4, Vec3};

/// Placement of a model in the world: `world_from_model = T · Rx · Ry · Rz · S` (course editor,
/// "Euler angles").
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Transform {
    /// Position of the model's origin in the world.
    pub position: Vec3,
    /// Rotation, applied after scaling and before translation.
    pub rotation: Euler,
    /// Scale along the model's own axes.
    pub scale: Vec3,
}

impl Transform {
    /// Transform that changes nothing.
    pub const IDENTITY: Self = Self {
        position: Vec3::ZERO,
        rotation: Euler::ZERO,
        scale: Vec3::ONE,
    };

    /// Matrix from model space to world space.
    pub fn world_from_model(&self) -> Mat4 {
        Mat4::from_translation(self.position)
            * self.rotation.to_mat4()
            * Mat4::from_scale(self.scale)
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// Cofactor matrix, the inverse transpose times the determinant: how areas, and so normals, are
/// transformed, up to their length. It exists where the inverse does not, and agrees with the
/// winding of triangles even under a reflection.
pub fn cofactors(m: Mat3) -> Mat3 {
    Mat3::from_cols(
        m.y_axis.cross(m.z_axis),
        m.z_axis.cross(m.x_axis),
        m.x_axis.cross(m.y_axis),
    )
}
