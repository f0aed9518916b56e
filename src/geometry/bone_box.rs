use glam::{Mat3, Mat4, Vec3};

/// Half width of a bone's box, in the character's space. The assignment's text says 0.025; the
/// course's program draws 0.01.
pub const BONE_HALF_WIDTH: f32 = 0.01;

/// Transform that places the box of a bone (assignment, "Stick figure"): `model_from_unit` of a
/// unit cuboid with x and y in −1..1 and z in 0..1, which then reaches from `start` to `end`.
///
/// `None` for a bone of zero length, which has no direction.
pub fn cuboid_from_unit(start: Vec3, end: Vec3, half_width: f32) -> Option<Mat4> {
    let frame = bone_frame(end - start)?;
    let length = (end - start).length();
    Some(
        Mat4::from_translation(start)
            * Mat4::from_mat3(frame)
            * Mat4::from_scale(Vec3::new(half_width, half_width, length)),
    )
}

/// Rotation of a bone's box, which is modeled along +Z, onto the bone (assignment, "Stick figure":
/// `y = normalize(z × rnd)`, `x = normalize(y × z)`).
///
/// `direction` runs along the bone, in the character's space, and need not be of unit length. The
/// helper `rnd` is +Y, and +X where the bone is nearly parallel to +Y, as the course's program
/// draws it. `None` for a bone of zero or undefined length.
fn bone_frame(direction: Vec3) -> Option<Mat3> {
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
    fn the_box_reaches_from_one_joint_to_the_other() {
        let (start, end) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(-0.5, 2.5, 3.25));
        let model_from_unit = cuboid_from_unit(start, end, BONE_HALF_WIDTH).unwrap();
        assert!(
            model_from_unit
                .transform_point3(Vec3::ZERO)
                .abs_diff_eq(start, 1e-6)
        );
        assert!(
            model_from_unit
                .transform_point3(Vec3::Z)
                .abs_diff_eq(end, 1e-6)
        );
        let side = model_from_unit.transform_vector3(Vec3::X);
        assert!((side.length() - BONE_HALF_WIDTH).abs() < 1e-7);
        assert!(side.dot(end - start).abs() < 1e-6);
    }

    #[test]
    fn a_bone_of_zero_length_has_no_box() {
        assert!(cuboid_from_unit(Vec3::ONE, Vec3::ONE, BONE_HALF_WIDTH).is_none());
    }

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
