use glam::{Mat3, Vec3};

/// The rotation that turns a bone's box, which is modelled along +Z, onto the bone (assignment,
/// "Stick figure": `y = normalize(z × rnd)`, `x = normalize(y × z)`).
///
/// `direction` runs along the bone, in the character's space, and need not be of unit length.
/// The helper `rnd` is +Y, and +X where the bone is nearly parallel to +Y, as the course's
/// program draws it. `None` for a bone of zero or undefined length.
pub fn bone_frame(direction: Vec3) -> Option<Mat3> {
    let z = direction.try_normalize()?;
    let rnd = if z.dot(Vec3::Y).abs() > 0.99 {
        Vec3::X
    } else {
        Vec3::Y
    };
    let y = z.cross(rnd).try_normalize()?;
    let x = y.cross(z).try_normalize()?;
    Some(Mat3::from_cols(x, y, z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_is_orthonormal_and_its_z_runs_along_the_bone() {
        for direction in [
            Vec3::X,
            Vec3::Y,
            -Vec3::Y,
            Vec3::Z,
            Vec3::new(0.1, 2.0, -0.05),
        ] {
            let frame = bone_frame(direction).unwrap();
            assert!((frame.transpose() * frame).abs_diff_eq(Mat3::IDENTITY, 1e-5));
            assert!((frame.determinant() - 1.0).abs() < 1e-5);
            assert!(frame.z_axis.dot(direction) > 0.999 * direction.length());
        }
    }

    #[test]
    fn a_bone_of_zero_length_has_no_frame() {
        assert!(bone_frame(Vec3::ZERO).is_none());
        assert!(bone_frame(Vec3::NAN).is_none());
    }
}
