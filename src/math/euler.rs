use glam::{EulerRot, Mat3, Mat4, Vec3};

/// Three angles in radians about X, Y and Z, meaning the rotation `Rx · Ry · Rz` of column
/// vectors: Z turns first, X last (assignment, "Sliders").
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct Euler {
    /// Angles about X, Y and Z, radians.
    pub radians: Vec3,
}

impl Euler {
    /// No rotation.
    pub const ZERO: Self = Self {
        radians: Vec3::ZERO,
    };

    /// From radians about X, Y and Z.
    pub fn from_radians(radians: Vec3) -> Self {
        Self { radians }
    }

    /// From degrees about X, Y and Z, the unit of files and panels.
    pub fn from_degrees(degrees: Vec3) -> Self {
        Self {
            radians: degrees * (std::f32::consts::PI / 180.0),
        }
    }

    /// Degrees about X, Y and Z.
    pub fn degrees(self) -> Vec3 {
        self.radians * (180.0 / std::f32::consts::PI)
    }

    /// Degrees brought into 0..360, as the panel shows them.
    pub fn wrapped_degrees(self) -> Vec3 {
        self.degrees().map(wrap_degrees)
    }

    /// The rotation `Rx · Ry · Rz`.
    pub fn to_mat3(self) -> Mat3 {
        Mat3::from_euler(
            EulerRot::XYZ,
            self.radians.x,
            self.radians.y,
            self.radians.z,
        )
    }

    /// The rotation `Rx · Ry · Rz` without translation.
    pub fn to_mat4(self) -> Mat4 {
        Mat4::from_mat3(self.to_mat3())
    }
}

/// Brings an angle in degrees into 0..360; an angle that rounding would show as 360 becomes 0.
fn wrap_degrees(degrees: f32) -> f32 {
    let wrapped = degrees.rem_euclid(360.0);
    if wrapped > 359.999_95 { 0.0 } else { wrapped }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_is_rx_times_ry_times_rz() {
        let euler = Euler::from_degrees(Vec3::new(30.0, -70.0, 145.0));
        let [x, y, z] = euler.radians.to_array();
        let expected =
            Mat3::from_rotation_x(x) * Mat3::from_rotation_y(y) * Mat3::from_rotation_z(z);
        assert!(euler.to_mat3().abs_diff_eq(expected, 1e-6));
    }

    #[test]
    fn angles_are_shown_between_0_and_360() {
        let shown = Euler::from_degrees(Vec3::new(-30.0, 725.0, 360.0)).wrapped_degrees();
        assert!(
            shown.abs_diff_eq(Vec3::new(330.0, 5.0, 0.0), 1e-3),
            "{shown}"
        );
    }
}
