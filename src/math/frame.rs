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

/// Three unit vectors at a point of a curve, at right angles and right-handed:
/// `binormal = tangent × normal`. In the curve's model space.
///
/// Frames are carried along a curve so that they turn about the tangent as little as they can,
/// where the Frenet frame would flip at every inflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Along the curve.
    pub tangent: Vec3,
    /// To the left of the tangent in a flat curve.
    pub normal: Vec3,
    /// +Z in a flat curve.
    pub binormal: Vec3,
}

/// Below this length the cross product of two unit vectors says nothing about a direction.
const PARALLEL: f32 = 1e-4;

impl Frame {
    /// The first frame of a curve that starts along the unit vector `tangent`: made from the
    /// binormal +Z, or +Y where the tangent is parallel to +Z.
    pub fn first(tangent: Vec3) -> Self {
        let seed = if tangent.cross(Vec3::Z).length() > PARALLEL {
            Vec3::Z
        } else {
            Vec3::Y
        };
        let normal = seed.cross(tangent).normalize_or(Vec3::X);
        Self::from_tangent_and_normal(tangent, normal)
    }

    /// This frame carried on to where the curve runs along the unit vector `tangent`:
    /// `N = normalize(B × T)`, `B = normalize(T × N)` with the `B` before. Where the new tangent
    /// is parallel to that binormal the normal before is kept upright instead.
    pub fn carried_to(self, tangent: Vec3) -> Self {
        let across = self.binormal.cross(tangent);
        let normal = if across.length() > PARALLEL {
            across.normalize_or(self.normal)
        } else {
            let upright = self.normal - tangent * self.normal.dot(tangent);
            upright.normalize_or(self.normal)
        };
        Self::from_tangent_and_normal(tangent, normal)
    }

    /// This frame turned about its tangent, counter-clockwise seen from the tangent's tip.
    pub fn turned(self, angle: f32) -> Self {
        let (sin, cos) = angle.sin_cos();
        let normal = self.normal * cos + self.binormal * sin;
        Self::from_tangent_and_normal(self.tangent, normal.normalize_or(self.normal))
    }

    /// The angle in −π..π by which [`Frame::turned`] brings this frame's normal to `other`'s,
    /// as seen along this frame's tangent.
    pub fn angle_to(self, other: Self) -> f32 {
        let (x, y) = (
            other.normal.dot(self.normal),
            other.normal.dot(self.binormal),
        );
        y.atan2(x)
    }

    /// Whether all three vectors are finite, of unit length and at right angles within
    /// `tolerance`, and right-handed.
    pub fn is_orthonormal(self, tolerance: f32) -> bool {
        let axes = Mat3::from_cols(self.tangent, self.normal, self.binormal);
        (axes.transpose() * axes).abs_diff_eq(Mat3::IDENTITY, tolerance) && axes.determinant() > 0.0
    }

    fn from_tangent_and_normal(tangent: Vec3, normal: Vec3) -> Self {
        Self {
            tangent,
            normal,
            binormal: tangent.cross(normal).normalize_or(Vec3::Z),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_frame_of_a_flat_curve_has_its_binormal_on_z() {
        let frame = Frame::first(Vec3::Y);
        assert_eq!(frame.normal, -Vec3::X);
        assert_eq!(frame.binormal, Vec3::Z);
    }

    #[test]
    fn a_frame_exists_for_every_direction_even_along_z() {
        for tangent in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Z] {
            assert!(Frame::first(tangent).is_orthonormal(1e-6));
        }
    }

    #[test]
    fn carrying_onto_the_old_binormal_keeps_the_normal() {
        let frame = Frame::first(Vec3::X);
        let carried = frame.carried_to(frame.binormal);
        assert!(carried.is_orthonormal(1e-6));
        assert_eq!(carried.normal, frame.normal);
    }

    #[test]
    fn turning_by_the_angle_between_two_frames_brings_one_to_the_other() {
        let frame = Frame::first(Vec3::new(0.6, 0.0, 0.8));
        let other = frame.turned(-1.2);
        assert!((frame.angle_to(other) + 1.2).abs() < 1e-6);
        assert!(other.is_orthonormal(1e-6));
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
